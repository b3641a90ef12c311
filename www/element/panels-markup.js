// The markup of the panels, as constant text; the tabs that show them are in markup.js. What panel-components.js brings
// to life is inert until then.

import { LUCK_MARKUP, REPLAYS_MARKUP, SAVE_MARKUP } from "../attempts/attempts-markup.js";

export const PANELS_MARKUP = `
<p id="laid" data-hideable="imagine" hidden><span></span> <button type="button" id="laid-off">Take it off</button></p>
<div role="tabpanel" id="play" aria-labelledby="tab-play" tabindex="0" hidden>
  <section id="solved" aria-labelledby="solved-title" hidden>
    <h2 id="solved-title"></h2>
    <p class="actions">
      <a class="button primary" id="solved-next">Next puzzle</a>
      <button type="button" id="solved-share">Share</button>
      <label data-hideable="puzzles">Next: <select id="next-by"><option value="kind">similar</option><option value="harder">harder</option><option value="easier">easier</option></select></label>
    </p>
  </section>
  <div id="race" role="group" aria-labelledby="race-title" inert data-hideable="compare">
    <h2 id="race-title" class="visually-hidden">You against the model</h2>
    <dl><div><dt>You</dt><dd id="race-player"></dd></div><div class="model"><dt>The model</dt><dd id="race-model"></dd></div></dl>
    <button type="button" id="race-it">Race it</button>
    <p id="race-verdict"></p>
  </div>
  <p id="story" data-hideable="story"></p>
  <details id="forecast-how" hidden><summary>What are the dotted lines?</summary><p>The model’s guess: where this ball and green would go, before anything moves. The wider the ribbon around a line, the less sure the model is. Nothing is simulated for that, so it can be wrong: run the ball, and see how far off it was.</p></details>
  <form id="ball-form" class="ball-form" autocomplete="off" data-hideable="fields">
    <label class="radius">Radius <input type="range" id="radius" step="1"></label>
    <div class="ball-fields">
      <label>x <input type="number" id="ball-x" min="0" step="1" inputmode="numeric"></label>
      <label>y <input type="number" id="ball-y" min="0" step="1" inputmode="numeric"></label>
      <label>r <input type="number" id="ball-r" step="1" inputmode="numeric"></label>
    </div>
    <div class="undoing" role="group" aria-label="Placements">
      <button type="button" id="undo" title="Undo  Ctrl+Z"><svg><use href="#icon-undo"/></svg><span class="visually-hidden">Undo</span></button>
      <button type="button" id="redo" title="Redo  Ctrl+Y"><svg><use href="#icon-redo"/></svg><span class="visually-hidden">Redo</span></button>
    </div>
  </form>
  <p class="hint" data-hideable="hint">Tap or click the scene to place the ball; drag it to move it, drag its knob<span class="with-mouse"> or turn the wheel</span> for its size. <span class="with-mouse">With keys: arrows, <kbd>+</kbd> and <kbd>−</kbd>.</span></p>
  <p class="small" id="difficulty"></p>
  <p data-hideable="watch"><button type="button" id="watch">Watch without a ball</button></p>
  <div data-hideable="attempts">
    <h2>Your attempts <span class="count" id="play-count"></span></h2>
    <ol class="attempts" id="play-attempts"></ol>
    <p class="empty" id="play-empty">None yet. A ball that may not be placed does not count.</p>
    ${LUCK_MARKUP}
    ${REPLAYS_MARKUP}
  </div>
  ${SAVE_MARKUP}
</div>

<div role="tabpanel" id="imagine" aria-labelledby="tab-imagine" tabindex="0" inert hidden>
  <div id="imagine-trouble" class="trouble" role="alert" hidden><p></p><button type="button">Try again</button></div>
  <p id="imagine-loading" class="loading" hidden><label>Loading the model <progress max="1"></progress></label></p>
  <div id="imagine-body">
    <div class="steps" role="group" aria-labelledby="walkthrough-step">
      <button type="button" id="walkthrough-play"><svg><use id="walkthrough-play-icon" href="#icon-run"/></svg><span id="walkthrough-play-label">Play</span></button>
      <button type="button" id="walkthrough-all" aria-pressed="true">All</button>
      <span class="dots">
        <button type="button" id="walkthrough-back" title="Back"><svg><use href="#icon-previous"/></svg><span class="visually-hidden">Back</span></button>
        <span class="dots" id="walkthrough-dots"></span>
        <button type="button" id="walkthrough-next" title="Next"><svg><use href="#icon-next"/></svg><span class="visually-hidden">Next</span></button>
      </span>
    </div>
    <p class="visually-hidden" id="walkthrough-step"></p>
    <ul class="maps" id="maps"></ul>
    <section id="choice" aria-labelledby="choice-title" hidden><h2 id="choice-title"></h2><p id="choice-meaning"></p><p id="choice-result"></p><details><summary>How?</summary><p id="choice-how"></p></details></section>
    <p id="imagine-intro"></p>
    <p class="model-badge"></p>
    <p class="small" id="outlines-note" hidden>Over the scene two maps are shaded; of the others you see the outlines.</p>
    <label class="opacity">Opacity <input type="range" id="opacity" min="0" max="1" step="0.05"></label>
    <div id="model-choice" hidden><label>Model <select id="model-select"></select></label> <p class="small" id="model-words"></p></div>
    <section class="section" aria-labelledby="overlap-title">
      <h2 id="overlap-title">Imagined and real</h2>
      <p class="hint" id="overlap-empty">Run a ball<span data-hideable="compare">, let the model play</span> or watch without a ball: then you see here how well it was imagined.</p>
      <p class="visually-hidden" id="overlap-words"></p>
      <ul class="runs" id="runs"></ul>
      <details id="overlap-how" hidden><summary>What do the numbers mean?</summary><p>The shade is imagined, the line goes round what was real. 100 % means that both are the same, 0 % that they have nothing in common. It is the soft intersection over union on 64 × 64 cells: the smaller of the two values in each cell, added up, by the larger of the two, added up.</p></details>
    </section>
    <p data-hideable="save"><button type="button" id="save-strip" disabled>Save all maps as one picture</button></p>
    <p class="small" id="imagined-in"></p>
    <p><button type="button" data-opens="about-dialog">How was it trained?</button></p>
  </div>
</div>

<div role="tabpanel" id="compare" aria-labelledby="tab-compare" tabindex="0" inert hidden>
  <p id="verdict"></p>
  <p class="model-badge"></p>
  <div id="compare-trouble" class="trouble" role="alert" hidden><p></p><button type="button">Try again</button></div>
  <p class="actions">
    <button type="button" id="model-turn" class="primary">Let the model play</button>
    <button type="button" id="model-skip" hidden>Skip to the result</button>
    <button type="button" id="compare-both">Run both</button>
  </p>
  <p class="small key"><span class="line"></span> you <span class="line dashed"></span> the model</p>
  <div class="columns">
    <section aria-labelledby="player-title"><h2 id="player-title">You <span class="count" id="player-count"></span></h2><ol class="attempts" id="player-attempts"></ol><p class="empty">You have not tried yet.</p></section>
    <section aria-labelledby="model-title"><h2 id="model-title">The model <span class="count" id="model-count"></span></h2><ol class="attempts" id="model-attempts"></ol><p class="empty">It has not played yet.</p></section>
  </div>
  <p><button type="button" id="clear-attempts">Clear attempts</button></p>

  <div id="proposals-failure"><div id="proposals-trouble" class="trouble" role="alert" hidden><p></p><button type="button">Try again</button></div></div>
  <section class="section" id="proposals" aria-labelledby="proposals-title" hidden>
    <h2 id="proposals-title">The model’s balls, one by one</h2>
    <div id="proposal-strip" class="outcome-strip" aria-hidden="true"></div>
    <p class="small" id="proposal-outcomes"></p>
    <ul class="samples outcome-key" id="proposal-key" aria-hidden="true"><li><span data-outcome="solved"></span> solves</li><li><span data-outcome="touched"></span> touches for a while</li><li><span data-outcome="missed"></span> never touches</li></ul>
    <div class="steps">
      <button type="button" id="proposal-back" title="Ball before"><svg><use href="#icon-previous"/></svg><span class="visually-hidden">Ball before</span></button>
      <input type="range" id="proposal-slider" min="1" step="1" value="1" aria-label="Which of the model’s balls">
      <button type="button" id="proposal-next" title="Next ball"><svg><use href="#icon-next"/></svg><span class="visually-hidden">Next ball</span></button>
      <span id="proposal-number">–</span>
    </div>
    <p class="actions"><button type="button" id="proposal-other" title="Next different result  N">Next different result</button> <button type="button" id="proposal-save">Save as CSV</button></p>
    <p class="hint" id="proposal-none"></p>
    <p class="hint" id="proposal-hint">The model has up to a hundred balls ready. Step through them and see where each comes from and what it does.</p>
    <dl class="facts" id="proposal-facts" hidden>
      <dt>Why this one</dt><dd id="proposal-origin"></dd>
      <dt>Ball</dt><dd id="proposal-ball"></dd>
      <dt>Allowed?</dt><dd id="proposal-valid"></dd>
      <dt>Outcome</dt><dd id="proposal-outcome"></dd>
      <dt id="proposal-imagined-term">Imagined</dt><dd id="proposal-imagined"></dd>
    </dl>
    <p><button type="button" id="proposal-close" hidden>Back to placing</button></p>
  </section>

  <section class="section" id="model-pair" aria-labelledby="pair-title" hidden>
    <h2 id="pair-title">Two models side by side</h2>
    <p class="actions"><button type="button" id="pair-run">Let both play</button> <label>Second model <select id="pair-model"></select></label> <label id="pair-map" hidden>Map <select id="pair-map-name"></select></label></p>
    <p id="pair-words"></p>
    <div class="pair" id="pair-columns"></div>
  </section>

  <section class="section" aria-labelledby="score-title">
    <h2 id="score-title">Scoreboard</h2>
    <p class="hint" id="score-empty">Try a puzzle, and let the model play it too: then your scores stand here side by side.</p>
    <div id="score-table" hidden>
      <table>
        <caption>Points from 0 to 100, <span id="score-count"></span></caption>
        <thead><tr><th scope="col">Puzzle</th><th scope="col">You</th><th scope="col">The model</th></tr></thead>
        <tbody id="score-rows"></tbody>
        <tfoot><tr><th scope="row">Points</th><td id="score-player"></td><td id="score-model"></td></tr></tfoot>
      </table>
      <details><summary>How are points counted?</summary><p>The fewer attempts, the more points: a puzzle solved on the first attempt gives 100, on the second 85, on the tenth 50; one that is not solved within 100 gives none. The points are the mean over all puzzles that both have played. Balls that may not be placed do not count, for either. This is the benchmark’s AUCCESS: the share of puzzles solved within k attempts, each k from 1 to 100 weighted by ln(k + 1) − ln(k).</p></details>
    </div>
  </section>
</div>

<div role="tabpanel" id="predict" aria-labelledby="tab-predict" tabindex="0" inert hidden>
  <p>Which way will the green object go? Draw its path in the scene. Then run, and see who was closer: you or the model.</p>
  <p class="actions">
    <button type="button" id="predict-watch" class="primary">Run without ball</button>
    <button type="button" id="predict-run">Run with ball</button>
    <button type="button" id="predict-wipe">Wipe</button>
  </p>
  <p id="predict-words"></p>
  <section id="predict-result" aria-label="Prediction and reality" hidden>
    <p class="model-badge"></p>
    <ul class="overlap-cards" id="predict-cards"></ul>
    <details><summary>How is it measured?</summary><p>Your line counts as if the green object had slid along it. What is shaded and what was real, inside the line, are laid over each other: 100 % means that both are the same. The model is measured alike: its base path if there is no ball, its target path if there is one. It has not seen your ball.</p></details>
  </section>
  <p class="hint">Draw with the mouse or a finger. With keys, in the scene: arrows draw on from the green object, with <kbd>Shift</kbd> further; <kbd>Backspace</kbd> takes a piece back.</p>
</div>

<div role="tabpanel" id="map" aria-labelledby="tab-map" tabindex="0" inert hidden>
  <p>Where could the red ball start, so that the puzzle is solved? The computer tries every place: roughly at first, then finer.</p>
  <p class="actions"><button type="button" id="solve-map-search" class="primary"></button></p>
  <p class="loading" id="solve-map-progress" hidden><label>Trying <progress max="1" value="0"></progress></label></p>
  <p id="solve-map-words"></p>
  <ul class="samples">
    <li><canvas width="256" height="256" data-outcome="3" aria-hidden="true"></canvas> solves it</li>
    <li><canvas width="256" height="256" data-outcome="2" aria-hidden="true"></canvas> does not</li>
    <li><canvas width="256" height="256" data-outcome="1" aria-hidden="true"></canvas> no room</li>
  </ul>
  <label class="check" data-hideable="imagine"><input type="checkbox" id="solve-map-placement"> Compare with the model’s guess</label>
  <p class="model-badge" data-hideable="imagine"></p>
  <p class="hint">The radius is that of your ball. Each place is tried by a whole simulation, in a worker beside the page.</p>
</div>
`;
