// The exhibits without a browser: which ball is shown when, the trend, the table for spreadsheets.

import assert from "node:assert/strict";
import { test } from "node:test";
import { resultsCsv } from "../../www/exhibits/results-file.ts";
import { duration, momentOf, playedOf, shownTries, trend } from "../../www/exhibits/learns-timeline.ts";
import type { ModelResults } from "../../www/exhibits/results-file.ts";
import type { Reminder, TriedProposal } from "../../www/api/index.ts";

const reminder: Reminder = { puzzle: 1, task: "00015:001", change: 2, ball: [1, 2, 3], solved: true, mirrored: false };

/** Balls of which the last solves, or none. */
const tries = (count: number, solved = true, reminded?: Reminder): TriedProposal[] =>
  Array.from({ length: count }, (_, index) => {
    const isSolution = solved && index === count - 1;
    const ending = { solved: isSolution, steps: isSolution ? 300 : 1000, longest_touch: 0, final_touch: 0 };
    return { ball: [index, 9, 9], ending, ...(reminded && { reminder: reminded }) } as TriedProposal;
  });

test("of many balls the first and a few others are shown in short, one after the other, the last at length", () => {
  assert.deepEqual(shownTries(0), []);
  for (const count of [1, 2, 6, 7, 100]) {
    const shown = shownTries(count);
    assert.deepEqual([shown[0]!.number, shown.at(-1)!.number], [1, count]);
    assert.ok(shown.length <= 6);
    shown.forEach(({ start, number }, index) => {
      assert.equal(start, shown[index - 1]?.end ?? 0);
      assert.ok(number > (shown[index - 1]?.number ?? 0));
    });
  }
});

test("a run is shown from its start to its end, a solution without the wait that follows", () => {
  const all = tries(3);
  assert.deepEqual(momentOf(all, 0), { number: 1, step: 0, isOver: false });
  assert.equal(momentOf(all, duration(3) - 1e-9)!.number, 3);
  assert.deepEqual(momentOf(all, Infinity), { number: 3, step: 150, isOver: true });
  assert.deepEqual(momentOf(tries(1, false), Infinity), { number: 1, step: 1000, isOver: true });
  assert.equal(momentOf([], 0), null);
});

test("a puzzle helped only if it was solved, and made a solution likelier", () => {
  const played = (reminded: Reminder, solved = true) =>
    playedOf("00015:009", tries(2, solved, reminded), tries(4, false));
  assert.deepEqual(played(reminder), { task: "00015:009", learned: 2, fresh: null, reminder });
  assert.equal(played({ ...reminder, solved: false }).reminder, null);
  assert.equal(played({ ...reminder, change: -1 }).reminder, null);
  assert.equal(played(reminder, false).reminder, null);
});

test("the trend is the geometric mean of the last five", () => {
  const rounded = (balls: number[]) => trend(balls).map((mean) => Math.round(1e6 * mean) / 1e6);
  assert.deepEqual(rounded([4, 1]), [4, 2]);
  assert.equal(rounded([100, 1, 1, 1, 1, 1])[5], 1);
});

test("a line for each model, agent and task; a comma is quoted, and what was not solved is empty", () => {
  const model: ModelResults = {
    name: "within-0",
    setup: "within",
    simulator: 4,
    agents_version: 2,
    tasks: ["00000:001", "00001:002"],
    auccess: { online: 50 },
    first_solved: { online: [3, null] },
    calibration: { random: [], candidates: [] },
  };
  assert.equal(
    resultsCsv([model], (task) => (task.startsWith("00000") ? "Drops" : 'A "b", c')),
    "model,simulator,agents_version,agent,task,template,first_solved\r\n" +
      "within-0,4,2,online,00000:001,Drops,3\r\n" +
      'within-0,4,2,online,00001:002,"A ""b"", c",\r\n',
  );
});
