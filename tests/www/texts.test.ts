// Texts that no type holds to each other: those that are seen before the page's code is there, and those by template.

import assert from "node:assert/strict";
import { readFileSync, readdirSync } from "node:fs";
import { test } from "node:test";
import { TEMPLATES } from "../../www/pkg/constants.ts";
import { LANGUAGES } from "../../www/text/language.ts";
import { loadExhibitText } from "../../www/text/exhibits.ts";
import { loadText } from "../../www/text/text.ts";

const read = (file: string) => readFileSync(`www/${file}`, "utf8");

test("what is seen before the code is there has the words of the page in each language", async () => {
  for (const language of LANGUAGES) {
    const { home, play } = await loadText(language);
    for (const words of [home.title, home.about, home.waiting, play.noAttempts])
      assert.ok(read("index.html").includes(`lang="${language}">${words}<`), words);
    if (language === "en") continue;
    assert.ok(read("style.css").includes(`:root:lang(${language})`), language);
    assert.ok(read("first-look.js").includes(`"${language}"`), language);
  }
});

test("each template has a name and a story in each language", async () => {
  for (const language of LANGUAGES) {
    const { puzzle } = await loadText(language);
    const names = TEMPLATES.map(({ id }) => puzzle.name({ id: `${id}:000`, name: null }));
    assert.equal(new Set(names).size, TEMPLATES.length, language);
  }
});

/** Named by a variable, or used in other texts. */
const ELSEWHERE = ["page.learns", "page.results", "puzzle.body"];

test("no text is there that nothing shows", async () => {
  const sources = readdirSync("www", { recursive: true, encoding: "utf8" }).filter((path) => path.endsWith(".ts"));
  const codeOf = (isRead: (path: string) => boolean) => sources.filter(isRead).map(read).join("\n");
  const page = codeOf((path) => !/^(pkg|exhibits|text\/(en|de))\//.test(path));
  const exhibits = codeOf((path) => path.startsWith("exhibits/"));
  const entriesOf = (text: object) =>
    Object.entries(text).flatMap(([part, entries]) =>
      typeof entries === "string" ? [] : Object.keys(entries).map((name) => [part, name] as const),
    );
  for (const [part, name] of entriesOf(await loadText("en")))
    if (!ELSEWHERE.includes(`${part}.${name}`))
      assert.match(page, new RegExp(`\\b(${part}|words)\\.${name}\\b`), `${part}.${name}`);
  for (const [part, name] of entriesOf((await loadExhibitText("en")).text))
    assert.match(exhibits, new RegExp(`\\.${name}\\b`), `${part}.${name}`);
});
