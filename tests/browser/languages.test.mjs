// The page speaks the language of the browser, or the one that its address asks for, and says nothing that is not in
// the catalogue: in a language that marks all its words, no text of any view stands outside of a mark.

import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import { axeFindsNothingInLightAndDark } from "./axe.mjs";
import { start } from "./harness.mjs";
import { EASY, becomeRegular, known, openPanel, openPuzzle, type } from "./page-actions.mjs";

let session;
before(async () => (session = await start({ sources: true })));
after(() => session.stop());

const GERMAN = { locale: "de-AT" };

/** The German catalogue of the page is replaced by the English one with a mark around everything. */
const MARKED = `
import { en } from "../en/index.js";
const marked = (entry) => {
  if (typeof entry === "string") return "⟦" + entry + "⟧";
  if (typeof entry === "function") return (...values) => marked(entry(...values));
  if (Array.isArray(entry)) return entry.map(marked);
  return entry && typeof entry === "object"
    ? Object.fromEntries(Object.entries(entry).map(([id, value]) => [id, marked(value)]))
    : entry;
};
export const de = marked(en);
`;

/** Names that are the same in all languages, and what a key or a number has for a sign. */
const NAMES =
  /[A-Z]\w+ et al\. \(\d+\)|DQN|RAND|RPIN|Pathlight|PHYRE|AUCCESS|within-\d|cross-\d|CSV|Deutsch|English|Esc|Ctrl|Shift|Space|PgUp|PgDn|ms|px/g;

/** In a page: the visible text of the document and of each shadow tree, a string each, and what elements are called. */
function visibleTexts() {
  /** @type {string[]} */
  const texts = [];
  const look = (/** @type {Document | ShadowRoot} */ root) => {
    const walker = document.createTreeWalker(root, NodeFilter.SHOW_TEXT);
    let whole = "";
    while (walker.nextNode()) {
      const parent = walker.currentNode.parentElement;
      if (parent?.checkVisibility() && !/^(SCRIPT|STYLE|TITLE)$/.test(parent.tagName))
        whole += ` ${walker.currentNode.textContent}`;
    }
    texts.push(whole);
    for (const element of root.querySelectorAll("*")) {
      if (element.shadowRoot) look(element.shadowRoot);
      if (element.checkVisibility())
        for (const name of ["title", "aria-label", "alt", "aria-valuetext", "aria-roledescription"])
          texts.push(element.getAttribute(name) ?? "");
    }
  };
  look(document);
  return texts;
}

/**
 * @param {import("playwright-core").Page} page
 * @param {string} view
 */
async function everythingIsMarked(page, view) {
  const unmarked = (await page.evaluate(visibleTexts)).map((text) => {
    let rest = text;
    // From the inside out: what a text is given may be marked too.
    for (let before = ""; before !== rest; rest = rest.replace(/⟦[^⟦⟧]*⟧/g, "|")) before = rest;
    return rest.replace(NAMES, "").match(/\p{L}{2}[^|]*/u)?.[0];
  });
  assert.deepEqual([...new Set(unmarked.filter((rest) => rest !== undefined))], [], view);
}

test("a German browser gets German, and the address may ask for another language", async () => {
  const page = await session.open("/", GERMAN);
  await page.locator("#templates canvas.drawn").first().waitFor();
  assert.equal(await page.locator("html").getAttribute("lang"), "de");
  assert.match(await page.locator("#gallery-title").textContent(), /KI/);
  await page.locator("#languages a").click();
  await page.waitForURL(/[?]lang=en/);
  await page.locator("#templates canvas.drawn").first().waitFor();
  assert.equal(await page.locator("html").getAttribute("lang"), "en");
  assert.match(await page.locator("#gallery-title").textContent(), /tiny AI/);
});

test("a German puzzle is played in German, and nothing about it is unreadable", async () => {
  const page = await openPuzzle(session, { ...GERMAN, reducedMotion: true });
  assert.match(await page.locator("#goal").textContent(), /^Die grüne Kugel soll 3 Sekunden lang/);
  await axeFindsNothingInLightAndDark(page, "Play in German");
  await type(page, (await known()).solving);
  await page.locator("#run").click();
  await page.locator("#status[data-kind=solved]").waitFor();
  await page.locator("#race-it:enabled").click();
  await page
    .locator("#race-verdict")
    .filter({ hasText: /Das Modell hat es|Du hast es|Du und das Modell/ })
    .waitFor();
  for (const panel of ["imagine", "make"]) {
    await openPanel(page, panel);
    await axeFindsNothingInLightAndDark(page, `${panel} in German`);
  }
});

test("words that cannot be loaded leave the page in English", async () => {
  const page = await session.open("", GERMAN);
  await page.route("**/text/de/index.js", (route) => route.abort());
  await page.goto(`${session.origin}/`);
  await page.locator("#templates canvas.drawn").first().waitFor();
  assert.match(await page.locator("#gallery-title").textContent(), /tiny AI/);
  assert.equal(await page.locator("html").getAttribute("lang"), "en");
  session.takeProblems();
});

test("no view has words that are not in the catalogue", async () => {
  const page = await session.open("", { ...GERMAN, reducedMotion: "reduce" });
  await page.route("**/text/de/index.js", (route) =>
    route.fulfill({ body: MARKED, contentType: "text/javascript; charset=utf-8" }),
  );
  await page.addInitScript(becomeRegular);
  await page.goto(`${session.origin}/`);
  await page.locator("#templates canvas.drawn").first().waitFor();
  await everythingIsMarked(page, "home");
  for (const view of ["results", "learns"]) {
    await page.goto(`${session.origin}/#view=${view}`);
    await page.locator(`#${view}-body`).waitFor();
    await everythingIsMarked(page, view);
  }
  await page.goto(`${session.origin}/#task=${EASY}&ball=30,200,8&forecast=on`);
  await page.locator("#puzzle [inert]").first().waitFor({ state: "detached" });
  await page.locator("#forecast-words").filter({ hasText: "%" }).waitFor();
  await everythingIsMarked(page, "Play");
  await page.locator("#run").click();
  await page.locator("#status[data-kind=solved], #status[data-kind=missed]").waitFor();
  await page.locator("#race-it:enabled").click();
  await page.locator("#race-verdict").filter({ hasText: "odel" }).waitFor();
  await everythingIsMarked(page, "after a race");
  for (const panel of ["imagine", "predict", "map", "compare", "make"]) {
    await openPanel(page, panel);
    await everythingIsMarked(page, panel);
  }
  for (const button of ["keys-button", "about-button", "share-button"]) {
    await page.locator(`#${button}`).click();
    await page.locator("dialog[open]").waitFor();
    await everythingIsMarked(page, button);
    await page.keyboard.press("Escape");
  }
});
