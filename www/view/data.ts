// The panel Data, for researchers: the ball in numbers, the model, imagined compared with real paths, and files.

import { html, nothing } from "lit-html";
import { attemptCount } from "../core/change/kept.ts";
import { chooseModel } from "../core/change/model.ts";
import { FIRST_BALL, place } from "../core/change/placement.ts";
import { openDialog } from "../core/change/dialog.ts";
import { attempts as attemptsHere, meanDistance } from "../core/derived/duel.ts";
import { overlap } from "../core/derived/imagined.ts";
import { guess } from "../core/derived/placing.ts";
import { ended, rollouts } from "../core/derived/run.ts";
import { sameBall } from "../core/puzzle.ts";
import { openFile, saveAttempts, saveMaps, saveTable } from "../effects/files.ts";
import { SETUPS } from "../model/shared.ts";
import { fileButton, numberField } from "./widgets.ts";
import type { Ball, Setup } from "../pkg/page/pathlight.js";
import type { State } from "../core/state.ts";
import type { App, View } from "./view.ts";

export function data(app: App): View {
  return html`${ball(app)} ${model(app)} ${paths(app)} ${attempts(app)}`;
}

function ball({ store }: App): View {
  const { placement, text } = store.state;
  const axes = ["x", "y", "r"] as const;
  return html`<fieldset>
    <legend>${text.data.ball}</legend>
    <div class="row">
      ${axes.map((axis, index) => numberField(text.data.axes[axis], placement.ball?.[index] ?? null, (value) => changed(value, index)))}
    </div>
  </fieldset>`;

  function changed(value: number, index: number): void {
    store.change(place, (placement.ball ?? FIRST_BALL).with(index, value) as Ball, null);
  }
}

function model({ store }: App): View {
  const { kept, text } = store.state;
  if (SETUPS.length < 2) return nothing;
  return html`<label class="switch">
    ${text.model.choose}
    <select @change=${({ target }: Event) => store.change(chooseModel, (target as HTMLSelectElement).value as Setup)}>
      ${SETUPS.map((setup) => html`<option value=${setup} .selected=${setup === kept.model}>${text.model.names[setup]}</option>`)}
    </select>
  </label>`;
}

function paths({ store }: App): View {
  const { state } = store;
  const { text, run, answers } = state;
  const rows = run && ended(state) && answers.maps ? run.balls.map((_, index) => row(state, index)) : [];
  return html`<h2>${text.data.run}</h2>
    ${
      rows.length === 0
        ? html`<p class="quiet">${text.data.noRun}</p>`
        : html`<table>
              <thead>
                <tr>
                  <td></td>
                  <th scope="col">${text.data.green}</th>
                  <th scope="col">${text.data.red}</th>
                  <th scope="col">${text.data.off}</th>
                </tr>
              </thead>
              <tbody>
                ${rows}
              </tbody>
            </table>
            <p class="quiet">${text.data.explained}</p>`
    }
    ${answers.maps ? html`<p><button @click=${() => saveMaps(store)}>${text.data.saveMaps}</button></p>` : nothing}`;
}

/** Shows how well one ball of the run agrees with what was imagined. */
function row(state: State, index: number): View {
  const { text, puzzle, run, answers } = state;
  const { ball, of_model } = run!.balls[index]!;
  const real = puzzle.pathMasks(ball);
  const maps = answers.maps!;
  const imagined = guess(state);
  const facts = rollouts(state)[index]!;
  const off =
    sameBall(imagined?.of ?? null, ball) && facts.paths && meanDistance(imagined!.imagined.object, facts.paths.object);
  return html`<tr>
    <th scope="row">${of_model ? text.data.model : ball ? text.data.you : text.data.alone}</th>
    <td>${text.data.agreement(overlap(ball ? maps.target : maps.base, real.object))}</td>
    <td>${real.ball ? text.data.agreement(overlap(maps.action, real.ball)) : "–"}</td>
    <td>${off ? text.data.px(off) : "–"}</td>
  </tr>`;
}

function attempts(app: App): View {
  const { state } = app.store;
  const hasAttempts = attemptsHere(state).length > 0;
  return html`<h2>${state.text.data.attempts}</h2>
    ${attemptFiles(app)}
    <p><button ?disabled=${!hasAttempts} @click=${() => saveTable(state)}>${state.text.data.table}</button></p>`;
}

/** The attempts kept in this browser: to save, to open, and to forget. */
export function attemptFiles({ store }: App): View {
  const { kept, text } = store.state;
  const count = attemptCount(kept.attempts);
  return html`<p class="quiet">${text.data.kept(count)}</p>
    <div class="row">
      <button ?disabled=${count === 0} @click=${() => saveAttempts(store.state)}>${text.data.save}</button>
      ${fileButton(text.data.open, ".jsonl,.json,application/json", (file) => void openFile(store, file))}
      <button ?disabled=${count === 0} @click=${() => store.change(openDialog, "forget")}>${text.home.forget}</button>
    </div>`;
}
