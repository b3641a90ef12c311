// Delays work that the first picture does not need until the next frame is on the screen.

/** Resolves once the next frame is on the screen; in a page that is not seen, which has no frames, at once. */
export function afterFrame() {
  return new Promise((/** @type {(value: void) => void} */ resolve) => {
    if (document.hidden) setTimeout(resolve);
    else requestAnimationFrame(() => setTimeout(resolve));
  });
}
