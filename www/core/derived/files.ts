// Attempts as text files: JSON lines, which the page can open again and `pathlight verify` reads, and a table.

import { attempts } from "./duel.ts";
import { isAlone } from "./hidden.ts";
import type { Attempts } from "../change/kept.ts";
import type { State } from "../state.ts";

/** Maximum length of an attempt's line, characters. */
const LONGEST_LINE = 65_536;

export function attemptsText(attempts: Attempts): string {
  const lines = Object.values(attempts).flat();
  return lines.map((line) => `${JSON.stringify(line)}\n`).join("");
}

/** Parses the lines of a file one by one; undefined for a line that is not JSON. */
export function* parsedLines(text: string): Generator<unknown> {
  // PowerShell writes a byte order mark at the start of a file.
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
 * The attempts of player and model at the open puzzle that have been played, as a table in the format of RFC 4180.
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
