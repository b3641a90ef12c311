// All text that a person reads, in the language of the page: `text.play.run`. It is read when it is shown, never while
// a module loads: the language is known only then. The folders en/ and de/ hold the words, a file for each part of the
// page; tsc compares the two.

import { en } from "./en/index.js";
import { LANGUAGES, firstKnown, language, setLanguage } from "./language.js";

/** @type {import("./en/index.js").Catalogue} */
export let text = en;

/** @type {Record<import("./language.js").Language, () => Promise<import("./en/index.js").Catalogue>>} */
const CATALOGUES = {
  en: async () => en,
  // By the path from another folder: in a bundle this import stays, in a file that lies in one.
  de: async () => (await import("../text/de/index.js")).de,
};

/**
 * Loads the words of the first language among some tags that the page has. If they do not come, the page stays as it
 * is.
 * @param {(string | null | undefined)[]} tags "de-AT", …
 */
export async function useLanguage(...tags) {
  const name = firstKnown(tags);
  if (name === language) return;
  try {
    text = await CATALOGUES[name]();
    setLanguage(name);
  } catch {
    console.warn(`The words in ${LANGUAGES[name]} could not be loaded.`);
  }
}
