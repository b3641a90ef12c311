// Looks elements up in the page or in the shadow tree of a puzzle, and changes text only where it differs: every
// assignment triggers an announcement and a layout. An element that is missing is a bug of ours, so it throws
// immediately, with its name.

import { text } from "../text/text.js";

/**
 * A tree of elements in which an id is unique.
 * @typedef {Document | ShadowRoot} Root
 */

/**
 * The element of this id, checked to be of a class.
 * @template {Element} [T=HTMLElement]
 * @param {Root} root
 * @param {string} id
 * @param {new () => T} [type] HTMLElement if left out
 * @returns {T}
 */
export function byId(root, id, type) {
  return checked(root.getElementById(id), `#${id}`, type);
}

/**
 * The first descendant that matches, checked to be of a class.
 * @template {Element} [T=HTMLElement]
 * @param {ParentNode} parent
 * @param {string} selector
 * @param {new () => T} [type] HTMLElement if left out
 * @returns {T}
 */
export function find(parent, selector, type) {
  return checked(parent.querySelector(selector), selector, type);
}

/**
 * Gives the focus that is in an element to another: the element is about to be hidden, disabled or removed.
 * @param {Element} from
 * @param {HTMLElement} to
 */
export function passFocus(from, to) {
  if (from.matches(":focus-within")) to.focus({ preventScroll: true });
}

/**
 * Does nothing in the page have the focus, or only something that is now hidden? The browser takes it away a frame
 * later.
 */
export function focusIsLost() {
  let focused = document.activeElement;
  while (focused?.shadowRoot?.activeElement) focused = focused.shadowRoot.activeElement;
  return !focused || focused === document.body || !focused.checkVisibility();
}

/**
 * A copy of what a <template> holds.
 * @param {Root} root
 * @param {string} id
 * @returns {HTMLElement}
 */
export function fromTemplate(root, id) {
  const content = byId(root, id, HTMLTemplateElement).content.firstElementChild;
  return /** @type {HTMLElement} */ (checked(content, `#${id} > *`, HTMLElement).cloneNode(true));
}

/**
 * Returns a new cell of a table.
 * @param {string} words
 */
export function createCell(words) {
  const cell = document.createElement("td");
  cell.textContent = words;
  return cell;
}

/**
 * Returns a new button.
 * @param {string} label
 * @param {() => void} act
 */
export function createButton(label, act) {
  const button = document.createElement("button");
  button.type = "button";
  button.textContent = label;
  button.addEventListener("click", act);
  return button;
}

/**
 * @param {HTMLCanvasElement} canvas
 * @returns {CanvasRenderingContext2D}
 */
export function contextOf(canvas) {
  const context = canvas.getContext("2d");
  if (!context) throw new Error(text.page.broken.noCanvas);
  return context;
}

/**
 * @param {Element} element
 * @param {string} words
 */
export function setText(element, words) {
  if (element.textContent !== words) element.textContent = words;
}

/**
 * @template {Element} T
 * @param {Element | null} element
 * @param {string} selector
 * @param {(new () => T) | undefined} type
 * @returns {T}
 */
function checked(element, selector, type) {
  if (!(element instanceof (type ?? HTMLElement)))
    throw new Error(`The markup has no ${selector} of the class ${(type ?? HTMLElement).name}`);
  return /** @type {T} */ (element);
}
