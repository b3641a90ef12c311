// Saves something as a file, as the browser's downloads do.

/** How long the address of a download is kept, ms: the browser may read it some time after the click. */
const DOWNLOAD_TIME = 60_000;

/**
 * @param {string} name
 * @param {Blob} blob
 */
export function download(name, blob) {
  const link = document.createElement("a");
  link.href = URL.createObjectURL(blob);
  link.download = name;
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), DOWNLOAD_TIME);
}

/**
 * A name of a file made of words: letters, digits and hyphens.
 * @param {string} words
 * @param {string} extension
 */
export function fileName(words, extension) {
  const stem = words
    .toLowerCase()
    .replace(/[^\p{L}\p{N}]+/gu, "-")
    .replace(/^-|-$/g, "");
  return `${stem || "pathlight"}.${extension}`;
}
