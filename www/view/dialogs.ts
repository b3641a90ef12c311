// The dialogs over the page: one at a time, closed by its button, by Escape, or, where browsers support it, by a click
// outside it.

import { html, nothing } from "lit-html";
import { live } from "lit-html/directives/live.js";
import { ref } from "lit-html/directives/ref.js";
import { hideable } from "../core/change/route.ts";
import { PRESETS, forget, openDialog, setLesson, setShare, toggleHidden, usePreset } from "../core/change/dialog.ts";
import { playerSolvedAt } from "../core/derived/duel.ts";
import { canShare, copy, lessonAddress, lessonTasks, share, shareAddress, shareText } from "../effects/sharing.ts";
import { download } from "../effects/files.ts";
import { checkbox } from "./widgets.ts";
import type { Hideable } from "../core/change/route.ts";
import type { Dialog } from "../core/change/dialog.ts";
import type { App, View } from "./view.ts";

const DIALOGS: Record<Dialog, (app: App) => View> = {
  share: shareDialog,
  lesson: lessonDialog,
  about,
  forget: forgetDialog,
};

export function dialogs(app: App): View {
  const { store } = app;
  const { dialog, text } = store.state;
  if (!dialog) return nothing;
  return html`<dialog aria-label=${text.page.titles[dialog]} closedby="any" ${ref(show)} @close=${closed}>
    <div class="row">
      <h2>${text.page.titles[dialog]}</h2>
      <button @click=${closed}>${text.page.dismiss}</button>
    </div>
    ${DIALOGS[dialog](app)}
  </dialog>`;

  function closed(): void {
    store.change(openDialog, null);
  }
}

/** Shows a dialog once it has been rendered into the document. */
function show(element: Element | undefined): void {
  queueMicrotask(() => {
    const dialog = element as HTMLDialogElement | undefined;
    if (dialog?.isConnected && !dialog.open) dialog.showModal();
  });
}

function shareDialog({ store }: App): View {
  const { state } = store;
  const { text } = state;
  const { card, withBall, done } = state.share;
  const words = `${shareText(state)}\n${shareAddress(state)}`;
  const alt = shareText(state);
  return html`<p class="message">${shareText(state)}</p>
    <input class="address" readonly aria-label=${text.share.link} .value=${shareAddress(state)} @focus=${selected} />
    ${playerSolvedAt(state) === null ? nothing : html`<p class="quiet">${text.share.noBall}</p>`}
    <p class="row">
      <button class="primary" @click=${() => copy(store, words)}>${text.share.copy}</button>
      ${canShare() ? html`<button @click=${() => share(store)}>${text.share.system}</button>` : nothing}
      ${card.kind === "ready" ? html`<button @click=${() => download(card.file)}>${text.share.save}</button>` : nothing}
    </p>
    <p role="status">${done ? text.share.done[done] : ""}</p>
    <div class="card">
      ${
        card.kind === "ready"
          ? html`<img src=${card.url} alt=${alt} width="1200" height="630" />`
          : html`<p>${card.kind === "drawing" ? text.share.drawing : text.share.noCard[card.why]}</p>`
      }
    </div>
    ${
      playerSolvedAt(state) !== null
        ? checkbox(withBall, text.share.withBall, () => store.change(setShare, { withBall: !withBall }))
        : nothing
    }`;
}

function lessonDialog({ store }: App): View {
  const { state } = store;
  const { text, lesson } = state;
  const address = lessonAddress(state);
  return html`<label class="field"
      >${text.share.puzzles}
      <input
        autocomplete="off"
        spellcheck="false"
        .value=${live(lesson.tasks)}
        @input=${({ target }: Event) => store.change(setLesson, { tasks: (target as HTMLInputElement).value })}
    /></label>
    <fieldset>
      <legend>${text.share.shows}</legend>
      ${PRESETS.map(
        (preset) =>
          html`<label class="switch">
            <input
              type="radio"
              name="preset"
              .checked=${live(lesson.preset === preset)}
              @change=${() => store.change(usePreset, preset)}
            />
            ${text.share.presets[preset]}
          </label>`,
      )}
      <details>
        <summary>${text.share.customise}</summary>
        ${hideable(text).map((part) =>
          checkbox(!lesson.hide.includes(part), partName(part), () => store.change(toggleHidden, part)),
        )}
      </details>
    </fieldset>
    ${checkbox(lesson.presentation, text.share.presentation, () =>
      store.change(setLesson, { presentation: !lesson.presentation }),
    )}
    ${
      address
        ? html`<input class="address" readonly aria-label=${text.share.link} .value=${address} @focus=${selected} />
            <p class="row">
              <button class="primary" @click=${() => copy(store, address)}>${text.share.copyLink}</button>
              <a class="button" href=${address} target="_blank" rel="noopener">${text.share.preview}</a>
            </p>
            <p role="status">${state.share.done ? text.share.done[state.share.done] : ""}</p>
            ${OWN_MACHINE.test(new URL(address).hostname) ? html`<p class="quiet">${text.share.ownMachine}</p>` : nothing}
            ${lesson.code ? html`<img class="code" src=${lesson.code} alt=${text.share.code} />` : nothing}
            ${lesson.code === null ? html`<p class="quiet">${text.share.noCode}</p>` : nothing}`
        : html`<p role="alert">${text.share.noPuzzles(lessonTasks(state).wrong)}</p>`
    }
    <p class="quiet">${text.share.end}</p>`;

  function partName(part: Hideable): string {
    return { ...text.share.parts, ...text.tabs }[part];
  }
}

/** Names of this machine, which mean another machine elsewhere. */
const OWN_MACHINE = /^(localhost|127\.|\[::1\])/;

function about({ store }: App): View {
  const { text } = store.state;
  return html`<div class="about">
    ${text.about.idea.map((paragraph) => html`<p>${paragraph}</p>`)}
    <p><a href=${PAPER} target="_blank" rel="noopener">${text.about.paper}</a></p>
    <p><a href=${PHYRE} target="_blank" rel="noopener">${text.about.phyre}</a></p>
    <h2>${text.about.keys}</h2>
    <dl>
      ${text.about.keyList.map(
        ([keys, does]) =>
          html`<dt>${keys.split(" ").map((key) => html`<kbd>${key}</kbd> `)}</dt>
            <dd>${does}</dd>`,
      )}
    </dl>
    <h2>${text.about.source}</h2>
    <p>${text.about.cite}</p>
    <p class="row">
      <a href="CITATION.cff">${text.about.citation}</a> <a href="licences.txt">${text.about.licences}</a>
    </p>
  </div>`;
}

const PAPER = "https://arxiv.org/abs/2011.07357";
const PHYRE = "https://arxiv.org/abs/1908.05656";

function forgetDialog({ store }: App): View {
  const { text } = store.state;
  return html`<p>${text.home.forgetHint}</p>
    <p class="row">
      <button @click=${() => store.change(openDialog, null)}>${text.home.keep}</button>
      <button @click=${() => store.change(forget, Date.now())}>${text.home.forget}</button>
    </p>`;
}

function selected({ target }: Event): void {
  (target as HTMLInputElement).select();
}
