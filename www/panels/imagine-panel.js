// The panel Imagine: its markup and its components.

import { text } from "../text/text.js";
import { Choice } from "./choice.js";
import { ImaginedVsReal } from "./imagined-vs-real.js";
import { ModelBadge } from "./model-badge.js";
import { Presentation } from "./presentation.js";
import { StripPicture } from "./strip-picture.js";
import { Walkthrough } from "./walkthrough.js";

/** @type {import("./panel-module.js").PanelModule} */
export const IMAGINE = {
  markup() {
    const words = text.panels.imagine;
    return `
<div id="imagine-trouble" class="trouble" role="alert" hidden><p></p><button type="button"></button></div>
<p id="imagine-loading" class="loading" hidden><label>${words.loading} <progress max="1"></progress></label></p>
<div id="imagine-body">
  <div class="steps" role="group" aria-labelledby="walkthrough-step">
    <button type="button" id="walkthrough-play"><svg><use id="walkthrough-play-icon" href="#icon-run"/></svg><span id="walkthrough-play-label">${words.play}</span></button>
    <button type="button" id="walkthrough-all" aria-pressed="true">${words.all}</button>
    <span class="dots">
      <button type="button" id="walkthrough-back" title="${words.back}"><svg><use href="#icon-previous"/></svg><span class="visually-hidden">${words.back}</span></button>
      <span class="dots" id="walkthrough-dots"></span>
      <button type="button" id="walkthrough-next" title="${words.next}"><svg><use href="#icon-next"/></svg><span class="visually-hidden">${words.next}</span></button>
    </span>
  </div>
  <p class="visually-hidden" id="walkthrough-step"></p>
  <ul class="maps" id="maps"></ul>
  <section id="choice" aria-labelledby="choice-title" hidden><h2 id="choice-title"></h2><p id="choice-meaning"></p><p id="choice-result"></p><details><summary>${words.how}</summary><p id="choice-how"></p></details></section>
  <p id="imagine-intro"></p>
  <p class="model-badge"></p>
  <p class="small" id="outlines-note" hidden>${words.outlines}</p>
  <section class="section" aria-labelledby="overlap-title">
    <h2 id="overlap-title">${words.real}</h2>
    <p class="hint" id="overlap-empty">${words.empty}</p>
    <p class="visually-hidden" id="overlap-words"></p>
    <ul class="runs" id="runs"></ul>
    <details id="overlap-how" hidden><summary>${words.numbers}</summary><p>${words.numbersHow}</p></details>
  </section>
  <p class="small" id="imagined-in"></p>
</div>
<template id="map-row">
  <li>
    <label><input type="checkbox"> <b></b></label>
    <div class="map"><canvas class="scene-layer" width="256" height="256" aria-hidden="true"></canvas><canvas class="shade-layer" width="64" height="64" role="img"></canvas></div>
    <p class="meaning"></p>
    <div class="scale" aria-hidden="true"><span>0</span><canvas class="legend" width="64" height="4"></canvas><span class="peak"></span></div>
    <p class="summary"></p>
    <details><summary>${words.how}</summary><p class="how"></p><p class="numbers"></p></details>
  </li>
</template>
<template id="run-row"><li><h3></h3><ul class="overlap-cards"></ul></li></template>
<template id="overlap-card">
  <li>
    <div class="overlap-card"><canvas class="scene-layer" width="256" height="256" aria-hidden="true"></canvas><canvas class="shade-layer" width="64" height="64" aria-hidden="true"></canvas><canvas class="outline-layer" width="512" height="512" role="img"></canvas></div>
    <p><b></b> <span></span></p>
  </li>
</template>
`;
  },
  create({ root, client, preferences, imagine, scenePicture }) {
    const choice = new Choice(root, client);
    const walkthrough = new Walkthrough(root, imagine, choice, preferences);
    return [
      choice,
      walkthrough,
      new Presentation(root, walkthrough),
      new ImaginedVsReal(root, imagine, scenePicture),
      new ModelBadge(root, client, imagine),
      new StripPicture(root, imagine, scenePicture),
    ];
  },
};
