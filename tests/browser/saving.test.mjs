// Saving what the nets imagine as one picture.

import assert from "node:assert/strict";
import { readFile } from "node:fs/promises";
import { after, before, test } from "node:test";
import { start } from "./harness.mjs";
import { inMore, known, openImagined, says, type } from "./page-actions.mjs";

let session;
before(async () => (session = await start()));
after(() => session.stop());

async function saved(page, act) {
  const [download] = await Promise.all([page.waitForEvent("download", { timeout: 60_000 }), act()]);
  return { name: download.suggestedFilename(), bytes: await readFile(await download.path()) };
}

test("the strip shows the puzzle, each map and the run side by side, none of them blank", async () => {
  const page = await openImagined(session, { reducedMotion: true });
  const { solving } = await known();
  await page.locator("#tab-play").click();
  await type(page, solving);
  await page.locator("#run").click();
  await says(page, /^Solved/);
  await page.locator("#tab-imagine").click();
  const { name, bytes } = await saved(page, () => inMore(page, () => page.locator("#save-strip").click()));
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
