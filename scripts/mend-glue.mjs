// Makes two changes to the JavaScript that wasm-bindgen writes: node scripts/mend-glue.mjs FILE
//
// First, a getter or a proxy in an argument runs in the middle of the call that reads it, and may free the object whose
// method is running. wasm-bindgen then throws, and the object counts as freed although it is not. Second, the errors
// that wasm-bindgen throws when an object is used after it was freed, or is called while it changes, have no code.

import { readFileSync, writeFileSync } from "node:fs";

const [file] = process.argv.slice(2);

/** @type {[from: RegExp, to: string][]} */
const CHANGES = [
  // The second argument: whether to wait until nothing uses the object.
  [/(\.__wbg_\w+_free\(ptr), 0\)/g, "$1, 1)"],
  [/throw (new Error\(getStringFromWasm0\(arg0, arg1\)\))/g, 'throw Object.assign($1, { code: "bad_data" })'],
];

const mended = CHANGES.reduce(
  (code, [from, to]) => {
    if (code.search(from) < 0) throw new Error(`${file} has no ${from}: adapt it to this version of wasm-bindgen`);
    return code.replace(from, to);
  },
  readFileSync(file, "utf8"),
);
writeFileSync(file, mended);
