// The header: the open puzzle, the way to others, and the menu.

import { html, nothing } from "lit-html";
import { goBy, goTo, puzzleBy } from "../opening.ts";
import { showAgain } from "../core/change/home.ts";
import { choose } from "../core/change/kept.ts";
import { present } from "../core/change/route.ts";
import { openDialog } from "../core/change/dialog.ts";
import { canGoOn, isHidden } from "../core/derived/hidden.ts";
import { isHome } from "../core/derived/home.ts";
import { taskOf } from "../core/derived/next.ts";
import { PAGES } from "../effects/old-links.ts";
import { LANGUAGES } from "../text/languages.ts";
import { icon } from "./icons.ts";
import type { Theme } from "../core/change/kept.ts";
import type { Language } from "../text/languages.ts";
import type { State } from "../core/state.ts";
import type { App, View } from "./view.ts";

export function header(app: App): View {
  const { store } = app;
  const { state } = store;
  const { text } = state;
  return html`<header>
    ${
      isHidden(state, "puzzles")
        ? html`<span class="brand">${icon("brand")}</span>`
        : html`<a class="brand" href="#" aria-label=${text.page.brand} @click=${() => store.change(showAgain)}
            >${icon("brand")}</a
          >`
    }
    ${isHome(state) ? html`<strong class="picker">${text.page.brand}</strong>` : canGoOn(state) ? picker(app) : title(state)}
    <button class="share" aria-label=${text.page.share} @click=${() => store.change(openDialog, "share")}>
      ${icon("share")}
    </button>
    ${menu(app)}
  </header>`;
}

/** The name of the puzzle, where a lesson offers no others. */
function title({ text, puzzle }: State): View {
  return html`<div class="picker"><h1>${text.puzzle.name(puzzle.about)}</h1></div>`;
}

/** Progress in a lesson. */
function place({ text, puzzle, route: { lesson } }: State): View {
  const index = lesson.indexOf(puzzle.about.id ?? "");
  return index < 0 ? nothing : html`<span>${text.share.place(index + 1, lesson.length)}</span>`;
}

function picker({ store }: App): View {
  const { text, puzzle } = store.state;
  const field = html`<input
    class="number"
    size="9"
    spellcheck="false"
    autocomplete="off"
    ?hidden=${puzzle.about.id === null}
    aria-label=${text.page.number}
    .value=${puzzle.about.id ?? ""}
    @change=${typed}
  />`;
  return html`<nav class="picker">
    ${beside(text.page.previous, "previous", -1)}
    <div class="title">
      <h1>${text.puzzle.name(puzzle.about)}</h1>
      ${store.state.route.lesson.length > 0 ? place(store.state) : field}
    </div>
    ${beside(text.page.next, "next", 1)}
  </nav>`;

  function beside(label: string, sign: "previous" | "next", places: number): View {
    return html`<button
      aria-label=${label}
      aria-disabled=${puzzleBy(store.state, places) === undefined}
      @click=${() => goBy(store, places)}
    >
      ${icon(sign)}
    </button>`;
  }

  function typed({ target }: Event): void {
    const field = target as HTMLInputElement;
    goTo(store, taskOf(field.value) ?? field.value);
    field.value = store.state.puzzle.about.id ?? "";
  }
}

function menu({ store }: App): View {
  const { state } = store;
  const { text, kept } = state;
  return html`<button popovertarget="menu" aria-label=${text.page.menu}>${icon("menu")}</button>
    <div id="menu" popover>
      <div class="items">
        <button @click=${() => store.change(openDialog, "lesson")}>${text.page.titles.lesson}</button>
        ${isHome(state) ? nothing : html`<button @click=${() => store.change(present, "presentation")}>${text.page.present}</button>`}
        <button @click=${() => store.change(openDialog, "about")}>${text.page.titles.about}</button>
      </div>
      <fieldset>
        <legend>${text.page.language}</legend>
        ${Object.entries(LANGUAGES).map(
          ([language, { name }]) =>
            html`<button
              lang=${language}
              aria-pressed=${language === text.language}
              @click=${() => store.change(choose, { language: language as Language })}
            >
              ${name}
            </button>`,
        )}
      </fieldset>
      <fieldset>
        <legend>${text.page.theme}</legend>
        ${(["light", "dark"] satisfies Theme[]).map(
          (one) =>
            html`<button
              aria-pressed=${one === kept.theme}
              @click=${() => store.change(choose, { theme: one === kept.theme ? null : one })}
            >
              ${text.page.themes[one]}
            </button>`,
        )}
      </fieldset>
      <p>
        ${(["learns", "results"] as const).map((exhibit) => html`<a href=${PAGES.get(exhibit)}>${text.page[exhibit]}</a>`)}
      </p>
    </div>`;
}
