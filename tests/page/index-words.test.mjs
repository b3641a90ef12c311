// The words in www/index.html, which stand there until the page is translated, are those of the English catalogue, and
// each names its place there.

import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { test } from "node:test";
import { en } from "../../www/text/en/index.js";

const HTML = readFileSync(new URL("../../www/index.html", import.meta.url), "utf8")
  .replace(/<!--.*?-->|<!doctype[^>]*>/gs, "")
  // Seen only where no catalogue is: without scripts.
  .replace(/<noscript>.*?<\/noscript>/gs, "");

/** Texts of attributes; of the `content` of <meta> only a description is one. */
const ATTRIBUTES = ["title", "aria-label", "alt"];
const WITHOUT_END = /^(meta|link|input|img|br)$/;
/** The same in all languages. */
const NAME = "Pathlight";

/**
 * What is wrong with the markup, and how many texts it has.
 * @param {string} html
 */
function check(html) {
  /** @type {string[]} */
  const problems = [];
  let count = 0;
  const compare = (/** @type {string | undefined} */ id, /** @type {string} */ found) => {
    count += 1;
    const words = id?.split(".").reduce((entry, name) => Object(entry)[name], /** @type {unknown} */ (en));
    if (words !== found) problems.push(id ? `${id} is ${words}, not ${found}` : `not in the catalogue: ${found}`);
  };
  /** @type {{ id: string | undefined, start: number }[]} */
  const open = [];
  for (const { 0: whole, 1: end, 2: name, 3: written, index } of html.matchAll(/<(\/?)([\w-]+)([^>]*)>|[^<]+/g)) {
    if (name === undefined) {
      const isBare = whole.trim() !== "" && whole.trim() !== NAME && !open.some(({ id }) => id);
      if (isBare) compare(undefined, whole.trim());
    } else if (end) {
      const { id, start } = open.pop() ?? {};
      if (id) compare(id, html.slice(start, index));
    } else {
      const attributes = Object.fromEntries(
        Array.from(written.matchAll(/([\w-]+)="([^"]*)"/g), ([, key, value]) => [key, value]),
      );
      const texts = attributes.name === "description" ? ["content"] : ATTRIBUTES;
      for (const key of texts) {
        const id = attributes[`data-text-${key}`];
        if (id || attributes[key]) compare(id, attributes[key]);
      }
      if (!WITHOUT_END.test(name) && !written.endsWith("/"))
        open.push({ id: attributes["data-text"], start: index + whole.length });
    }
  }
  return { problems, count };
}

test("index.html says what the English catalogue says", () => {
  const { problems, count } = check(HTML);
  assert.deepEqual(problems, []);
  assert.ok(count > 80, `${count}`);
});

test("a text without a name, or another one, is found", () => {
  assert.equal(check(`<p>New</p>`).problems.length, 1);
  assert.equal(check(`<img alt="New">`).problems.length, 1);
  assert.equal(check(`<option data-text="results.all">every puzzle</option>`).problems.length, 1);
  assert.equal(check(`<option data-text="results.every">all puzzles</option>`).problems.length, 1);
  assert.deepEqual(check(`<option data-text="results.all">all puzzles</option>`).problems, []);
});
