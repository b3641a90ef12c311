// Reads the style sheets of a puzzle once; all puzzles of a page adopt the same ones.

import { readFile } from "../api/files.js";

const ADDRESSES = [new URL("../base.css", import.meta.url), new URL("./puzzle.css", import.meta.url), new URL("./panels.css", import.meta.url)];

/** Resolves to the style sheets. Rejects with a sentence for the person. */
export const styleSheets = Promise.all(ADDRESSES.map(readSheet));

// The element handles the rejection, but may attach its handler only later.
styleSheets.catch(() => {});

/** @param {URL} address */
async function readSheet(address) {
  const bytes = await readFile(address, (reason) => new Error(`Pathlight’s style sheet could not be loaded: ${reason} for ${address}. Load the page again.`));
  return new CSSStyleSheet().replace(new TextDecoder().decode(bytes));
}
