// The four nets in the package that the page loads. It is given a task and not an image, so that it also lays out and
// draws the scene.

import { initSync, Model } from '../../../www/pkg/pathlight.js';
import { ofMaps } from '../../web/contender.mjs';
import { TASK } from './task.mjs';

export async function load(read) {
  initSync({ module: await read('www/pkg/pathlight_bg.wasm') });
  const model = new Model(await read('assets/within-0.safetensors'));
  return ofMaps(() => [model.imaginePaths(TASK)]);
}
