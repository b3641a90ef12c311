// A result as a picture: 1200 x 630 pixels, which messengers and social networks show uncropped.

import { isDark } from "../core/derived/preferences.ts";
import { attempts } from "../core/derived/duel.ts";
import { result } from "../core/derived/sharing.ts";
import { paint } from "../simulator.ts";
import { nameOf } from "./files.ts";
import { DARK_PALETTE, LIGHT_PALETTE } from "../pkg/constants.ts";
import type { Card } from "../core/change/dialog.ts";
import type { State } from "../core/state.ts";

const WIDTH = 1200;
const HEIGHT = 630;
const MARGIN = 36;
const SIDE = HEIGHT - 2 * MARGIN;
const FONT = 'system-ui, "Segoe UI", Roboto, "Helvetica Neue", "Liberation Sans", sans-serif';
/** Timeout, ms: some browsers never answer, and Chromium may wait ten seconds for an idle moment. */
const PATIENCE = 12_000;

export async function cardOf(state: State, patience = PATIENCE): Promise<Card> {
  const canvas = Object.assign(document.createElement("canvas"), { width: WIDTH, height: HEIGHT });
  const context = canvas.getContext("2d");
  if (!context) return { kind: "none", why: "missing" };
  paintCard(context, state);
  // Browsers that block fingerprinting return noise instead of the painted pixels.
  const paper = context.getImageData(1, 1, 1, 1).data;
  const [red, green, blue] = colourOf(palette(state).paper);
  if (paper[0] !== red || paper[1] !== green || paper[2] !== blue) return { kind: "none", why: "noise" };
  const blob = await new Promise<Blob | null>((resolve) => {
    setTimeout(() => resolve(null), patience);
    canvas.toBlob(resolve, "image/png");
  });
  if (!blob) return { kind: "none", why: "missing" };
  const file = new File([blob], `pathlight-${nameOf(state.puzzle)}.png`, { type: "image/png" });
  return { kind: "ready", url: URL.createObjectURL(blob), file };
}

const palette = (state: State) => (isDark(state) ? DARK_PALETTE : LIGHT_PALETTE);

/** Parses "#rrggbb". */
function colourOf(text: string): number[] {
  return [1, 3, 5].map((at) => parseInt(text.slice(at, at + 2), 16));
}

function paintCard(context: CanvasRenderingContext2D, state: State): void {
  const { text, puzzle } = state;
  const colours = palette(state);
  context.fillStyle = colours.paper;
  context.fillRect(0, 0, WIDTH, HEIGHT);
  context.drawImage(scene(state), MARGIN, MARGIN, SIDE, SIDE);
  context.strokeStyle = colours.gray;
  context.lineWidth = 2;
  context.strokeRect(MARGIN, MARGIN, SIDE, SIDE);

  const found = result(state);
  const left = 2 * MARGIN + SIDE;
  const width = WIDTH - left - MARGIN;
  context.textBaseline = "top";
  let top = MARGIN + 8;
  const lines: [words: string, size: number, colour: string, gap: number][] = [
    [text.page.brand, 34, colours.gray, 40],
    [text.puzzle.name(puzzle.about), 46, colours.ink, 34],
    [text.share.headline(found.solvedAt), 62, colours.green, 28],
    [text.share.model(found), 40, colours.model, 34],
  ];
  for (const [words, size, colour, gap] of lines) {
    context.font = `700 ${size}px ${FONT}`;
    context.fillStyle = colour;
    for (const line of wrapped(context, words, width)) {
      context.fillText(line, left, top);
      top += size * 1.2;
    }
    if (words) top += gap;
  }
}

/** Paints the scene, with the ball of the solution and its paths if the person wants to show them. */
function scene(state: State): HTMLCanvasElement {
  const canvas = Object.assign(document.createElement("canvas"), { width: SIDE, height: SIDE });
  const solution = state.share.withBall ? attempts(state).find(({ status }) => status === "solved") : undefined;
  const shown = solution ? [{ ball: solution.ball, of_model: false }] : [];
  const view = {
    step: solution ? 1e6 : 0,
    ball: null,
    valid: true,
    knob: 0,
    whole: true,
    opacity: 0,
    dark: isDark(state),
  };
  paint(canvas.getContext("2d")!, state.puzzle, shown, view, []);
  return canvas;
}

/** Breaks a text into lines that fit a width. */
function wrapped(context: CanvasRenderingContext2D, words: string, width: number): string[] {
  const lines: string[] = [];
  for (const word of words.split(" ").filter(Boolean)) {
    const longer = lines.length ? `${lines.at(-1)} ${word}` : word;
    if (lines.length && context.measureText(longer).width <= width) lines[lines.length - 1] = longer;
    else lines.push(word);
  }
  return lines;
}
