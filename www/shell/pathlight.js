// The API for the page's own thread, without a model: the worker has that. The wasm has to be loaded before this module
// is used: page/main.js imports the rest only then.

import { Pathlight } from "../api/pathlight.js";

export const pathlight = new Pathlight();
