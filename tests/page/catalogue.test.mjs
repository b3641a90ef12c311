// All that a person reads stands in the catalogue, in every language. tsc compares the keys of the languages.

import assert from "node:assert/strict";
import { readFileSync, readdirSync } from "node:fs";
import { createRequire } from "node:module";
import { test } from "node:test";
import { de } from "../../www/text/de/index.js";
import { en } from "../../www/text/en/index.js";

const WWW = new URL("../../www/", import.meta.url);
// ESLint's own parser.
const { parse } = createRequire(new URL("../../scripts/package.json", import.meta.url))("espree");

/** The modules of the page by path: not the catalogue, the API for scripts, and what has no page. */
const MODULES = readdirSync(WWW, { recursive: true, encoding: "utf8" })
  .filter((path) => path.endsWith(".js") && !/^((pkg|api|text)\/|offline\/service-worker)/.test(path))
  .map((path) => /** @type {const} */ ([path, readFileSync(new URL(path, WWW), "utf8")]));

/** Two words, or one with a capital letter and others small: what a person might read. */
const WORDS = /\p{L}{2,}[,.:;!?…]? \p{L}|\p{L}{2,}[.!?…]$|^\p{Lu}\p{Ll}+$/u;

/** What looks like words and is none, or is for those alone who write the page. */
const OTHER = [
  // Keys and names of the browser's.
  /^(Enter|Escape|Tab|Space|Backspace|Delete|Home|End|Page(Up|Down)|Arrow\w+|Shift|AbortError|Array|Error|Event|Files)$/,
  // Styles, selectors, templates of markup, keys of what is stored.
  /gradient\(|var\(--|sans-serif|: |^[.#[]|[>{}=]/,
  /^((a|button|dialog|input|select|summary)(, )?)+$/,
  /^[a-z]+\.$/,
  /^The markup has no … of the class …$/,
];

/** What is looked up by a value of data. */
const LOOKED_UP = /^(kinds|model\.agents)\./;

/**
 * All strings of a module, without what it imports.
 * @param {string} source
 * @returns {string[]}
 */
function stringsOf(source) {
  /** @type {string[]} */
  const strings = [];
  const visit = (/** @type {any} */ node) => {
    if (!node || typeof node.type !== "string") return;
    if (/^(Import|Export)/.test(node.type) && node.source) return;
    if (node.type === "Literal" && typeof node.value === "string") strings.push(node.value);
    if (node.type === "TemplateLiteral")
      strings.push(node.quasis.map((/** @type {any} */ quasi) => quasi.value.cooked).join("…"));
    for (const value of Object.values(node)) [value].flat().forEach(visit);
  };
  visit(parse(source, { ecmaVersion: "latest", sourceType: "module" }));
  return strings;
}

/**
 * The entries of a catalogue by id.
 * @param {object} entries
 * @param {string} [prefix]
 * @returns {[id: string, entry: unknown][]}
 */
const entriesOf = (entries, prefix = "") =>
  Object.entries(entries).flatMap(([key, entry]) =>
    entry && typeof entry === "object" ? entriesOf(entry, `${prefix}${key}.`) : [[prefix + key, entry]],
  );

test("no module has words of its own", () => {
  const found = MODULES.flatMap(([path, source]) =>
    stringsOf(source)
      .map((string) => string.replace(/<[^>]*>/g, " ").trim())
      .filter((string) => WORDS.test(string) && !OTHER.some((pattern) => pattern.test(string)))
      .map((string) => `${path}: ${string.slice(0, 100)}`),
  );
  assert.deepEqual(found, []);
});

test("every language has the same ids, and words for each", () => {
  const ids = entriesOf(en).map(([id]) => id);
  assert.ok(ids.length > 300);
  assert.deepEqual(
    entriesOf(de)
      .map(([id]) => id)
      .sort(),
    ids.toSorted(),
  );
  const german = new Map(entriesOf(de));
  const same = entriesOf(en).filter(([id, entry]) => typeof entry === "string" && entry === german.get(id));
  assert.deepEqual(
    same.filter(([, entry]) => /\w \w/.test(String(entry))).map(([id]) => id),
    [],
    "not translated",
  );
});

test("every entry is used", () => {
  const sources = [...MODULES.map(([, source]) => source), readFileSync(new URL("index.html", WWW), "utf8")].join("\n");
  const used = new Set(sources.match(/\w+/g));
  const unused = entriesOf(en)
    .map(([id]) => id)
    .filter((id) => !LOOKED_UP.test(id) && !id.split(".").some((name, depth) => depth > 1 && used.has(name)));
  assert.deepEqual(
    unused.filter((id) => !used.has(id.split(".").at(-1) ?? "")),
    [],
  );
});
