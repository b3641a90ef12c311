"""Measures the model on the test tasks of a fold in Box2D itself, with PHYRE's parameters.

Needs `pathlight` on the PATH, Pathlight's folder, and pybox2d: pip install box2d
"""

import argparse, json, math, subprocess, sys
from itertools import groupby

from Box2D import b2CircleShape, b2FixtureDef, b2PolygonShape, b2World

PX_PER_METRE = 6
# Centre, width and height of the four walls, px.
WALLS = [(128, -2.5, 256, 5), (-2.5, 128, 5, 256), (128, 258.5, 256, 5), (258.5, 128, 5, 256)]

def add(world, x, y, angle, dynamic, shapes):
    body = (world.CreateDynamicBody if dynamic else world.CreateStaticBody)(
        position=(x / PX_PER_METRE, y / PX_PER_METRE), angle=angle, angularDamping=0.01
    )
    for shape in shapes:
        body.CreateFixture(b2FixtureDef(shape=shape, density=0.25, friction=0.5, restitution=0.2))
    return body

def circle(radius):
    return b2CircleShape(radius=radius / PX_PER_METRE)

def polygon(corners):
    return b2PolygonShape(vertices=[(x / PX_PER_METRE, y / PX_PER_METRE) for x, y in corners])

def simulate(scene, ball):
    """The outcome of a ball, as `pathlight agent` reads it."""
    world = b2World(gravity=(0, -9.8))
    for x, y, width, height in WALLS:
        w, h = width / 2, height / 2
        add(world, x, y, 0, False, [polygon([(w, h), (-w, h), (-w, -h), (w, -h)])])
    bodies, radii = [], []
    for body in scene["bodies"]:
        parts = [circle(part["circle"]) if "circle" in part else polygon(part["polygon"]) for part in body["parts"]]
        bodies.append(add(world, body["x"], body["y"], body["angle"], body["dynamic"], parts))
        radii.append(body["parts"][0].get("circle") if len(parts) == 1 else None)
    x, y, radius = ball
    added = add(world, x, y, 0, True, [circle(radius)])
    green, goal = bodies[scene["body1"]], bodies[scene["body2"]]
    both_radii = [radii[scene["body1"]], radii[scene["body2"]]]

    def touches():
        if None not in both_radii:
            return math.dist(green.position, goal.position) * PX_PER_METRE < sum(both_radii) + 0.1
        return any(edge.other == goal and edge.contact.touching for edge in green.contacts)

    def pose(body):
        return [body.position.x * PX_PER_METRE, body.position.y * PX_PER_METRE, body.angle]

    paths, touched = {"object": [pose(green)], "ball": [pose(added)]}, 0
    for step in range(1, 1001):
        world.Step(1 / 60, 15, 20)
        if step % 10 == 0:
            paths["object"].append(pose(green))
            paths["ball"].append(pose(added))
        touched = touched + 1 if touches() else 0
        if touched == 180:
            return {"status": "solved", "paths": paths}
    return {"status": "not_solved", "paths": paths}

def first_solved(agent, scene):
    """The attempt that solves a task, or None."""
    def ask(line):
        print(json.dumps(line), file=agent.stdin, flush=True)
        return json.loads(agent.stdout.readline())["ball"]

    ball, attempt = ask({"task": scene["id"]}), 0
    while ball:
        outcome, attempt = simulate(scene, ball), attempt + 1
        if outcome["status"] == "solved":
            return attempt
        ball = ask(outcome)

def whole_number(text):
    count = int(text)
    if count < 1:
        raise argparse.ArgumentTypeError("it has to be at least 1")
    return count

def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--setup", choices=["within", "cross"], default="within")
    parser.add_argument("--fold", type=int, choices=range(10), default=0)
    of_each = "use at most the first N tasks of each template"
    parser.add_argument("--limit", type=whole_number, metavar="N", help=of_each)
    options = parser.parse_args()
    of_fold = ["--setup", options.setup, "--fold", str(options.fold)]
    lines = subprocess.check_output(["pathlight", "tasks", *of_fold, "--json"], text=True).splitlines()
    templates = groupby(map(json.loads, lines), lambda scene: scene["id"][:5])
    scenes = [scene for _, scenes in templates for scene in list(scenes)[:options.limit]]
    agent = subprocess.Popen(["pathlight", "agent", *of_fold], stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True)
    firsts = []
    for scene in scenes:
        firsts.append(first_solved(agent, scene))
        print(scene["id"], "solved by attempt" if firsts[-1] else "not solved", firsts[-1] or "", file=sys.stderr)
    # PHYRE's auccess: attempt k counts with ln(k + 1) - ln(k).
    score = sum(1 - math.log(first) / math.log(101) for first in firsts if first) / len(firsts)
    print(f"{options.setup} {options.fold}: auccess {100 * score:.1f} on {len(scenes)} tasks in Box2D")

if __name__ == "__main__":
    main()
