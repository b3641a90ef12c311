// Takes the README's picture of the real page: node tests/browser/screenshot.mjs [TASK] A tool, not a test: it asserts
// nothing. The model has played; its last attempt is under way, over two of the maps that it was imagined from.

import { dirname, join } from "node:path";
import { fileURLToPath } from "node:url";
import { start } from "./harness.mjs";

const picture = join(dirname(fileURLToPath(import.meta.url)), "..", "..", "assets", "screenshot.png");
const task = process.argv[2] ?? "00012:037";

const session = await start();
const page = await session.open(`/#task=${task}&layers=target,placement`, {
  viewport: { width: 1280, height: 800 },
  reducedMotion: "reduce",
});
await page.locator("#tab-compare").click();
await page.locator("#model-turn:enabled").click();
await page.locator("#model-turn").filter({ hasText: "The model has played" }).waitFor({ timeout: 120_000 });
await page.locator("#model-attempts [data-act=replay]").last().click();
const time = page.locator("#time");
const last = Number(await time.getAttribute("max"));
await time.fill(String(Math.round(last * 0.93)));
await page.locator("#tab-imagine").click();
await page.waitForTimeout(300);
await page.screenshot({ path: picture });
console.log(`${picture}: ${await page.locator("#status").textContent()}`);
await session.stop();
