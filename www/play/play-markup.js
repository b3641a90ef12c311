// The markup of the panel Play. What comes after the first picture is inert until then.

import { text } from "../text/text.js";

/** The markup of the panel Play. */
export function playMarkup() {
  const words = text.play.panel;
  return `
<section id="solved" aria-labelledby="solved-title" hidden>
  <div id="celebration" aria-hidden="true" hidden></div>
  <h2 id="solved-title"></h2>
  <p class="actions">
    <a class="button primary" id="solved-next">${words.next}</a>
    <button type="button" id="solved-share">${words.share}</button>
    <label data-hideable="puzzles">${words.nextBy} <select id="next-by"><option value="kind">${words.similar}</option><option value="harder">${words.harder}</option><option value="easier">${words.easier}</option></select></label>
  </p>
</section>
<div id="race" role="group" aria-labelledby="race-title" inert data-hideable="compare">
  <h2 id="race-title" class="visually-hidden">${words.race}</h2>
  <dl><div><dt>${words.you}</dt><dd id="race-player"></dd></div><div class="model"><dt>${words.model}</dt><dd id="race-model"></dd></div></dl>
  <div class="actions"><button type="button" id="model-skip" hidden>${words.skip}</button><button type="button" id="race-it">${words.raceIt}</button></div>
  <p id="race-verdict"></p>
  <p id="race-source"></p>
  <details id="score" hidden><summary id="score-words"></summary><p>${words.score}</p></details>
  <div id="remembers">
    <label class="switch"><input type="checkbox" role="switch" id="remembers-on"> <span>${words.remembers}</span></label>
    <p id="remembers-words"></p>
    <button type="button" id="remembers-forget" hidden>${words.forget}</button>
  </div>
</div>
<div id="compare-trouble" class="trouble" role="alert" data-hideable="compare" hidden><p></p><button type="button">${text.element.tryAgain}</button></div>
<div class="part" data-hideable="play">
  <p id="story" data-hideable="story"></p>
  <div class="ball-form" data-hideable="fields">
    <label class="radius">${words.radius} <input type="range" id="radius" step="1"></label>
    <div class="undoing" role="group" aria-label="${words.placements}">
      <button type="button" id="undo" title="${words.undo}  ${text.element.keys.ctrl}+Z"><svg><use href="#icon-undo"/></svg><span class="visually-hidden">${words.undo}</span></button>
      <button type="button" id="redo" title="${words.redo}  ${text.element.keys.ctrl}+Y"><svg><use href="#icon-redo"/></svg><span class="visually-hidden">${words.redo}</span></button>
    </div>
  </div>
  <p class="hint" data-hideable="hint">${words.hint}</p>
  <p class="small" id="difficulty"></p>
  <p data-hideable="watch"><button type="button" id="watch">${words.watch}</button></p>
  <details id="forecast-how" hidden><summary>${words.dotted}</summary><p>${words.dottedHow}</p></details>
</div>
<div class="columns">
  <section aria-labelledby="player-title" data-hideable="attempts">
    <h2 id="player-title">${words.yourAttempts} <span class="count" id="play-count"></span></h2>
    <ol class="attempts" id="play-attempts"></ol>
  </section>
  <section aria-labelledby="model-title" data-hideable="compare" inert>
    <h2 id="model-title">${words.modelAttempts} <span class="count" id="model-count"></span></h2>
    <ol class="attempts" id="model-attempts"></ol>
  </section>
</div>
<div data-hideable="attempts">
  <div id="luck" class="saving" inert hidden>
    <button type="button" id="luck-ask">${words.luck}</button>
    <p id="luck-words"></p>
  </div>
</div>
`;
}
