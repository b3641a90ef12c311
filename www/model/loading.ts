// Finds out why a file could not be used: turns an error into a failure, for which the text has the remedy.

import type { Failure, FailureCode } from "../core/change/model.ts";

export class LoadError extends Error {
  readonly failure: Failure;

  constructor(failure: Failure) {
    super(failure.reason);
    this.failure = failure;
  }
}

/** A module of one function that uses SIMD, as the project's wasm does. */
const SIMD = [
  0, 97, 115, 109, 1, 0, 0, 0, 1, 5, 1, 96, 0, 1, 123, 3, 2, 1, 0, 10, 10, 1, 8, 0, 65, 0, 253, 15, 253, 98, 11,
];

/**
 * Fetches the file once more and inspects it, because browsers report little, and each something different. `otherwise`
 * is the failure if the file is there.
 */
export async function loadError(url: string, error: unknown, otherwise: FailureCode): Promise<LoadError> {
  const said = error instanceof Error ? error.message : String(error);
  return new LoadError({ code: await codeOf(url, said, otherwise), reason: `${url}: ${said}` });
}

async function codeOf(url: string, said: string, otherwise: FailureCode): Promise<FailureCode> {
  const response = await fetch(url).catch(() => null);
  if (!response) return navigator.onLine ? "unreachable" : "offline";
  if (!response.ok) return response.status < 500 ? "missing" : "unreachable";
  const start = (await response.text().catch(() => "")).trimStart();
  // The host answers everything with its start page, or the network asks for a login first.
  if (/^<(!doctype|html)/i.test(start)) return "page";
  if (/content.security.policy|\bCSP\b|unsafe-eval/i.test(said)) return "forbidden";
  return WebAssembly.validate(Uint8Array.from(SIMD)) ? otherwise : "old";
}
