// The shadow tree of a puzzle: scene, transport, tabs and dialogs; the panels come later, each with its own markup. It
// is the only markup that is made from text, and the text is constant. Ids are unique in each shadow tree.

import { MORE_MARKUP } from "./more-markup.js";
import { TABS_MARKUP } from "./tabs-markup.js";

const PUZZLE = `
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

<p id="problem" lang="en" role="alert" hidden></p>

<div class="puzzle" id="puzzle" lang="en" role="group" hidden>
  <div class="scene-area">
    <div class="scene">
      <canvas id="scene" tabindex="0" role="application" aria-roledescription="puzzle scene" aria-labelledby="goal" aria-describedby="description"></canvas>
      <p id="scene-label" aria-hidden="true" hidden></p>
      <div id="celebration" aria-hidden="true" hidden></div>
    </div>
    <p class="visually-hidden" id="description"></p>
    <div class="transport" role="group" aria-label="Playback">
      <button type="button" id="run" class="primary"><svg><use id="run-icon" href="#icon-run"/></svg><span id="run-label">Run</span></button>
      <div class="timeline" data-hideable="transport">
      <button type="button" id="step" title="One step  ."><svg><use href="#icon-step"/></svg><span class="visually-hidden">One step</span></button>
      <input type="range" id="time" min="0" max="0" value="0" step="1" aria-label="Time" disabled>
      <span id="clock" aria-hidden="true">0.0 s</span>
      <label data-hideable="speed"><span class="visually-hidden">Speed</span><select id="speed">
        <option value="0.25">0.25×</option><option value="0.5">0.5×</option><option value="1" selected>1×</option><option value="2">2×</option><option value="4">4×</option>
      </select></label>
      </div>
      <button type="button" id="reset" title="Back to placing  R"><svg><use href="#icon-reset"/></svg><span class="visually-hidden">Reset</span></button>
    </div>
    <div class="status-row">
      <p id="status"></p>
      <button type="button" id="see-closest" title="Shows the moment at which the green object was nearest to its goal" hidden>See it</button>
      <div id="goal-meter" role="meter" aria-label="How long the green object has touched its goal" aria-valuemin="0" hidden>
        <svg viewBox="0 0 24 24" aria-hidden="true"><circle cx="12" cy="12" r="9"/><circle cx="12" cy="12" r="9" pathLength="100" class="filled"/></svg>
        <span></span>
      </div>
      <div id="forecast" inert data-hideable="imagine">
        <label class="switch" data-hideable="forecast"><input type="checkbox" role="switch" id="forecast-on"> <span>The model’s guess</span></label>
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
        <span class="dots" role="group" aria-label="Story" data-hideable="imagine">
          <button type="button" id="caption-back" title="Back  ←"><svg><use href="#icon-previous"/></svg><span class="visually-hidden">Back</span></button>
          <button type="button" id="caption-next" title="Next  →"><svg><use href="#icon-next"/></svg><span class="visually-hidden">Next</span></button>
          <button type="button" id="caption-play"><svg><use id="caption-play-icon" href="#icon-run"/></svg><span id="caption-play-label">Play</span></button>
        </span>
        <button type="button" id="presentation-leave" data-hideable="tools" title="All panels  Esc">All panels</button>
      </div>
    </section>
    <section id="guide" aria-label="Introduction" hidden>
      <p id="guide-words"></p>
      <p class="actions"><button type="button" id="guide-act" class="primary"></button> <button type="button" id="guide-skip">Leave the introduction</button> <span class="small" id="guide-count"></span></p>
    </section>
    <p id="challenge" hidden></p>
    <p id="goal"></p>
    <p id="laid" data-hideable="imagine" hidden><span></span> <button type="button" id="laid-off">Take it off</button></p>
    ${TABS_MARKUP}
  </div>
  ${MORE_MARKUP}
</div>

<p class="visually-hidden" id="announcement" lang="en" role="status"></p>

<template id="attempt-row">
  <li>
    <button type="button" data-act="replay"><b></b><span class="mark" aria-hidden="true"></span><span class="words"></span></button>
    <button type="button" data-act="overlay"><svg aria-hidden="true"><use href="#icon-compare"/></svg></button>
    <button type="button" data-act="remove"><svg aria-hidden="true"><use href="#icon-delete"/></svg></button>
  </li>
</template>

<dialog id="keys-dialog" lang="en" aria-labelledby="keys-title">
  <h2 id="keys-title">Keys</h2>
  <dl>
    <dt><kbd>←</kbd> <kbd>→</kbd> <kbd>↑</kbd> <kbd>↓</kbd></dt><dd>in the scene: move the ball by 1, with <kbd>Shift</kbd> by 10</dd>
    <dt><kbd>+</kbd> <kbd>−</kbd></dt><dd>in the scene: larger, smaller</dd>
    <dt data-hideable="fields"><kbd>Ctrl</kbd> <kbd>Z</kbd>, <kbd>Ctrl</kbd> <kbd>Y</kbd></dt><dd data-hideable="fields">undo, redo a placement</dd>
    <dt><kbd>Space</kbd></dt><dd>run, pause, go on</dd>
    <dt data-hideable="transport"><kbd>.</kbd> <kbd>,</kbd></dt><dd data-hideable="transport">one step forward, one back</dd>
    <dt><kbd>R</kbd></dt><dd>back to placing</dd>
    <dt data-hideable="puzzles"><kbd>[</kbd> <kbd>]</kbd></dt><dd data-hideable="puzzles">previous, next puzzle</dd>
    <dt data-hideable="compare"><kbd>N</kbd></dt><dd data-hideable="compare">among the model’s balls: the next one with another result, with <kbd>Shift</kbd> the one before</dd>
    <dt><kbd>V</kbd></dt><dd>the presentation: the scene and one sentence, in large type; <kbd>Esc</kbd> leaves it<span data-hideable="imagine">, <kbd>←</kbd> <kbd>→</kbd> or <kbd>PgUp</kbd> <kbd>PgDn</kbd> go through the story</span></dd>
    <dt id="keys-of-panels"><kbd>1</kbd> to <kbd>3</kbd></dt><dd id="key-panels"></dd>
    <dt><kbd>?</kbd></dt><dd>this sheet</dd>
  </dl>
  <form method="dialog"><button>Close</button></form>
</dialog>

<dialog id="about-dialog" lang="en" aria-labelledby="about-title">
  <h2 id="about-title" tabindex="-1">About Pathlight</h2>
  <p>You choose where one red ball starts. After that nobody touches anything: balls fall and roll, bars tip, and everything bumps into everything else. <span data-hideable="compare">The model plays by the same rules, in the same simulator.</span></p>
  <div data-hideable="imagine">
  <h3>How the model thinks</h3>
  <p id="about-nets"></p>
  <h3>How it was trained</h3>
  <p>Nobody told it the laws of motion. It was shown solved puzzles: the scene, the way that the green object takes by itself, the ways that it and the red ball take when the puzzle is solved, and where that ball began. Each time, all its numbers were shifted a little, so that the next maps would come closer.</p>
  <p id="card">No model is loaded.</p>
  <dl id="card-entries"></dl>
  </div>
  <h3>Where the ideas come from</h3>
  <p data-hideable="imagine">The nets: Augustin Harter, Andrew Melnik, Gaurav Kumar, Dhruv Agarwal, Animesh Garg and Helge Ritter, <a href="https://arxiv.org/abs/2011.07357">Solving Physics Puzzles by Reasoning about Paths</a> (2020).</p>
  <p>The puzzles: the 25 ball templates of <a href="https://phyre.ai">PHYRE</a>, a benchmark for physical reasoning by Anton Bakhtin and others (2019).</p>
  <p>All of this runs in your browser. Nothing that you do here leaves your device.</p>
  <p>Pathlight is free software under the Apache License 2.0, and made with the work of many others: <a id="licences" target="_blank">their names and licences</a>.</p>
  <form method="dialog"><button>Close</button></form>
</dialog>
`;

/** The shadow tree of a puzzle, without the panels that come later. */
export function puzzleMarkup() {
  return fragmentOf(PUZZLE);
}

/**
 * @param {string} markup nothing but constants: no text of a link, a file or a model
 */
export function fragmentOf(markup) {
  const template = document.createElement("template");
  template.innerHTML = markup;
  return template.content;
}
