// The panel Make: bodies to add, the selected one with its numbers, and ways to keep or send the puzzle.

import { html, nothing } from "lit-html";
import { live } from "lit-html/directives/live.js";
import { openScene } from "../opening.ts";
import { choose, keepPuzzles } from "../core/change/kept.ts";
import {
  add,
  duplicate,
  empty,
  isSettled,
  making,
  mayAdd,
  mayBe,
  mayRemove,
  moveTo,
  remove,
  rename,
  resizeTo,
  select,
  selectedBody,
  setRole,
  turnTo,
} from "../core/change/make.ts";
import { setNotice } from "../core/change/settings.ts";
import { SIZES, circleOf, degreesOf, namedOf, namedProblem, roleOf, sizeOf } from "../core/derived/bodies.ts";
import { shownPanel } from "../core/derived/hidden.ts";
import { readPuzzles, savePuzzle } from "../effects/making.ts";
import { SCENE_LIMITS, SCENE_SIZE } from "../pkg/constants.ts";
import { fits, openPuzzle, problemsOf } from "../simulator.ts";
import { badge } from "./badge.ts";
import { check } from "./check.ts";
import { checkbox, fileButton, numberField } from "./widgets.ts";
import type { Role, Shape } from "../core/derived/bodies.ts";
import type { State } from "../core/state.ts";
import type { SceneProblem } from "../pkg/page/pathlight.js";
import type { App, View } from "./view.ts";

export function make(app: App): View {
  const { store } = app;
  const { state } = store;
  const { text } = state;
  return html`${tools(app)} ${selected(app)} ${details(app)} ${state.model.kind === "failed" ? badge(app) : nothing}
  ${check(app)}
  ${
    // The check replaces it in the scene.
    state.check ? nothing : checkbox(state.kept.live, text.make.live, (live) => store.change(choose, { live }))
  }
  ${keeping(app)} ${yours(app)}`;
}

/** Shows a problem next to the body that has it. */
export function problem({ store }: App): View {
  const { state } = store;
  const [first] = problemsHere(state);
  if (!first || state.run) return nothing;
  const body = making(state).scene.bodies[first.body ?? -1];
  const { centre, radius } = body ? circleOf(body) : { centre: [128, 128] as const, radius: 0 };
  // Above the body, or below where there is no room.
  const isHigh = centre[1] + radius > 0.8 * SCENE_SIZE;
  const within = (value: number) => Math.min(Math.max(value, 0.08 * SCENE_SIZE), 0.92 * SCENE_SIZE);
  const bottom = within(isHigh ? centre[1] - radius - 40 : centre[1] + radius + 6) / SCENE_SIZE;
  const left = Math.min(Math.max(centre[0] / SCENE_SIZE, 0.3), 0.7);
  const place = `left:${left * 100}%;bottom:${bottom * 100}%`;
  return html`<p class="problem" .style=${place}>${problemWords(state, first)}</p>`;
}

/** Problems of the scene being made, while it is visible. */
export function problemsHere(state: State): readonly SceneProblem[] {
  if (shownPanel(state) !== "make") return [];
  const { scene, selected } = making(state);
  // Report the body that the person is handling as the one in the way of others.
  const turned = problemsOf(scene).map((one) =>
    one.other === selected && one.other !== null ? { ...one, body: one.other, other: one.body } : one,
  );
  return turned.sort((one, other) => Number(other.body === selected) - Number(one.body === selected));
}

/** The selected body and its problems, for screen readers. */
export function madeInWords(state: State): string {
  const { scene, selected } = making(state);
  const body = selectedBody(state);
  const sizes = body ? SIZES[body.shape].map((size) => [size, sizeOf(body, size)] as const) : [];
  return [
    body && state.text.make.described(namedOf(scene, selected)!, body.x, body.y, degreesOf(body), sizes),
    ...problemsHere(state).map((problem) => problemWords(state, problem)),
  ]
    .filter(Boolean)
    .join(" ");
}

function problemWords(state: State, problem: SceneProblem): string {
  return state.text.make.problem(namedProblem(making(state).scene, problem));
}

function tools({ store }: App): View {
  const { state } = store;
  const { text } = state;
  return html`<div class="row" role="group" aria-label=${text.make.add}>
    ${(Object.keys(SIZES) as Shape[]).map(
      (shape) =>
        html`<button ?disabled=${!mayAdd(state)} @click=${() => store.change(add, shape, fits)}>
          ${text.make.shapes[shape]}
        </button>`,
    )}
    <button @click=${() => store.change(empty)}>${text.make.empty}</button>
  </div>`;
}

