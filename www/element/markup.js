// The shadow tree of a puzzle: scene, transport, tabs and dialogs; the panels come later, each with its own markup. It
// is the only markup that is made from text, and all text in it is the catalogue's. Ids are unique in each shadow tree.

import { MAPS } from "../shell/constants.js";
import { language } from "../text/language.js";
import { text } from "../text/text.js";
import { moreMarkup } from "./more-markup.js";
import { tabsMarkup } from "./tabs-markup.js";

const ICONS = `
<svg class="sprite" aria-hidden="true">
  <symbol id="icon-run" viewBox="0 0 24 24"><path d="M7 4.5v15l12-7.5z"/></symbol>
  <symbol id="icon-pause" viewBox="0 0 24 24"><path d="M6 5h4v14H6zM14 5h4v14h-4z"/></symbol>
  <symbol id="icon-step" viewBox="0 0 24 24"><path d="M5 5v14l9-7zM16 5h3v14h-3z"/></symbol>
  <symbol id="icon-reset" viewBox="0 0 24 24"><path d="M12 5V1.5L6.5 6 12 10.5V7.2a5.5 5.5 0 1 1-5.5 5.5H4.3A7.7 7.7 0 1 0 12 5z"/></symbol>
  <symbol id="icon-previous" viewBox="0 0 24 24"><path d="M15.5 5 8.5 12l7 7" class="line"/></symbol>
  <symbol id="icon-next" viewBox="0 0 24 24"><path d="m8.5 5 7 7-7 7" class="line"/></symbol>
  <symbol id="icon-undo" viewBox="0 0 24 24"><path d="M9 5 4.5 9.5 9 14M5 9.5h8.5a5 5 0 0 1 0 10H9" class="line"/></symbol>
  <symbol id="icon-redo" viewBox="0 0 24 24"><path d="m15 5 4.5 4.5L15 14M19 9.5h-8.5a5 5 0 0 0 0 10H15" class="line"/></symbol>
  <symbol id="icon-more" viewBox="0 0 24 24"><circle cx="5.5" cy="12" r="1.9"/><circle cx="12" cy="12" r="1.9"/><circle cx="18.5" cy="12" r="1.9"/></symbol>
  <symbol id="icon-compare" viewBox="0 0 24 24"><circle cx="9.5" cy="12" r="5.5" class="line"/><circle cx="14.5" cy="12" r="5.5" class="line dashed"/></symbol>
  <symbol id="icon-delete" viewBox="0 0 24 24"><path d="M5 7h14M10 7V4.5h4V7M7 7l.8 12.5h8.4L17 7M10.3 10.5v5.5M13.7 10.5v5.5" class="line"/></symbol>
</svg>
`;

function sceneMarkup() {
  const words = text.element.scene;
  const { story } = text.element;
  return `
<p id="problem" lang="${language}" role="alert" hidden></p>

<div class="puzzle" id="puzzle" lang="${language}" role="group" hidden>
  <div class="scene-area">
    <div class="scene">
      <canvas id="scene" tabindex="0" role="application" aria-roledescription="${words.role}" aria-labelledby="goal" aria-describedby="description"></canvas>
      <canvas id="loupe" aria-hidden="true" hidden></canvas>
      <p id="scene-label" aria-hidden="true" hidden></p>
    </div>
    <p class="visually-hidden" id="description"></p>
    <div class="transport" role="group" aria-label="${words.playback}">
      <button type="button" id="run" class="primary"><svg><use id="run-icon" href="#icon-run"/></svg><span id="run-label">${text.play.run.run}</span></button>
      <div class="timeline" data-hideable="transport">
      <button type="button" id="step" title="${words.step}  ."><svg><use href="#icon-step"/></svg><span class="visually-hidden">${words.step}</span></button>
      <input type="range" id="time" min="0" max="0" value="0" step="1" aria-label="${words.time}" disabled>
      <span id="clock" aria-hidden="true">${text.play.time(0)}</span>
      <label data-hideable="speed"><span class="visually-hidden">${words.speed}</span><select id="speed">
        <option value="0.25">0.25×</option><option value="0.5">0.5×</option><option value="1" selected>1×</option><option value="2">2×</option><option value="4">4×</option>
      </select></label>
      </div>
      <button type="button" id="reset" title="${words.back}  R"><svg><use href="#icon-reset"/></svg><span class="visually-hidden">${words.reset}</span></button>
    </div>
    <div class="status-row">
      <p id="status"></p>
      <button type="button" id="skip-quiet" hidden>${text.play.skipQuiet}</button>
      <button type="button" id="see-closest" title="${words.closest}" hidden>${words.seeIt}</button>
      <div id="goal-meter" role="meter" aria-label="${words.touched}" aria-valuemin="0" hidden>
        <svg viewBox="0 0 24 24" aria-hidden="true"><circle cx="12" cy="12" r="9"/><circle cx="12" cy="12" r="9" pathLength="100" class="filled"/></svg>
        <span></span>
      </div>
      <div id="forecast" inert data-hideable="imagine">
        <label class="switch" data-hideable="forecast"><input type="checkbox" role="switch" id="forecast-on"> <span>${words.guess}</span></label>
        <p id="forecast-words" hidden></p>
      </div>
    </div>
  </div>

  <div class="side">
    <section id="presentation" aria-labelledby="caption-title" inert hidden>
      <p id="caption-step"></p>
      <h2 id="caption-title"></h2>
      <p id="caption"></p>
      <p id="caption-result"></p>
      <p class="model-badge" data-hideable="imagine"></p>
      <div class="actions">
        <span class="dots" role="group" aria-label="${story.label}" data-hideable="imagine">
          <button type="button" id="caption-back" title="${story.back}  ←"><svg><use href="#icon-previous"/></svg><span class="visually-hidden">${story.back}</span></button>
          <button type="button" id="caption-next" title="${story.next}  →"><svg><use href="#icon-next"/></svg><span class="visually-hidden">${story.next}</span></button>
          <button type="button" id="caption-play"><svg><use id="caption-play-icon" href="#icon-run"/></svg><span id="caption-play-label"></span></button>
        </span>
        <button type="button" id="presentation-leave" data-hideable="tools" title="${story.leave}  Esc">${story.leave}</button>
      </div>
    </section>
    <section id="guide" aria-label="${words.introduction}" hidden>
      <p id="guide-words"></p>
      <p class="actions"><button type="button" id="guide-act" class="primary"></button> <button type="button" id="guide-skip">${words.leaveIntroduction}</button> <span class="small" id="guide-count"></span></p>
    </section>
    <p id="challenge" hidden></p>
    <p id="goal"></p>
    ${legendMarkup()}
    ${tabsMarkup()}
  </div>
  ${moreMarkup()}
</div>

<p class="visually-hidden" id="announcement" lang="${language}" role="status"></p>

<template id="attempt-row">
  <li>
    <button type="button" data-act="replay"><b></b><span class="mark" aria-hidden="true"></span><span class="words"></span></button>
    <button type="button" data-act="overlay"><svg aria-hidden="true"><use href="#icon-compare"/></svg></button>
    <button type="button" data-act="remove"><svg aria-hidden="true"><use href="#icon-delete"/></svg></button>
  </li>
</template>
`;
}

