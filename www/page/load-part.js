import { showNotice } from "../widgets/notice.js";

/**
 * Loads a part of the page that is not there from the beginning. If that fails, a notice says so.
 * @template Part
 * @param {string} name
 * @param {() => Promise<Part>} load
 */
export async function loadPart(name, load) {
  try {
    return await load();
  } catch {
    showNotice(
      `${name} could not be loaded. Check the connection; if Pathlight has been updated meanwhile, load the page again.`,
    );
    return null;
  }
}
