// Starts the service worker, and offers a new version of the page. Only the index.html of dist/ loads this file. Where
// service workers are missing or denied, or storage is full, the page works without them. It depends on no other
// script, so that a broken version can still be replaced.

const SERVICE_WORKER = "service-worker.js";
/** Maximum wait for an idle page before the service worker is registered, ms. */
const PATIENCE = 5000;
/** Name of the cache of this version, and of the lock that its pages hold. */
const CACHE = `pathlight ${new URL("./", import.meta.url)}`;

// Without a network, in a private window or in a sandboxed frame, there is nothing to do or report.
start().catch(() => {});

async function start(): Promise<void> {
  const { serviceWorker, locks } = navigator;
  if (!serviceWorker || !locks) return;
  const release = await holdVersion();
  serviceWorker.controller?.postMessage("started");
  // The first puzzle must not wait for files cached for later.
  await idle();
  // Do not read the worker's script from the HTTP cache.
  const registration = await serviceWorker.register(SERVICE_WORKER, { updateViaCache: "none" });
  const offerNext = () => offer(() => load(registration));
  if (registration.waiting) offerNext();
  const watch = () => {
    const { installing } = registration;
    // The very first version replaces none.
    installing?.addEventListener("statechange", () => {
      if (installing.state === "installed" && registration.active) offerNext();
    });
  };
  registration.addEventListener("updatefound", watch);
  watch();
  const check = () => checkForUpdate(registration, release);
  document.addEventListener("visibilitychange", () => document.visibilityState === "visible" && void check());
  if (serviceWorker.controller) await check();
}

/** Resolves once this page holds the lock of its version, which keeps its files. The result releases the lock. */
function holdVersion(): Promise<() => Promise<unknown>> {
  return new Promise((held, denied) => {
    const ended = navigator.locks.request(CACHE, { mode: "shared" }, () => {
      return new Promise<void>((end) => held(() => (end(), ended)));
    });
    ended.catch(denied);
  });
}

function idle(): Promise<unknown> {
  return new Promise((resolve) => {
    // Not supported by every browser.
    if ("requestIdleCallback" in window) requestIdleCallback(resolve, { timeout: PATIENCE });
    else setTimeout(resolve, PATIENCE);
  });
}

async function checkForUpdate(registration: ServiceWorkerRegistration, release: () => Promise<unknown>): Promise<void> {
  try {
    await registration.update();
  } catch {
    // Something else is served at this address now. Without this check, the cached version would be shown forever.
    if (!(await isGone())) return;
    await registration.unregister();
    offer(() => leave(registration.scope, release));
  }
}

/** Whether the server says that there is no service worker, or answers everything with a page; not on errors. */
async function isGone(): Promise<boolean> {
  try {
    const { status, ok, redirected, headers } = await fetch(SERVICE_WORKER, { method: "HEAD", cache: "no-store" });
    const isPage = headers.get("content-type")?.startsWith("text/html") ?? false;
    return status === 404 || status === 410 || (ok && !redirected && isPage);
  } catch {
    return false;
  }
}

/** Shows the message once, outside what main.js renders, which may be broken. */
function offer(act: () => void): void {
  const bar = document.getElementById("update")!;
  if (!bar.hidden) return;
  const [yes, no] = bar.querySelectorAll("button");
  yes!.onclick = act;
  no!.onclick = () => (bar.hidden = true);
  bar.hidden = false;
}

/** Reloads the page in the new version. */
function load({ waiting }: ServiceWorkerRegistration): void {
  // Another page may already have activated the new version.
  if (!waiting) return location.reload();
  navigator.serviceWorker.addEventListener("controllerchange", () => location.reload(), { once: true });
  waiting.postMessage("activate");
}

/** Deletes cached versions of this address that no other page uses, and loads what the server has now. */
async function leave(scope: string, release: () => Promise<unknown>): Promise<void> {
  try {
    await release();
    const prefix = `pathlight ${scope}`;
    for (const name of await caches.keys()) {
      // Caches of pages in subfolders have a longer path.
      if (!name.startsWith(prefix) || !/^[^/]+\/$/.test(name.slice(prefix.length))) continue;
      await navigator.locks.request(name, { ifAvailable: true }, async (lock) => lock && (await caches.delete(name)));
    }
  } finally {
    location.reload();
  }
}
