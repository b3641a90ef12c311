// Numbers, units and lists as English writes them.

import { formatsOf } from "../formats.js";

export const format = formatsOf("en-GB", { point: ".", group: ",", percent: "" });
export const { counted, list, number, percent, seconds } = format;
