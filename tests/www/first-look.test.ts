// The page before its code is there says what the page says then.

import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { test } from "node:test";
import { de } from "../../www/text/de/de.ts";
import { en } from "../../www/text/en/en.ts";

test("index.html has the words of the home page in each language", () => {
  const html = readFileSync("www/index.html", "utf8");
  for (const { language, home } of [en, de])
    for (const words of [home.title, home.about]) assert.ok(html.includes(`lang="${language}">${words}<`), words);
});
