// The files that come with the package: where they are, and how they are read, with fetch or in Node from disk.
//
// Addresses are computed only when a file is needed: a bundle imported from a blob has no address to resolve others
// against. Bundlers find a file only by its literal address, relative to the bundle, not to this module.

import models from "../../assets/model.json";
import { failure } from "./errors.ts";
import type { ErrorCode } from "./errors.ts";

/** Called with the fraction of a file that has been loaded, 0..1, or null if its size is unknown. */
export type OnProgress = (fraction: number | null) => void;

/** The folder that holds the package's `pkg/` and `assets/`; null for the package's own location. */
export type Base = URL | string | null;

export interface ModelEntry {
  readonly name: string;
  readonly file: string;
  /** Bytes. */
  readonly size: number;
  readonly sha256: string;
}

export const MODELS: readonly ModelEntry[] = models.models;

/** Why a file cannot be used. */
type Fault = "missing" | "unreachable" | "page" | "forbidden" | "damaged";

const REMEDIES: Record<Fault, string> = {
  missing: "Build or install Pathlight again.",
  page: "Build or install Pathlight again.",
  unreachable: "Check the connection and try again.",
  forbidden: "Allow 'wasm-unsafe-eval' in the script-src of the page’s Content-Security-Policy.",
  damaged: "Give the file of this version.",
};

interface What {
  readonly code: ErrorCode;
  /** Name for use in a sentence: "Pathlight’s wasm". */
  readonly name: string;
}

const WASM: What = { code: "no_wasm", name: "Pathlight’s wasm" };
const WEIGHTS: What = { code: "no_weights", name: "The model’s weights" };

const compiled = new Map<string, Promise<WebAssembly.Module>>();

/** Compiles the wasm, once per address. Rejects with `no_wasm`. */
export async function compileWasm(
  source: WebAssembly.Module | BufferSource | URL | string | undefined,
  base: Base,
): Promise<WebAssembly.Module> {
  if (typeof WebAssembly !== "object")
    throw failure("no_wasm", "There is no WebAssembly here, or it is switched off: try a current browser.");
  if (source instanceof WebAssembly.Module) return checked(source, "this module");
  if (source !== undefined && typeof source !== "string" && !(source instanceof URL))
    return compile(source, "these bytes");
  const address = source === undefined ? wasmAddress(base) : addressOf(source);
  const compiling = compiled.get(address.href) ?? read(address, WASM).then((bytes) => compile(bytes, address.href));
  compiled.set(address.href, compiling);
  return compiling.catch((error) => {
    compiled.delete(address.href);
    throw error;
  });
}

async function compile(bytes: BufferSource, address: string): Promise<WebAssembly.Module> {
  const module = await WebAssembly.compile(bytes).catch(({ message }: Error) => {
    throw refused(
      WASM,
      /CSP|Content.Security.Policy|unsafe-eval/i.test(message) ? "forbidden" : "damaged",
      message,
      address,
    );
  });
  return checked(module, address);
}

/** Refuses other wasm modules: the glue code would keep one, and all later calls would fail. */
function checked(module: WebAssembly.Module, address: string): WebAssembly.Module {
  if (WebAssembly.Module.exports(module).some(({ name }) => name === "verifyAttempt")) return module;
  throw refused(WASM, "damaged", "it is another program", address);
}

/** Reads the weights of a model. Refuses files that differ from the list. */
export async function readModel(entry: ModelEntry, base: Base, onProgress?: OnProgress): Promise<Uint8Array> {
  const address = modelAddress(entry, base);
  // Fetch a damaged file once more, bypassing all caches, which may hold the damage.
  for (const cache of ["default", "reload"] as const) {
    const bytes = await read(address, WEIGHTS, onProgress, entry.size, cache);
    if (((await sha256(bytes)) ?? entry.sha256) === entry.sha256) return bytes;
  }
  throw failure("bad_weights", `${address} is not the model “${entry.name}” of this version: it is damaged or old.`);
}

/** Reads weights from an address; in Node, also from a path. */
export function readWeights(address: URL | string, onProgress?: OnProgress): Promise<Uint8Array> {
  return read(addressOf(address), WEIGHTS, onProgress);
}

