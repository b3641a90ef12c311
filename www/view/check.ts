// The check, for all panels that offer it: where a ball works, and an easy ball.

import { html, nothing } from "lit-html";
import { live } from "lit-html/directives/live.js";
import { setCheckRadius, toggleCheck, toggleSeeking } from "../core/change/check.ts";
import { toggleLayer } from "../core/change/route.ts";
import { agreement, working } from "../core/derived/check.ts";
import { solutions } from "../core/derived/placing.ts";
import { MAX_RADIUS, MIN_RADIUS } from "../pkg/constants.ts";
import { checkbox } from "./widgets.ts";
import type { App, View } from "./view.ts";

export function check({ store }: App): View {
  const { state } = store;
  const { check, text, answers, route, model } = state;
  const found = solutions(state);
  const toggle = checkbox(check !== null, text.check.show, () => store.change(toggleCheck));
  if (!check) return html`<div class="check">${toggle}</div>`;
  const agreed = route.layers.includes("placement") ? agreement(state) : null;
  return html`<div class="check">
    ${toggle}
    <label class="slider">
      <span>${text.check.radius}</span>
      <input
        type="range"
        min=${MIN_RADIUS}
        max=${MAX_RADIUS}
        .value=${live(String(check.radius))}
        @input=${({ target }: Event) => store.change(setCheckRadius, (target as HTMLInputElement).valueAsNumber)}
      />
      <output>${check.radius}</output>
    </label>
    ${model.kind === "failed" && !found ? nothing : html`<p class="quiet">${text.check.tried(found?.progress ?? 0, working(state))}</p>`}
    ${
      answers.maps?.placement
        ? checkbox(route.layers.includes("placement"), text.check.compare, () => store.change(toggleLayer, "placement"))
        : nothing
    }
    ${agreed === null ? nothing : html`<p class="quiet">${text.check.agrees(agreed)}</p>`}
    <button @click=${() => store.change(toggleSeeking)}>${check.seeking ? text.check.stop : text.check.seek}</button>
  </div>`;
}
