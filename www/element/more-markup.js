// The menu “…”: all that a first-time visitor does not need, as constant text.

export const MORE_MARKUP = `
<div id="more" popover role="dialog" aria-labelledby="more-title">
  <h2 id="more-title" class="visually-hidden">More</h2>
  <section data-hideable="fields" aria-labelledby="more-ball"><h2 id="more-ball">Ball</h2>
    <div class="ball-fields">
      <label>x <input type="number" id="ball-x" min="0" step="1" inputmode="numeric"></label>
      <label>y <input type="number" id="ball-y" min="0" step="1" inputmode="numeric"></label>
      <label>r <input type="number" id="ball-r" step="1" inputmode="numeric"></label>
    </div>
  </section>
  <section data-hideable="imagine" aria-labelledby="more-model" inert><h2 id="more-model">Model</h2>
  <div id="model-choice" hidden><label>Model <select id="model-select"></select></label> <p class="small" id="model-words"></p></div>
  <label class="opacity">Opacity <input type="range" id="opacity" min="0" max="1" step="0.05"></label>
  <p data-hideable="save"><button type="button" id="save-strip" disabled>Save all maps as one picture</button></p>
  <p><button type="button" data-opens="about-dialog">How was it trained?</button></p>
  </section>
  <section data-hideable="attempts compare" aria-labelledby="more-attempts"><h2 id="more-attempts">Attempts</h2>
    <div class="saving" data-hideable="attempts" inert>
      <button type="button" id="attempts-save">Save the attempts</button>
      <span data-hideable="puzzles"><button type="button" id="attempts-open">Open attempts</button><input type="file" id="attempts-file" accept=".jsonl,.json" aria-label="A file of attempts" hidden></span>
      <p class="small" id="attempts-words"></p>
      <ol id="attempts-read" class="replays" data-hideable="puzzles"></ol>
    </div>
    <p class="actions">
      <button type="button" id="clear-attempts">Clear attempts</button>
      <button type="button" id="proposal-save" data-hideable="compare" inert>Save the model’s balls as CSV</button>
    </p>
  </section>
  <div data-hideable="compare" inert><section class="section" id="model-pair" aria-labelledby="pair-title" hidden>
  <h2 id="pair-title">Two models side by side</h2>
  <p class="actions"><button type="button" id="pair-run">Let both play</button> <label>Second model <select id="pair-model"></select></label> <label id="pair-map" hidden>Map <select id="pair-map-name"></select></label></p>
  <p id="pair-words"></p>
  <div class="pair" id="pair-columns"></div>
</section></div>
</div>
`;
