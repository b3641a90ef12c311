// Draws the icons of the web manifest from www/icon.svg: node tests/browser/icons.mjs
// A tool; dist.test.mjs checks that what it draws is what is committed.

import { mkdir, readFile, writeFile } from "node:fs/promises";
import { dirname, join } from "node:path";
import { fileURLToPath } from "node:url";
import { launch } from "./harness.mjs";

export const page = join(dirname(fileURLToPath(import.meta.url)), "..", "..", "www");

/**
 * The icons: side in px, how much of it the mark takes, and the colour behind it. Launchers cut maskable ones to any
 * shape.
 */
const ICONS = [
  { path: "icons/icon-192.png", side: 192, share: 1, ground: "transparent" },
  { path: "icons/icon-512.png", side: 512, share: 1, ground: "transparent" },
  { path: "icons/maskable-512.png", side: 512, share: 0.62, ground: "#fdfcf9" },
];

/**
 * Draws all icons: their path and their PNG.
 * @param {import('playwright-core').Browser} browser
 */
export async function drawIcons(browser) {
  const svg = await readFile(join(page, "icon.svg"), "base64");
  const drawn = [];
  for (const { path, side, share, ground } of ICONS) {
    const tab = await browser.newPage({ viewport: { width: side, height: side } });
    await tab.setContent(`<style>body { margin: 0; height: 100vh; display: grid; place-items: center; background: ${ground} }</style>
      <img width="${side * share}" src="data:image/svg+xml;base64,${svg}">`);
    drawn.push({ path, side, png: await tab.screenshot({ omitBackground: true }) });
    await tab.close();
  }
  return drawn;
}

if (process.argv[1] === fileURLToPath(import.meta.url)) {
  const browser = await launch();
  await mkdir(join(page, "icons"), { recursive: true });
  for (const { path, png } of await drawIcons(browser)) await writeFile(join(page, path), png);
  await browser.close();
}
