// Results in a sentence.

/**
 * How many tasks are solved, and how soon.
 * @param {(number | null)[]} firsts the first attempt that solved each task, from 1, or null
 */
export function outcomeCount(firsts) {
  const within = (/** @type {number} */ most) => firsts.filter((first) => first !== null && first <= most).length;
  return `${within(100)} of ${firsts.length} puzzles solved within a hundred attempts, ${within(10)} within ten, ${within(1)} at the first.`;
}

/** @param {number} auccess 0 to 100 */
export function auccessWords(auccess) {
  return `Auccess ${auccess.toFixed(1)} of 100.`;
}
