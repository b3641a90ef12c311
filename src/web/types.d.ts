/** The red ball, px: its centre, counted from the lower left corner of the scene, and its radius. */
export type Ball = [x: number, y: number, r: number];

/** PHYRE's colour for a body: the green object, its blue (dynamic) or purple (static) goal, other dynamic (gray) and
 * static (black) bodies. */
export type Role = "green" | "blue" | "purple" | "gray" | "black";

/** One convex shape in the coordinates of its body, px: a circle of this radius around the origin, or a polygon with
 * its corners counter-clockwise. */
export type Shape = { circle: number } | { polygon: [x: number, y: number][] };

/** A rigid body. Its origin is at x, y (px); the angle is in radians, counter-clockwise. */
export interface Body {
    x: number;
    y: number;
    angle: number;
    dynamic: boolean;
    shape: "ball" | "bar" | "jar" | "standing_sticks";
    role: Role;
    parts: Shape[];
}

/** A scene of 256 x 256 px, y up, without the walls around it. The goal: `body1` touches `body2` for three seconds;
 * both are indices into `bodies`. */
export type Scene = { body1: number; body2: number; bodies: Body[] };

/** A scene that somebody has made, as it is edited, shared and stored; `scene.schema.json` is its schema. Colours
 * follow from the goal: the body `body1`, which is dynamic, touches `body2` for three seconds. */
export interface CustomScene {
    version: 1;
    /** What its maker calls it, at most 60 characters. */
    name?: string;
    body1: number;
    body2: number;
    bodies: CustomBody[];
}

/** A body of a custom scene; lengths in px, the angle in radians, counter-clockwise. The origin at x, y is the centre
 * of a ball or of a bar, the middle of a jar's base, or where sticks cross. */
export type CustomBody = { x: number; y: number; angle: number; dynamic: boolean } & (
    | { shape: "ball"; radius: number }
    | { shape: "bar"; length: number; thickness: number }
    | { shape: "jar"; height: number }
    | { shape: "standing_sticks"; length: number }
);

/** A puzzle: the id of a task ("00007:008"), or a custom scene. */
export type Puzzle = string | CustomScene;

/** Why a custom scene cannot be played: the body with the problem, as an index into `bodies`, and the second if it is
 * between two. The sentence names the remedy. */
export type SceneProblem = { body: number | null; other: number | null; fault: SceneFault; sentence: string };

/** What is wrong with a custom scene; lengths in px. */
export type SceneFault =
    | { kind: "unreadable" | "own_goal" | "static_object" | "place" }
    | { kind: "bodies"; count: number; least: number; most: number }
    | { kind: "name"; most: number }
    | { kind: "length"; key: "radius" | "length" | "thickness" | "height"; length: number; least: number; most: number }
    | { kind: "sticks_out" | "sticks_out_of_corner" | "outside"; by: number }
    | { kind: "overlap"; by: number; most: number };

/** The limits of custom scenes: least and most, lengths in px; `max_overlap`: how deep two bodies may overlap at the
 * start if one is dynamic; `name_length`: most characters of a name. */
export type SceneLimits = { max_overlap: number; name_length: number } & Record<
    "bodies" | "ball_radius" | "bar_length" | "bar_thickness" | "jar_height" | "stick_length",
    [least: number, most: number]
>;

/** PHYRE's status of an attempt. */
export type Status = "solved" | "not_solved" | "invalid";

/** What a search for solutions has found so far. */
export interface FoundSolutions {
    /** The fraction of the balls that has been examined, 0..1. */
    progress: number;
    /** The valid balls so far, and those of them that solve. */
    valid: number;
    solved: number;
    /** The share of the benchmark's tasks that are harder, 0..1, by the share of valid balls that solve; those that are
     * as hard count half. Null without a valid ball. */
    rank: number | null;
    /** The solving ball around which most balls solve too; null if none solves. */
    easiest: Ball | null;
    /** Whether the scene solves itself, without a ball. */
    solves_itself: boolean;
}

/** Of the 27 balls within a pixel of one in x, y and radius: those that are valid, and those of them that solve. */
export type Luck = { valid: number; solved: number };

/** An attempt that anyone can simulate again. Either `task` or `scene` is there. */
export interface AttemptLine {
    task?: string;
    scene?: CustomScene;
    /** Null without a ball, or, with the status `invalid`, if an action placed none. */
    ball: Ball | null;
    /** The engine, if not `box2d`: the native program alone has another. */
    engine?: "rapier";
    /** The version of the engine. */
    simulator: number;
    status: Status;
    steps: number;
    /** A hash of all poses, 16 hexadecimal digits: equal digests are equal rollouts, to the bit. */
    digest: string;
}

