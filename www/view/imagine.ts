// The panel Imagine: the walkthrough, the maps, and how they are made.

import { html, nothing } from "lit-html";
import { toggleLayer } from "../core/change/route.ts";
import { STEPS, go, goTo, stepIndex, toggleTour } from "../core/change/walkthrough.ts";
import { extent, shownLayers } from "../core/derived/imagined.ts";
import { isDark } from "../core/derived/preferences.ts";
import { goal } from "../core/derived/placing.ts";
import { MAPS } from "../pkg/constants.ts";
import { mapTile } from "../simulator.ts";
import { badge } from "./badge.ts";
import { icon } from "./icons.ts";
import type { Step } from "../core/change/walkthrough.ts";
import type { State } from "../core/state.ts";
import type { MapName } from "../pkg/page/pathlight.js";
import type { Text } from "../text/languages.ts";
import type { App, View } from "./view.ts";

export function imagine(app: App): View {
  const { state } = app.store;
  const { maps } = state.answers;
  return html`${walkthrough(app)} ${maps ? tiles(app, maps) : nothing} ${how(state)} ${badge(app)}`;
}

/** Navigation through the steps, and the content of the current one. */
export function walkthrough(app: App): View {
  const { state } = app.store;
  const { text, route } = state;
  const [name, meaning] = route.step ? text.imagine.steps[route.step] : [];
  return html`${steps(app)}
    <div class="meaning">
      <h2>${name ?? text.imagine.walkthrough}</h2>
      <p>${meaning ?? text.imagine.intro}</p>
      <p class="quiet">${found(state)}</p>
    </div>`;
}

/** The step, for a screen reader. */
export function stepWords(state: State): string {
  const { text, route } = state;
  const words = route.step ? text.imagine.steps[route.step] : [text.imagine.walkthrough, text.imagine.intro];
  return [`${words[0]}.`, words[1], found(state)].filter(Boolean).join(" ");
}

function steps({ store }: App): View {
  const { state } = store;
  const { text, route, touring } = state;
  const index = stepIndex(state);
  const tour = touring ? text.imagine.stop : text.imagine.tour;
  const last = STEPS.length - 1;
  return html`<div class="steps" role="group" aria-label=${text.imagine.walkthrough}>
    <button title=${tour} aria-label=${tour} @click=${() => store.change(toggleTour)}>
      ${icon(touring ? "stop" : "tour")}
    </button>
    <button class="chip" aria-pressed=${route.step === null} @click=${() => store.change(goTo, null)}>
      ${text.imagine.all}
    </button>
    <button aria-label=${text.imagine.back} aria-disabled=${index < 0} @click=${() => store.change(go, -1)}>
      ${icon("previous")}
    </button>
    ${STEPS.map((step, place) => {
      const label = text.imagine.step(place + 1, text.imagine.steps[step][0]);
      return html`<button
        class="chip"
        title=${label}
        aria-label=${label}
        aria-current=${step === route.step ? "step" : nothing}
        @click=${() => store.change(goTo, step)}
      >
        ${place + 1}
      </button>`;
    })}
    <button
      aria-label=${text.imagine.next}
      aria-disabled=${index === last}
      @click=${() => index < last && store.change(go, 1)}
    >
      ${icon("next")}
    </button>
  </div>`;
}

/** What a step shows for this puzzle, next to the scene. */
function found({ route, answers, model, text }: State): string {
  if (model.kind !== "ready") return "";
  if (route.step === "run") return answers.turn.length === 0 ? text.imagine.waiting : "";
  if (route.step !== "imagined") return "";
  const { candidates } = answers;
  if (!candidates) return text.imagine.waiting;
  return text.imagine.considered(candidates.length, candidates.filter(({ probability }) => probability > 0.5).length);
}

function tiles({ store }: App, maps: NonNullable<State["answers"]["maps"]>): View {
  const { state } = store;
  const { text, puzzle } = state;
  const layers = shownLayers(state);
  return html`<div class="maps" role="group" aria-label=${text.imagine.maps}>
    ${MAPS.map((name) => {
      const values = maps[name];
      if (!values) return nothing;
      return html`<button
        aria-pressed=${layers.includes(name)}
        aria-label=${`${nameOf(text.imagine, name)} (${text.imagine.paper[name]}): ${described(state, name, values)}`}
        @click=${() => store.change(toggleLayer, name)}
      >
        ${mapTile(puzzle, name, values, isDark(state))}<span>${nameOf(text.imagine, name)}</span
        ><small class="quiet">${text.imagine.paper[name]}</small>
      </button>`;
    })}
  </div>`;
}

function described(state: State, name: MapName, values: Float32Array): string {
  const { imagine } = state.text;
  const [{ x, y }] = goal(state);
  if (name === "base" || name === "target") {
    const { from, to } = extent(values, [x, y]);
    return imagine.path(from, to);
  }
  const { from, to } = extent(values, null);
  return name === "action" ? imagine.path(to, from) : imagine.strongest(from);
}

function nameOf(words: Text["imagine"], part: MapName | Step): string {
  return part === "success" ? words.works : words.steps[part][0];
}

/** Explains how the step works, or all steps. */
function how({ route: { step }, text: { imagine } }: State): View {
  const parts =
    step === "placement" ? (["placement", "success"] as const) : step ? [step] : new Set([...MAPS, ...STEPS]);
  return html`<details class="how">
    <summary>${imagine.how}</summary>
    <dl>
      ${[...parts].map(
        (part) =>
          html`<dt>${nameOf(imagine, part)}</dt>
            <dd>${imagine.hows[part]}</dd>`,
      )}
    </dl>
  </details>`;
}
