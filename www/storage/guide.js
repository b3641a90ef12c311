// Has the introduction been offered in this browser, and taken or declined?

import { BrowserStore } from "./browser-store.js";

const KEY = "guide";
const store = new BrowserStore(true);

export function guideOffered() {
  // Where nothing is kept it could not be remembered that it was.
  return store.get(KEY) !== null || store.failure !== null;
}

export function rememberGuide() {
  store.set(KEY, "offered");
}
