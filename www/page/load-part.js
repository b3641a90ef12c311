import { showNotice } from "../widgets/notice.js";

/**
 * Loads a part of the page that is not there from the beginning. If that fails, a notice says so.
 * @template Part
 * @param {string} failure what it says
 * @param {() => Promise<Part>} load
 */
export async function loadPart(failure, load) {
  try {
    return await load();
  } catch {
    showNotice(failure);
    return null;
  }
}
