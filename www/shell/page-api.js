// The API for the page's own thread, without a model: the worker has that. Its methods can be called once `loadWasm`
// has resolved.

import { Pathlight } from "../api/index.js";

export const pathlight = new Pathlight();
