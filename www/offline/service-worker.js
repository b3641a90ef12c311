// The service worker of dist/, which keeps all files of one version, so that the page works without a network. It
// belongs to dist/ alone: the sources and the bundle of `make play` have nothing at this worker's address.
//
// Each version has a cache of its own, and takes the place of the one before only when the person says so, or when no
// page is open. A page that is still open then asks for files in the folder of its own version, and gets them from the
// cache of that version, which stays as long as such a page holds its lock.

/**
 * The version, and the paths that it is made of with their integrity. scripts/build-dist.mjs fills it in.
 * @type {{ version: string, files: [path: string, integrity: string][] }}
 */
const PRECACHE = { version: "", files: [] };

const worker = /** @type {ServiceWorkerGlobalScope} */ (/** @type {unknown} */ (self));
const { scope } = worker.registration;
/** How the caches of all versions begin; the address keeps other pages of this origin apart. */
const PREFIX = `pathlight ${scope}`;
/** The cache of this version, and the lock of its pages. */
const CACHE = `${PREFIX}${PRECACHE.version}/`;
/** The folder of a version, which is named by a hash. */
const VERSION_FOLDER = /^[0-9a-f]{12}\/$/;
/** Files that never change: those in the folder of a version, and weights. */
const IMMUTABLE = /^([0-9a-f]{12}|assets)\//;
const PATHS = new Set(PRECACHE.files.map(([path]) => path));

worker.addEventListener("install", (event) => event.waitUntil(install()));
worker.addEventListener("activate", (event) => event.waitUntil(worker.clients.claim()));

worker.addEventListener("message", (event) => {
  if (event.data === "activate") event.waitUntil(worker.skipWaiting());
  if (event.data === "started") event.waitUntil(deleteUnusedVersions());
});

worker.addEventListener("fetch", (event) => {
  const { request } = event;
  if (request.method !== "GET" || !request.url.startsWith(scope)) return;
  const path = new URL(request.url).href.slice(scope.length).replace(/[?#].*$/, "");
  if (request.mode === "navigate" && (path === "" || path === "index.html")) {
    event.respondWith(cachedOrFetched(scope, request));
  } else if (PATHS.has(path) || IMMUTABLE.test(path)) {
    event.respondWith(cachedOrFetched(scope + path, request));
  }
});

/**
 * Keeps all files. The lock, as long as it takes, keeps another version's worker from deleting this cache as unused.
 */
function install() {
  return navigator.locks.request(CACHE, { mode: "shared" }, precache);
}

/** Fetches the files that are not here yet. If one fails, this version is not installed, and the one before stays. */
async function precache() {
  const cache = await caches.open(CACHE);
  const isWeights = (/** @type {string} */ path) => path.startsWith("assets/");
  await Promise.all(PRECACHE.files.filter(([path]) => !isWeights(path)).map((file) => keep(cache, file)));
  // Large ones after each other, so that the page's own requests come through.
  for (const file of PRECACHE.files.filter(([path]) => isWeights(path))) await keep(cache, file);
}

/**
 * @param {Cache} cache
 * @param {[path: string, integrity: string]} file
 */
async function keep(cache, [path, integrity]) {
  const address = new URL(path, scope).href;
  // It may be there from an installation that was interrupted, or from a version with the same weights.
  if (await cache.match(address, { ignoreVary: true })) return;
  const known = IMMUTABLE.test(path) ? await caches.match(address, { ignoreVary: true }) : undefined;
  await cache.put(address, known ?? (await fetched(address, integrity)));
}

/**
 * @param {string} address
 * @param {string} integrity
 */
async function fetched(address, integrity) {
  const response = await fetch(address, { integrity, cache: "no-cache" });
  if (!response.ok) throw new Error(`The server answered ${response.status} for ${address}.`);
  return response;
}

/**
 * @param {string} address
 * @param {Request} request
 */
async function cachedOrFetched(address, request) {
  const own = await (await caches.open(CACHE)).match(address, { ignoreVary: true });
  // A page of another version asks for files of that one.
  return own ?? (await caches.match(address, { ignoreVary: true })) ?? fetch(request);
}

/** Deletes the caches of other versions that no page uses. */
async function deleteUnusedVersions() {
  for (const name of await caches.keys()) {
    if (name === CACHE || !name.startsWith(PREFIX) || !VERSION_FOLDER.test(name.slice(PREFIX.length))) continue;
    await navigator.locks.request(name, { ifAvailable: true }, async (lock) => {
      // The next version has a cache, but no pages yet.
      if (lock && !hasNextVersion()) await caches.delete(name);
    });
  }
}

function hasNextVersion() {
  return Boolean(worker.registration.installing || worker.registration.waiting);
}
