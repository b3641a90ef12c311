// The charts of the exhibits, as SVG in the colours of exhibits.css.

import { html, svg } from "lit-html";
import { trend } from "./learns-timeline.ts";
import { ATTEMPT_LIMIT } from "../pkg/constants.ts";
import type { TemplateResult } from "lit-html";
import type { Played } from "./learns-timeline.ts";
import type { Bin } from "./results-file.ts";
import type { ExhibitText } from "../text/exhibits-en.ts";

/** Size of the chart of balls, in its own units. */
const WIDTH = 320;
const HEIGHT = 150;
const TICKS = [1, 3, 10, 30, 100];
/** Minimum number of puzzles on the axis. */
const ROOM = 20;

/** Shows how many balls each puzzle took, and the trend of the last few. */
export function ballsChart(all: readonly Played[], text: ExhibitText): TemplateResult {
  const room = Math.max(ROOM, Math.ceil(all.length / ROOM) * ROOM);
  const across = (index: number) => ((index + 0.5) * WIDTH) / room;
  const up = (balls: number) => HEIGHT * (1 - Math.log(balls) / Math.log(ATTEMPT_LIMIT));
  const series = (name: "learned" | "fresh") => {
    const firsts = all.map((played) => played[name]);
    const means = trend(firsts.map((first) => first ?? ATTEMPT_LIMIT));
    const line = means.map((mean, index) => `${across(index).toFixed(1)} ${up(mean).toFixed(1)}`).join("L");
    return svg`${all.length > 1 ? svg`<path class=${name} d="M${line}"></path>` : ""}
      ${firsts.map((first, index) => mark(name, first, across(index), up(first ?? ATTEMPT_LIMIT)))}`;
  };
  return html`<svg
    class="chart"
    viewBox="-28 -12 ${WIDTH + 36} ${HEIGHT + 40}"
    role="img"
    aria-label=${text.learns.chartLabel}
  >
    ${TICKS.map(
      (balls) =>
        svg`<path class="grid" d="M0 ${up(balls)}H${WIDTH}"></path><text x="-6" y=${up(balls) + 4} text-anchor="end">${balls}</text>`,
    )}
    ${[1, room / 2, room].map(
      (number) => svg`<text x=${across(number - 1)} y=${HEIGHT + 15} text-anchor="middle">${number}</text>`,
    )}
    <text x=${WIDTH / 4} y=${HEIGHT + 15} text-anchor="middle">${text.learns.axis}</text>
    ${series("fresh")} ${series("learned")}
  </svg>`;
}

/** A disc with a memory, a square without; a cross if the puzzle was not solved. */
function mark(name: "learned" | "fresh", first: number | null, x: number, y: number): TemplateResult {
  if (first === null) return svg`<path class="mark ${name}" d="M${x - 3} ${y - 3}l6 6m0 -6l-6 6"></path>`;
  return name === "learned"
    ? svg`<circle class=${name} cx=${x} cy=${y} r="3.4"></circle>`
    : svg`<rect class=${name} x=${x - 2.8} y=${y - 2.8} width="5.6" height="5.6"></rect>`;
}

/** With fewer balls, a share is due to chance. */
const FEW = 10;

/** Plots the predicted chance horizontally and the share that solves vertically; on the diagonal they are equal. */
export function calibrationChart(
  bins: { readonly random: readonly Bin[]; readonly candidates: readonly Bin[] },
  text: ExhibitText,
): TemplateResult {
  const curve = (name: "random" | "candidates") => {
    const points = bins[name]
      .filter(({ balls }) => balls >= FEW)
      .map(({ balls, chance, solved }) => [100 * chance, 100 * (1 - solved / balls)] as const);
    return svg`<path class=${name} d="M${points.map(([x, y]) => `${x.toFixed(1)} ${y.toFixed(1)}`).join("L")}"></path>
      ${points.map(([x, y]) =>
        name === "random"
          ? svg`<circle class=${name} cx=${x} cy=${y} r="1.8"></circle>`
          : svg`<rect class=${name} x=${x - 1.8} y=${y - 1.8} width="3.6" height="3.6"></rect>`,
      )}`;
  };
  return html`<svg class="chart" viewBox="-20 -5 130 118" role="img" aria-label=${text.results.calibrationLabel}>
    ${[0, 50, 100].map(
      (at) => svg`<text x=${at} y="109" text-anchor="middle">${text.percent(at / 100)}</text>
        <text x="-3" y=${102 - at} text-anchor="end">${text.percent(at / 100)}</text>
        <path class="grid" d="M${at} 0V100M0 ${at}H100"></path>`,
    )}
    <path class="diagonal" d="M0 100L100 0"></path>
    ${curve("random")} ${curve("candidates")}
  </svg>`;
}
