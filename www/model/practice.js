import { text } from "../text/text.js";

/**
 * Whether a model has practised a puzzle, in words.
 * @param {{ dynamics?: { random_scenes_alone?: boolean } }} card
 * @param {boolean} seen whether any of its nets has
 */
export function practice({ dynamics }, seen) {
  const { seen: practised, seenByMaps, unseen } = text.model;
  if (!seen) return unseen;
  return dynamics?.random_scenes_alone ? seenByMaps : practised;
}
