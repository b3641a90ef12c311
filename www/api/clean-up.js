// Freeing what the wasm holds, after a call that may have failed.

/**
 * Does what has to follow a call, as far as possible: after a panic the wasm refuses it, and the error of the panic
 * must not be hidden by another.
 * @param {() => void} act
 */
export function cleanUp(act) {
  try {
    act();
  } catch {
    // The error of the call is on its way.
  }
}
