// Numbers, units and lists as English writes them.

import { formatsOf } from "../formats.js";

export const format = formatsOf("en-GB");
export const { counted, list, number, percent, seconds } = format;
