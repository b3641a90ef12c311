// The markup of what this folder adds to the panel Play, as constant text.

/** After a ball that solved. */
export const LUCK_MARKUP = `
<div id="luck" class="saving" inert hidden>
  <button type="button" id="luck-ask">Luck or plan?</button>
  <p id="luck-words"></p>
</div>
`;

/** The badge of a run, and attempts as files. */
export const REPLAYS_MARKUP = `
<div class="saving" role="group" aria-label="Attempts as files" inert>
  <button type="button" id="digest" class="badge" title="The digest of this run" hidden></button>
  <button type="button" id="attempts-save">Save the attempts</button>
  <span data-hideable="puzzles"><button type="button" id="attempts-open">Open attempts</button><input type="file" id="attempts-file" accept=".jsonl,.json" aria-label="A file of attempts" hidden></span>
  <p class="small" id="attempts-words"></p>
  <ol id="attempts-read" class="replays" data-hideable="puzzles"></ol>
</div>
`;

/** What the scene shows as a picture or a film. */
export const SAVE_MARKUP = `
<div class="saving" role="group" aria-label="Save what the scene shows" inert data-hideable="save">
  <button type="button" id="save-picture">Save a picture</button>
  <button type="button" id="save-film">Save the run as a film</button>
  <p class="small" id="save-words"></p>
</div>
`;
