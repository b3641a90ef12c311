// The attributes of <pathlight-puzzle>, and how they and its properties follow each other.

/** The attributes that make up the state; state/url-state.js knows their values. */
export const STATE_ATTRIBUTES = [
  "task",
  "scene",
  "model",
  "panel",
  "step",
  "view",
  "proposal",
  "layers",
  "opacity",
  "forecast",
  "ball",
  "challenge",
  "hide",
];

/** Old names of attributes, and today's. */
const RENAMED = new Map([["stage", "step"]]);
/** The attributes that are properties too. */
export const PROPERTY_ATTRIBUTES = [...STATE_ATTRIBUTES, ...RENAMED.keys(), "theme"];
/** The attributes that are on or off. */
export const FLAGS = ["fill", "remember"];

/** @param {string} name */
export function currentName(name) {
  return RENAMED.get(name) ?? name;
}

/**
 * @param {Element} element
 * @param {string} name
 * @param {string | null | undefined} value
 */
export function setAttribute(element, name, value) {
  if (value === null || value === undefined) element.removeAttribute(name);
  else if (value !== element.getAttribute(name)) element.setAttribute(name, value);
}

/**
 * The attributes that make up the state.
 * @param {Element} element
 * @returns {[name: string, value: string][]}
 */
export function stateTexts(element) {
  return STATE_ATTRIBUTES.filter((name) => element.hasAttribute(name)).map((name) => [
    name,
    element.getAttribute(name) ?? "",
  ]);
}

/**
 * Sets again the properties that were set before the element was defined: they are the object's own, and hide the
 * accessors.
 * @param {Element} element
 * @param {string[]} names
 */
export function takeEarlyProperties(element, names) {
  for (const name of names) {
    if (!Object.hasOwn(element, name)) continue;
    const value = Reflect.get(element, name);
    Reflect.deleteProperty(element, name);
    Reflect.set(element, name, value);
  }
}
