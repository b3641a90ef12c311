// Takes pictures of all views, on a desktop, a projector and a phone, light and dark, into target/pictures, for people
// to look at: make pictures. A tool, not a test: it asserts nothing. The task is one on which player and model have
// something to show.

import { mkdir } from "node:fs/promises";
import { dirname, join } from "node:path";
import { fileURLToPath } from "node:url";
import { start } from "./harness.mjs";
import { inMore, known, openLesson, openPanel, openPuzzle, playModelTurn, says, type } from "./page-actions.mjs";

const TASK = process.argv[2] ?? "00007:008";
const folder = join(dirname(fileURLToPath(import.meta.url)), "..", "..", "target", "pictures");

const SCREENS = {
  desktop: { viewport: { width: 1280, height: 800 } },
  projector: { viewport: { width: 1920, height: 1080 } },
  phone: { viewport: { width: 390, height: 844 }, isMobile: true, hasTouch: true, deviceScaleFactor: 2 },
};

await mkdir(folder, { recursive: true });
const session = await start();
/** @type {Awaited<ReturnType<typeof known>> | undefined} */
let knownBalls;

for (const [screen, size] of Object.entries(SCREENS)) {
  for (const colorScheme of /** @type {const} */ (["light", "dark"])) {
    const page = await openPuzzle(session, { ...size, task: TASK, reducedMotion: true, colorScheme });
    const balls = (knownBalls ??= await known(TASK));
    const take = async (view) => {
      await page.waitForTimeout(400);
      await page.screenshot({ path: join(folder, `${view}-${screen}-${colorScheme}.png`) });
    };
    const run = async (ball, words) => {
      await type(page, ball);
      await page.locator("#run").click();
      await says(page, words);
    };

    await type(page, balls.missing);
    await take("placing");
    await type(page, balls.invalid);
    await take("invalid");
    await run(balls.missing, /^Not solved/);
    await take("missed");
    await page.locator("#reset").click();

    // The paths that the model imagines for the ball, before and after it has run.
    await page.locator("#forecast-on").setChecked(true);
    await page.locator("#forecast-words").filter({ hasText: "model’s guess:" }).waitFor();
    await take("forecast");
    await run(balls.missing, /^Not solved/);
    await take("forecast-and-real");
    await page.locator("#reset").click();
    await page.locator("#forecast-on").setChecked(false);

    // Half way through a run that is played.
    await page.emulateMedia({ reducedMotion: "no-preference" });
    await run(balls.solving, /is running/);
    await page.locator("#run").click();
    const time = page.locator("#time");
    await time.fill(String(Math.round(Number(await time.getAttribute("max")) * 0.5)));
    await take("running");
    await page.emulateMedia({ reducedMotion: "reduce" });
    await time.fill(await time.getAttribute("max"));
    await says(page, /^Solved/);
    await take("solved");
    await page.locator("#solved-share").click();
    await page.locator("#share-dialog[open]").waitFor();
    await take("share");
    await page.keyboard.press("Escape");
    await page.locator("#play-attempts [data-act=overlay]").first().click();
    await take("overlaid");

    await page.locator("#reset").click();
    await page.locator("#tab-imagine").click();
    await page.locator("#imagined-in").filter({ hasText: "Imagined" }).waitFor();
    await page.locator("[data-map=target] input").check();
    await page.locator("[data-map=placement] input").check();
    await take("imagine");
    await inMore(page, async () => {
      await page.locator("[data-opens=about-dialog]").click();
      await take("about");
      await page.keyboard.press("Escape");
    });

    await openPanel(page, "compare");
    await playModelTurn(page);
    await take("compare");

    await page.locator("#proposal-slider").fill("8");
    await page.locator("#proposals").scrollIntoViewIfNeeded();
    await take("ball-by-ball");
    await page.locator("#proposal-close").click();
    await page.locator("#more-button").click();
    await take("menu");
    await page.locator("#pair-run").click();
    await page.locator("#pair-columns > div").nth(1).waitFor();
    await page.locator("#pair-columns").scrollIntoViewIfNeeded();
    await take("two-models");
    await page.keyboard.press("Escape");

    await page.locator("#tab-imagine").click();
    await page.locator("#overlap-how").scrollIntoViewIfNeeded();
    await take("imagined-and-real");
    await page.locator("#walkthrough-next").click();
    await take("story");
    await page.locator("#walkthrough-dots button:visible").last().click();
    await take("story-ends");
    await page.locator("#scene").press("v");
    await take("presentation");
    await page.keyboard.press("Escape");
    if (screen !== "phone") {
      await openLesson(page);
      await page.locator("#lesson-code:visible").waitFor();
      await take("lesson-link");
      await page.keyboard.press("Escape");
    }

    await openPanel(page, "predict");
    for (const key of ["ArrowDown", "ArrowDown", "ArrowLeft", "ArrowDown", "ArrowDown", "ArrowDown"])
      await page.locator("#scene").press(`Shift+${key}`);
    await page.locator("#predict-watch").click();
    await take("predict");

    await openPanel(page, "map");
    await page.locator("#solve-map-search").click();
    await page.locator("#solve-map-words").filter({ hasText: "Every place tried" }).waitFor({ timeout: 120_000 });
    await page.locator("#solve-map-placement").check();
    await take("map");

    await page.keyboard.press("?");
    await take("keys");
    await page.keyboard.press("Escape");
    await page.locator("#home").click();
    await page.locator("#templates canvas.drawn").first().waitFor();
    await take("grid");
    await page.locator("#results-link").click();
    await page.locator("#results-templates a").first().waitFor();
    await take("results");
    await page.locator("#home").click();
    await page.locator("[data-pick=learns] a").click();
    await page.locator("#learns-play").click();
    await page.locator("#learns-finish").click();
    await page.locator("#learns-play").filter({ hasText: "more" }).waitFor({ timeout: 120_000 });
    await take("learns");
    await page.context().close();
  }
}

await session.stop();
console.log(folder);
