// Films the README's animation from the real page: node tests/browser/film.mjs [TASK] A tool, not a test: it asserts
// nothing. The presentation tells its story: what the model imagines, the ball that it chooses, and what that does. The
// page's clock is stopped between two frames of the run, so that it moves evenly on a slow machine too.

import { writeFile } from "node:fs/promises";
import { dirname, join } from "node:path";
import { fileURLToPath } from "node:url";
import gifenc from "gifenc";
import { PNG } from "pngjs";
import { start } from "./harness.mjs";

const { GIFEncoder, applyPalette, quantize } = gifenc;

const out = join(dirname(fileURLToPath(import.meta.url)), "..", "..", "assets", "film.gif");
const task = process.argv[2] ?? "00002:017";
const [width, height] = [720, 450];
/** The steps of the story that are filmed, and how long each is shown, ms. */
const STEPS = {
  base: 1800,
  target: 1800,
  action: 1800,
  placement: 1800,
  imagined: 2500,
  chosen: 1800,
  run: 100,
  real: 3500,
};
/** Time on the page between two frames of the run, ms; it is played faster than it happens. */
const RUN_FRAME = 200;
/** More frames than any run has. */
const MOST_FRAMES = 300;
/** Colours of the film; one more is left for what does not change. */
const COLOURS = 127;

const session = await start();
const page = await session.open("", { viewport: { width, height } });
await page.clock.install();
await page.goto(`${session.origin}/#task=${task}&view=presentation`);
await page.locator("#imagined-in").filter({ hasText: "Imagined in" }).waitFor({ state: "attached" });

/** @type {{ pixels: Uint8Array, delay: number }[]} */
const frames = [];
await take(1800);
for (let number = 1, count = 1; number <= count; number++) {
  await page.keyboard.press("PageDown");
  const place = page.locator("#caption-step", { hasText: `${number} of` });
  await place.waitFor();
  count = Number((await place.textContent())?.split(" of ")[1]);
  const result = page.locator("#caption-result");
  await result.filter({ hasText: /\S.*\.$/ }).waitFor();
  await result.filter({ hasText: "is choosing" }).waitFor({ state: "detached" });
  const step = await page.evaluate(() => new URLSearchParams(location.hash.slice(1)).get("step"));
  if (step === "run") await filmRun();
  else if (step && step in STEPS) await take(STEPS[step]);
}
await session.stop();

const gif = encode();
await writeFile(out, gif);
console.log(`${out}: ${frames.length} frames, ${(gif.length / 1000).toFixed(0)} kB`);

/** Films the run to its end. */
async function filmRun() {
  const time = page.locator("#time");
  await page.clock.pauseAt(await page.evaluate(() => Date.now() + 500));
  // On a busy machine the run starts after the clock has been stopped.
  for (let last = -1, now = 0; now > last || now === 0; last = now, now = Number(await time.inputValue())) {
    if (frames.length > MOST_FRAMES) throw new Error("the run does not end");
    await take(STEPS.run);
    await page.clock.runFor(RUN_FRAME);
  }
  await page.clock.resume();
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
    gif.writeFrame(index === 0 ? picture : changes, width, height, {
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
