// The page's only live region: a screen reader reads what is announced as soon as there is time, and a later announcement
// replaces one that has not been read yet.

import { byId, setText } from "./dom.js";

const region = byId("announcement");

/** @param {string} sentence */
export function announce(sentence) {
  setText(region, sentence);
}
