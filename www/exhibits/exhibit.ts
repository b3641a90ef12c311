// Shared code of the exhibits: separate pages that use the public package and, from the main page, only its texts.
// Language and theme are passed in the address: learns.html?lang=de&theme=dark.

import { html, render } from "lit-html";
import { languageOf } from "../text/languages.ts";
import type { TemplateResult } from "lit-html";
import type { ExhibitText } from "../text/exhibits-en.ts";

const page = document.getElementById("page")!;
const asked = new URLSearchParams(location.search);
const darkScheme = matchMedia("(prefers-color-scheme: dark)");

export const still = matchMedia("(prefers-reduced-motion: reduce)");

export function isDark(): boolean {
  return (asked.get("theme") ?? (darkScheme.matches ? "dark" : "light")) === "dark";
}

export async function loadText(): Promise<ExhibitText> {
  const language = languageOf(asked.get("lang") ?? navigator.language) ?? "en";
  const { exhibits } = await import(`../text/exhibits-${language}.ts`);
  const theme = asked.get("theme");
  document.documentElement.lang = language;
  if (theme) document.documentElement.dataset.theme = theme;
  // Remove the placeholder once the texts are loaded.
  page.replaceChildren();
  return exhibits;
}

/** Renders an exhibit under its title, with a link back. */
export function show(text: ExhibitText, title: string, body: TemplateResult): void {
  document.title = `${title} · Pathlight`;
  const whole = html`<main class="exhibit">
    <a class="back" href="./">← ${text.back}</a>
    <h1>${title}</h1>
    ${body}
  </main>`;
  render(whole, page);
}

export function onDarkChange(act: () => void): void {
  darkScheme.addEventListener("change", act);
}

/** The address of a puzzle on the page. */
export const puzzleAddress = (task: string): string => `./#task=${task}`;
