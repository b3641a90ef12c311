// The markup of the panel Play, as constant text. What comes after the first picture is inert until then.

export const PLAY_MARKUP = `
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
  <div class="actions"><button type="button" id="model-skip" hidden>Skip to the result</button><button type="button" id="race-it">Race it</button></div>
  <p id="race-verdict"></p>
  <details id="score" hidden><summary id="score-words"></summary><p>The fewer attempts, the more points: a puzzle solved on the first attempt gives 100, on the second 85, on the tenth 50; one that is not solved within 100 gives none. The points are the mean over all puzzles that both have played. Balls that may not be placed do not count, for either. This is the benchmark’s AUCCESS: the share of puzzles solved within k attempts, each k from 1 to 100 weighted by ln(k + 1) − ln(k).</p></details>
</div>
<div id="compare-trouble" class="trouble" role="alert" data-hideable="compare" hidden><p></p><button type="button">Try again</button></div>
<div class="part" data-hideable="play">
  <p id="story" data-hideable="story"></p>
  <details id="forecast-how" hidden><summary>What are the dotted lines?</summary><p>The model’s guess: where this ball and green would go, before anything moves. The wider the ribbon around a line, the less sure the model is. Nothing is simulated for that, so it can be wrong: run the ball, and see how far off it was.</p></details>
  <div class="ball-form" data-hideable="fields">
    <label class="radius">Radius <input type="range" id="radius" step="1"></label>
    <div class="undoing" role="group" aria-label="Placements">
      <button type="button" id="undo" title="Undo  Ctrl+Z"><svg><use href="#icon-undo"/></svg><span class="visually-hidden">Undo</span></button>
      <button type="button" id="redo" title="Redo  Ctrl+Y"><svg><use href="#icon-redo"/></svg><span class="visually-hidden">Redo</span></button>
    </div>
  </div>
  <p class="hint" data-hideable="hint">Tap or click the scene to place the ball; drag it to move it, drag its knob<span class="with-mouse"> or turn the wheel</span> for its size. <span class="with-mouse">With keys: arrows, <kbd>+</kbd> and <kbd>−</kbd>.</span></p>
  <p class="small" id="difficulty"></p>
  <p data-hideable="watch"><button type="button" id="watch">Watch without a ball</button></p>
</div>
<div class="columns">
  <section aria-labelledby="player-title" data-hideable="attempts">
    <h2 id="player-title">Your attempts <span class="count" id="play-count"></span></h2>
    <ol class="attempts" id="play-attempts"></ol>
  </section>
  <section aria-labelledby="model-title" data-hideable="compare" inert>
    <h2 id="model-title">The model’s <span class="count" id="model-count"></span></h2>
    <ol class="attempts" id="model-attempts"></ol>
  </section>
</div>
<div data-hideable="attempts">
  <div id="luck" class="saving" inert hidden>
    <button type="button" id="luck-ask">Luck or plan?</button>
    <p id="luck-words"></p>
  </div>
</div>
`;
