// The language of the page: English until another is set. Knows nothing of the document.

/** The languages, each by its own name. */
export const LANGUAGES = /** @type {const} */ ({ en: "English", de: "Deutsch" });
/** @typedef {keyof typeof LANGUAGES} Language */

/** @type {Language} */
export let language = "en";

/** @param {Language} name */
export function setLanguage(name) {
  language = name;
}

/**
 * The first of some language tags ("de-AT") that is one of the page's languages; English if none is.
 * @param {readonly (string | null | undefined)[]} tags
 * @returns {Language}
 */
export function firstKnown(tags) {
  const names = tags.map((tag) => tag?.split("-")[0].toLowerCase() ?? "");
  return /** @type {Language} */ (names.find((name) => Object.hasOwn(LANGUAGES, name)) ?? "en");
}
