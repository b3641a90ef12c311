// Paints a result as a picture, or as a frame of a film: 1200 x 630 pixels, the size that messengers and networks show
// whole, or in that ratio.

import { text } from "../text/text.js";
import { contextOf } from "../widgets/dom.js";

export const WIDTH = 1200;
export const HEIGHT = 630;
const MARGIN = 36;
const SIDE = HEIGHT - 2 * MARGIN;
const FONT = 'system-ui, "Segoe UI", Roboto, "Helvetica Neue", "Liberation Sans", sans-serif';

/** @typedef {{ name: string, solved: string, model: string, difficulty: string }} Lines */

/**
 * @param {HTMLCanvasElement} canvas in the ratio of WIDTH to HEIGHT
 * @param {import("../pkg/pathlight.js").Palette} palette
 * @param {Lines} lines
 * @param {(context: CanvasRenderingContext2D) => void} paintScene draws the scene so that it fills a square canvas
 */
export function paintResultCard(canvas, palette, lines, paintScene) {
  const context = contextOf(canvas);
  const scale = canvas.width / WIDTH;
  context.setTransform(scale, 0, 0, scale, 0, 0);
  context.fillStyle = palette.paper;
  context.fillRect(0, 0, WIDTH, HEIGHT);
  const scene = document.createElement("canvas");
  scene.width = scene.height = Math.round(SIDE * scale);
  paintScene(contextOf(scene));
  context.drawImage(scene, MARGIN, MARGIN, SIDE, SIDE);
  context.strokeStyle = palette.gray;
  context.lineWidth = 2;
  context.strokeRect(MARGIN, MARGIN, SIDE, SIDE);

  const left = 2 * MARGIN + SIDE;
  const width = WIDTH - left - MARGIN;
  context.textBaseline = "top";
  let top = MARGIN + 8;
  /** @type {[words: string, size: number, weight: number, colour: string, gap: number][]} */
  const texts = [
    [text.page.name, 34, 700, palette.gray, 40],
    [lines.name, 46, 700, palette.ink, 34],
    [lines.solved, 62, 700, palette.green, 28],
    [lines.model, 40, 600, palette.model, 34],
    [lines.difficulty, 28, 400, palette.gray, 0],
  ];
  for (const [words, size, weight, colour, gap] of texts) {
    context.font = `${weight} ${size}px ${FONT}`;
    context.fillStyle = colour;
    for (const line of wrapped(context, words, width)) {
      context.fillText(line, left, top);
      top += size * 1.2;
    }
    if (words) top += gap;
  }
}

/**
 * A word in pieces that fit a width.
 * @param {CanvasRenderingContext2D} context
 * @param {string} word
 * @param {number} width
 */
function pieces(context, word, width) {
  /** @type {string[]} */
  const all = [];
  for (const letter of word) {
    const longer = `${all.at(-1) ?? ""}${letter}`;
    if (all.length && context.measureText(longer).width <= width) all[all.length - 1] = longer;
    else all.push(letter);
  }
  return all;
}

/**
 * The lines of a text that fit a width.
 * @param {CanvasRenderingContext2D} context
 * @param {string} words
 * @param {number} width
 */
function wrapped(context, words, width) {
  /** @type {string[]} */
  const lines = [];
  for (const word of words.split(" ").flatMap((word) => pieces(context, word, width))) {
    const longer = lines.length ? `${lines.at(-1)} ${word}` : word;
    if (lines.length && context.measureText(longer).width <= width) lines[lines.length - 1] = longer;
    else lines.push(word);
  }
  return lines;
}
