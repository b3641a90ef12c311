// Links: what is written is read again, and what cannot be read is named and changes nothing.

import assert from "node:assert/strict";
import { test } from "node:test";
import { START } from "../../www/core/change/route.ts";
import {
  addressEffect,
  addressOf,
  hasMovedOn,
  readAddress,
  readLocation,
  writeAddress,
} from "../../www/effects/address.ts";
import { Store } from "../../www/core/store.ts";
import { dropAt, fresh, MISSING } from "./player.ts";
import type { Link } from "../../www/core/change/route.ts";

test("an address names puzzle, maps and ball, and is read as it was written", () => {
  const link: Link = { ...START, task: "00007:008", layers: ["base", "placement"], step: "run", ball: [40, 200, 12] };
  assert.equal(writeAddress(link), "#task=00007:008&layers=base,placement&step=run&ball=40,200,12");
  assert.deepEqual(readAddress(writeAddress(link), fresh.text), { link, unread: [] });
  assert.equal(readAddress("#scene=a-Z_9&panel=make", fresh.text).link.scene, "a-Z_9");
  assert.deepEqual(readAddress("#scene=a%20b", fresh.text).unread, ["scene=a b"]);
  assert.equal(writeAddress(START), "#");
  assert.equal(addressOf(dropAt(fresh, MISSING)), "#task=00000:000&ball=100,100,12");
});

test("the address follows the state, but not past a link that has just been followed", async () => {
  const location = { hash: "#task=00001:002" };
  const pushState = (_: null, __: string, hash: string) => void (location.hash = hash);
  Object.assign(globalThis, { location, history: { pushState, replaceState: pushState } });
  readLocation(fresh.text);
  location.hash = "#task=00002:003";
  const run = () => addressEffect.run(new Store(fresh, []), new AbortController().signal);
  await run();
  assert.deepEqual([location.hash, hasMovedOn()], ["#task=00002:003", true]);
  assert.equal(readLocation(fresh.text).link.task, "00002:003");
  await run();
  assert.deepEqual([location.hash, hasMovedOn()], ["#task=00000:000", false]);
});

test("what a link has that is not understood is named, shortened, and left out", () => {
  const { link, unread } = readAddress(
    `#task=00007:008&ball=1,2&layers=base,nose&x=${"y".repeat(60)}&%E0%A4%A=%E0`,
    fresh.text,
  );
  assert.deepEqual(link, { ...START, task: "00007:008" });
  assert.deepEqual(unread, ["ball=1,2", "layers=base,nose", `x=${"y".repeat(37)}…`, "%E0%A4%A=%E0"]);
});

test("balls of links lie within the scene and have a radius that there is", () => {
  for (const ball of ["256,0,12", "0,0,1", "0,0,33", "-1,0,12", "1.5,0,12", "1e2,0,12", ""])
    assert.equal(readAddress(`#ball=${ball}`, fresh.text).link.ball, null, ball);
});
