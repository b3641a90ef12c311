// Player and model compared, in a sentence. Knows nothing of the document.

import { text } from "../text/text.js";

/** @typedef {import("../pkg/pathlight.js").Standing} Standing */

/**
 * @param {Standing} player
 * @param {Standing} model
 */
export function verdictWords(player, model) {
  const words = text.play.verdict;
  const [you, it] = [player.solved_at, model.solved_at];
  if (you !== null && it !== null) {
    if (you === it) return words.draw(you);
    return you < it ? words.playerQuicker(you, it) : words.modelQuicker(you, it);
  }
  if (you !== null) return model.used === 0 ? words.modelNext(you) : words.modelMissed(you, model.used);
  if (it !== null) return player.used === 0 ? words.playerNext(it) : words.playerMissed(it, player.used);
  return player.used + model.used === 0 ? words.nobody : words.neither(player.used, model.used);
}
