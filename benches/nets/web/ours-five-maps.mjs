// What the page shows: the four nets, and the judge on the scene and on its mirror image, with the check of which balls
// are valid. No other engine runs the judge; the row says what it adds.

import { initSync, Model } from '../../../www/pkg/pathlight.js';
import { ofMaps } from '../../web/contender.mjs';
import { TASK } from './task.mjs';

export async function load(read) {
  initSync({ module: await read('www/pkg/pathlight_bg.wasm') });
  const model = new Model(await read('assets/within-0.safetensors'));
  return ofMaps(() => {
    const { base, target, action, placement } = model.imagine(TASK);
    return [base, target, action, placement];
  });
}
