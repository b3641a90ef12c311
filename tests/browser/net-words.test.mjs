// What the page says of the nets of a model and of what it has learned follows from the card of its weights.

import assert from "node:assert/strict";
import { test } from "node:test";
import { ballNetOf } from "../../www/model/ball-net.js";
import { practice } from "../../www/model/practice.js";
import { text } from "../../www/text/text.js";

const { nets, knows } = text.model;

test("the net that scores balls is named, and no other", () => {
  for (const [net, other] of /** @type {const} */ ([
    ["dynamics", "success"],
    ["success", "dynamics"],
  ])) {
    assert.equal(ballNetOf({ [net]: {} }), net);
    assert.match(
      nets.intro(4, net),
      new RegExp(`five small nets .+: four make maps, and the ${net} net scores balls\\.$`),
    );
    assert.match(
      nets.about(4, net),
      new RegExp(`^It has five small neural nets, .+ Four of them .+The last one, the ${net} net,`),
    );
    assert.doesNotMatch(`${nets.intro(4, net)} ${nets.about(4, net)} ${nets.how[net]}`, new RegExp(other, "i"));
  }
  for (const card of [{}, undefined]) {
    assert.equal(ballNetOf(card), null);
    assert.equal(nets.intro(4, null), "Before anything moves, four small nets imagine, one after the other.");
    assert.doesNotMatch(nets.about(4, null), /the last one/i);
  }
});

test("the number of nets is that of the paper's maps, and one more if balls are scored", () => {
  assert.match(nets.intro(5, null), /five small nets/);
  assert.match(nets.about(12, null), /^It has 12 small neural nets/);
});

test("what a model has learned from follows from the setup of its card, whatever its name", () => {
  assert.match(knows.within, /all 25 kinds/);
  assert.match(knows.cross, /20 of the 25 kinds/);
});

test("a model whose ball net learned from random puzzles alone has practised puzzles by its maps alone", () => {
  const alone = { dynamics: { random_scenes_alone: true } };
  assert.equal(practice({ dynamics: {} }, true), "practised this one");
  assert.equal(practice(alone, true), "only its maps practised this one");
  assert.equal(practice(alone, false), "new to the model");
});
