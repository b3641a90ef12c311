// The entry: loads the wasm and starts the page. Unhandled errors are shown here.

import "../element/pathlight-puzzle.js";
import { byId } from "../widgets/dom.js";
import { showNotice } from "../widgets/notice.js";
import { loadWasm } from "../loading/load-wasm.js";
import { Page } from "./page.js";

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

loadWasm().then(
  () => new Page().start(),
  (error) => {
    // The notice says it once for the page and its puzzle. Loads the same address again, with what follows # in it.
    byId(document, "puzzle").hidden = true;
    showNotice(/** @type {Error} */ (error).message, [["Try again", reload]]);
  },
);
