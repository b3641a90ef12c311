// Finds the worker's code and starts it.

import { text } from "../text/text.js";

/** @type {string | undefined} */
let scriptAddress;

/** A worker of a page has to come from the page's own origin. */
export function createWorker() {
  // In this form bundlers find the worker. Some write the address of a file of theirs for that of the module.
  const { origin, protocol } = new URL(import.meta.url);
  if (origin === globalThis.origin || protocol === "file:")
    return new Worker(new URL("../model/worker.js", import.meta.url), { type: "module" });
  return new Worker(importingScript(), { type: "module" });
}

/** Returns the address of a script of the page's own that imports a worker of another origin. */
function importingScript() {
  const address = import.meta.url.replace(/[^/]*\/[^/]*$/, "model/worker.js");
  return (scriptAddress ??= URL.createObjectURL(
    new Blob([`import ${JSON.stringify(address)};`], { type: "text/javascript" }),
  ));
}

/** Returns a sentence for the person: not even the worker's code could be loaded. */
export function whyNoWorker() {
  return text.model.worker.notLoaded(globalThis.origin === "null");
}
