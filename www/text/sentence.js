// Words as a sentence. Knows nothing of the document.

/**
 * "the ball …" becomes "The ball …".
 * @param {string} words
 */
export function upper(words) {
  return words[0].toUpperCase() + words.slice(1);
}

/**
 * "the ball …" becomes "The ball ….".
 * @param {string} words
 */
export function sentence(words) {
  return upper(words) + (/[.!?]$/.test(words) ? "" : ".");
}
