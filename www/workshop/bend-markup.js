// The markup of the panel Bend, as constant text.

export const BEND_MARKUP = `
<div role="tabpanel" id="bend" aria-labelledby="tab-bend" tabindex="0" inert hidden>
  <p>Make a puzzle of your own out of this one. <b data-hideable="imagine">The model has never seen such scenes.</b></p>
  <div class="bend-tools">
    <div class="undoing" role="group" aria-label="Changes">
      <button type="button" id="bend-undo" title="Undo  Ctrl+Z"><svg><use href="#icon-undo"/></svg><span class="visually-hidden">Undo</span></button>
      <button type="button" id="bend-redo" title="Redo  Ctrl+Y"><svg><use href="#icon-redo"/></svg><span class="visually-hidden">Redo</span></button>
    </div>
    <div class="undoing" role="group" aria-label="Add a body">
      <button type="button" data-adds="ball">+ Ball</button>
      <button type="button" data-adds="bar">+ Bar</button>
      <button type="button" data-adds="jar">+ Jar</button>
      <button type="button" data-adds="standing_sticks">+ Sticks</button>
    </div>
    <label class="check"><input type="checkbox" id="bend-snap"> Snap</label>
  </div>
  <ul id="bend-problems" class="problems" aria-label="What keeps this from being a puzzle" hidden></ul>
  <ul id="bend-bodies" class="bodies" aria-label="Bodies"></ul>
  <form id="bend-fields" class="ball-form" autocomplete="off" aria-label="Selected body" hidden>
    <div class="ball-fields">
      <label>x <input type="number" id="bend-x" step="any" inputmode="decimal"></label>
      <label>y <input type="number" id="bend-y" step="any" inputmode="decimal"></label>
      <label>angle <input type="number" id="bend-angle" step="any" inputmode="decimal"></label>
    </div>
    <div class="ball-fields">
      <label><span id="bend-size-label"></span> <input type="number" id="bend-size" step="any" inputmode="decimal"></label>
      <label id="bend-thickness-label">thickness <input type="number" id="bend-thickness" step="any" inputmode="decimal"></label>
    </div>
    <label class="check"><input type="checkbox" id="bend-dynamic"> Moves</label>
    <div class="undoing" role="group" aria-label="What to do with it">
      <button type="button" id="bend-object">Green object</button>
      <button type="button" id="bend-goal">Goal</button>
      <button type="button" id="bend-duplicate">Duplicate</button>
      <button type="button" id="bend-remove">Delete</button>
    </div>
  </form>
  <p class="hint">Select a body in the scene or in the list. With keys, in the scene: <kbd>N</kbd> and <kbd>P</kbd> select, arrows move, <kbd>,</kbd> <kbd>.</kbd> turn, <kbd>+</kbd> <kbd>−</kbd> resize, with <kbd>Shift</kbd> further; <kbd>D</kbd> duplicates, <kbd>Delete</kbd> removes.</p>
  <p id="bend-alone"></p>
  <div data-hideable="imagine">
    <p class="small">What the model imagines: it learned from the benchmark’s puzzles alone, so here it may be nonsense.</p>
    <ul id="bend-maps" class="bend-maps" aria-label="What the model imagines"></ul>
    <p class="small" id="bend-maps-words"></p>
  </div>
  <p class="actions"><button type="button" id="bend-watch">Watch without a ball</button></p>
  <section class="section" aria-labelledby="check-title">
    <h2 id="check-title">Can it be solved?</h2>
    <p class="actions"><button type="button" id="check-search"></button></p>
    <p class="loading" id="check-progress" hidden><label>Trying <progress max="1" value="0"></progress></label></p>
    <p id="check-words"></p>
    <p class="actions"><button type="button" id="check-reveal" hidden>Show the easiest ball</button></p>
    <p id="check-ball"></p>
  </section>
  <form id="bend-share" class="ball-form" autocomplete="off" aria-label="Your puzzle">
    <label>Name <input type="text" id="bend-name" maxlength="60"></label>
    <div class="undoing">
      <button type="button" id="bend-keep">Keep it in this browser</button>
      <button type="button" id="bend-save">Save to a file</button>
    </div>
  </form>
  <p class="small" id="bend-said"></p>
  <p class="hint">The address of this page holds the whole puzzle: copy the link, and whoever opens it plays what you made.</p>
</div>
`;
