// Shared code of the exhibits: separate pages that use the public package and, from the main page, only its texts.
// first-look.js has set language and theme.

import { html, render } from "lit-html";
import { languageOf } from "../text/languages.ts";
import type { TemplateResult } from "lit-html";
import type { ExhibitText } from "../text/exhibits-en.ts";

const page = document.getElementById("page")!;
const root = document.documentElement;
const darkScheme = matchMedia("(prefers-color-scheme: dark)");

export const still = matchMedia("(prefers-reduced-motion: reduce)");

export function isDark(): boolean {
  return (root.dataset.theme ?? (darkScheme.matches ? "dark" : "light")) === "dark";
}

export async function loadText(): Promise<ExhibitText> {
  const language = languageOf(root.lang) ?? "en";
  const { exhibits } = await import(`../text/exhibits-${language}.ts`);
  root.lang = language;
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
