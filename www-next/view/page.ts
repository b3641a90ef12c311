// A puzzle as a whole: header, notice, scene with its controls, verdict and panels.

import { html, nothing } from "lit-html";
import { setNotice } from "../core/change/settings.ts";
import { goal } from "../core/derived/placing.ts";
import { controls } from "./controls.ts";
import { header } from "./header.ts";
import { problem } from "./make.ts";
import { panels } from "./panels.ts";
import { announcement, news } from "./news.ts";
import type { App, View } from "./view.ts";

export function page(app: App): View {
  const { state } = app.store;
  const { text, puzzle } = state;
  return html`<div class="app">
    ${app.embedded ? nothing : header(app)} ${notice(app)}
    <main class="puzzle">
      <div class="goal">
        <p><strong>${text.puzzle.goal(...goal(state))}</strong></p>
        <p class="quiet">${text.puzzle.instructions(puzzle.about)}</p>
      </div>
      <section class="scene" aria-label=${text.page.scene}>${app.canvas}${problem(app)}</section>
      <section class="controls">${controls(app)}</section>
      <section class="news">${news(app)}</section>
      <section class="side">${panels(app)}</section>
    </main>
    <p class="unseen" role="status">${announcement(state)}</p>
  </div>`;
}

function notice({ store }: App): View {
  const { notice, text } = store.state;
  if (!notice) return nothing;
  return html`<div class="notice" role="alert">
    <p>${text.page.notice(notice)}</p>
    <button @click=${() => store.change(setNotice, null)}>${text.page.dismiss}</button>
  </div>`;
}
