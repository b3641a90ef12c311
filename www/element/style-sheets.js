// Reads the style sheets of a puzzle once; all puzzles of a page adopt the same ones.

import { failure } from "../api/failure.js";
import { readFile } from "../api/files.js";
import { text } from "../text/text.js";

const ADDRESSES = [
  new URL("../base.css", import.meta.url),
  new URL("../element/puzzle.css", import.meta.url),
  new URL("../element/panels.css", import.meta.url),
  new URL("../editor/editor.css", import.meta.url),
];

/** @type {Promise<CSSStyleSheet[]> | null} */
let loaded = null;

/** Returns the style sheets. Rejects with a sentence for the person; the next call then tries again. */
export function loadStyleSheets() {
  loaded ??= Promise.all(ADDRESSES.map(readSheet)).catch((error) => {
    loaded = null;
    throw error;
  });
  return loaded;
}

/** @param {URL} address */
async function readSheet(address) {
  const bytes = await readFile(address, (reason, status) =>
    failure("no_style", text.element.style[status === 404 ? "missing" : "unreachable"](reason, address.href)),
  );
  return new CSSStyleSheet().replace(new TextDecoder().decode(bytes));
}
