// The entry: shows the top of the home page, loads the wasm and starts the page. Unhandled errors are shown here.

import "../element/pathlight-puzzle.js";
import { Hero } from "../home/hero.js";
import { byId } from "../widgets/dom.js";
import { hideParts } from "../widgets/hidden-parts.js";
import { showNotice } from "../widgets/notice.js";
import { loadWasm } from "../loading/load-wasm.js";
import { showsHome } from "../state/links.js";
import { parseFragment } from "../state/url-state.js";

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

/** The top of the home page, which needs no wasm; at once if it is what the address asks for. */
const hero = new Hero();
const { state } = parseFragment(location.hash);
if (showsHome(state)) {
  hero.setState(state);
  hideParts(document, state.hide);
  byId(document, "gallery").hidden = false;
}

// Awaited, because offline/updates.js waits for this module before it keeps files for later.
await loadWasm().then(
  async () => {
    // Imported here, so that an error in the page's modules is shown too, as is one in the puzzle before they come.
    const { Page } = await import("./page.js");
    new Page(hero).start();
  },
  (error) => {
    // The notice says it once for the page and its puzzle. Loads the same address again, with what follows # in it.
    byId(document, "puzzle").hidden = true;
    showNotice(/** @type {Error} */ (error).message, [["Try again", reload]]);
  },
);
