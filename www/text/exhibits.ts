// The texts of the exhibits, by language. Apart from those of the page, which does not load them.

import type { Language } from "../core/change/kept.ts";
import type { ExhibitText } from "./en/exhibits.ts";

const LANGUAGES: Record<Language, () => Promise<ExhibitText>> = {
  en: async () => (await import("./en/exhibits.ts")).exhibits,
  de: async () => (await import("./de/exhibits.ts")).exhibits,
};

/** Loads the texts of a language tag like "de-AT"; the English ones for all that there are none for. */
export async function loadExhibitText(tag: string): Promise<{ language: Language; text: ExhibitText }> {
  const language = (Object.keys(LANGUAGES) as Language[]).find((one) => tag.split("-")[0] === one) ?? "en";
  return { language, text: await LANGUAGES[language]() };
}
