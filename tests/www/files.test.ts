// Attempts as files: what is saved is what is opened, and nothing is lost when histories meet.

import assert from "node:assert/strict";
import { test } from "node:test";
import { NOTHING_KEPT, merged, mergeKept, openAttempts } from "../../www/core/change/kept.ts";
import { setModel } from "../../www/core/change/model.ts";
import { forget } from "../../www/core/change/dialog.ts";
import { attempts } from "../../www/core/derived/duel.ts";
import { attemptsTable, attemptsText, parsedLines } from "../../www/core/derived/files.ts";
import { ATTEMPT_LIMIT } from "../../www/pkg/constants.ts";
import { MISSING, SOLVING, fresh, line, playAt, withTurn } from "./player.ts";
import type { Attempts } from "../../www/core/change/kept.ts";
import type { AttemptLine, Ball } from "../../www/pkg/page/pathlight.js";

const reread = (attempts: Attempts) => {
  const read: Record<string, AttemptLine[]> = {};
  for (const line of parsedLines(attemptsText(attempts)))
    (read[(line as AttemptLine).task!] ??= []).push(line as AttemptLine);
  return read;
};
const balls = (attempts: Attempts, task: string) => (attempts[task] ?? []).map(({ ball }) => String(ball));

test("an opened file joins what is here: no attempt and no solution of either is lost, in whatever order they meet", () => {
  const random = generator(11);
  for (let round = 0; round < 200; round++) {
    const [here, file] = [history(random), history(random)];
    const state = { ...fresh, kept: { ...NOTHING_KEPT, guess: false, attempts: here } };
    const both = openAttempts(state, reread(file)).kept;
    const back = merged({ ...NOTHING_KEPT, attempts: reread(file) }, { ...NOTHING_KEPT, attempts: here });
    assert.equal(both.guess, false);
    for (const task of TASKS) {
      const all = new Set([...balls(here, task), ...balls(file, task)]);
      const now = balls(both.attempts, task);
      assert.equal(new Set(now).size, now.length);
      assert.equal(now.length, Math.min(all.size, ATTEMPT_LIMIT));
      if (all.size > ATTEMPT_LIMIT) {
        const solutions = [...all].filter((ball) => Number(ball.split(",")[0]) > 200).slice(0, ATTEMPT_LIMIT);
        if (solutions.length < ATTEMPT_LIMIT) for (const ball of solutions) assert.ok(now.includes(ball), ball);
      } else {
        assert.deepEqual(now.slice(0, balls(here, task).length), balls(here, task));
        assert.deepEqual(new Set(balls(back.attempts, task)), new Set(now));
      }
    }
    const again = openAttempts({ ...state, kept: both }, reread(file)).kept;
    assert.deepEqual(again, both);
  }
});

test("a file that has a ball twice brings it once; what is no JSON is no attempt", () => {
  const opened = openAttempts(fresh, { "00000:000": [line(MISSING), line(MISSING), line(SOLVING)] });
  assert.equal(attempts(opened).length, 2);
  assert.deepEqual([...parsedLines('\ufeff{"ball":1}\r\n\nno\n[2]')], [{ ball: 1 }, undefined, [2]]);
});

test("forgotten attempts do not come back from another tab; what comes after stays, and a file brings them back", () => {
  const played = playAt(fresh, MISSING);
  const forgotten = forget(played, 1000);
  assert.deepEqual([attempts(forgotten), forgotten.run], [[], null]);
  assert.deepEqual(attempts(mergeKept(forgotten, played.kept)), []);
  assert.deepEqual(attempts(mergeKept(played, forgotten.kept)), []);
  const later = playAt(forgotten, SOLVING);
  assert.equal(attempts(mergeKept(later, played.kept)).length, 1);
  assert.equal(attempts(openAttempts(forgotten, played.kept.attempts)).length, 1);
});

test("the table has the player's balls and the model's, as far as both have been played", () => {
  const ready = setModel(fresh, { kind: "ready", name: "within-0", card: {} as never });
  const turn = [MISSING, SOLVING].map((ball) => ({
    ...withTurn(fresh, ball).answers.turn[0]!,
    origin: { kind: "success" as const, probability: 0.25 },
  }));
  const state = { ...ready, answers: { ...ready.answers, turn, turnUpTo: 2 } };
  assert.deepEqual(attemptsTable(playAt(state, [90, 80, 7])).split("\r\n"), [
    "puzzle,by,number,x,y,r,status,steps,chance",
    "00000:000,player,1,90,80,7,not_solved,60,",
    "00000:000,within-0,1,100,100,12,not_solved,,0.25",
    "",
  ]);
});

const TASKS = ["00000:000", "00001:000"];

function history(random: () => number): Attempts {
  const some = (task: string) => {
    const count = Math.floor(random() * 90);
    const balls = Array.from({ length: count }, (): Ball => [Math.floor(random() * 256), Math.floor(random() * 3), 5]);
    return [...new Map(balls.map((ball) => [String(ball), line(ball, task)])).values()];
  };
  return Object.fromEntries(TASKS.map((task) => [task, some(task)]));
}

/** Numbers in 0..1 that are the same each time. */
function generator(seed: number): () => number {
  let state = seed;
  return () => (state = (state * 16807) % 2147483647) / 2147483647;
}
