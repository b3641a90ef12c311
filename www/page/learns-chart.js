// How many tries each puzzle took with a memory and without, as a chart: a mark for each puzzle, and a line through the
// mean of the last few.

import { svgElement } from "./svg-element.js";
import { text } from "../text/text.js";
import { runningMeans } from "./learns-words.js";

/** @typedef {import("./learns-words.js").Played} Played */

/** The size of the chart, in its own units. */
const WIDTH = 320;
const HEIGHT = 150;
/** The tries at which a line is drawn. */
const TICKS = [1, 3, 10, 30, 100];
/** Least number of puzzles that have room. */
const ROOM = 20;

/**
 * @param {Played[]} all
 * @param {number} limit the tries that there are
 */
export function learnsChart(all, limit) {
  const chart = svgElement("svg", {
    viewBox: `-28 -12 ${WIDTH + 36} ${HEIGHT + 40}`,
    role: "img",
    "aria-label": text.learns.chartLabel,
  });
  const room = Math.max(ROOM, Math.ceil(all.length / ROOM) * ROOM);
  const across = (/** @type {number} */ index) => ((index + 0.5) * WIDTH) / room;
  const up = (/** @type {number} */ tries) => HEIGHT * (1 - Math.log(tries) / Math.log(limit));
  for (const tries of TICKS) {
    const y = up(tries);
    chart.append(
      svgElement("path", { d: `M0 ${y.toFixed(1)}H${WIDTH}`, class: "grid" }),
      label(String(tries), { x: -6, y: y + 4, "text-anchor": "end" }),
    );
  }
  for (const number of [1, room / 2, room])
    chart.append(label(String(number), { x: across(number - 1), y: HEIGHT + 15, "text-anchor": "middle" }));
  chart.append(label(text.learns.axis, { x: WIDTH / 4, y: HEIGHT + 15, "text-anchor": "middle" }));
  for (const series of /** @type {const} */ (["fresh", "learned"])) {
    const firsts = all.map((played) => played[series]);
    const means = runningMeans(firsts.map((first) => first ?? limit));
    const points = means.map((mean, index) => `${across(index).toFixed(1)} ${up(mean).toFixed(1)}`);
    if (points.length > 1) chart.append(svgElement("path", { d: `M${points.join("L")}`, class: series }));
    chart.append(...firsts.map((first, index) => mark(series, first, across(index), up(first ?? limit))));
  }
  return chart;
}

/**
 * A disc with a memory, a square without; a cross if the puzzle was not solved.
 * @param {"learned" | "fresh"} series
 * @param {number | null} first
 * @param {number} x
 * @param {number} y
 */
function mark(series, first, x, y) {
  if (first === null) {
    const d = `M${x - 3} ${y - 3}l6 6m0 -6l-6 6`;
    return svgElement("path", { d, class: `mark ${series}` });
  }
  return series === "learned"
    ? svgElement("circle", { cx: x, cy: y, r: 3.4, class: series })
    : svgElement("rect", { x: x - 2.8, y: y - 2.8, width: 5.6, height: 5.6, class: series });
}

/**
 * @param {string} words
 * @param {Record<string, string | number>} attributes
 */
function label(words, attributes) {
  const created = svgElement("text", attributes);
  created.textContent = words;
  return created;
}
