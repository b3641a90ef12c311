// Why a custom scene may not be played, in words.

import { text } from "../text/text.js";
import { roleOf } from "./body-words.js";

/**
 * A problem as a sentence.
 * @param {import("../pkg/pathlight.js").SceneProblem} problem
 * @param {import("../pkg/pathlight.js").CustomScene} scene the one that has it
 */
export function problemWords({ body, other, fault, sentence }, scene) {
  const words = text.editor.problems;
  const named = (/** @type {number | null} */ index) => ({
    role: roleOf(scene, index ?? 0),
    shape: scene.bodies[index ?? 0].shape,
    index: index ?? 0,
  });
  switch (fault.kind) {
    // Only the wasm knows what it could not read.
    case "unreadable":
      return words.unreadable(sentence);
    case "own_goal":
      return words.ownGoal;
    case "static_object":
      return words.staticObject;
    case "bodies":
      return words.bodies(fault.least, fault.most, fault.count > fault.most);
    case "name":
      return words.name(fault.most);
    case "place":
      return words.place(named(body));
    case "length":
      return words.length(named(body), fault.key, fault.length, [fault.least, fault.most]);
    case "sticks_out":
      return words.sticksOut(named(body), fault.by);
    case "sticks_out_of_corner":
      return words.sticksOutOfCorner(named(body), fault.by);
    case "outside":
      return words.outside(named(body), fault.by);
    case "overlap":
      return words.overlap(named(body), named(other), fault.by, fault.most);
  }
}

/**
 * Problems as sentences.
 * @param {import("../pkg/pathlight.js").SceneProblem[]} problems
 * @param {import("../pkg/pathlight.js").CustomScene} scene the one that has them
 */
export function sentencesOf(problems, scene) {
  return problems.map((problem) => problemWords(problem, scene));
}
