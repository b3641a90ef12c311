// The race and the model's balls one by one: the markup and the components. The race itself is part
// of the panel Play (play/play-markup.js), two models side by side of the menu (element/more-markup.js).

import { AttemptList } from "../play/attempt-list.js";
import { text } from "../text/text.js";
import { byId } from "../widgets/dom.js";
import { Race } from "./race.js";
import { ModelPair } from "./model-pair.js";
import { Proposals } from "./proposals.js";
import { Remembers } from "./remembers.js";
import { Scoreboard } from "./scoreboard.js";

/** @type {import("./panel-module.js").PanelModule} */
export const COMPARE = {
  markup() {
    const words = text.panels.proposals;
    return `
<p class="model-badge"></p>
<p class="actions"><button type="button" id="model-turn">${text.panels.compare.play}</button></p>
<div id="proposals-failure"><div id="proposals-trouble" class="trouble" role="alert" hidden><p></p><button type="button"></button></div></div>
<section class="part" id="proposals" aria-labelledby="open-compare" hidden>
  <p class="small" id="proposal-outcomes"></p>
  <p class="hint" id="proposals-afresh" hidden>${words.afresh}</p>
  <div class="steps">
    <button type="button" id="proposal-back" title="${words.back}"><svg><use href="#icon-previous"/></svg><span class="visually-hidden">${words.back}</span></button>
    <input type="range" id="proposal-slider" min="1" step="1" value="1" aria-label="${words.which}">
    <button type="button" id="proposal-next" title="${words.next}"><svg><use href="#icon-next"/></svg><span class="visually-hidden">${words.next}</span></button>
    <span id="proposal-number">–</span>
  </div>
  <p class="actions"><button type="button" id="proposal-other" title="${words.other}  N">${words.other}</button></p>
  <p class="hint" id="proposal-none"></p>
  <p class="hint" id="proposal-hint">${words.hint}</p>
  <dl class="facts" id="proposal-facts" hidden>
    <dt>${words.why}</dt><dd id="proposal-origin"></dd>
    <dt>${words.ball}</dt><dd id="proposal-ball"></dd>
    <dt>${words.outcome}</dt><dd id="proposal-outcome"></dd>
    <dt id="proposal-imagined-term">${words.imagined}</dt><dd id="proposal-imagined"></dd>
  </dl>
  <p><button type="button" id="proposal-close" hidden>${words.close}</button></p>
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
`;
  },
  create: ({ root, module, client, progress, preferences, memory, hrefOf, imagine, scenePicture }) => [
    new AttemptList(root, byId(root, "model-attempts"), byId(root, "model-count"), "model"),
    new Race(root, client, memory, (task) => hrefOf(task, "play")),
    new Remembers(root, memory, preferences),
    new Proposals(root, client, imagine),
    new ModelPair(root, module, client, scenePicture),
    new Scoreboard(root, client, progress, memory),
  ],
};
