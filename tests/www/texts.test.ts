// Texts that no type holds to each other: those that are seen before the page's code is there, and those by template.

import assert from "node:assert/strict";
import { readFileSync, readdirSync } from "node:fs";
import { test } from "node:test";
import { TEMPLATES } from "../../www/pkg/constants.ts";
import { LANGUAGES, languageOf, loadText } from "../../www/text/languages.ts";
import type { ExhibitText } from "../../www/text/exhibits-en.ts";

const languages = Object.keys(LANGUAGES).map((name) => languageOf(name)!);
const exhibitsIn = async (language: string): Promise<ExhibitText> =>
  (await import(`../../www/text/exhibits-${language}.ts`)).exhibits;
const read = (file: string) => readFileSync(`www/${file}`, "utf8");

test("what is seen before the code is there has the words of the page in each language", async () => {
  const page = read("index.html").replace(/<html.*>/, "");
  const counts = languages.map((language) => page.split(`lang="${language}">`).length);
  assert.equal(new Set(counts).size, 1, `of ${languages.join()}: ${counts.join()}`);
  for (const language of languages) {
    const { home, play } = await loadText(language);
    for (const words of [home.title, home.goal, home.about, home.waiting, play.noAttempts])
      assert.ok(page.includes(`lang="${language}">${words}<`), words);
    if (language !== "en") assert.ok(read("style.css").includes(`:root:lang(${language})`), language);
  }
});

test("each template has a name and a story in each language", async () => {
  for (const language of languages) {
    const { puzzle } = await loadText(language);
    const names = TEMPLATES.map(({ id }) => puzzle.name({ id: `${id}:000`, name: null }));
    assert.equal(new Set(names).size, TEMPLATES.length, language);
  }
});

/** Named by a variable, or used in other texts. */
const ELSEWHERE = /^tabs\.|^page\.(learns|results)$|^puzzle\.body$/;

test("no text is there that nothing shows", async () => {
  const sources = readdirSync("www", { recursive: true, encoding: "utf8" }).filter((path) => path.endsWith(".ts"));
  const codeOf = (isRead: (path: string) => boolean) => sources.filter(isRead).map(read).join("\n");
  const page = codeOf((path) => !/^(pkg|exhibits|text\/(en|de)\.ts)/.test(path));
  const exhibits = codeOf((path) => path.startsWith("exhibits/"));
  const entriesOf = (text: object) =>
    Object.entries(text).flatMap(([part, entries]) =>
      typeof entries === "string" ? [] : Object.keys(entries).map((name) => [part, name] as const),
    );
  for (const [part, name] of entriesOf(await loadText("en")))
    if (!ELSEWHERE.test(`${part}.${name}`))
      assert.match(page, new RegExp(`\\b(${part}|words)\\.${name}\\b`), `${part}.${name}`);
  for (const [part, name] of entriesOf(await exhibitsIn("en")))
    assert.match(exhibits, new RegExp(`\\.${name}\\b`), `${part}.${name}`);
});
