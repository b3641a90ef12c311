// The entry: waits for the wasm, then loads the page, whose modules may call its exports from their first line on.
// Unhandled errors are shown here.

import "../element/pathlight-puzzle.js";
import { byId } from "../widgets/dom.js";
import { showNotice } from "../widgets/notice.js";
import { loadWasm } from "../loading/load-wasm.js";

const reload = () => location.reload();

/** @param {unknown} error */
function showCrash(error) {
  const reason = error instanceof Error ? error.message : String(error);
  showNotice(`Something in Pathlight broke: ${reason.replace(/\.$/, "")}. Load the page again to go on.`, [
    ["Load it again", reload],
  ]);
}

addEventListener("error", ({ error, message }) => showCrash(error ?? message));
addEventListener("unhandledrejection", ({ reason }) => showCrash(reason));

let loaded = false;
try {
  await loadWasm();
  loaded = true;
} catch (error) {
  // The notice says it once for the page and its puzzle. Loads the same address again, with what follows # in it.
  byId(document, "puzzle").hidden = true;
  showNotice(/** @type {Error} */ (error).message, [["Try again", reload]]);
}
if (loaded) {
  const { Page } = await import("./page.js");
  new Page().start();
}
