// How often the chances that a model gives to balls come true, as a chart and as a table: where it says 30%, three of
// ten balls should solve.

import { svgElement } from "./svg-element.js";
import { text } from "../text/text.js";
import { createCell } from "../widgets/dom.js";

/** @typedef {import("../model/results.js").Bin} Bin */
/** @typedef {{ random: Bin[], candidates: Bin[] }} Calibration */

/** Width and height of the chart, in its own units: percent. */
const SIDE = 100;
/** A share of fewer balls is chance. */
const FEW = 10;

/**
 * Chance across, the share that solves upwards; on the diagonal both are the same.
 * @param {Calibration} calibration
 */
export function calibrationChart({ random, candidates }) {
  const chart = svgElement("svg", {
    viewBox: `-20 -5 ${SIDE + 30} ${SIDE + 18}`,
    role: "img",
    "aria-label": text.results.calibration.chart,
  });
  for (const at of [0, 50, 100]) {
    const [across, up] = [
      svgElement("text", { x: at, y: SIDE + 9, "text-anchor": "middle" }),
      svgElement("text", { x: -3, y: SIDE - at + 2, "text-anchor": "end" }),
    ];
    across.textContent = up.textContent = text.format.percent(at / 100);
    chart.append(across, up, svgElement("path", { d: `M${at} 0V${SIDE}M0 ${at}H${SIDE}`, class: "grid" }));
  }
  chart.append(svgElement("path", { d: `M0 ${SIDE}L${SIDE} 0`, class: "diagonal" }));
  for (const [kind, bins] of Object.entries({ random, candidates })) {
    const points = bins
      .filter(({ balls }) => balls >= FEW)
      .map(({ balls, chance, solved }) => [SIDE * chance, SIDE * (1 - solved / balls)]);
    chart.append(
      svgElement("path", {
        d: `M${points.map((point) => point.map((value) => value.toFixed(1)).join(" ")).join("L")}`,
        class: kind,
      }),
    );
    chart.append(
      ...points.map(([x, y]) =>
        kind === "random"
          ? svgElement("circle", { cx: x, cy: y, r: 1.8, class: kind })
          : svgElement("rect", { x: x - 1.8, y: y - 1.8, width: 3.6, height: 3.6, class: kind }),
      ),
    );
  }
  return chart;
}

/**
 * A row for each tenth: the chances, then of both kinds of balls how many there are and how many of them solve.
 * @param {Calibration} calibration
 */
export function calibrationTable({ random, candidates }) {
  return random.map((bin, index) => {
    const head = document.createElement("th");
    head.scope = "row";
    head.textContent = text.results.calibration.range(index / random.length, (index + 1) / random.length);
    const row = document.createElement("tr");
    row.append(
      head,
      ...[bin, candidates[index]].flatMap(({ balls, solved }) => [
        createCell(text.format.number(balls)),
        createCell(balls ? text.format.percent(solved / balls, 1) : "–"),
      ]),
    );
    return row;
  });
}
