// The panel Predict: what to do, and two buttons; the large one lets the scene run.

import { html } from "lit-html";
import { place } from "../core/change/placement.ts";
import { wipe } from "../core/change/sketch.ts";
import type { App, View } from "./view.ts";

export function predict({ store }: App): View {
  const { text, sketch, placement } = store.state;
  return html`<p>${text.predict.intro}</p>
    <div class="row">
      <button ?disabled=${sketch.line.length === 0} @click=${() => store.change(wipe)}>${text.predict.wipe}</button>
      <button ?disabled=${placement.ball === null} @click=${() => store.change(place, null, null)}>
        ${text.predict.noBall}
      </button>
    </div>
    <p class="quiet by-keys">${text.predict.keys}</p>`;
}
