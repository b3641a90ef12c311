// Takes pictures of every view, in all sizes, light and dark, English and German, into target/pictures, for people to
// look at: make pictures, or node tests/browser/pictures.mjs VIEW… A tool, not a test: it asserts nothing.

import { mkdir } from "node:fs/promises";
import { dirname, join } from "node:path";
import { fileURLToPath } from "node:url";
import { painted, start } from "./harness.mjs";
import { EASY, known } from "./player.mjs";

const OUT = join(dirname(fileURLToPath(import.meta.url)), "../../target/pictures");
const SIZES = [
  { width: 390, height: 844 },
  { width: 390, height: 664 },
  { width: 1280, height: 800 },
  { width: 1920, height: 1080 },
];
const LOOKS = /** @type {const} */ (["light", "dark"]).flatMap((colorScheme) =>
  ["en-GB", "de-DE"].map((locale) => ({ colorScheme, locale })),
);
/** The model solves it with its fourth ball; EASY with its first. */
const PUZZLE = "00007:008";
const ARTICLE = `<!doctype html><html lang="LANGUAGE"><meta name="viewport" content="width=device-width">
  <style>body { font-family: serif; max-width: 40em; margin: 1em auto } html { color-scheme: light dark }</style>
  <script type="module" src="element.js"></script><p>Lorem ipsum dolor sit amet, consectetur adipiscing elit.</p>
  <pathlight-puzzle task="${EASY}"></pathlight-puzzle><p>Sed do eiusmod tempor incididunt ut labore.</p></html>`;

const { missing, solving, invalid } = await known(PUZZLE);
const [lost] = (await known(EASY)).missing;

const ball = (ball, task = PUZZLE) => `#task=${task}&ball=${ball}`;
const large = (page) => page.locator("button.step").click();
const withModel = (page) => page.locator("main p b").first().waitFor();
const verdict = (page) => page.locator(".verdict").waitFor();
const dropped = async (page) => {
  await withModel(page);
  await large(page);
  await verdict(page);
};
const sheet = (number) => async (page) => {
  await page.locator("[popovertarget]").click();
  await page.locator("#menu .items button").nth(number).click();
};
const maps = (page) => page.locator(".maps button").first().waitFor();

/** @type {Record<string, [link: string, act: (page: import("playwright-core").Page) => Promise<unknown>]>} */
const VIEWS = {
  home: ["", (page) => page.locator("ul.kinds canvas.painted").nth(2).waitFor()],
  placing: [ball(missing[0]), withModel],
  invalid: [ball(invalid), withModel],
  running: [
    ball(solving),
    async (page) => {
      await page.emulateMedia({ reducedMotion: "no-preference" });
      await withModel(page);
      await large(page);
      const moment = page.locator(".controls input[type=range]");
      await moment.fill(String(Math.round(Number(await moment.getAttribute("max")) / 2)));
    },
  ],
  missed: [ball(missing[0]), dropped],
  solved: [ball(solving), dropped],
  "model-first": [ball(lost, EASY), dropped],
  challenge: [`${ball(missing[1])}&challenge=2`, (page) => page.getByRole("application").waitFor()],
  imagine: [`#task=${PUZZLE}&panel=imagine&layers=target,placement`, maps],
  ...Object.fromEntries(
    ["base", "target", "action", "placement", "imagined", "run"].map((step) => [
      `imagine-${step}`,
      [`#task=${PUZZLE}&panel=imagine&step=${step}`, step === "run" ? verdict : maps],
    ]),
  ),
  predict: [
    `#task=${PUZZLE}&panel=predict`,
    async (page) => {
      const scene = page.getByRole("application");
      for (const key of ["Down", "Down", "Left", "Down"]) await scene.press(`Shift+Arrow${key}`);
      await large(page);
      await verdict(page);
    },
  ],
  make: [`#task=${PUZZLE}&panel=make`, (page) => page.getByRole("application").press("n")],
  data: [
    ball(missing[0]),
    async (page) => {
      await dropped(page);
      await page.getByRole("tab").last().click();
    },
  ],
  share: [
    ball(solving),
    async (page) => {
      await dropped(page);
      await page.locator("button.share").click();
      await page.locator(".card img").waitFor();
    },
  ],
  lesson: [ball(missing[0]), sheet(0)],
  about: ["", sheet(1)],
  "presentation-imagine": [`#task=${PUZZLE}&panel=imagine&step=run&view=presentation`, verdict],
  presentation: [`${ball(solving)}&view=presentation`, (page) => large(page).then(() => verdict(page))],
  element: ["article", (page) => page.locator("pathlight-puzzle canvas").first().waitFor()],
  learns: [
    "learns.html",
    async (page) => {
      await page.locator(".radios input").last().check();
      await page.locator("button").first().click();
      await page.locator("ol li").nth(2).waitFor({ state: "attached" });
    },
  ],
  results: ["results.html", (page) => page.locator(".tasks a").first().waitFor()],
};

const named = process.argv.slice(2);
const unknown = named.find((name) => !VIEWS[name]);
if (unknown) throw new Error(`there is no view ${unknown}: ${Object.keys(VIEWS).join(", ")}`);

await mkdir(OUT, { recursive: true });
const session = await start();
for (const name of named.length ? named : Object.keys(VIEWS))
  for (const viewport of SIZES) await Promise.all(LOOKS.map((look) => takeView(name, { viewport, ...look })));
await session.stop();
console.log(OUT);

async function takeView(name, { viewport, colorScheme, locale }) {
  const isPhone = viewport.width < 500;
  const touch = { isMobile: isPhone, hasTouch: isPhone };
  const page = await session.open("", { viewport, colorScheme, locale, reducedMotion: "reduce", ...touch });
  const body = ARTICLE.replace("LANGUAGE", locale);
  await page.route(/article/, (route) => route.fulfill({ contentType: "text/html", body }));
  const [link, act] = VIEWS[name];
  await page.goto(`${session.origin}/${link}`);
  await act(page);
  const size = `${viewport.width}x${viewport.height}`;
  await take(page, join(OUT, `${name}-${size}-${colorScheme}-${locale.slice(0, 2)}.png`));
  await page.context().close();
}

/** Takes a picture once two are alike, or what still moves has been waited for long enough. */
async function take(page, path) {
  let before = Buffer.alloc(0);
  for (let looks = 0; looks < 10; looks++) {
    const now = await page.screenshot({ path });
    if (now.equals(before)) return;
    before = now;
    await painted(page);
  }
}
