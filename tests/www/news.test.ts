// What a screen reader hears.

import assert from "node:assert/strict";
import { test } from "node:test";
import { place } from "../../www/core/change/placement.ts";
import { openPanel } from "../../www/core/change/route.ts";
import { goTo } from "../../www/core/change/walkthrough.ts";
import { announcement } from "../../www/view/news.ts";
import { SOLVING, fresh, playAt } from "./player.ts";

test("in Imagine the steps are told, but what becomes of a ball comes first", () => {
  const imagining = openPanel(fresh, "imagine");
  assert.match(announcement(goTo(imagining, "base")), /^If you do nothing\./);
  assert.match(announcement(goTo(place(imagining, SOLVING, null), "base")), /^If you do nothing\./);
  assert.match(announcement(place(imagining, [10, 100, 12], null)), /^Not here/);
  assert.match(announcement(playAt(imagining, SOLVING)), /^Solved with your first ball!/);
});
