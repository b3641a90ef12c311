// One sentence above everything else: what is wrong, and what the person can do about it; or, for a while at the lower
// edge, what has been done.

import { text } from "../text/text.js";
import { byId, createButton, passFocus } from "./dom.js";

const bar = byId(document, "notice");
/** How long a sentence about what has been done stays, ms. */
const DONE_TIME = 6000;
/** @type {number | undefined} */
let timer;
/** What had the focus before something in the bar: it has it again afterwards. @type {EventTarget | null} */
let focusedBefore = null;

document.addEventListener("focusout", (event) => {
  const enters = event.relatedTarget instanceof Node && bar.contains(event.relatedTarget);
  if (enters && !bar.contains(/** @type {Node} */ (event.target))) [focusedBefore] = event.composedPath();
});

/**
 * Shows a sentence with links and buttons.
 * @param {string} sentence
 * @param {[label: string, action: string | (() => void)][]} [actions] an address to follow, or what a button does
 */
export function showNotice(sentence, actions = []) {
  byId(document, "notice-text").textContent = sentence;
  const controls = actions.map(([label, action]) =>
    typeof action === "string" ? link(label, action) : createButton(label, action),
  );
  const list = byId(document, "notice-actions");
  // A notice about progress changes often: whoever is about to stop it stays there.
  const place = Array.from(list.children).findIndex((control) => control.matches(":focus"));
  list.replaceChildren(...controls, createButton(text.page.widgets.close, dismissNotice));
  bar.classList.remove("done");
  clearTimeout(timer);
  bar.hidden = false;
  const control = list.children[place] ?? list.lastElementChild;
  if (place >= 0) /** @type {HTMLElement} */ (control).focus();
}

/**
 * Says what has been done, off everything else, for a while.
 * @param {string} sentence
 */
export function showDone(sentence) {
  showNotice(sentence);
  bar.classList.add("done");
  timer = setTimeout(dismissNotice, DONE_TIME);
}

export function dismissNotice() {
  if (focusedBefore instanceof HTMLElement) passFocus(bar, focusedBefore);
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
