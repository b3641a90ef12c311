// Keys and wheel: what the facts of an event ask for.

import assert from "node:assert/strict";
import { test } from "node:test";
import { keyAction } from "../../www/stage/keys.ts";
import { wheelSteps } from "../../www/stage/wheel.ts";
import type { KeyFacts } from "../../www/stage/keys.ts";

const NONE = { ctrlKey: false, metaKey: false, altKey: false, shiftKey: false };
const press = (key: string, code: string, held: Partial<KeyFacts> = {}) => keyAction({ ...NONE, key, code, ...held });

test("keys mean the same on every layout: a key that writes no Latin letter counts by its place", () => {
  const undo = { kind: "undo" };
  assert.deepEqual(press("z", "KeyZ", { ctrlKey: true }), undo);
  assert.deepEqual(press("я", "KeyZ", { ctrlKey: true }), undo);
  assert.deepEqual(press("Я", "KeyZ", { metaKey: true, shiftKey: true }), { kind: "redo" });
  assert.deepEqual(press("к", "KeyR"), { kind: "again" });
  assert.deepEqual(press("ר", "KeyR"), { kind: "again" });
  assert.deepEqual(press("х", "BracketLeft"), { kind: "previousPuzzle" });
});

test("a Latin letter counts as what it writes, wherever it is", () => {
  // German and French layouts have Z and Y, and Z and W, in each other's places.
  assert.deepEqual(press("z", "KeyY", { ctrlKey: true }), { kind: "undo" });
  assert.deepEqual(press("y", "KeyZ", { ctrlKey: true }), { kind: "redo" });
  assert.equal(press("w", "KeyZ", { ctrlKey: true }), null);
  assert.equal(press("ü", "BracketLeft"), null);
});

test("digits open panels, also where the row of digits writes signs", () => {
  assert.deepEqual(press("2", "Digit2"), { kind: "panel", index: 1 });
  assert.deepEqual(press("é", "Digit2"), null);
  assert.deepEqual(press("&", "Digit1"), { kind: "panel", index: 0 });
  assert.deepEqual(press("-", "Digit6"), { kind: "resize", dr: -1 });
});

test("arrows move by one, with Shift by ten; nothing that belongs to the browser is taken", () => {
  assert.deepEqual(press("ArrowUp", "ArrowUp"), { kind: "move", dx: 0, dy: 1 });
  assert.deepEqual(press("ArrowLeft", "ArrowLeft", { shiftKey: true }), { kind: "move", dx: -10, dy: 0 });
  assert.equal(press("ArrowLeft", "ArrowLeft", { altKey: true }), null);
  assert.equal(press("r", "KeyR", { ctrlKey: true }), null);
  assert.equal(press("+", "Equal", { ctrlKey: true }), null);
  assert.equal(press("Tab", "Tab"), null);
});

test("a clicker turns pages", () => {
  assert.deepEqual(press("PageDown", "PageDown"), { kind: "page", by: 1 });
  assert.deepEqual(press("PageUp", "PageUp"), { kind: "page", by: -1 });
});

test("small movements of a trackpad add up, and a notch of a wheel is one step", () => {
  const roll = (...deltas: number[]) =>
    deltas.reduce<[steps: number, rest: number]>(
      ([sum, rest], deltaY) => {
        const [steps, left] = wheelSteps(rest, { deltaY, deltaMode: 0 });
        return [sum + steps, left];
      },
      [0, 0],
    )[0];
  assert.equal(roll(-100), 1);
  assert.equal(roll(120), -1);
  assert.equal(roll(...Array(24).fill(-4)), 0);
  assert.equal(roll(...Array(25).fill(-4)), 1);
  assert.equal(roll(...Array(24).fill(-4), 4, ...Array(24).fill(-4)), 0);
  assert.equal(wheelSteps(0, { deltaY: 3, deltaMode: 1 })[0], -1);
});
