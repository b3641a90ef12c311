// The texts of the page. The English ones define the type of all others; only those of the current language are loaded.

import type { Language } from "./language.ts";
import type { en } from "./en/en.ts";

export type Text = typeof en;

export const TEXTS: Record<Language, { readonly name: string; load(): Promise<Text> }> = {
  en: { name: "English", load: async () => (await import("./en/en.ts")).en },
  de: { name: "Deutsch", load: async () => (await import("./de/de.ts")).de },
};

export function loadText(language: Language): Promise<Text> {
  return TEXTS[language].load();
}