function selected({ store }: App): View {
  const { state } = store;
  const { text } = state;
  const { scene, selected } = making(state);
  if (selected === null) return nothing;
  const role = roleOf(scene, selected);
  return html`<div class="row" role="group" aria-label=${text.make.selected}>
    <label class="field">
      ${text.make.role}
      <select @change=${({ target }: Event) => store.change(setRole, (target as HTMLSelectElement).value as Role)}>
        ${(Object.entries(text.make.roles) as [Role, string][]).map(
          ([one, words]) =>
            html`<option value=${one} ?disabled=${!mayBe(state, one)} .selected=${live(one === role)}>
              ${words}
            </option>`,
        )}
      </select>
    </label>
    <button ?disabled=${!mayAdd(state)} @click=${() => store.change(duplicate, fits)}>${text.make.duplicate}</button>
    <button ?disabled=${!mayRemove(state)} @click=${() => store.change(remove)}>${text.make.remove}</button>
  </div>`;
}

function details({ store }: App): View {
  const { state } = store;
  const { text } = state;
  const { scene, selected } = making(state);
  const body = selectedBody(state);
  return html`<details>
    <summary>${text.make.details}</summary>
    <div class="row">
      <label class="field">
        ${text.make.body}
        <select @change=${chosen}>
          <option value="" .selected=${live(selected === null)}>${text.make.nothing}</option>
          ${scene.bodies.map(
            (_, index) =>
              html`<option value=${index} .selected=${live(index === selected)}>
                ${text.make.named(namedOf(scene, index)!, index)}
              </option>`,
          )}
        </select>
      </label>
      ${
        body
          ? html`${numberField("x", body.x, (x) => store.change(moveTo, x, body.y, null))}
            ${numberField("y", body.y, (y) => store.change(moveTo, body.x, y, null))}
            ${numberField(text.make.angle, degreesOf(body), (degrees) => store.change(turnTo, degrees, null))}
            ${SIZES[body.shape].map((size) =>
              numberField(text.make.sizes[size], sizeOf(body, size), (value) =>
                store.change(resizeTo, size, value, null),
              ),
            )}`
          : nothing
      }
    </div>
    <p class="quiet by-keys">${text.make.keys}</p>
  </details>`;

  function chosen({ target }: Event): void {
    const { value } = target as HTMLSelectElement;
    store.change(select, value === "" ? null : Number(value));
  }
}

function keeping({ store }: App): View {
  const { state } = store;
  const { text, puzzle, kept } = state;
  const { scene } = making(state);
  const isPlayable = isSettled(state);
  const isCustom = isPlayable && puzzle.about.id === null;
  const there = kept.puzzles[puzzle.key]?.scene;
  const isKept = isCustom && there != null && there.name === scene.name;
  return html`<div class="row">
      <label class="field wide">
        ${text.make.name}
        <input
          type="text"
          maxlength=${SCENE_LIMITS.name_length}
          autocomplete="off"
          placeholder=${text.puzzle.name(puzzle.about)}
          .value=${scene.name ?? ""}
          @change=${named}
        />
      </label>
      <button ?disabled=${!isCustom || isKept} @click=${keep}>${isKept ? text.make.kept : text.make.keep}</button>
      <button ?disabled=${!isPlayable} @click=${() => savePuzzle(puzzle)}>${text.make.save}</button>
      ${fileButton(text.make.open, ".json,application/json", (file) => void open(file))}
    </div>
    ${isCustom ? html`<p class="quiet">${text.make.link}</p>` : nothing}`;

  function named({ target }: Event): void {
    const field = target as HTMLInputElement;
    const { value } = field;
    // Drop characters that were not accepted.
    field.value = scene.name ?? "";
    store.change(rename, value);
  }

  function keep(): void {
    store.change(keepPuzzles, { [puzzle.key]: puzzle.custom }, Date.now());
  }

  async function open(file: File): Promise<void> {
    const read = await readPuzzles(file);
    if ("problem" in read) return store.change(setNotice, { kind: "bad_file", ...read });
    if (read.length === 1) return openScene(store, read[0]!);
    const puzzles = read.map((scene) => openPuzzle(scene));
    store.change(keepPuzzles, Object.fromEntries(puzzles.map(({ key, custom }) => [key, custom])), Date.now());
  }
}

/** The kept puzzles; nothing if there are none. */
export function yours({ store }: App): View {
  const { kept, text } = store.state;
  const puzzles = Object.entries(kept.puzzles).flatMap(([key, { scene }]) =>
    scene && problemsOf(scene).length === 0 ? [{ key, scene }] : [],
  );
  if (puzzles.length === 0) return nothing;
  return html`<details>
    <summary>${text.make.yours(puzzles.length)}</summary>
    <ul class="kept">
      ${puzzles.map(({ key, scene }) => {
        const name = text.puzzle.name({ id: null, name: scene.name ?? null });
        return html`<li>
          <button @click=${() => openScene(store, scene)}>${name}</button>
          <button class="small" aria-label=${text.make.forget(name)} @click=${(event: Event) => forget(event, key)}>
            ✕
          </button>
        </li>`;
      })}
    </ul>
  </details>`;

  function forget({ currentTarget }: Event, key: string): void {
    // The button is removed with the puzzle.
    (currentTarget as Element).closest("details")!.querySelector("summary")!.focus();
    store.change(keepPuzzles, { [key]: null }, Date.now());
  }
}
