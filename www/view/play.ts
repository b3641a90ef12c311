// The panel Play: the duel so far, the model, and the check.

import { html, nothing } from "lit-html";
import { choose } from "../core/change/kept.ts";
import { show } from "../core/change/run.ts";
import { missesInARow, modelSolvedAt, rounds } from "../core/derived/duel.ts";
import { isAlone, isHidden } from "../core/derived/hidden.ts";
import { badge } from "./badge.ts";
import { check } from "./check.ts";
import { checkbox } from "./widgets.ts";
import type { Round } from "../core/derived/duel.ts";
import type { App, View } from "./view.ts";

/** Number of misses in a row after which the check is offered. */
const MISSES = 3;

export function play(app: App): View {
  if (isHidden(app.store.state, "model")) return duel(app);
  return html`${duel(app)} ${badge(app)} ${switches(app)} ${offered(app)}`;
}

function duel({ store }: App): View {
  const { state } = store;
  const { text, run } = state;
  const made = rounds(state);
  const modelAt = modelSolvedAt(state);
  if (made.length === 0) return isAlone(state) ? nothing : html`<p class="quiet">${text.play.noAttempts}</p>`;
  return html`<div class="duel">
    <div class="who" aria-hidden="true">
      <span class="you">${text.play.you}</span>
      ${isAlone(state) ? nothing : html`<span class="model">${text.play.model}</span>`}
    </div>
    <ol aria-label=${text.play.duel}>
      ${made.map(
        (round) =>
          html`<li>
            <button
              aria-label=${named(round)}
              aria-pressed=${run?.round === round.number}
              @click=${() => store.change(show, round.number)}
            >
              <span class=${round.player.status}>${round.player.status === "solved" ? "✓" : "✕"}</span>
              ${isAlone(state) ? nothing : modelMark(round)}
            </button>
          </li>`,
      )}
    </ol>
  </div>`;

  function modelMark({ number, model }: Round): View {
    if (!model) return html`<span class="none">${modelAt !== null && number > modelAt ? nothing : "…"}</span>`;
    return html`<span class=${model.solved ? "solved" : "not_solved"}>${model.solved ? "✓" : "✕"}</span>`;
  }

  function named({ number, player, model }: Round): string {
    const word = (solved: boolean) => (solved ? text.play.solved : text.play.missed);
    const you = `${text.play.round(number)}. ${text.play.you}: ${word(player.status === "solved")}`;
    if (isAlone(state)) return you;
    const rest = modelAt !== null && number > modelAt ? text.play.done : text.play.waiting;
    return `${you}. ${text.play.model}: ${model ? word(model.solved) : rest}`;
  }
}

function switches({ store }: App): View {
  const { kept, route, text } = store.state;
  return html`<div class="switches">
    ${isHidden(store.state, "guess") ? nothing : checkbox(kept.guess, text.play.guess, (guess) => store.change(choose, { guess }))}
    ${route.challenge !== null ? nothing : checkbox(kept.alone, text.play.alone, (alone) => store.change(choose, { alone }))}
  </div>`;
}

function offered(app: App): View {
  const { state } = app.store;
  if (!state.check && missesInARow(state) < MISSES) return nothing;
  return html`${state.check ? nothing : html`<p>${state.text.check.offer}</p>`} ${check(app)}`;
}
