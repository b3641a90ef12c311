// Current messages: the ball's place, or the verdict of a round.

import { html, nothing } from "lit-html";
import { openDialog } from "../core/change/dialog.ts";
import { show } from "../core/change/run.ts";
import { searched, shownSolution } from "../core/derived/check.ts";
import { introMiss, introPhase, introShown } from "../core/derived/home.ts";
import { attempts, attemptLimitReached, modelSolvedAt, playerSolvedAt, verdict } from "../core/derived/duel.ts";
import { endsLesson, shownPanel } from "../core/derived/hidden.ts";
import { favourite } from "../core/derived/imagined.ts";
import { fault, goal } from "../core/derived/placing.ts";
import { prediction } from "../core/derived/prediction.ts";
import { ended } from "../core/derived/run.ts";
import { sameBall } from "../core/puzzle.ts";
import { stepWords } from "./imagine.ts";
import { madeInWords, problemsHere } from "./make.ts";
import type { Verdict } from "../core/derived/duel.ts";
import type { State } from "../core/state.ts";
import type { App, View } from "./view.ts";

export function news(app: App): View {
  const { state } = app.store;
  const found = result(state);
  if (found)
    return html`<div class="verdict">
      <p class="outcome">${found[0]}</p>
      <p>${found[1]}</p>
    </div>`;
  const told = verdict(state);
  if (!told) return html`<p class="hint">${hint(state)}</p>`;
  const isWon = told.outcome === "won" || (told.outcome === "solved" && state.route.challenge !== null);
  return html`<div class="verdict ${told.outcome}">
    <p class="outcome">${state.text.play.verdict(told)}</p>
    ${details(state, told).map((sentence) => html`<p>${sentence}</p>`)} ${unveil(app)}
    ${
      isWon && !app.embedded
        ? html`<button @click=${() => app.store.change(openDialog, "share")}>${state.text.share.send}</button>`
        : nothing
    }
  </div>`;
}

/** The same for a screen reader, once nothing moves; otherwise it would never stop reading. */
export function announcement(state: State): string {
  const { placement, sketch, make, run, check } = state;
  if (placement.drag || sketch.drawing || make?.drag || run?.playing || check?.seeking || introShown(state)) return "";
  const panel = shownPanel(state);
  if (panel === "make" && !run && !searched(state)) return madeInWords(state) || hint(state);
  const found = result(state);
  if (found) return found.join(" ");
  const told = verdict(state);
  if (told) return [state.text.play.verdict(told), ...details(state, told)].join(" ");
  const isStep = panel === "imagine" && !run && !fault(state) && (state.route.step !== null || !placement.ball);
  return isStep ? stepWords(state) : hint(state);
}

/** Describes the scene for people who cannot see it. */
export function description(state: State): string {
  const { puzzle, placement, text } = state;
  const [object, target] = goal(state);
  const others = puzzle.scene.bodies.filter((body) => body !== object && body !== target);
  const panel = shownPanel(state);
  const first =
    panel === "make"
      ? text.make.hint
      : panel === "predict"
        ? `${text.predict.draw} ${text.predict.keys}`
        : `${text.play.placeFirst} ${text.play.keys}`;
  const where = placement.ball ? text.puzzle.ballAt(...placement.ball) : first;
  return [text.puzzle.goal(object, target), text.puzzle.scene(object, target, others), where].join(" ");
}

/** The outcome of a prediction, or of the model's favourite at the end of its walkthrough. */
function result(state: State): [outcome: string, details: string] | null {
  const { text } = state;
  const predicted = prediction(state);
  if (predicted) return [text.predict.result(predicted.you, predicted.model), text.predict.measured];
  const ran = favourite(state);
  if (!ran) return null;
  const { ending, line } = ran.facts;
  return [text.imagine.ended(ending.solved, ran.chance), text.imagine.off(ran.off, line.ball![2])];
}

function hint(state: State): string {
  const { text, puzzle, placement, route, run } = state;
  if (introShown(state)) return caption(state);
  const panel = shownPanel(state);
  const wrong = fault(state);
  const looked = searched(state);
  if (run && !ended(state)) return text.play.running;
  if (run) return sameBall(run.balls[0]!.ball, shownSolution(state)) ? text.check.shown : "";
  if (looked) return text.check.found(looked);
  if (panel === "make") return problemsHere(state).length ? text.make.broken : text.make.hint;
  if (wrong) return text.puzzle.fault(wrong, puzzle.scene.bodies);
  if (attemptLimitReached(state)) return text.play.full;
  if (placement.dropped) return text.play.choosing;
  if (panel === "predict") return state.sketch.line.length > 1 ? text.predict.drawn : text.predict.draw;
  if (panel === "imagine" && !placement.ball) return "";
  if (placement.ball) return text.play.ready;
  return route.challenge && attempts(state).length === 0 ? text.share.challenge(route.challenge) : text.play.placeFirst;
}

/** Caption of the show on the home page. */
function caption(state: State): string {
  const { futures } = state.answers;
  if (!futures) return state.text.home.waiting;
  switch (introPhase(state)) {
    case "imagine":
      return state.text.home.imagine(futures.futures.length);
    case "pick":
      return state.text.home.pick(futures.imagined.probability);
    case "real":
      return state.text.home.real;
    case "result": {
      const { solved, off } = introMiss(state)!;
      return state.text.home.result(solved, off, futures.ball[2]);
    }
  }
}

function details(state: State, told: Verdict): string[] {
  const { text, route } = state;
  const { facts, guessed, luck } = told;
  return [
    facts.ending.solved ? null : text.play.miss(told),
    facts.ending.solved && route.challenge ? text.share.challenged(told.round, route.challenge) : null,
    facts.ending.solved && endsLesson(state) ? text.share.lastPuzzle : null,
    luck && text.play.luck(luck.kind, luck.solved, luck.valid),
    guessed && text.play.guessed(guessed.chance, guessed.off, facts.line.ball![2]),
  ].filter((sentence) => sentence !== null);
}

/** The model's solution is hidden until the person asks for it, so that the puzzle stays theirs. */
function unveil({ store }: App): View {
  const modelAt = modelSolvedAt(store.state);
  if (modelAt === null || playerSolvedAt(store.state) !== null) return nothing;
  return html`<button @click=${() => store.change(show, modelAt, true)}>${store.state.text.play.showModel}</button>`;
}
