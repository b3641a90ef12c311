// The languages of the page.

export const LANGUAGES = ["en", "de"] as const;
export type Language = (typeof LANGUAGES)[number];

/** The language of a tag like "de-AT"; English for languages without texts. */
export function languageOf(tag: string): Language {
  const [name] = tag.toLowerCase().split("-");
  return LANGUAGES.find((one) => one === name) ?? "en";
}
