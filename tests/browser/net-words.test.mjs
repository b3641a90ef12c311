// What the page says of the nets of a model and of what it has learned follows from the card of its weights.

import assert from "node:assert/strict";
import { test } from "node:test";
import { modelWords } from "../../www/model/model-words.js";
import { netWords } from "../../www/model/map-text.js";

test("the net that scores balls is named, and no other", () => {
  const dynamics = netWords({ dynamics: {} }, 4);
  assert.match(dynamics.intro, /four small nets .+ and the dynamics net scores balls\.$/);
  assert.match(dynamics.about, /^It has four small neural nets\. .+Another net, the dynamics net, imagines/);
  assert.doesNotMatch(Object.values(dynamics).join(" "), /success/i);
  const success = netWords({ success: {} }, 4);
  assert.match(success.intro, /and the success net scores balls\.$/);
  assert.match(success.about, /Another net, the success net, says/);
  assert.doesNotMatch(Object.values(success).join(" "), /dynamics/i);
  for (const card of [{}, undefined]) {
    const { intro, about, how } = netWords(card, 4);
    assert.equal(intro, "Before anything moves, four small nets imagine, one after the other.");
    assert.doesNotMatch(about, /another net/i);
    assert.equal(how, "");
  }
});

test("the number of nets is that of the paper's maps", () => {
  assert.match(netWords({}, 5).intro, /five small nets/);
  assert.match(netWords({}, 12).about, /^It has 12 small neural nets/);
});

test("what a model has learned from follows from the setup of its card, whatever its name", () => {
  assert.match(modelWords({ setup: "within" }), /all 25 kinds/);
  assert.match(modelWords({ setup: "cross" }), /20 of the 25 kinds/);
});
