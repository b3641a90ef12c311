// The panel Make: its markup, as constant text, and its components.

import { Check } from "./check.js";
import { Editor } from "./editor.js";
import { SharePuzzle } from "./share-puzzle.js";

/** @type {import("../panels/panel-module.js").PanelModule} */
export const MAKE = {
  markup: `
<p>Make a puzzle of your own out of this one. <b data-hideable="imagine">The model has never seen such scenes.</b></p>
<div class="make-tools">
  <div class="undoing" role="group" aria-label="Changes">
    <button type="button" id="make-undo" title="Undo  Ctrl+Z"><svg><use href="#icon-undo"/></svg><span class="visually-hidden">Undo</span></button>
    <button type="button" id="make-redo" title="Redo  Ctrl+Y"><svg><use href="#icon-redo"/></svg><span class="visually-hidden">Redo</span></button>
  </div>
  <div class="undoing" role="group" aria-label="Add a body">
    <button type="button" data-adds="ball">+ Ball</button>
    <button type="button" data-adds="bar">+ Bar</button>
    <button type="button" data-adds="jar">+ Jar</button>
    <button type="button" data-adds="standing_sticks">+ Sticks</button>
  </div>
  <label class="check"><input type="checkbox" id="make-snap"> Snap</label>
</div>
<ul id="make-problems" class="problems" aria-label="What keeps this from being a puzzle" hidden></ul>
<ul id="make-bodies" class="bodies" aria-label="Bodies"></ul>
<form id="make-fields" class="ball-form" autocomplete="off" aria-label="Selected body" hidden>
  <div class="ball-fields">
    <label>x <input type="number" id="make-x" step="any" inputmode="decimal"></label>
    <label>y <input type="number" id="make-y" step="any" inputmode="decimal"></label>
    <label>angle <input type="number" id="make-angle" step="any" inputmode="decimal"></label>
  </div>
  <div class="ball-fields">
    <label><span id="make-size-label"></span> <input type="number" id="make-size" step="any" inputmode="decimal"></label>
    <label id="make-thickness-label">thickness <input type="number" id="make-thickness" step="any" inputmode="decimal"></label>
  </div>
  <label class="check"><input type="checkbox" id="make-dynamic"> Moves</label>
  <div class="undoing" role="group" aria-label="What to do with it">
    <button type="button" id="make-object">Green object</button>
    <button type="button" id="make-goal">Goal</button>
    <button type="button" id="make-duplicate">Duplicate</button>
    <button type="button" id="make-remove">Delete</button>
  </div>
</form>
<p class="hint">Select a body in the scene or in the list. With keys, in the scene: <kbd>N</kbd> and <kbd>P</kbd> select, arrows move, <kbd>,</kbd> <kbd>.</kbd> turn, <kbd>+</kbd> <kbd>−</kbd> resize, with <kbd>Shift</kbd> further; <kbd>D</kbd> duplicates, <kbd>Delete</kbd> removes.</p>
<p id="make-alone"></p>
<div data-hideable="imagine">
  <p class="small">What the model imagines: it learned from the benchmark’s puzzles alone, so here it may be nonsense.</p>
  <ul id="make-maps" class="make-maps" aria-label="What the model imagines"></ul>
  <p class="small" id="make-maps-words"></p>
</div>
<p class="actions"><button type="button" id="make-watch">Watch without a ball</button></p>
<section class="section" aria-labelledby="check-title">
  <h2 id="check-title">Can it be solved?</h2>
  <p class="actions"><button type="button" id="check-search"></button></p>
  <p class="loading" id="check-progress" hidden><label>Trying <progress max="1" value="0"></progress></label></p>
  <p id="check-words"></p>
  <p class="actions"><button type="button" id="check-reveal" hidden>Show the easiest ball</button></p>
  <p id="check-ball"></p>
</section>
<form id="make-share" class="ball-form" autocomplete="off" aria-label="Your puzzle">
  <label>Name <input type="text" id="make-name" maxlength="60"></label>
  <div class="undoing">
    <button type="button" id="make-keep">Keep it in this browser</button>
    <button type="button" id="make-save">Save to a file</button>
  </div>
</form>
<p class="small" id="make-said"></p>
<p class="hint">The address of this page holds the whole puzzle: copy the link, and whoever opens it plays what you made.</p>
`,
  create({ root, client, progress }) {
    const editor = new Editor(root, client);
    return [editor, new SharePuzzle(root, editor, progress.persistent), new Check(root, client, editor)];
  },
};
