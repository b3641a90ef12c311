// One sentence above everything else: what is wrong, and what the person can do about it.

import { byId, createButton } from "./dom.js";

const bar = byId(document, "notice");

/**
 * Shows a sentence with links and buttons.
 * @param {string} sentence
 * @param {[label: string, action: string | (() => void)][]} [actions] an address to follow, or what a button does
 */
export function showNotice(sentence, actions = []) {
  byId(document, "notice-text").textContent = sentence;
  const controls = actions.map(([label, action]) => (typeof action === "string" ? link(label, action) : createButton(label, action)));
  byId(document, "notice-actions").replaceChildren(...controls, createButton("Close", dismissNotice));
  bar.hidden = false;
}

export function dismissNotice() {
  bar.hidden = true;
}

/**
 * @param {string} label
 * @param {string} href
 */
function link(label, href) {
  const element = document.createElement("a");
  element.href = href;
  element.textContent = label;
  return element;
}
