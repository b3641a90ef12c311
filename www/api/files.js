// Reads the files beside the modules, and compiles the wasm: by fetch, or in Node, whose fetch knows no `file:`
// addresses, from the disk.

import { WASM_SHA256 } from "../pkg/integrity.js";
import { failure } from "./failure.js";
import { intact, sha256 } from "./sha256.js";

/** The wasm of this version. */
const WASM = new URL("../pkg/pathlight_bg.wasm", import.meta.url);

/**
 * Called with the fraction of a file that has arrived, 0..1, or null if its size is unknown.
 * @typedef {(fraction: number | null) => void} OnProgress
 */

/**
 * Makes an error out of a reason like “the server answered 404”.
 * @typedef {(reason: string, status?: number) => Error} Refuse
 */

/**
 * Returns the bytes at an address. Rejects with the error that `refuse` makes, also if the transfer breaks off.
 * @param {URL} address
 * @param {Refuse} refuse
 * @param {OnProgress} [onProgress]
 * @param {number | null} [size] of the file in bytes, if it is known: a compressed answer does not say it
 * @param {RequestCache} [cache]
 * @returns {Promise<Uint8Array<ArrayBuffer>>}
 */
export async function readFile(address, refuse, onProgress = () => {}, size = null, cache = "default") {
  const disk = diskOf(address);
  if (disk) return new Uint8Array(await orRefuse(disk(address), refuse));
  const response = await answerOf(address, refuse, cache);
  if (!response.body) throw refuse("the answer is empty");
  const whole = size ?? (Number(response.headers.get("content-length")) || null);
  const chunks = [];
  let length = 0;
  for (const reader = response.body.getReader(); ;) {
    const { done, value } = await orRefuse(reader.read(), refuse);
    if (done) break;
    chunks.push(value);
    length += value.length;
    // What a host compresses becomes longer than it says.
    onProgress(whole && Math.min(length / whole, 1));
  }
  const bytes = new Uint8Array(length);
  let end = 0;
  for (const chunk of chunks) {
    bytes.set(chunk, end);
    end += chunk.length;
  }
  return bytes;
}

/**
 * The wasm beside this module is compiled once for all who ask.
 * @type {Promise<WebAssembly.Module> | null}
 */
let compiled = null;

/**
 * Compiles the wasm. Rejects with `no_wasm` if it cannot be read or is no wasm.
 * @param {WebAssembly.Module | BufferSource | URL | string} [source] the module itself, its bytes or their address;
 *   without it, the wasm beside this module
 * @returns {Promise<WebAssembly.Module>}
 */
export async function compileWasm(source) {
  if (typeof WebAssembly !== "object") {
    throw failure(
      "no_wasm",
      "There is no WebAssembly here, or it is switched off. Pathlight needs it: try a current browser.",
    );
  }
  if (source === undefined) {
    compiled ??= compileFile(WASM, WASM_SHA256);
    return compiled.catch((error) => {
      compiled = null;
      throw error;
    });
  }
  if (source instanceof WebAssembly.Module) return checked(source);
  if (typeof source !== "string" && !(source instanceof URL)) {
    const compiling = orRefuse(WebAssembly.compile(source), (reason) =>
      failure("no_wasm", `Pathlight’s wasm could not be compiled: ${reason}. Give the wasm file of this version.`),
    );
    return checked(await compiling);
  }
  return checked(await compileFile(addressOf(source)));
}

/**
 * Returns the module if it is Pathlight's. Another would be kept by the glue code, and all later calls would fail.
 * @param {WebAssembly.Module} module
 */
function checked(module) {
  if (WebAssembly.Module.exports(module).some(({ name }) => name === "verifyAttempt")) return module;
  throw failure("no_wasm", "This wasm is not Pathlight’s. Give the wasm file of this version.");
}

/**
 * @param {URL} address
 * @param {string | null} [hash] SHA-256 of the file, if it is known
 */
async function compileFile(address, hash = null) {
  /** @type {Refuse} */
  const refuse = (reason, status) => {
    const missing = status === 404 || diskOf(address);
    const forbidden = /Content.Security.Policy|unsafe-eval/i.test(reason);
    const remedy = forbidden
      ? "Allow 'wasm-unsafe-eval' in the script-src of the page’s Content-Security-Policy."
      : missing
        ? "Build or install Pathlight again."
        : "Check the connection and try again.";
    return failure("no_wasm", `Pathlight’s wasm could not be loaded: ${reason} for ${address}. ${remedy}`);
  };
  const module = await intact((cache) => compileIntact(address, hash, refuse, cache));
  return module ?? Promise.reject(refuse("the file is damaged or another version’s"));
}

/**
 * Compiles a file while it arrives, and hashes it beside that. Returns null if its hash is another.
 * @param {URL} address
 * @param {string | null} hash
 * @param {Refuse} refuse
 * @param {RequestCache} cache
 */
async function compileIntact(address, hash, refuse, cache) {
  const response = diskOf(address)
    ? new Response(await readFile(address, refuse))
    : await answerOf(address, refuse, cache);
  const copy = hash === null ? null : response.clone();
  // Not every static server knows wasm's media type, without which browsers refuse to compile what arrives.
  const streams = response.headers.get("content-type") === "application/wasm";
  const compiling = orRefuse(
    streams
      ? WebAssembly.compileStreaming(response)
      : response.arrayBuffer().then((bytes) => WebAssembly.compile(bytes)),
    refuse,
  );
  // What is damaged may not compile either; the hash decides.
  compiling.catch(() => {});
  const found = copy && (await orRefuse(copy.arrayBuffer().then(sha256), refuse));
  return found && found !== hash ? null : compiling;
}

/**
 * Returns an absolute address. One without a scheme is relative to the page, or in Node to the working directory.
 * @param {URL | string} address
 */
export function addressOf(address) {
  if (address instanceof URL) return address;
  if (typeof address !== "string") throw failure("bad_data", `${address} is neither bytes nor an address.`);
  const node = nodeModule("node:url");
  if (node && !/^[a-z]{2,}:/i.test(address)) return node.pathToFileURL(address);
  try {
    return new URL(address, globalThis.location?.href);
  } catch {
    throw failure("bad_data", `“${address}” is no address.`);
  }
}

/**
 * @param {URL} address
 * @param {Refuse} refuse
 * @param {RequestCache} cache
 */
async function answerOf(address, refuse, cache) {
  const response = await orRefuse(fetch(address, { cache }), refuse);
  if (!response.ok) throw refuse(`the server answered ${response.status}`, response.status);
  // Servers of single-page apps send their page in place of what is missing.
  if (response.headers.get("content-type")?.startsWith("text/html"))
    throw refuse("the server answered with a page (text/html)", 404);
  return response;
}

/**
 * Returns what a promise resolves to; if it rejects, rejects with the error that `refuse` makes of the reason.
 * @template T
 * @param {Promise<T>} promise
 * @param {Refuse} refuse
 */
function orRefuse(promise, refuse) {
  return promise.catch((/** @type {Error} */ { message }) => Promise.reject(refuse(message)));
}

/**
 * Returns what reads an address from the disk, or null if fetch has to.
 * @param {URL} address
 * @returns {((address: URL) => Promise<Uint8Array<ArrayBuffer>>) | null}
 */
function diskOf(address) {
  return address.protocol === "file:" ? (nodeModule("node:fs/promises")?.readFile ?? null) : null;
}

/**
 * Returns a module of Node, or undefined elsewhere. It is no import, which a bundler would look for.
 * @param {string} name
 */
function nodeModule(name) {
  return /** @type {any} */ (globalThis).process?.getBuiltinModule?.(name);
}