function wasmAddress(base: Base): URL {
  return base === null
    ? here(WASM, () => new URL("./pkg/worker/pathlight_bg.wasm", import.meta.url))
    : new URL("pkg/worker/pathlight_bg.wasm", addressOf(base));
}

/** The package contains the weights of the first model only; a base may have others. */
function modelAddress({ file }: ModelEntry, base: Base): URL {
  return base === null && file === MODELS[0]!.file
    ? here(WEIGHTS, () => new URL("./assets/within-0.safetensors", import.meta.url))
    : new URL(`assets/${file}`, base === null ? here(WEIGHTS, () => new URL(import.meta.url)) : addressOf(base));
}

function here({ code, name }: What, make: () => URL): URL {
  try {
    const address = make();
    if (address.protocol !== "blob:" && address.protocol !== "data:") return address;
  } catch {
    // This module's address cannot be resolved against.
  }
  throw failure(code, `${name} cannot be found from here: name its folder with load({ base: "https://…/" }).`);
}

async function read(
  address: URL,
  what: What,
  onProgress: OnProgress = () => {},
  size: number | null = null,
  cache: RequestCache = "default",
): Promise<Uint8Array<ArrayBuffer>> {
  const refuse = (fault: Fault, reason: string) => refused(what, fault, reason, address.href);
  const disk = address.protocol === "file:" && nodeModule("node:fs/promises");
  if (disk) return new Uint8Array(await orRefuse(disk.readFile(address), (reason) => refuse("missing", reason)));
  const unreachable = (reason: string) => refuse("unreachable", reason);
  const response = await orRefuse(fetch(address, { cache }), unreachable);
  if (!response.ok || !response.body)
    throw refuse(response.status === 404 ? "missing" : "unreachable", `the server answered ${response.status}`);
  const whole = size ?? (Number(response.headers.get("content-length")) || null);
  const chunks: Uint8Array[] = [];
  let length = 0;
  for (const reader = response.body.getReader(); ;) {
    const { done, value } = await orRefuse(reader.read(), unreachable);
    if (done) break;
    chunks.push(value);
    length += value.length;
    // Compressed responses are longer than their stated size.
    onProgress(whole && Math.min(length / whole, 1));
  }
  const bytes = new Uint8Array(length);
  let end = 0;
  for (const chunk of chunks) {
    bytes.set(chunk, end);
    end += chunk.length;
  }
  // Servers of single-page apps answer for missing files with their page, some with the requested type.
  if (/^\s*<(!|html)/i.test(new TextDecoder("latin1").decode(bytes.subarray(0, 16))))
    throw refuse("page", "the server answered with a page");
  return bytes;
}

function refused({ code, name }: What, fault: Fault, reason: string, address: string): Error {
  return failure(code, `${name} could not be loaded: ${reason} for ${address}. ${REMEDIES[fault]}`);
}

function orRefuse<T>(promise: Promise<T>, refuse: (reason: string) => Error): Promise<T> {
  return promise.catch((error: Error) => Promise.reject(refuse(error.message)));
}

/** Resolves an address. Without a scheme, it is relative to the page, or in Node to the working directory. */
function addressOf(address: URL | string): URL {
  if (address instanceof URL) return address;
  if (typeof address !== "string") throw failure("bad_data", `${address} is neither bytes nor an address.`);
  const node = nodeModule("node:url");
  if (node && !/^[a-z]{2,}:/i.test(address)) return node.pathToFileURL(address);
  try {
    return new URL(address, globalThis.location?.href);
  } catch {
    throw failure("bad_data", `“${address}” is not an address.`);
  }
}

/** Returns a module of Node, or undefined elsewhere. Not an import, because bundlers would try to resolve it. */
function nodeModule(name: string): any {
  return (globalThis as any).process?.getBuiltinModule?.(name);
}

/** Returns the hash in hexadecimal; null where browsers cannot hash: on addresses that are neither secure nor local. */
async function sha256(bytes: BufferSource): Promise<string | null> {
  if (!globalThis.crypto?.subtle) return null;
  const hash = new Uint8Array(await crypto.subtle.digest("SHA-256", bytes));
  return Array.from(hash, (byte) => byte.toString(16).padStart(2, "0")).join("");
}
