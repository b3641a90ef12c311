// The texts of the exhibits, by language. Separate from those of the page, which does not load them.

import { languageOf } from "./language.ts";
import type { Language } from "./language.ts";
import type { ExhibitText } from "./en/exhibits.ts";

const TEXTS: Record<Language, () => Promise<ExhibitText>> = {
  en: async () => (await import("./en/exhibits.ts")).exhibits,
  de: async () => (await import("./de/exhibits.ts")).exhibits,
};

/** Loads the texts of the language of a tag. */
export async function loadExhibitText(tag: string): Promise<{ language: Language; text: ExhibitText }> {
  const language = languageOf(tag);
  return { language, text: await TEXTS[language]() };
}