/** What lies over the scene in Play: the colour of each map and the dashes of its outline; and the model's guess. */
function legendMarkup() {
  const { over, green, red } = text.panels.laid;
  const maps = MAPS.map(
    (mapName) =>
      `<li data-of="${mapName}"><canvas width="24" height="4"></canvas>${text.model.steps[mapName].name}</li>`,
  );
  return `<div id="laid" data-hideable="imagine" hidden>
      <ul aria-label="${over}"><li data-of="guess"><i></i>${green}</li><li data-of="guess"><i class="red"></i>${red}</li>${maps.join("")}</ul>
      <button type="button" id="laid-off">${text.element.scene.takeOff}</button>
    </div>`;
}

function keysMarkup() {
  const words = text.element.keys;
  return `
<dialog id="keys-dialog" lang="${language}" aria-labelledby="keys-title">
  <h2 id="keys-title">${words.title}</h2>
  <dl>
    <dt><kbd>←</kbd> <kbd>→</kbd> <kbd>↑</kbd> <kbd>↓</kbd></dt><dd>${words.move}</dd>
    <dt><kbd>+</kbd> <kbd>−</kbd></dt><dd>${words.resize}</dd>
    <dt data-hideable="fields"><kbd>${words.ctrl}</kbd> <kbd>Z</kbd>, <kbd>${words.ctrl}</kbd> <kbd>Y</kbd></dt><dd data-hideable="fields">${words.undo}</dd>
    <dt><kbd>${words.space}</kbd></dt><dd>${words.run}</dd>
    <dt data-hideable="transport"><kbd>.</kbd> <kbd>,</kbd></dt><dd data-hideable="transport">${words.step}</dd>
    <dt><kbd>R</kbd></dt><dd>${words.reset}</dd>
    <dt data-hideable="puzzles"><kbd>[</kbd> <kbd>]</kbd></dt><dd data-hideable="puzzles">${words.puzzles}</dd>
    <dt data-hideable="compare"><kbd>N</kbd></dt><dd data-hideable="compare">${words.outcome}</dd>
    <dt><kbd>V</kbd></dt><dd>${words.presentation}<span data-hideable="imagine">, ${words.story}</span></dd>
    <dt id="keys-of-panels"><kbd>1</kbd> ${words.to} <kbd>3</kbd></dt><dd id="key-panels"></dd>
    <dt><kbd>?</kbd></dt><dd>${words.sheet}</dd>
  </dl>
  <form method="dialog"><button>${text.element.close}</button></form>
</dialog>
`;
}

function aboutMarkup() {
  const words = text.element.about;
  return `
<dialog id="about-dialog" lang="${language}" aria-labelledby="about-title">
  <h2 id="about-title" tabindex="-1">${words.title}</h2>
  <p>${words.rules} <span data-hideable="compare">${words.sameRules}</span></p>
  <div data-hideable="imagine">
  <h3>${words.thinks}</h3>
  <p id="about-nets"></p>
  <h3>${words.training}</h3>
  <p>${words.trained}</p>
  <p id="card">${words.noModel}</p>
  <dl id="card-entries"></dl>
  </div>
  <h3>${words.sources}</h3>
  <p data-hideable="imagine">${words.paper}</p>
  <p>${words.benchmark}</p>
  <p>${words.local}</p>
  <p>${words.licences}</p>
  <form method="dialog"><button>${text.element.close}</button></form>
</dialog>
`;
}

/** The shadow tree of a puzzle, without the panels that come later. */
export function puzzleMarkup() {
  return fragmentOf(ICONS + sceneMarkup() + keysMarkup() + aboutMarkup());
}

/**
 * @param {string} markup nothing but constants: no text of a link, a file or a model
 */
export function fragmentOf(markup) {
  const template = document.createElement("template");
  template.innerHTML = markup;
  return template.content;
}
