// The service worker of dist/. It caches all files of one version, so that the page works without a network.
//
// Each version has a separate cache. It replaces the previous version only when the person agrees or no page is open. A
// page that is still open requests files from the folder of its version and gets them from that version's cache, which
// is kept as long as such a page holds its lock.

/** The version and its files with their integrity, filled in by scripts/build-dist.mjs. */
declare const PRECACHE: { readonly version: string; readonly files: readonly KeptFile[] };

type KeptFile = readonly [path: string, integrity: string];

const worker = self as unknown as ServiceWorkerGlobalScope;
const { scope } = worker.registration;
/** Prefix of the caches of all versions; the address separates them from other pages of this origin. */
const PREFIX = `pathlight ${scope}`;
/** The cache of this version, and the lock of its pages. */
const CACHE = `${PREFIX}${PRECACHE.version}/`;
/** The folder of a version, named by a hash. */
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
  const path = request.url.slice(scope.length).replace(/[?#].*$/, "");
  const isIndex = request.mode === "navigate" && (path === "" || path === "index.html");
  if (isIndex || PATHS.has(path) || IMMUTABLE.test(path))
    event.respondWith(cachedOrFetched(isIndex ? scope : scope + path, request));
});

/** Caches all files. Holding the lock meanwhile keeps other versions from deleting this cache as unused. */
function install(): Promise<void> {
  return navigator.locks.request(CACHE, { mode: "shared" }, precache);
}

/** Fetches the files that are missing. If one fails, this version is not installed, and the previous one stays. */
async function precache(): Promise<void> {
  const cache = await caches.open(CACHE);
  const isWeights = ([path]: KeptFile) => path.startsWith("assets/");
  await Promise.all(PRECACHE.files.filter((file) => !isWeights(file)).map((file) => keep(cache, file)));
  // Large files one at a time, so that the page's own requests get through.
  for (const file of PRECACHE.files.filter(isWeights)) await keep(cache, file);
}

async function keep(cache: Cache, [path, integrity]: KeptFile): Promise<void> {
  const address = new URL(path, scope).href;
  // It may exist from an interrupted installation, or from a version with the same weights.
  if (await cache.match(address, { ignoreVary: true })) return;
  const known = IMMUTABLE.test(path) ? await caches.match(address, { ignoreVary: true }) : undefined;
  await cache.put(address, known ?? (await fetched(address, integrity)));
}

async function fetched(address: string, integrity: string): Promise<Response> {
  const response = await fetch(address, { integrity, cache: "no-cache" });
  if (!response.ok) throw new Error(`The server answered ${response.status} for ${address}.`);
  return response;
}

async function cachedOrFetched(address: string, request: Request): Promise<Response> {
  const own = await (await caches.open(CACHE)).match(address, { ignoreVary: true });
  // A page of another version requests files of that version.
  return own ?? (await caches.match(address, { ignoreVary: true })) ?? fetch(request);
}

/** Deletes the caches of other versions that no page uses. */
async function deleteUnusedVersions(): Promise<void> {
  for (const name of await caches.keys()) {
    if (name === CACHE || !name.startsWith(PREFIX) || !VERSION_FOLDER.test(name.slice(PREFIX.length))) continue;
    await navigator.locks.request(name, { ifAvailable: true }, async (lock) => {
      // The next version has a cache, but no pages yet.
      const { installing, waiting } = worker.registration;
      if (lock && !installing && !waiting) await caches.delete(name);
    });
  }
}
