// Box2D 2.4.1 in wasm, the npm package box2d-wasm, with the loop in JavaScript as its users write it. Stepping alone.

import { createRequire } from "node:module";

export async function load(read) {
  // Its ES module does not run in Node.
  const start = createRequire(import.meta.url)("../../../target/bench/node_modules/box2d-wasm/dist/umd/Box2D.simd.js");
  const box2d = await start({
    wasmBinary: await read("target/bench/node_modules/box2d-wasm/dist/umd/Box2D.simd.wasm"),
  });
  const { parameters, rollouts } = parse(new TextDecoder().decode(await read("target/bench/rollouts.txt")));
  const result = rollouts.map((rollout) => {
    const { world, bodies, free } = build(box2d, parameters, rollout);
    const { solved, steps } = run(box2d, parameters, rollout, world, bodies);
    const positions = bodies
      .filter((_, index) => rollout.bodies[index].dynamic)
      .flatMap((body) => {
        const { x, y } = body.GetPosition();
        return [x * parameters.pxPerMetre, y * parameters.pxPerMetre];
      });
    free();
    return [Number(solved), steps, ...positions];
  });
  return {
    result,
    time() {
      let milliseconds = 0;
      for (const rollout of rollouts) {
        const { world, bodies, free } = build(box2d, parameters, rollout);
        const start = performance.now();
        run(box2d, parameters, rollout, world, bodies);
        milliseconds += performance.now() - start;
        free();
      }
      return milliseconds;
    },
  };
}

/** The file that `cargo bench --bench simulator -- export FILE` writes. */
function parse(text) {
  let at = 0;
  const numbers = text.split(/\s+/).map(Number);
  const next = () => numbers[at++];
  const many = (count, one) => Array.from({ length: count }, one);
  const names = [
    "maxSteps",
    "goalSteps",
    "velocityIterations",
    "positionIterations",
    "pxPerMetre",
    "timeStep",
    "gravity",
    "density",
    "friction",
    "restitution",
    "angularDamping",
  ];
  const parameters = Object.fromEntries(names.map((name) => [name, next()]));
  const shape = () => ({ radius: next(), corners: many(next(), () => [next(), next()]) });
  const body = () => ({ dynamic: next() === 1, x: next(), y: next(), angle: next(), shapes: many(next(), shape) });
  const rollouts = [];
  while (at < numbers.length - 1) {
    rollouts.push({ object: next(), goal: next(), touchDistance: next(), bodies: many(next(), body) });
  }
  return { parameters, rollouts };
}

function build(box2d, parameters, rollout) {
  const { b2World, b2Vec2, b2BodyDef, b2FixtureDef, b2CircleShape, b2PolygonShape, b2_dynamicBody, b2_staticBody } =
    box2d;
  const temporary = [];
  const keep = (object) => {
    temporary.push(object);
    return object;
  };
  const metres = (x, y) => keep(new b2Vec2(x / parameters.pxPerMetre, y / parameters.pxPerMetre));
  const world = new b2World(keep(new b2Vec2(0, parameters.gravity)));
  const bodies = rollout.bodies.map((from) => {
    const definition = keep(new b2BodyDef());
    definition.set_type(from.dynamic ? b2_dynamicBody : b2_staticBody);
    definition.set_position(metres(from.x, from.y));
    definition.set_angle(from.angle);
    definition.set_angularDamping(parameters.angularDamping);
    const body = world.CreateBody(definition);
    for (const { radius, corners } of from.shapes) {
      let shape;
      if (corners.length > 0) {
        shape = keep(new b2PolygonShape());
        const [points, free] = box2d.tuplesToVec2Array(
          corners.map(([x, y]) => [x / parameters.pxPerMetre, y / parameters.pxPerMetre]),
        );
        shape.Set(points, corners.length);
        free();
      } else {
        shape = keep(new b2CircleShape());
        shape.set_m_radius(radius / parameters.pxPerMetre);
      }
      const fixture = keep(new b2FixtureDef());
      fixture.set_shape(shape);
      fixture.set_density(parameters.density);
      fixture.set_friction(parameters.friction);
      fixture.set_restitution(parameters.restitution);
      body.CreateFixture(fixture);
    }
    return body;
  });
  temporary.forEach((object) => box2d.destroy(object));
  return { world, bodies, free: () => box2d.destroy(world) };
}

/** Steps until the task is solved or the steps are over; skips the steps in which all bodies sleep, as ours does. */
function run(box2d, parameters, rollout, world, bodies) {
  const { maxSteps, goalSteps, timeStep, velocityIterations, positionIterations, pxPerMetre } = parameters;
  const dynamic = bodies.filter((_, index) => rollout.bodies[index].dynamic);
  const [object, goal] = [bodies[rollout.object], bodies[rollout.goal]];
  const goalPointer = box2d.getPointer(goal);
  const nothing = box2d.getPointer(box2d.NULL);
  const touches = () => {
    if (rollout.touchDistance > 0) {
      const [one, other] = [object.GetPosition(), goal.GetPosition()];
      return Math.hypot(one.x - other.x, one.y - other.y) * pxPerMetre < rollout.touchDistance;
    }
    for (let edge = object.GetContactList(); box2d.getPointer(edge) !== nothing; edge = edge.next) {
      if (box2d.getPointer(edge.other) === goalPointer && edge.contact.IsTouching()) return true;
    }
    return false;
  };
  let touchSteps = 0;
  for (let step = 1; step <= maxSteps; step += 1) {
    if (dynamic.some((body) => body.IsAwake())) world.Step(timeStep, velocityIterations, positionIterations);
    touchSteps = touches() ? touchSteps + 1 : 0;
    if (touchSteps === goalSteps) return { solved: true, steps: step };
  }
  return { solved: false, steps: maxSteps };
}
