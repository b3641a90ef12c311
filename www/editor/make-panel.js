// The panel Make: its markup and its components.

import { text } from "../text/text.js";
import { SolvableCheck } from "./solvable-check.js";
import { Editor } from "./editor.js";
import { SharePuzzle } from "./share-puzzle.js";

/** @type {import("../panels/panel-module.js").PanelModule} */
export const MAKE = {
  markup() {
    const words = text.editor.panel;
    const { undo, redo, watch } = text.play.panel;
    const { ctrl } = text.element.keys;
    return `
<p>${words.intro} <b data-hideable="imagine">${words.neverSeen}</b></p>
<div class="make-tools">
  <div class="undoing" role="group" aria-label="${words.changes}">
    <button type="button" id="make-undo" title="${undo}  ${ctrl}+Z"><svg><use href="#icon-undo"/></svg><span class="visually-hidden">${undo}</span></button>
    <button type="button" id="make-redo" title="${redo}  ${ctrl}+Y"><svg><use href="#icon-redo"/></svg><span class="visually-hidden">${redo}</span></button>
  </div>
  <div class="undoing" role="group" aria-label="${words.add}">
    <button type="button" data-adds="ball">${words.addBall}</button>
    <button type="button" data-adds="bar">${words.addBar}</button>
    <button type="button" data-adds="jar">${words.addJar}</button>
    <button type="button" data-adds="standing_sticks">${words.addSticks}</button>
  </div>
  <label class="check"><input type="checkbox" id="make-snap"> ${words.snap}</label>
</div>
<ul id="make-problems" class="problems" aria-label="${words.problems}" hidden></ul>
<ul id="make-bodies" class="bodies" aria-label="${words.bodies}"></ul>
<form id="make-fields" class="ball-form" autocomplete="off" aria-label="${words.selected}" hidden>
  <div class="ball-fields">
    <label>x <input type="number" id="make-x" step="any" inputmode="decimal"></label>
    <label>y <input type="number" id="make-y" step="any" inputmode="decimal"></label>
    <label>${words.angle} <input type="number" id="make-angle" step="any" inputmode="decimal"></label>
  </div>
  <div class="ball-fields">
    <label><span id="make-size-label"></span> <input type="number" id="make-size" step="any" inputmode="decimal"></label>
    <label id="make-thickness-label">${text.editor.sizes.thickness} <input type="number" id="make-thickness" step="any" inputmode="decimal"></label>
  </div>
  <label class="check"><input type="checkbox" id="make-dynamic"> ${words.moves}</label>
  <div class="undoing" role="group" aria-label="${words.actions}">
    <button type="button" id="make-object">${words.object}</button>
    <button type="button" id="make-goal">${words.goal}</button>
    <button type="button" id="make-duplicate">${words.duplicate}</button>
    <button type="button" id="make-remove">${words.remove}</button>
  </div>
</form>
<p class="hint">${words.hint}</p>
<p id="make-alone"></p>
<div data-hideable="imagine">
  <p class="small">${words.elsewhere}</p>
  <ul id="make-maps" class="make-maps" aria-label="${words.imagined}"></ul>
  <p class="small" id="make-maps-words"></p>
</div>
<p class="actions"><button type="button" id="make-watch">${watch}</button></p>
<section class="section" aria-labelledby="check-title">
  <h2 id="check-title">${words.check}</h2>
  <p class="actions"><button type="button" id="check-search"></button></p>
  <p class="loading" id="check-progress" hidden><label>${words.trying} <progress max="1" value="0"></progress></label></p>
  <p id="check-words"></p>
  <p class="actions"><button type="button" id="check-reveal" hidden>${words.reveal}</button></p>
  <p id="check-ball"></p>
</section>
<form id="make-share" class="ball-form" autocomplete="off" aria-label="${words.yours}">
  <label>${words.name} <input type="text" id="make-name" maxlength="60"></label>
  <div class="undoing">
    <button type="button" id="make-keep">${words.keep}</button>
    <button type="button" id="make-save">${words.save}</button>
  </div>
</form>
<p class="small" id="make-said"></p>
<p class="hint">${words.link}</p>
`;
  },
  create({ root, client, progress }) {
    const editor = new Editor(root, client);
    return [editor, new SharePuzzle(root, editor, progress.persistent), new SolvableCheck(root, client, editor)];
  },
};
