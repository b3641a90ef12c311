// Attempts as text for files: JSON lines, which can be opened again and which `pathlight verify` reads, and a table.

import { attempts } from "./duel.ts";
import { isAlone } from "./hidden.ts";
import type { Attempts } from "../change/kept.ts";
import type { State } from "../state.ts";

/** A longer line is no attempt, characters. */
const LONGEST_LINE = 65_536;

export function attemptsText(attempts: Attempts): string {
  const lines = Object.values(attempts).flat();
  return lines.map((line) => `${JSON.stringify(line)}\n`).join("");
}

/** What the lines of a file hold, one by one; undefined for one that is no JSON. */
export function* parsedLines(text: string): Generator<unknown> {
  // PowerShell marks the begin of a file.
  for (const line of text.replace(/^\ufeff/, "").split(/\r?\n/)) {
    if (line.trim() === "") continue;
    try {
      yield line.length > LONGEST_LINE ? undefined : JSON.parse(line);
    } catch {
      yield undefined;
    }
  }
}

/**
 * The player's attempts at the open puzzle and the model's, as far as they have been played, as RFC 4180 has tables.
 */
export function attemptsTable(state: State): string {
  const { puzzle, answers, model } = state;
  const made = attempts(state);
  const name = model.kind === "ready" ? model.name : "";
  const rows = [
    ["puzzle", "by", "number", "x", "y", "r", "status", "steps", "chance"],
    ...made.map(({ ball, status, steps }, index) => [puzzle.key, "player", index + 1, ...ball!, status, steps, ""]),
    ...(isAlone(state) ? [] : answers.turn.slice(0, made.length)).map(({ ball, ending, origin }, index) => {
      const chance = "probability" in origin ? origin.probability : "";
      return [puzzle.key, name, index + 1, ...ball, ending.solved ? "solved" : "not_solved", ending.steps, chance];
    }),
  ];
  return rows.map((row) => `${row.join(",")}\r\n`).join("");
}
