// The page as a whole: header, notice, the scene with its controls and verdict, and next to it panels or puzzles to
// start with.

import { html, nothing } from "lit-html";
import { present } from "../core/change/route.ts";
import { setNotice } from "../core/change/settings.ts";
import { difficulty, introShown, isHome, rarity, taskOfDay } from "../core/derived/home.ts";
import { shownPanel } from "../core/derived/hidden.ts";
import { goal } from "../core/derived/placing.ts";
import { benchmark, rateOf } from "../simulator.ts";
import { controls } from "./controls.ts";
import { header } from "./header.ts";
import { walkthrough } from "./imagine.ts";
import { problem } from "./make.ts";
import { gallery, headline, picks } from "./home.ts";
import { panels } from "./panels.ts";
import { announcement, news } from "./news.ts";
import { dialogs } from "./dialogs.ts";
import type { App, View } from "./view.ts";

export function page(app: App): View {
  const { state } = app.store;
  const { text, route } = state;
  const home = isHome(state);
  const isPresented = route.view === "presentation" && !home;
  return html`<div class="app ${isPresented ? "presentation" : ""}">
    ${app.embedded || isPresented ? nothing : header(app)} ${notice(app)}
    <main class="puzzle ${home ? "home" : shownPanel(state)} ${introShown(state) ? "show" : ""}">
      <div class="goal">${home ? headline(app) : task(app)}</div>
      <section class="scene" aria-label=${text.page.scene}>${app.canvas}${app.loupe}${problem(app)}</section>
      <section class="controls">${controls(app)}</section>
      <section class="news">${news(app)}</section>
      <section class="side">
        ${introShown(state) ? (app.parts > 1 ? picks(app) : nothing) : isPresented ? presented(app) : panels(app)}
      </section>
    </main>
    ${home && app.parts > 2 ? gallery(app) : nothing}
    <p class="unseen" role="status">${announcement(state)}</p>
    ${dialogs(app)}
  </div>`;
}

/** The task, what happens in the puzzle, and how hard it is; in Make, the task alone. */
function task({ store }: App): View {
  const { state } = store;
  const { text, puzzle, device } = state;
  const { id } = puzzle.about;
  const task = html`<p><strong>${text.puzzle.goal(...goal(state))}</strong></p>`;
  // The first change would replace the rest, and move the tabs away from a pointer that presses one to leave a field.
  if (shownPanel(state) === "make") return task;
  const isDaily = id !== null && id === taskOfDay(benchmark(), device.day);
  return html`${isDaily ? html`<p class="daily">${text.home.day}</p>` : nothing} ${task}
    <p class="quiet">
      ${text.puzzle.instructions(puzzle.about)}
      ${id === null ? nothing : text.home.howHard(difficulty(rateOf(id)), rarity(rateOf(id)))}
    </p>`;
}

function presented(app: App): View {
  const { store } = app;
  return html`${shownPanel(store.state) === "imagine" ? walkthrough(app) : nothing}
    <button @click=${() => store.change(present, null)}>${store.state.text.page.leave}</button>`;
}

function notice({ store }: App): View {
  const { notice, text } = store.state;
  if (!notice) return nothing;
  return html`<div class="notice" role="alert">
    <p>${text.page.notice(notice)}</p>
    <button @click=${() => store.change(setNotice, null)}>${text.page.dismiss}</button>
  </div>`;
}
