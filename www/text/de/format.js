// Numbers, units and lists as German writes them.

import { formatsOf } from "../formats.js";

/** @type {typeof import("../en/format.js").format} */
export const format = formatsOf("de");
export const { counted, list, number, percent, seconds } = format;