/** What became of an attempt that was simulated again: status and steps as they are now; the reason is a sentence. */
export type Verification =
    | { verdict: "same" }
    | { verdict: "other_outcome"; status: Status; steps: number; reason: string }
    | { verdict: "not_valid"; fault: "form" | "puzzle" | "ball"; reason: string };

/** What an agent must generalise to: new tasks of the templates that it was trained on, or new templates. */
export type Setup = "within" | "cross";

/** The ids of a fold's tasks. PHYRE's training tasks are `train` and `dev`, on which settings are chosen. */
export type Fold = Record<"train" | "dev" | "test", string[]>;

/** A map or a mask: 64 x 64 values in 0..1, row by row, row 0 at the bottom. */
export type GridMap = Float32Array;

/** The maps of a task; weights with neither a success net nor a dynamics net have no `success`. */
export type Maps = Record<Exclude<MapName, "success">, GridMap> & { success?: GridMap };

/** A puzzle template and the ids of its tasks ("00007:000"). */
export type Template = { id: string; name: string; story: string; tasks: string[] };

/** A task has an id; a custom scene has a digest, the SHA-256 of it without its name, and perhaps a name. */
export type About = { id: string | null; digest: string | null; name: string | null; scene: Scene };

/** Why a ball on the page is invalid; `body` is an index into the scene's bodies. */
export type InvalidBall = { kind: "radius" | "outside" } | { kind: "overlaps"; body: number };

/** One of the rollouts of a frame: the ball, null if the scene runs alone, and whose it is. */
export type ShownRollout = { ball: Ball | null; of_model: boolean };

/** What a ball of an open puzzle leads to. */
export interface RolloutFacts {
    line: AttemptLine;
    ending: Ending;
    /** The last step at which anything can be seen to happen. */
    last: number;
    nearest: ClosestApproach;
    /** When and where the ball first touches the green object. */
    contact: Contact | null;
    /** Where object and ball really were after the steps of an `ImaginedBall`; null without a ball. */
    paths: Pick<ImaginedBall, "object" | "ball"> | null;
}

/** How a rollout ended, the longest touch of object and goal, and the touch that it ended with; in steps. */
export type Ending = { solved: boolean } & Record<"steps" | "longest_touch" | "final_touch", number>;

/** A complete simulation, of at most 1,000 steps of 1/60 s; it ends as soon as the task is solved. */
export interface Rollout extends Ending {
    status: Status;
    /** Why the ball is invalid, as a phrase; null if it is valid. */
    reason: string | null;
    /** The dynamic bodies as indices into the scene's bodies; the ball comes last, with the next free index. */
    bodies: Uint32Array;
    /** `[steps + 1, bodies, 3]`: x, y (px) and angle (radians) of each dynamic body; the first row is the start. */
    poses: Float32Array;
    /** For the start and each step: 1 if the green object touches its goal, else 0. */
    touching: Uint8Array;
}

/** The real paths of a rollout as masks; no `ball` if the scene ran alone. */
export type PathMasks = { object: GridMap; ball?: GridMap };

/** Where a proposed ball comes from: what the dynamics net imagines (the probability before any attempt and now, and
 * the attempt, from 1, that lowered it most), the success net, a cell of the placement map (px), an earlier proposal
 * with noise, or the whole action space. */
export type Origin =
    | { kind: "imagined"; prior: number; probability: number; lowered_by: number | null }
    | { kind: "success"; probability: number }
    | { kind: "map"; x: number; y: number }
    | { kind: "perturbed"; number: number }
    | { kind: "uniform" };

/** A ball that the model would try. */
export type Proposal = { ball: Ball; origin: Origin };

/** What the dynamics net imagines for a ball. */
export interface ImaginedBall {
    /** The 16 steps after which positions are imagined. */
    steps: Uint32Array;
    /** The positions of the green object and of the ball after each of these steps: x, y, x, y, … in px. */
    object: Float32Array;
    ball: Float32Array;
    /** How far each position is expected to be off, px: first those of the object, then those of the ball. */
    errors: Float32Array;
    /** The probability that the ball solves the task, 0..1. */
    probability: number;
}

/** A ball of the model's turn: proposed, then simulated. */
export interface TriedProposal extends Proposal {
    ending: Ending;
    /** In a turn with a memory: the earlier puzzle that changed the chance of this ball most, if one did noticeably. */
    reminder?: Reminder;
}

