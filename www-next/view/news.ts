// What there is to say now: the ball's place, the verdict of a round.

import { html, nothing } from "lit-html";
import { show } from "../core/change/run.ts";
import { searched } from "../core/derived/check.ts";
import { attemptLimitReached, modelSolvedAt, playerSolvedAt, verdict } from "../core/derived/duel.ts";
import { fault, goal } from "../core/derived/placing.ts";
import { ended } from "../core/derived/run.ts";
import { madeInWords, problemsHere } from "./make.ts";
import type { Verdict } from "../core/derived/duel.ts";
import type { State } from "../core/state.ts";
import type { App, View } from "./view.ts";

export function news(app: App): View {
  const { state } = app.store;
  const told = verdict(state);
  if (!told) return html`<p class="hint">${hint(state)}</p>`;
  return html`<div class="verdict ${told.outcome}">
    <p class="outcome">${state.text.play.verdict(told)}</p>
    ${details(state, told).map((sentence) => html`<p>${sentence}</p>`)} ${unveil(app)}
  </div>`;
}

/** The same for a screen reader, once nothing moves: it would never come to an end. */
export function announcement(state: State): string {
  if (state.placement.drag || state.make?.drag || state.run?.playing || state.check?.seeking) return "";
  if (state.route.panel === "make" && !state.run && !searched(state)) return madeInWords(state) || hint(state);
  const told = verdict(state);
  return told ? [state.text.play.verdict(told), ...details(state, told)].join(" ") : hint(state);
}

/** The scene for people who cannot see it. */
export function description({ puzzle, placement, text, ...state }: State): string {
  const [object, target] = goal({ puzzle, placement, text, ...state });
  const others = puzzle.scene.bodies.filter((body) => body !== object && body !== target);
  const first = state.route.panel === "make" ? text.make.hint : text.play.placeFirst;
  const where = placement.ball ? text.puzzle.ballAt(...placement.ball) : first;
  return [text.puzzle.goal(object, target), text.puzzle.scene(object, target, others), where].join(" ");
}

function hint(state: State): string {
  const { text, puzzle, placement, route, run } = state;
  const wrong = fault(state);
  const looked = searched(state);
  if (run) return ended(state) ? "" : text.play.running;
  if (looked) return text.check.found(looked);
  if (route.panel === "make") return problemsHere(state).length ? text.make.broken : text.make.hint;
  if (wrong) return text.puzzle.fault(wrong, puzzle.scene.bodies);
  if (attemptLimitReached(state)) return text.play.full;
  return placement.ball ? text.play.ready : text.play.placeFirst;
}

function details({ text }: State, told: Verdict): string[] {
  const { facts, guessed, luck, radius } = told;
  return [
    facts.ending.solved ? null : text.play.miss(told),
    luck && text.play.luck(luck.solved, luck.valid),
    guessed && text.play.guessed(guessed.chance, guessed.off, radius),
  ].filter((sentence) => sentence !== null);
}

/** The model's solution is veiled until it is asked for, so that the puzzle stays the person's. */
function unveil({ store }: App): View {
  const modelAt = modelSolvedAt(store.state);
  if (modelAt === null || playerSolvedAt(store.state) !== null) return nothing;
  return html`<button @click=${() => store.change(show, modelAt, true)}>${store.state.text.play.showModel}</button>`;
}
