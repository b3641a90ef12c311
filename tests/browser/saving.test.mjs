// Saving what the scene shows: a picture, a run as a film, and the strip of what the nets imagine.

import assert from "node:assert/strict";
import { readFile } from "node:fs/promises";
import { after, before, test } from "node:test";
import { start } from "./harness.mjs";
import { known, openImagined, openPuzzle, says, type } from "./page-actions.mjs";

let session;
before(async () => (session = await start()));
after(() => session.stop());

async function saved(page, act) {
  const [download] = await Promise.all([page.waitForEvent("download", { timeout: 60_000 }), act()]);
  return { name: download.suggestedFilename(), bytes: await readFile(await download.path()) };
}

test("a picture of the scene is a PNG of 1024 x 1024 pixels", async () => {
  const page = await openPuzzle(session);
  const { name, bytes } = await saved(page, () => page.locator("#save-picture").click());
  assert.match(name, /^two-drops.*\.png$/);
  assert.equal(bytes.toString("latin1", 1, 4), "PNG");
  assert.deepEqual([bytes.readUInt32BE(16), bytes.readUInt32BE(20)], [1024, 1024]);
  assert.ok(bytes.length > 5000);
});

test("a run is saved as a film that plays as long as the run", async () => {
  const page = await openPuzzle(session, { reducedMotion: true });
  assert.equal(await page.locator("#save-film").isDisabled(), true);
  const { solving } = await known();
  await type(page, solving);
  await page.locator("#run").click();
  await says(page, /^Solved/);
  const steps = Number(await page.locator("#time").getAttribute("max"));
  const { name, bytes } = await saved(page, () => page.locator("#save-film").click());
  assert.match(name, /\.webm$/);
  assert.equal(bytes.readUInt32BE(0), 0x1a45dfa3, "it begins as Matroska does");
  // The policy of the page itself plays no films.
  const player = await session.open("");
  const seconds = await player.evaluate(async (base64) => {
    const video = document.createElement("video");
    video.src = URL.createObjectURL(
      new Blob([Uint8Array.from(atob(base64), (character) => character.charCodeAt(0))], { type: "video/webm" }),
    );
    await new Promise((resolve, reject) =>
      Object.assign(video, { onloadeddata: resolve, onerror: () => reject(new Error("no film")) }),
    );
    // What was recorded tells its length only when it has been read to its end.
    video.currentTime = 1e6;
    await new Promise((resolve) => (video.ontimeupdate = resolve));
    return video.duration;
  }, bytes.toString("base64"));
  assert.ok(Math.abs(seconds - steps / 60) < 3, `${seconds} s of ${steps / 60} s`);
});

test("recording can be stopped, and ends when the run is left", async () => {
  const page = await openPuzzle(session, { reducedMotion: true });
  await page.locator("#watch").click();
  await page.locator("#save-film").click();
  await page.locator("#save-words").filter({ hasText: "Recording" }).waitFor();
  await page.locator("#save-film").filter({ hasText: "Stop" }).click();
  await page.locator("#save-words").filter({ hasText: "given up" }).waitFor();
  await page.locator("#save-film").click();
  await page.locator("#save-words").filter({ hasText: "Recording" }).waitFor();
  await page.locator("#reset").click();
  await page.locator("#save-words").filter({ hasText: "given up" }).waitFor();
});

test("a browser that fails to record says so, and can be asked again", async () => {
  const page = await openPuzzle(session, { reducedMotion: true });
  await page.locator("#watch").click();
  const failures = [
    () =>
      (MediaRecorder.prototype.start = () => {
        throw new DOMException("no encoder", "NotSupportedError");
      }),
    () =>
      (HTMLCanvasElement.prototype.captureStream = () => {
        throw new DOMException("tainted", "SecurityError");
      }),
  ];
  for (const fail of failures) {
    await page.evaluate(fail);
    await page.locator("#save-film").filter({ hasText: "Save the run" }).click();
    await page.locator("#save-words").filter({ hasText: "could not record the film" }).waitFor();
  }
});

test("the strip shows the puzzle, each map and the run side by side, none of them blank", async () => {
  const page = await openImagined(session, { reducedMotion: true });
  const { solving } = await known();
  await page.locator("#tab-play").click();
  await type(page, solving);
  await page.locator("#run").click();
  await says(page, /^Solved/);
  await page.locator("#tab-imagine").click();
  const { name, bytes } = await saved(page, () => page.locator("#save-strip").click());
  assert.match(name, /^two-drops-.*-strip\.png$/);
  const [cells, side, gap, head] = [7, 320, 16, 60];
  assert.deepEqual([bytes.readUInt32BE(16), bytes.readUInt32BE(20)], [gap + cells * (side + gap), head + side + 44]);
  // The colours of each picture: paper, bodies, and what is imagined or has moved.
  const player = await session.open("");
  const pictures = await player.evaluate(
    async ({ base64, cells, side, gap, head }) => {
      const image = await createImageBitmap(
        new Blob([Uint8Array.from(atob(base64), (character) => character.charCodeAt(0))]),
      );
      const context = new OffscreenCanvas(image.width, image.height).getContext("2d");
      if (!context) throw new Error("no canvas");
      context.drawImage(image, 0, 0);
      return Array.from({ length: cells }, (_, index) =>
        [...context.getImageData(gap + index * (side + gap), head, side, side).data].join(" "),
      );
    },
    { base64: bytes.toString("base64"), cells, side, gap, head },
  );
  assert.equal(new Set(pictures).size, cells, "no two pictures are alike");
  for (const picture of pictures) assert.ok(new Set(picture.match(/(\d+ ){3}\d+/g)).size > 20);
});
