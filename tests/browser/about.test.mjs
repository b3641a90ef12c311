// The sheet “About Pathlight”, from the grid and from the panel Imagine: the paper, the benchmark, and the model's
// card.

import assert from "node:assert/strict";
import { open } from "node:fs/promises";
import { dirname, join } from "node:path";
import { fileURLToPath } from "node:url";
import { after, before, test } from "node:test";
import { start } from "./harness.mjs";
import { openPuzzle } from "./page-actions.mjs";

const ASSETS = join(dirname(fileURLToPath(import.meta.url)), "..", "..", "assets");

let session;
before(async () => (session = await start()));
after(() => session.stop());

/** The card in a weights file: a safetensors file begins with the length of its JSON header. */
async function card(file) {
  const weights = await open(join(ASSETS, file));
  try {
    const { buffer: size } = await weights.read(Buffer.alloc(8), 0, 8, 0);
    const { buffer: header } = await weights.read(
      Buffer.alloc(Number(size.readBigUInt64LE())),
      0,
      Number(size.readBigUInt64LE()),
      8,
    );
    return JSON.parse(JSON.parse(header.toString()).__metadata__.pathlight);
  } finally {
    await weights.close();
  }
}

test("the sheet names the paper, the benchmark and what the model learned from", async () => {
  const page = await openPuzzle(session, { fragment: "&panel=imagine" });
  const [entry] = await page.evaluate(async () => (await (await fetch("assets/model.json")).json()).models);
  const { samples, tasks, epochs } = await card(entry.file);
  await page.locator("#more-button").click();
  await page.locator("#more [data-opens=about-dialog]").click();
  const about = page.locator("#about-dialog[open]");
  const text = await about.textContent();
  for (const said of ["Solving Physics Puzzles by Reasoning about Paths", "Harter", "2020", "PHYRE"])
    assert.ok(text.includes(said), said);
  await about.locator("#card").filter({ hasText: entry.name }).waitFor();
  const { dynamics, success } = await card(entry.file);
  const saidOfNets = [
    about.locator("#about-nets"),
    page.locator("#imagine-intro"),
    page.locator("[data-map=success] .how"),
  ];
  for (const said of await Promise.all(saidOfNets.map((element) => element.textContent()))) {
    assert.equal(/dynamics net/.test(said), Boolean(dynamics), said);
    assert.equal(/the success net/i.test(said), Boolean(success), said);
  }
  const entries = await about.locator("#card-entries").textContent();
  const said = (number) => number.toLocaleString("en");
  assert.ok(entries.includes(`${said(samples)} solutions of ${said(tasks)} puzzles`), entries);
  assert.ok(entries.includes(`${epochs} times`), entries);
  assert.ok(entries.includes("Dev tasks"), entries);
  const licences = await page.evaluate(
    async (address) => (await fetch(address)).text(),
    await about.locator("#licences").evaluate((link) => link.href),
  );
  for (const part of ["rapier2d", "burn-core", "serde_json", "lean-qr"])
    assert.match(licences, new RegExp(`^${part} [0-9.]+: `, "m"));
  assert.match(licences, /Apache License\n +Version 2.0/);
  await about.getByRole("button", { name: "Close" }).click();
  await about.waitFor({ state: "hidden" });
});

for (const [what, viewport] of Object.entries({
  "a desktop": { width: 1280, height: 800 },
  "a phone": { width: 360, height: 640 },
})) {
  test(`it opens from the grid on ${what} and closes by key`, async () => {
    const page = await session.open("/", { viewport });
    await page.locator("#templates a").first().waitFor();
    await page.locator("#about-button").click();
    await page.locator("#about-title:focus").waitFor();
    const box = await page.locator("#about-dialog[open]").boundingBox();
    assert.ok(
      box && box.x >= 0 && box.x + box.width <= viewport.width && box.height <= viewport.height,
      JSON.stringify(box),
    );
    assert.ok(
      (await page.locator("#about-dialog").evaluate((about) => about.scrollTop)) === 0,
      "it begins at its beginning",
    );
    await page.keyboard.press("Escape");
    await page.locator("#about-dialog").waitFor({ state: "hidden" });
  });
}
