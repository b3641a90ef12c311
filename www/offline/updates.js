// Starts the service worker, and offers a new version of the page in a sentence. Only the index.html of dist/ names
// this file. Where service workers are missing or denied, or storage is full, the page works as it does without them.
// It imports nothing statically, so that a version with a broken module can still be replaced.

const SERVICE_WORKER = "service-worker.js";
/** Longest wait for an idle page before registering the service worker, ms. */
const PATIENCE = 5000;
/** Time after which screen readers have noticed an empty live region, ms. */
const LIVE_REGION_DELAY = 100;
/** The name of the cache of this version, and of the lock that its pages hold. */
const CACHE = `pathlight ${new URL("../", import.meta.url)}`;

// Without a network, in a private window or in a sandboxed frame there is nothing to do, and nothing to tell.
start().catch(() => {});

async function start() {
  const { serviceWorker, locks } = navigator;
  if (!serviceWorker || !locks) return;
  const releaseVersion = await holdVersion();
  // The first puzzle does not wait for files that are kept for later. A version that fails to start, and tells so
  // itself, must still find the next one.
  await import("../page/main.js").catch(() => {});
  serviceWorker.controller?.postMessage("started");
  await idle();
  // Do not read the worker's script from the HTTP cache.
  const registration = await serviceWorker.register(SERVICE_WORKER, { updateViaCache: "none" });
  if (registration.waiting) offer(() => load(registration));
  registration.addEventListener("updatefound", () => watch(registration));
  watch(registration);
  document.addEventListener("visibilitychange", () => {
    if (document.visibilityState === "visible") checkForUpdate(registration, releaseVersion);
  });
  if (serviceWorker.controller) await checkForUpdate(registration, releaseVersion);
}

/**
 * Resolves once this page holds the lock of its version, for which the service worker keeps the files. The result
 * releases the lock, and resolves when that is done.
 * @returns {Promise<() => Promise<void>>}
 */
function holdVersion() {
  return new Promise((held, denied) => {
    const ended = navigator.locks.request(CACHE, { mode: "shared" }, () => {
      return new Promise((end) => {
        held(() => {
          end(undefined);
          return ended;
        });
      });
    });
    ended.catch(denied);
  });
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
    if (installing.state === "installed" && registration.active) offer(() => load(registration));
  });
}

/**
 * @param {ServiceWorkerRegistration} registration
 * @param {() => Promise<void>} releaseVersion
 */
async function checkForUpdate(registration, releaseVersion) {
  try {
    await registration.update();
  } catch {
    // Something else is served at this address now: without this, the kept version would be shown for ever.
    if (await isGone()) {
      await registration.unregister();
      offer(() => leave(registration.scope, releaseVersion));
    }
  }
}

/**
 * Does the server answer that there is no service worker, or with a page for every address? An error is no such answer.
 */
async function isGone() {
  try {
    const { status, ok, redirected, headers } = await fetch(SERVICE_WORKER, { method: "HEAD", cache: "no-store" });
    const isPage = headers.get("content-type")?.startsWith("text/html");
    return status === 404 || status === 410 || (ok && !redirected && isPage);
  } catch {
    return false;
  }
}

/**
 * Shows the sentence, once.
 * @param {() => void} act what the person may choose
 */
function offer(act) {
  // It stands in index.html, in the language of the page, so that its words need no module.
  const bar = document.getElementById("update");
  const sentence = bar?.querySelector("span");
  if (!bar?.hidden || !sentence) return;
  const closed = new AbortController();
  const { signal } = closed;
  /** @type {EventTarget | undefined} */
  let focusedBefore;
  const close = () => {
    const hasFocus = bar.contains(document.activeElement);
    closed.abort();
    bar.hidden = sentence.hidden = true;
    if (hasFocus && focusedBefore instanceof HTMLElement) focusedBefore.focus({ preventScroll: true });
  };
  const leavesPage = (/** @type {FocusEvent} */ event) => {
    const [element] = event.composedPath();
    if (isInside(bar, event.relatedTarget) && !isInside(bar, element)) focusedBefore = element;
  };
  document.addEventListener("focusout", leavesPage, { signal });
  document.getElementById("update-load")?.addEventListener("click", act, { signal });
  document.getElementById("update-later")?.addEventListener("click", close, { signal });
  bar.hidden = false;
  // Screen readers read what changes in an element that they know already.
  setTimeout(() => (sentence.hidden = signal.aborted), LIVE_REGION_DELAY);
}

/**
 * @param {Node} container
 * @param {EventTarget | null} target
 */
function isInside(container, target) {
  return target instanceof Node && container.contains(target);
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
 * Deletes the versions kept for this address that no other page uses, and loads what the server has now.
 * @param {string} scope
 * @param {() => Promise<void>} releaseVersion
 */
async function leave(scope, releaseVersion) {
  try {
    await releaseVersion();
    for (const name of await caches.keys()) {
      // Caches of pages in a folder below have a longer path.
      if (!name.startsWith(`pathlight ${scope}`) || !/^[^/]+\/$/.test(name.slice(`pathlight ${scope}`.length)))
        continue;
      await navigator.locks.request(name, { ifAvailable: true }, (lock) => lock && caches.delete(name));
    }
  } finally {
    location.reload();
  }
}
