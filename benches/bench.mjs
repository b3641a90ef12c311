// Times our nets and simulator beside their peers, prints one table in Markdown and writes target/bench/results.json:
// node benches/bench.mjs [PART…]
//
// `run` has installed the peers. A peer that is missing or fails is left out, and the table says so. ROUNDS is how many
// turns each implementation has.

import { writeFileSync } from "node:fs";
import { parts, root } from "./comparisons.mjs";
import { circumstances, measure, row, wantedParts } from "./measure.mjs";

const RESULTS = "target/bench/results.json";

const wanted = wantedParts(parts, process.argv.slice(2));
const { commit, changed, cpu, cores, load, rounds } = circumstances(root);
const rows = [];
for (const comparison of wanted.flatMap((part) => parts[part])) {
  console.error(`measuring: ${comparison.title}`);
  rows.push(await measure(comparison));
}
writeFileSync(
  `${root}/${RESULTS}`,
  `${JSON.stringify({ commit, changed, cpu, cores, load, rounds, parts: wanted, rows }, null, 2)}\n`,
);
console.log("| work | ours | peers: their time, and how many times as fast ours is |\n| --- | ---: | --- |");
console.log(rows.map(row).join("\n"));
console.log(
  `\nMedians of ${rounds} rounds, and quartiles of the ratios, at commit ${commit}${changed ? ", changed" : ""}, ${cpu}, ` +
    `${cores} cores, load ${load.toFixed(1)} before. Parts: ${wanted.join(", ")}. All of it: ${RESULTS}`,
);
