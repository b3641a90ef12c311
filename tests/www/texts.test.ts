// Texts that no type holds to each other: those that are seen before the page's code is there, and those by template.

import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { test } from "node:test";
import { TEMPLATES } from "../../www/pkg/constants.ts";
import { LANGUAGES } from "../../www/text/language.ts";
import { loadText } from "../../www/text/text.ts";

const read = (file: string) => readFileSync(`www/${file}`, "utf8");

test("what is seen before the code is there has the words of the home page in each language", async () => {
  for (const language of LANGUAGES) {
    const { home } = await loadText(language);
    for (const words of [home.title, home.about])
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