/** The remembered puzzle that changed the chance of a ball most. */
export interface Reminder {
    /** Its number in the memory, from 1, and its id, unless it is a custom scene. */
    puzzle: number;
    task?: string;
    /** The change of the ball's logit, the attempt that changed it most, and whether its scene is mirrored. */
    change: number;
    ball: Ball;
    solved: boolean;
    mirrored: boolean;
}

/** A remembered puzzle: a task or a custom scene, numbered from 1 (forgotten puzzles keep their numbers), and its
 * attempts, each with the chance, 0..1, that the ball was given before. */
export interface RememberedPuzzle {
    number: number;
    task?: string;
    scene?: Scene;
    attempts: { ball: Ball; chance: number; solved: boolean }[];
}

/** A ball that the model considers before it chooses one; probability and path as in `ImaginedBall`. */
export type Candidate = { ball: Ball } & Pick<ImaginedBall, "probability" | "object">;

/** How weights were trained. */
export interface ModelCard extends Training, Record<"fold" | "decay_epochs" | "samples" | "tasks" | "simulator", number> {
    setup: Setup;
    mirror: boolean;
    without_dev: boolean;
    success?: SuccessCard;
    dynamics?: DynamicsCard;
}

/** The settings that the training of all nets has. */
export type Training = Record<"seed" | "epochs" | "batch" | "learning_rate", number>;

/** How the success net of weights was trained. */
export interface SuccessCard extends Training {
    balls_per_scene: number;
    /** The optimiser, if not Adam. */
    optimiser?: "muon";
    balls: number;
}

/** How the dynamics net of weights was trained. */
export interface DynamicsCard extends SuccessCard, Partial<Record<"unlisted" | "random_scenes", number>> {
    imagined_per_scene: number;
    /** How much paths count in the loss, if not as by default; `solving`: those of balls that solve, to others. */
    path_weights?: { all: number; solving: number };
    /** The scenes that it has seen, if no tasks of PHYRE: random ones alone, or unlisted tasks too. */
    learned_from?: "random_scenes" | "unlisted_tasks";
    without_dev: boolean;
    /** SHA-256 of the weights that it started from. */
    from?: string;
}

/** What a frame shows; lengths in px, opacities 0..1. */
export interface View {
    /** Steps since the start; a fraction lies between two steps. */
    step: number;
    /** The ball that is being placed, and whether it may be; `paintEditedScene` finds that out itself. */
    ball: Ball | null;
    valid: boolean;
    /** The radius of the knob on that ball; 0 draws none. */
    knob: number;
    /** Draws whole paths and not only up to the step. */
    whole: boolean;
    /** Opacity of the maps. */
    opacity: number;
    dark: boolean;
    /** Balls that are only marked. */
    marks?: Ball[];
    /** What a person has drawn as the path of the green object. */
    sketch?: [x: number, y: number][];
    /** What the model imagines for the ball `of`. */
    imagined?: ({ of: Ball } & Pick<ImaginedBall, "object" | "ball" | "errors">) | null;
    /** Imagined paths of the green object that are only hinted at. */
    hints?: { object: Float32Array; opacity: number }[];
    /** Where the first rollout came nearest to the goal. */
    approach?: ClosestApproach | null;
    /** A contact that sparks for a moment after its step. */
    spark?: Contact | null;
    /** Whose ball is whose, beside the balls of the rollouts in order. */
    names?: string[];
}

/** The moment at which the green object was nearest to its goal: the gap between them, px (0 if they overlap), and its
 * two ends. */
export type ClosestApproach = {
    step: number;
    gap: number;
    points: [object: [x: number, y: number], goal: [x: number, y: number]];
};

/** A contact of the ball with the green object: when, and where, px. */
export type Contact = { step: number; point: [x: number, y: number] };

/** How hard a task is: how many uniform valid balls were tried on it, and the share of them that solved it, 0..1. */
export type Difficulty = { balls: number; solve_rate: number };

/** Why an export throws: no such task; a custom scene that cannot be played; no such map, or one of another size;
 * weights of other nets; a memory that is damaged or of other weights; an invalid ball; a value of the wrong form; a
 * bug in the Rust code, after which the wasm instance must not be used again. */
export type ErrorCode =
    "bad_task" | "bad_scene" | "bad_map" | "bad_weights" | "bad_memory" | "invalid_ball" | "bad_data" | "panic";

/** What the exports throw. */
export type CodedError = Error & { code: ErrorCode };
