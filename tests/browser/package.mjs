// The npm package, as `make package` leaves it in target/package.

import { existsSync } from "node:fs";
import { fileURLToPath } from "node:url";

/** Its folder. */
export const PACKAGE = fileURLToPath(new URL("../../target/package", import.meta.url));

if (!existsSync(`${PACKAGE}/pathlight.js`)) throw new Error(`${PACKAGE} holds no package: run make package`);
/** @type {typeof import("../../www/api/index.ts").load} */
export const load = (await import(`${PACKAGE}/pathlight.js`)).load;
