// The names of the 25 kinds of puzzles and what happens in them, as the wasm has them.

import { TEMPLATES } from "../../pkg/constants.js";

/** @type {Record<string, { name: string, story: string }>} */
export const kinds = Object.fromEntries(TEMPLATES.map(({ id, name, story }) => [id, { name, story }]));
