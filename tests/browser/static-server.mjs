// A static host that sends only what it must: the files of a folder under a sub-path, with a media type and no other
// header.
//
//     const server = await serveStatic(folder);
//     server.folder = newer;       // another version is uploaded
//     server.isDown = true;        // it answers 503 with a page of its own, as a content delivery network does
//     await server.stop();         // the network is cut; server.start() brings it back under the same address

import { once } from "node:events";
import { readFile } from "node:fs/promises";
import { createServer } from "node:http";
import { extname, join } from "node:path";

const TYPES = {
  ".html": "text/html",
  ".css": "text/css",
  ".js": "text/javascript",
  ".json": "application/json",
  ".txt": "text/plain",
  ".svg": "image/svg+xml",
  ".png": "image/png",
  ".webmanifest": "application/manifest+json",
};

/**
 * Serves a folder under a path; files of other kinds, and wasm, are application/octet-stream.
 * @param {string} folder
 * @param {string} [path] with a slash at both ends
 */
export async function serveStatic(folder, path = "/a/b/") {
  const server = new StaticServer(folder, path);
  await server.start();
  return server;
}

class StaticServer {
  /** Where the page is, without the last slash. */
  origin = "";
  /** The addresses that were asked for, without the origin, and how they were answered. */
  answers = /** @type {{ url: string, status: number }[]} */ ([]);
  isDown = false;
  #port = 0;
  #path;
  /** @type {import('node:http').Server | null} */
  #server = null;

  /**
   * @param {string} folder
   * @param {string} path
   */
  constructor(folder, path) {
    this.folder = folder;
    this.#path = path;
  }

  async start() {
    const server = createServer((request, response) => this.#answer(request.url ?? "", response));
    server.listen(this.#port, "127.0.0.1");
    await once(server, "listening");
    this.#server = server;
    this.#port = /** @type {import('node:net').AddressInfo} */ (server.address()).port;
    this.origin = `http://127.0.0.1:${this.#port}${this.#path.slice(0, -1)}`;
  }

  async stop() {
    const server = this.#server;
    this.#server = null;
    server?.closeAllConnections();
    if (server) await new Promise((closed) => server.close(closed));
  }

  /**
   * @param {string} url
   * @param {import('node:http').ServerResponse} response
   */
  async #answer(url, response) {
    response.sendDate = false;
    if (this.isDown) {
      this.answers.push({ url, status: 503 });
      response.writeHead(503, { "content-type": "text/html" }).end("<h1>Service Unavailable</h1>");
      return;
    }
    const [path] = url.split("?");
    const inside = path.startsWith(this.#path) ? path.slice(this.#path.length) || "index.html" : null;
    const content = inside === null ? null : await readFile(join(this.folder, inside)).catch(() => null);
    const status = content ? 200 : 404;
    this.answers.push({ url, status });
    response
      .writeHead(status, { "content-type": (content && TYPES[extname(inside ?? "")]) ?? "application/octet-stream" })
      .end(content);
  }
}
