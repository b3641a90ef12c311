//! The constants of PHYRE and Box2D, each with its unit, its source and its effect.
//!
//! "PHYRE" is its v0.2.2 simulator, "Box2D" the engine that it runs on, erincatto/box2d at commit 33af62e3
//! (b2Settings.h unless another file is named). The constants are facts of those engines; none is tuned to outcomes.

use crate::puzzle::rollout::STEPS_PER_SECOND;
use crate::puzzle::scene_form::MAX_CORNERS;

/// Duration of a step, s (PHYRE).
pub const TIME_STEP: f32 = 1.0 / STEPS_PER_SECOND as f32;
/// Acceleration by gravity, m/s^2 (PHYRE).
pub const GRAVITY: f32 = -9.8;
/// Density of dynamic bodies, kg/m^2 (PHYRE). Only ratios of masses matter, so it has no effect as long as all bodies
/// share it.
pub const DENSITY: f32 = 0.25;
/// Friction coefficient of any two bodies (PHYRE: 0.5 each; Box2D takes the geometric mean). Higher: more rolling, less
/// sliding.
pub const FRICTION: f32 = 0.5;
/// Restitution of any two bodies (PHYRE: 0.2 each; Box2D takes the larger). Higher: bodies bounce further.
pub const RESTITUTION: f32 = 0.2;
/// Contacts with a slower approach are inelastic, m/s (b2_velocityThreshold). Lower: bodies take longer to come to
/// rest.
pub const RESTITUTION_THRESHOLD: f32 = 1.0;
/// Angular damping, 1/s (PHYRE; linear damping is 0). Higher: balls roll less far.
pub const ANGULAR_DAMPING: f32 = 0.01;

/// Iterations of the velocity solver in each step (PHYRE). Fewer: stacks and jars become soft.
pub const VELOCITY_ITERATIONS: usize = 15;
/// Maximum number of iterations of the position solver in each step (PHYRE). Fewer: overlaps last longer.
pub const POSITION_ITERATIONS: usize = 20;

/// Largest impulse that the next step starts from, kg m/s: far above any momentum in a scene. Box2D has no such limit,
/// so the impulses on a body that is wedged between static ones grow from step to step until they overflow.
pub const MAX_WARM_STARTING_IMPULSE: f32 = 1e7;

/// Radius of the skin around polygons, m (b2_polygonRadius). Bodies rest at this distance from a polygon; circles have
/// none.
pub const POLYGON_RADIUS: f32 = 2.0 * LINEAR_SLOP;
/// Allowed overlap of the skins, m (b2_linearSlop). It keeps resting contacts from flickering.
pub const LINEAR_SLOP: f32 = 0.005;
/// Fraction of the overlap that one position iteration resolves (b2_baumgarte).
pub const BAUMGARTE: f32 = 0.2;
/// The same fraction in the sub-step after a time of impact (b2_toiBaugarte).
pub const TOI_BAUMGARTE: f32 = 0.75;
/// Maximum overlap that one position iteration resolves, m (b2_maxLinearCorrection). It prevents overshoot.
pub const MAX_LINEAR_CORRECTION: f32 = 0.2;
/// Longest displacement in one step, m (b2_maxTranslation): no body is faster than 120 m/s.
pub const MAX_TRANSLATION: f32 = 2.0;
/// Largest rotation in one step, radians (b2_maxRotation).
pub const MAX_ROTATION: f32 = 0.5 * std::f32::consts::PI;

/// Highest speed of a body that may fall asleep, m/s (b2_linearSleepTolerance).
pub const LINEAR_SLEEP_TOLERANCE: f32 = 0.01;
/// Highest angular speed of a body that may fall asleep, radians/s (b2_angularSleepTolerance).
pub const ANGULAR_SLEEP_TOLERANCE: f32 = 2.0 / 180.0 * std::f32::consts::PI;
/// Time at such speeds after which an island sleeps, s (b2_timeToSleep). It ends slow creep, so it affects outcomes.
pub const TIME_TO_SLEEP: f32 = 0.5;

/// Largest number of corners of a polygon (b2_maxPolygonVertices). It also bounds the points that the search for a time
/// of impact resolves along one axis.
pub const MAX_POLYGON_VERTICES: usize = MAX_CORNERS;
/// Accuracy of the separation at a time of impact, m (b2TimeOfImpact.cpp).
pub const TOI_TOLERANCE: f32 = 0.25 * LINEAR_SLOP;
/// Maximum number of separating axes in the search for a time of impact (b2TimeOfImpact.cpp). Fewer: fast bodies may
/// tunnel.
pub const MAX_TOI_ITERATIONS: usize = 20;
/// Maximum number of steps to find the root along one axis (b2TimeOfImpact.cpp).
pub const MAX_TOI_ROOT_ITERATIONS: usize = 50;
/// Maximum number of contacts solved at a time of impact (b2_maxTOIContacts).
pub const MAX_TOI_CONTACTS: usize = 32;
/// Maximum number of times of impact of a contact within one step (b2_maxSubSteps).
pub const MAX_TOI_SUBSTEPS: u32 = 8;
/// Contacts whose block matrix has a higher condition number are solved with one point (k_maxConditionNumber in
/// b2ContactSolver.cpp).
pub const MAX_CONDITION_NUMBER: f32 = 1000.0;
/// Margin of the fat AABBs of the broad phase, m (b2_aabbExtension). It only affects the order of contacts.
pub const AABB_EXTENSION: f32 = 0.1;
/// Factor of a step's displacement by which fat AABBs are extended in advance (b2_aabbMultiplier).
pub const AABB_MULTIPLIER: f32 = 2.0;

/// Two balls touch when the distance of their surfaces is below this, px (PHYRE). Other bodies touch when the engine
/// has a touching contact.
pub const BALL_TOUCH_DISTANCE: f64 = 0.1;
