// Puts the words of the catalogue into markup that names them: `data-text="home.title"` for what an element says, which
// may hold tags, and `data-text-title`, `data-text-aria-label`, … for its attributes.

import { text } from "./text.js";

const ATTRIBUTES = ["title", "aria-label", "alt", "content"];

/** @param {ParentNode} root */
export function translate(root) {
  for (const element of root.querySelectorAll("[data-text]"))
    // Nothing but constants: the catalogue holds no text of a link, a file or a model.
    element.innerHTML = wordsOf(element, "data-text");
  for (const name of ATTRIBUTES)
    for (const element of root.querySelectorAll(`[data-text-${name}]`))
      element.setAttribute(name, wordsOf(element, `data-text-${name}`));
}

/**
 * @param {Element} element
 * @param {string} attribute
 */
function wordsOf(element, attribute) {
  const id = element.getAttribute(attribute) ?? "";
  /** @type {unknown} */
  let entry = text;
  for (const name of id.split(".")) entry = Reflect.get(Object(entry), name);
  if (typeof entry !== "string") throw new Error(`The catalogue has no text ${id}`);
  return entry;
}
