// Shows which model plays, whether it is loaded, and whether it was trained on the open puzzle.

import { html, nothing } from "lit-html";
import { startModel } from "../core/change/model.ts";
import type { App, View } from "./view.ts";

export function badge({ store }: App): View {
  const { model, answers, puzzle, kept, text } = store.state;
  switch (model.kind) {
    case "off":
      return nothing;
    case "loading":
      return html`<p class="quiet">
        ${text.page.loading(model.arrived)} <progress .value=${model.arrived} aria-hidden="true"></progress>
      </p>`;
    case "failed":
      return html`<p class="trouble">
        ${text.page.noModel(model.failure)}
        <button title=${model.failure.reason} @click=${() => store.change(startModel)}>${text.page.retry}</button>
      </p>`;
    case "ready": {
      if (answers.practised === null) return nothing;
      const unseen = text.model.unseen[puzzle.about.id ? kept.model : "custom"];
      return html`<p class=${answers.practised ? "practised" : "quiet"} title=${text.model.names[kept.model]}>
        <b>${text.model.short[kept.model]}.</b> ${answers.practised ? text.model.practised[kept.model] : unseen}
      </p>`;
    }
  }
}
