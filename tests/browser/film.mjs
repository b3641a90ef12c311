// Films the README's animation from the real page: node tests/browser/film.mjs. A tool, not a test: it asserts nothing.
// The walkthrough tells what the model imagines and what its ball does; then a ball of a person's drops against it. The
// page's clock is stopped between two frames of a run, so that it moves evenly on a slow machine too.

import { writeFile } from "node:fs/promises";
import { dirname, join } from "node:path";
import { fileURLToPath } from "node:url";
import gifenc from "gifenc";
import { PNG } from "pngjs";
import { painted, start } from "./harness.mjs";
import { button, place, says } from "./player.mjs";

const { GIFEncoder, applyPalette, quantize } = gifenc;

const OUT = join(dirname(fileURLToPath(import.meta.url)), "../../assets/film.gif");
const TASK = "00002:017";
/** A ball that misses, so that the film ends with a question. */
const BALL = [176, 170, 16];
const VIEWPORT = { width: 960, height: 600 };
/** Pixels of the film for each of the page. */
const SCALE = 0.75;
const [WIDTH, HEIGHT] = [VIEWPORT.width * SCALE, VIEWPORT.height * SCALE];
/** How long a step is looked at, and a result, ms. */
const [LOOK, RESULT] = [1800, 3500];
/** Time on the page between two frames of a run, and how long each is shown, ms: it plays faster than it happens. */
const [RUN_FRAME, RUN_LOOK] = [200, 100];
/** More frames than any run has. */
const MOST_FRAMES = 300;
/** Colours of the film; one more is left for what does not change. */
const COLOURS = 127;

const session = await start();
const page = await session.open("", { viewport: VIEWPORT, deviceScaleFactor: SCALE });
await page.clock.install();
await page.goto(`${session.origin}/#task=${TASK}&panel=imagine`);
await page.getByRole("group", { name: "Maps over the scene" }).waitFor();

/** @type {{ pixels: Uint8Array, delay: number }[]} */
const frames = [];
await take(LOOK);
for (let step = 1; step < 6; step++) {
  await button(page, new RegExp(`^Step ${step}`)).click();
  if (step === 5) await says(page, /It considered/);
  await painted(page);
  await take(LOOK);
}
await filmRun(/^Step 6/);
await page.getByRole("tab", { name: "Play" }).click();
await place(page, BALL, TASK);
await page.waitForFunction(() => document.querySelector(".hint")?.textContent === "Ready. Drop it!");
await painted(page);
await take(LOOK);
await filmRun("Drop it");
await session.stop();

const gif = encode();
await writeFile(OUT, gif);
console.log(`${OUT}: ${frames.length} frames, ${(gif.length / 1000).toFixed(0)} kB`);

/** Begins a run by a button, and films it to its verdict. */
async function filmRun(name) {
  await page.clock.pauseAt(await page.evaluate(() => Date.now() + 500));
  await button(page, name).click();
  for (let count = 0; (await page.locator(".verdict").count()) === 0; count++) {
    if (count > MOST_FRAMES) throw new Error("the run does not end");
    await page.clock.runFor(RUN_FRAME);
    await take(RUN_LOOK);
  }
  await page.clock.resume();
  await painted(page);
  await take(RESULT);
}

/** Adds what the page shows, for a while, ms. */
async function take(delay) {
  frames.push({ pixels: new Uint8Array(PNG.sync.read(await page.screenshot()).data), delay });
}

/** Returns the frames as a GIF. What does not change from frame to frame is transparent, which compresses well. */
function encode() {
  const palette = quantize(new Uint8Array(Buffer.concat(frames.map(({ pixels }) => pixels))), COLOURS);
  const gif = GIFEncoder();
  let last = new Uint8Array();
  for (const [index, { pixels, delay }] of frames.entries()) {
    const picture = applyPalette(pixels, palette);
    const changes = picture.map((colour, at) => (colour === last[at] ? palette.length : colour));
    gif.writeFrame(index === 0 ? picture : changes, WIDTH, HEIGHT, {
      palette: index === 0 ? [...palette, [0, 0, 0]] : undefined,
      delay,
      dispose: 1,
      transparent: index > 0,
      transparentIndex: palette.length,
    });
    last = picture;
  }
  gif.finish();
  return gif.bytes();
}
