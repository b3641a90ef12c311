// Words as a sentence. Knows nothing of the document.

/**
 * "the ball …" becomes "The ball ….".
 * @param {string} words
 */
export function sentence(words) {
  return words[0].toUpperCase() + words.slice(1) + (/[.!?]$/.test(words) ? "" : ".");
}
