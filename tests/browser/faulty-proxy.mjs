// Stands between the browser and the server, and spoils the files that a fault names: they do not come, break off, come
// with one bit changed, or slowly.
//
//     const proxy = await startFaultyProxy(session.origin);
//     proxy.fault = { path: /\.safetensors$/, kind: 'cut' };
//     await page.goto(`${proxy.origin}/`);
//     await proxy.stop();

import { once } from "node:events";
import { createServer, request } from "node:http";
import { setTimeout as wait } from "node:timers/promises";

/**
 * `gone`: no answer, the connection is closed; `cut`: half of it; `bit`: one bit in the middle is another; `bit once`:
 * the first time only; `slow`: a line of 3G.
 * @typedef {{ path: RegExp, kind: 'gone' | 'cut' | 'bit' | 'bit once' | 'slow' }} Fault
 */

/** What a slow line carries, bytes each `SLICE` ms: 50 kB a second. */
const SLICE_BYTES = 5000;
const SLICE = 100;

/** @param {string} target the origin of the server */
export async function startFaultyProxy(target) {
  const proxy = new FaultyProxy(target);
  await proxy.start();
  return proxy;
}

class FaultyProxy {
  origin = "";
  fault = /** @type {Fault | null} */ (null);
  #target;
  #server = createServer((asked, answer) => this.#answer(asked, answer));

  /** @param {string} target */
  constructor(target) {
    this.#target = target;
  }

  async start() {
    this.#server.listen(0, "127.0.0.1");
    await once(this.#server, "listening");
    this.origin = `http://127.0.0.1:${/** @type {import('node:net').AddressInfo} */ (this.#server.address()).port}`;
  }

  async stop() {
    this.#server.closeAllConnections();
    await new Promise((closed) => this.#server.close(closed));
  }

  /**
   * @param {import('node:http').IncomingMessage} asked
   * @param {import('node:http').ServerResponse} answer
   */
  async #answer(asked, answer) {
    const url = new URL(asked.url ?? "/", this.#target);
    // Uncompressed, so that one bit is one bit of the file.
    const headers = { ...asked.headers, host: url.host, "accept-encoding": "identity" };
    const [response] = await once(request(url, { headers }).end(), "response");
    const body = Buffer.concat(await response.toArray());
    const kind = this.fault?.path.test(url.pathname) ? this.fault.kind : null;
    if (kind === "gone") {
      answer.destroy();
      return;
    }
    if (kind === "bit once") this.fault = null;
    if (kind === "bit" || kind === "bit once") body[body.length >> 1] ^= 1;
    answer.writeHead(response.statusCode, { ...response.headers, "content-length": body.length });
    if (kind === "cut") {
      answer.write(body.subarray(0, body.length >> 1), () => answer.destroy());
      return;
    }
    let sent = 0;
    // Until the line is fast again.
    for (
      ;
      this.fault?.kind === "slow" && this.fault.path.test(url.pathname) && sent < body.length && !answer.destroyed;
      sent += SLICE_BYTES
    ) {
      answer.write(body.subarray(sent, sent + SLICE_BYTES));
      await wait(SLICE);
    }
    answer.end(body.subarray(sent));
  }
}
