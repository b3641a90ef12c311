// The menu “…”: all that a first-time visitor does not need.

import { text } from "../text/text.js";

export function moreMarkup() {
  const words = text.element.more;
  return `
<div id="more" popover role="dialog" aria-labelledby="more-title">
  <h2 id="more-title" class="visually-hidden">${words.title}</h2>
  <section data-hideable="fields" aria-labelledby="more-ball"><h2 id="more-ball">${words.ball}</h2>
    <div class="ball-fields">
      <label>x <input type="number" id="ball-x" min="0" step="1" inputmode="numeric"></label>
      <label>y <input type="number" id="ball-y" min="0" step="1" inputmode="numeric"></label>
      <label>r <input type="number" id="ball-r" step="1" inputmode="numeric"></label>
    </div>
  </section>
  <section data-hideable="imagine" aria-labelledby="more-model" inert><h2 id="more-model">${words.model}</h2>
  <div id="model-choice" hidden><label>${words.model} <select id="model-select"></select></label> <p class="small" id="model-words"></p></div>
  <label class="opacity">${words.opacity} <input type="range" id="opacity" min="0" max="1" step="0.05"></label>
  <p data-hideable="save"><button type="button" id="save-strip" disabled>${words.saveMaps}</button></p>
  <p><button type="button" data-opens="about-dialog">${words.trained}</button></p>
  </section>
  <section data-hideable="attempts compare" aria-labelledby="more-attempts"><h2 id="more-attempts">${words.attempts}</h2>
    <div class="saving" data-hideable="attempts" inert>
      <button type="button" id="attempts-save">${words.saveAttempts}</button>
      <span data-hideable="puzzles"><button type="button" id="attempts-open">${words.openAttempts}</button><input type="file" id="attempts-file" accept=".jsonl,.json" aria-label="${words.attemptsFile}" hidden></span>
      <p class="small" id="attempts-words"></p>
      <ol id="attempts-read" class="replays" data-hideable="puzzles"></ol>
    </div>
    <p class="actions">
      <button type="button" id="clear-attempts">${words.clearAttempts}</button>
      <button type="button" id="proposal-save" data-hideable="compare" inert>${words.saveBalls}</button>
    </p>
  </section>
  <div data-hideable="compare" inert><section class="section" id="model-pair" aria-labelledby="pair-title" hidden>
  <h2 id="pair-title">${words.pair}</h2>
  <p class="actions"><button type="button" id="pair-run">${words.playBoth}</button> <label>${words.second} <select id="pair-model"></select></label> <label id="pair-map" hidden>${words.map} <select id="pair-map-name"></select></label></p>
  <p id="pair-words"></p>
  <div class="pair" id="pair-columns"></div>
</section></div>
</div>
`;
}
