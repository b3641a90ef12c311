// Starts the service worker, and offers a new version of the page in a sentence. Only the index.html of dist/ names this
// file. Where service workers are missing or denied, or storage is full, the page works as it does without them.

// This module goes on once that one has shown the page: the first puzzle waits for nothing that is kept for later.
import "../main.js";

const SERVICE_WORKER = "service-worker.js";
/** Later than this after the start, files are kept even if the page is still busy, ms. */
const PATIENCE = 5000;

// Without a network, in a private window or in a sandboxed frame there is nothing to do, and nothing to tell.
start().catch(() => {});

async function start() {
  const { serviceWorker, locks } = navigator;
  if (!serviceWorker || !locks) return;
  // Held until the page is closed; the service worker keeps this version's files as long.
  await new Promise((held, denied) => {
    const hold = () => {
      held(undefined);
      return new Promise(() => {});
    };
    locks.request(`pathlight ${new URL("../", import.meta.url)}`, { mode: "shared" }, hold).catch(denied);
  });
  serviceWorker.controller?.postMessage("started");
  await idle();
  // The browser shall not take the worker itself from its HTTP cache.
  const registration = await serviceWorker.register(SERVICE_WORKER, { updateViaCache: "none" });
  if (registration.waiting) offer(registration);
  registration.addEventListener("updatefound", () => watch(registration));
  watch(registration);
  document.addEventListener("visibilitychange", () => {
    if (document.visibilityState === "visible") checkForUpdate(registration);
  });
  if (serviceWorker.controller) await checkForUpdate(registration);
}

/** Resolves once the page has nothing urgent to do. */
function idle() {
  return new Promise((resolve) => {
    // Not in every browser.
    if ("requestIdleCallback" in window) requestIdleCallback(resolve, { timeout: PATIENCE });
    else setTimeout(resolve, PATIENCE);
  });
}

/**
 * Offers the version that is being installed as soon as it is there.
 * @param {ServiceWorkerRegistration} registration
 */
function watch(registration) {
  const { installing } = registration;
  installing?.addEventListener("statechange", () => {
    // The first version of all replaces none.
    if (installing.state === "installed" && registration.active) offer(registration);
  });
}

/**
 * @param {ServiceWorkerRegistration} registration
 */
async function checkForUpdate(registration) {
  try {
    await registration.update();
  } catch {
    // Something else is served at this address now: without this, the kept version would be shown for ever.
    if (await isGone()) {
      await registration.unregister();
      offer(registration);
    }
  }
}

/** Does the server answer that there is no service worker, or with a page for every address? */
async function isGone() {
  try {
    const { status, headers } = await fetch(SERVICE_WORKER, { method: "HEAD", cache: "no-store" });
    return status === 404 || status === 410 || headers.get("content-type")?.startsWith("text/html");
  } catch {
    return false;
  }
}

/**
 * Shows the sentence, once.
 * @param {ServiceWorkerRegistration} registration
 */
function offer(registration) {
  if (document.getElementById("update")) return;
  const bar = document.createElement("aside");
  bar.id = "update";
  bar.ariaLabel = "Update";
  const sentence = document.createElement("p");
  sentence.role = "status";
  bar.append(sentence, button("Load it", () => load(registration)), button("Later", () => bar.remove()));
  document.body.append(bar);
  // Screen readers read what changes in an element that is there already.
  sentence.textContent = "A new version is here.";
}

/**
 * Loads the page again, in the new version.
 * @param {ServiceWorkerRegistration} registration
 */
function load({ waiting }) {
  // Another page may have taken the new version already.
  if (!waiting) return location.reload();
  navigator.serviceWorker.addEventListener("controllerchange", () => location.reload(), { once: true });
  waiting.postMessage("activate");
}

/**
 * @param {string} label
 * @param {() => void} act
 */
function button(label, act) {
  const element = document.createElement("button");
  element.type = "button";
  element.textContent = label;
  element.addEventListener("click", act);
  return element;
}
