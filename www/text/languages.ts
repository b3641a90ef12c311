// The languages of the page, and their texts. The English ones define the type of all others; only those of the current
// language are loaded.

export type Text = typeof import("./en.ts");

export type Language = "en" | "de";

export const LANGUAGES: Record<Language, { readonly name: string; load(): Promise<Text> }> = {
  en: { name: "English", load: () => import("./en.ts") },
  de: { name: "Deutsch", load: () => import("./de.ts") },
};

export function loadText(language: Language): Promise<Text> {
  return LANGUAGES[language].load();
}

/** The language of a tag like "de-AT"; null for a language without texts. */
export function languageOf(tag: string): Language | null {
  const [name = ""] = tag.toLowerCase().split("-");
  return Object.hasOwn(LANGUAGES, name) ? (name as Language) : null;
}
