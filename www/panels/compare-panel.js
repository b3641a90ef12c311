// The race and the model's balls one by one: the markup, as constant text, and the components. The race itself is part
// of the panel Play (play/play-markup.js), two models side by side of the menu (element/more-markup.js).

import { AttemptList } from "../play/attempt-list.js";
import { byId } from "../widgets/dom.js";
import { Compare } from "./compare.js";
import { ModelPair } from "./model-pair.js";
import { Proposals } from "./proposals.js";
import { Scoreboard } from "./scoreboard.js";

/** @type {import("./panel-module.js").PanelModule} */
export const COMPARE = {
  markup: `
<p class="model-badge"></p>
<p class="actions"><button type="button" id="model-turn">Let the model play</button></p>
<div id="proposals-failure"><div id="proposals-trouble" class="trouble" role="alert" hidden><p></p><button type="button">Try again</button></div></div>
<section class="part" id="proposals" aria-labelledby="open-compare" hidden>
  <p class="small" id="proposal-outcomes"></p>
  <div class="steps">
    <button type="button" id="proposal-back" title="Ball before"><svg><use href="#icon-previous"/></svg><span class="visually-hidden">Ball before</span></button>
    <input type="range" id="proposal-slider" min="1" step="1" value="1" aria-label="Which of the model’s balls">
    <button type="button" id="proposal-next" title="Next ball"><svg><use href="#icon-next"/></svg><span class="visually-hidden">Next ball</span></button>
    <span id="proposal-number">–</span>
  </div>
  <p class="actions"><button type="button" id="proposal-other" title="Next different result  N">Next different result</button></p>
  <p class="hint" id="proposal-none"></p>
  <p class="hint" id="proposal-hint">The model has up to a hundred balls ready. Step through them and see where each comes from and what it does.</p>
  <dl class="facts" id="proposal-facts" hidden>
    <dt>Why this one</dt><dd id="proposal-origin"></dd>
    <dt>Ball</dt><dd id="proposal-ball"></dd>
    <dt>Outcome</dt><dd id="proposal-outcome"></dd>
    <dt id="proposal-imagined-term">Imagined</dt><dd id="proposal-imagined"></dd>
  </dl>
  <p><button type="button" id="proposal-close" hidden>Back to placing</button></p>
</section>
<template id="pair-column">
  <div>
    <h3></h3>
    <p class="model-badge"><span></span></p>
    <p class="small model-words"></p>
    <div class="overlap-card"><canvas class="scene-layer" width="256" height="256" aria-hidden="true"></canvas><canvas class="shade-layer" width="64" height="64" role="img"></canvas></div>
    <p class="small pair-place"></p>
    <p class="pair-outcome"></p>
    <button type="button"></button>
  </div>
</template>
`,
  create: ({ root, module, client, progress, imagine, scenePicture }) => [
    new AttemptList(root, byId(root, "model-attempts"), byId(root, "model-count"), "model"),
    new Compare(root, client),
    new Proposals(root, client, imagine),
    new ModelPair(root, module, client, scenePicture),
    new Scoreboard(root, client, progress),
  ],
};
