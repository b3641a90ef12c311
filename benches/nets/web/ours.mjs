// Our nets in the package that the page loads. They are given a task and not an image, so that they also lay out and
// draw the scene.

import { initSync, Model } from "../../../www/pkg/worker/pathlight.js";
import { ofMaps } from "../../web/implementation.mjs";
import { OTHER_TASK, TASK } from "./task.mjs";

/** `what` is 'nets', the four nets; 'all-nets', all five maps as the page shows them; or 'propose', a hundred balls. */
export async function load(read, what) {
  initSync({ module: await read("www/pkg/worker/pathlight_bg.wasm") });
  const model = new Model(await read("assets/within-0.safetensors"));
  let calls = 0;
  const works = {
    nets: () => [model.imaginePaths(TASK)],
    "all-nets": () => {
      const { base, target, action, placement } = model.imagine(TASK);
      return [base, target, action, placement];
    },
    propose: () => model.propose(calls++ % 2 === 0 ? TASK : OTHER_TASK, 0).map(({ ball }) => ball),
  };
  return ofMaps(works[what]);
}
