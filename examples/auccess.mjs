// Measures the auccess of an agent on 50 test tasks. Here the agent is the model; to measure your own, let it choose the
// balls instead of `propose`.

import { load } from "pathlight";

const pathlight = await load();
const tasks = pathlight.fold("within", 0).test.filter((_, index) => index % 10 === 0);
const firstSolved = tasks.map((task) => {
  const balls = pathlight.propose(task).map(({ ball }) => ball);
  const index = balls.findIndex((ball) => pathlight.simulate(task, ball).solved);
  return index < 0 ? null : index + 1;
});
console.log(`auccess ${pathlight.auccess(firstSolved).toFixed(1)} on ${tasks.length} tasks`);
