// Below the scene: the one large button, and next to it the radius while the ball is placed, or playback during a run.

import { html, nothing } from "lit-html";
import { live } from "lit-html/directives/live.js";
import { takeNextStep } from "../opening.ts";
import { canRun } from "../core/change/sketch.ts";
import { isSettled } from "../core/change/make.ts";
import { toggleIntro } from "../core/change/home.ts";
import { FIRST_RADIUS, resize } from "../core/change/placement.ts";
import { SPEEDS, play, seek, setSpeed, togglePlaying } from "../core/change/run.ts";
import { attemptLimitReached, nextStep } from "../core/derived/duel.ts";
import { shownPanel } from "../core/derived/hidden.ts";
import { introShown } from "../core/derived/home.ts";
import { fault } from "../core/derived/placing.ts";
import { ended, lastStep } from "../core/derived/run.ts";
import { MAX_RADIUS, MIN_RADIUS } from "../pkg/constants.ts";
import { icon } from "./icons.ts";
import { problemsHere } from "./make.ts";
import type { App, View } from "./view.ts";

/** The button stays one element, so it never loses the focus. */
export function controls(app: App): View {
  const { store } = app;
  const { state } = store;
  const step = nextStep(state);
  const { ball, dropped } = state.placement;
  const canDrop = ball !== null && fault(state) === null && !attemptLimitReached(state) && !dropped;
  const isIdle =
    (step === "drop" && !canDrop) ||
    (step === "run" && !canRun(state)) ||
    (step === "try" && problemsHere(state).length > 0);
  return html`<button class="step ${step}" aria-disabled=${isIdle} @click=${clicked}>
      ${state.text.play.step[step]}
    </button>
    ${introShown(state) ? animation(app) : state.run ? playback(app) : beside(app)}`;

  // The second click of a double click must not undo what the first has done.
  function clicked({ detail }: MouseEvent): void {
    if (detail >= 2) return;
    takeNextStep(store);
    // After starting by key, continue in the scene.
    if (step === "start") app.canvas.focus({ preventScroll: true });
  }
}

function watch({ store }: App): View {
  const { state } = store;
  const alone = [{ ball: null, of_model: false }];
  return html`<button ?disabled=${!isSettled(state)} @click=${() => store.change(play, alone, null, false)}>
    ${state.text.make.watch}
  </button>`;
}

/** Pauses or resumes the show: any automatic motion can be paused. */
function animation({ store }: App): View {
  const { intro, text } = store.state;
  return html`<button class="plain" @click=${() => store.change(toggleIntro)}>
    ${intro!.playing ? text.home.pause : text.home.play}
  </button>`;
}

function beside(app: App): View {
  const panel = shownPanel(app.store.state);
  return panel === "make" ? watch(app) : panel === "imagine" ? nothing : radius(app);
}

function radius({ store }: App): View {
  const { placement, text } = store.state;
  return html`<label class="slider">
    <span>${text.play.radius}</span>
    <input
      type="range"
      min=${MIN_RADIUS}
      max=${MAX_RADIUS}
      .value=${live(String(placement.ball?.[2] ?? FIRST_RADIUS))}
      @input=${({ target }: Event) => store.change(resize, (target as HTMLInputElement).valueAsNumber, "slider")}
    />
  </label>`;
}

function playback({ store }: App): View {
  const { state } = store;
  const { run, text, speed } = state;
  const now = text.play.time(run!.step);
  return html`<div class="slider" role="group" aria-label=${text.play.playback}>
    ${
      ended(state)
        ? html`<button class="small" aria-label=${text.play.replay} @click=${() => store.change(togglePlaying)}>
            ${icon("replay")}
          </button>`
        : nothing
    }
    <input
      type="range"
      min="0"
      max=${lastStep(state)}
      aria-label=${text.play.moment}
      aria-valuetext=${now}
      .value=${live(String(Math.round(run!.step)))}
      @input=${({ target }: Event) => store.change(seek, (target as HTMLInputElement).valueAsNumber)}
    />
    <span class="time">${now}</span>
    <select aria-label=${text.play.speed} @change=${chosen}>
      ${SPEEDS.map((one) => html`<option value=${one} .selected=${one === speed}>${text.play.times(one)}</option>`)}
    </select>
  </div>`;

  function chosen({ target }: Event): void {
    store.change(setSpeed, Number((target as HTMLSelectElement).value));
  }
}
