// Times ours at two commits in one run: node benches/compare.mjs BEFORE AFTER [PART…], which are two checkouts that
// `compare` has built. The implementations of a commit are its own; the rounds are these here.

import { parts } from "./comparisons.mjs";
import { circumstances, measure, row, wantedParts } from "./measure.mjs";

const [before, after, ...names] = process.argv.slice(2);
const wanted = wantedParts(parts, names);
const [{ commit: first }, { commit: second, cpu, cores, load, rounds }] = [before, after].map(circumstances);
const rows = [];
// An implementation in a page is given the page, whose server has one checkout.
for (const comparison of wanted.flatMap((part) => parts[part]).filter(({ open }) => !open)) {
  console.error(`measuring: ${comparison.title}`);
  const [[, start]] = comparison.implementations;
  const implementations = [
    [second, () => start(undefined, after)],
    [first, () => start(undefined, before)],
  ];
  // Their weights may differ, and with them what is computed.
  rows.push(await measure({ ...comparison, implementations, agree() {} }));
}
console.log(`| work | ${second} | ${first}, and how many times as fast ${second} is |\n| --- | ---: | --- |`);
console.log(rows.map(row).join("\n"));
console.log(
  `\nMedians of ${rounds} rounds, and quartiles of the ratios, ${cpu}, ${cores} cores, load ${load.toFixed(1)} before.`,
);
