// The home page around its scene: what Pathlight is, puzzles to start with, and the kinds of puzzles.

import { html, nothing, svg } from "lit-html";
import { guard } from "lit-html/directives/guard.js";
import { goTo } from "../opening.ts";
import {
  difficulty,
  introShown,
  kindsOf,
  progress,
  rarity,
  standing,
  taskOfDay,
  unsolvedTask,
} from "../core/derived/home.ts";
import { isDark } from "../core/derived/preferences.ts";
import { taskOf } from "../core/derived/next.ts";
import { goal } from "../core/derived/placing.ts";
import { writeAddress } from "../effects/address.ts";
import { SETUPS } from "../model/shared.ts";
import { PAGES } from "../effects/old-links.ts";
import { START } from "../core/change/route.ts";
import { SCENE_SIZE } from "../pkg/constants.ts";
import { benchmark, rateOf, thumbnail } from "../simulator.ts";
import { attemptFiles } from "./data.ts";
import { yours } from "./make.ts";
import type { Kind } from "../core/derived/home.ts";
import type { State } from "../core/state.ts";
import type { App, View } from "./view.ts";

const hrefOf = (task: string) => writeAddress({ ...START, task });

export function headline({ store }: App): View {
  const { text, puzzle } = store.state;
  if (!introShown(store.state))
    return html`<h1 class="small">${text.puzzle.name(puzzle.about)}</h1>
      <p><strong>${text.puzzle.goal(...goal(store.state))}</strong></p>`;
  return html`<h1>${text.home.title}</h1>
    <p>${text.home.goal}</p>
    <p class="quiet">${text.home.about}</p>`;
}

/** A puzzle opens at its top. It scrolls after the click, so that going back finds the place in the list again. */
function toTop(event?: MouseEvent): void {
  if (!event?.ctrlKey && !event?.metaKey) setTimeout(() => scrollTo(0, 0));
}

/** Puzzles to start with, in addition to the one in the picture. */
export function picks({ store }: App): View {
  const { state } = store;
  const { text, device, kept, recorded } = state;
  // Nothing here depends on what moves in the picture.
  return html`${guard([text, device, kept.attempts, kept.model, recorded, isDark(state)], () => {
    const daily = taskOfDay(benchmark(), device.day);
    // Another model may solve it.
    const unsolved = kept.model === SETUPS[0] ? unsolvedTask(state) : null;
    const facts = (task: string) => text.home.facts(nameOf(state, task), difficulty(rateOf(task)));
    return html`<ul class="picks" @click=${toTop}>
      ${pick(state, daily, text.home.day, facts(daily))}
      ${unsolved ? pick(state, unsolved, text.home.unsolved, text.home.canYou(facts(unsolved))) : nothing}
      ${pick(state, EMPTIEST, text.home.make, text.home.makeHint, writeAddress({ ...START, task: EMPTIEST, panel: "make" }))}
    </ul>`;
  })}`;
}

/** The puzzle with the fewest bodies, with which making a puzzle starts. */
const EMPTIEST = "00000:000";

function pick(state: State, task: string, title: string, hint: string, href = hrefOf(task)): View {
  return html`<li>
    <a href=${href}
      >${thumbnail(task, isDark(state), title)}<span
        ><strong>${title}</strong> <span class="quiet">${hint}</span></span
      ></a
    >
  </li>`;
}

let kinds: Kind[] | null = null;

/** The kinds, the easiest first, each with its next puzzle that is new to the person and the first model. */
export function gallery(app: App): View {
  const { store } = app;
  const { state } = store;
  const { text, kept, recorded } = state;
  return html`${guard([text, kept.attempts, kept.puzzles, recorded, isDark(state)], () => {
    kinds ??= kindsOf(benchmark());
    return html`<section class="gallery" aria-label=${text.home.kinds(kinds.length)}>
      <div class="row">
        <h2>${text.home.kinds(kinds.length)}</h2>
        <label
          >${text.home.number}
          <input class="number" size="9" placeholder="7:8" autocomplete="off" spellcheck="false" @change=${typed}
        /></label>
      </div>
      <ul class="kinds" @click=${toTop}>
        ${kinds.map((kind) => tile(state, kind))}
      </ul>
      ${yours(app)} ${progressMenu(app)}
      <p class="row">
        <a href=${PAGES.get("results")}>${text.home.results}</a> <a href=${PAGES.get("learns")}>${text.home.learns}</a>
      </p>
    </section>`;
  })}`;

  function typed({ target }: Event): void {
    const { value } = target as HTMLInputElement;
    if (!value.trim()) return;
    goTo(store, taskOf(value) ?? value);
    toTop();
  }
}

function tile(state: State, kind: Kind): View {
  const { text, kept, recorded } = state;
  const { task, number, played } = standing(kind, kept.attempts);
  const path = recorded?.paths[task];
  return html`<li>
    <a href=${hrefOf(task)}>
      <span class="picture"> ${thumbnail(task, isDark(state), "tile")} ${path ? imagined(path) : nothing} </span>
      <strong>${nameOf(state, task)}</strong>
      <span class="quiet">${text.home.howHard(difficulty(rateOf(task)), rarity(rateOf(task)))}</span>
      ${played.length ? html`<span class="mark">${text.home.standing(number, kind.tasks.length, played)}</span>` : nothing}
    </a>
  </li>`;
}

/** The path that the model imagines, as a line drawn from its start. */
function imagined(path: readonly number[]): View {
  const points = path.map((value, index) => (index % 2 ? SCENE_SIZE - value : value)).join(" ");
  return html`<svg class="imagined" viewBox="0 0 ${SCENE_SIZE} ${SCENE_SIZE}" aria-hidden="true">
    ${svg`<polyline points=${points} pathLength="1"/>`}
  </svg>`;
}

function progressMenu(app: App): View {
  const { text } = app.store.state;
  const made = progress(app.store.state);
  return html`<details class="progress">
    <summary>${made.attempts ? text.home.soFar(made) : text.home.progress}</summary>
    ${attemptFiles(app)}
  </details>`;
}

const nameOf = ({ text, puzzle }: State, task: string) => text.puzzle.name({ ...puzzle.about, id: task });
