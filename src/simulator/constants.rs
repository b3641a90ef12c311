//! Every constant of the simulator, with its unit, its source, and what it changes.
//!
//! "PHYRE" is its v0.2.2 simulator, "Box2D" the 2.3 that it runs on. They are measured or published facts of
//! those engines; nothing here is tuned to outcomes.

/// px per metre (PHYRE). Scenes are in px; everything in this folder is in metres.
pub const SCALE: f64 = 6.0;
/// Length of a step, s (PHYRE).
pub const STEP: f32 = 1.0 / 60.0;
/// m/s^2 (PHYRE).
pub const GRAVITY: f32 = -9.8;
/// kg/m^2 of dynamic bodies (PHYRE). Only ratios of masses matter, so it changes nothing as long as all share it.
pub const DENSITY: f32 = 0.25;
/// Friction of any two bodies (PHYRE: 0.5 each; Box2D takes the geometric mean). Higher: rolls instead of slides.
pub const FRICTION: f32 = 0.5;
/// Restitution of any two bodies (PHYRE: 0.2 each; Box2D takes the larger). Higher: bounces further.
pub const RESTITUTION: f32 = 0.2;
/// Slower approaches do not bounce, m/s (Box2D). Lower: bodies settle later.
pub const BOUNCE_SPEED: f32 = 1.0;
/// 1/s (PHYRE; linear damping is 0). Higher: balls roll less far.
pub const ANGULAR_DAMPING: f32 = 0.01;

/// Sweeps over the contacts for their velocities, in each step (PHYRE). Fewer: stacks and jars give way.
pub const VELOCITY_SWEEPS: usize = 15;
/// Most sweeps for their positions (PHYRE). Fewer: bodies stay pressed into each other longer.
pub const POSITION_SWEEPS: usize = 20;

/// Skin around every polygon, m (Box2D: twice the slop). Bodies keep this distance from a polygon; balls have none.
pub const SKIN: f32 = 0.01;
/// Depth to which skins may overlap at rest, m (Box2D).
pub const SLOP: f32 = 0.005;
/// Share of the remaining overlap that one sweep removes (Box2D).
pub const PUSH: f32 = 0.2;
/// The same just after a moment of impact (Box2D).
pub const IMPACT_PUSH: f32 = 0.75;
/// Most overlap that one sweep removes, m (Box2D).
pub const MAX_PUSH: f32 = 0.2;
/// Longest way in one step, m (Box2D): no body is faster than 120 m/s.
pub const MAX_TRANSLATION: f32 = 2.0;
/// Largest turn in one step, radians (Box2D).
pub const MAX_ROTATION: f32 = 0.5 * std::f32::consts::PI;

/// Bodies slower than this, m/s, ... (Box2D)
pub const STILL_SPEED: f32 = 0.01;
/// ... that also turn slower than this, radians/s, ... (Box2D)
pub const STILL_SPIN: f32 = 2.0 / 180.0 * std::f32::consts::PI;
/// ... for this long, s, fall asleep until they are touched (Box2D). It stops slow creep, so it shows in outcomes.
pub const STILL_TIME: f32 = 0.5;

/// Moments of impact handled for a pair within one step (Box2D).
pub const MAX_IMPACTS: u32 = 8;
/// Contacts with a greater ratio of stiffnesses are solved one point at a time (Box2D).
pub const MAX_CONDITION: f32 = 1000.0;
/// Margin of the boxes that decide which pairs are looked at, m (Box2D). It only orders the contacts.
pub const BOX_MARGIN: f32 = 0.1;
/// How far ahead these boxes reach, in displacements of a step (Box2D).
pub const BOX_AHEAD: f32 = 2.0;

/// Two balls touch when their gap is below this, px (PHYRE). Others touch when the engine has a contact.
pub const TOUCHING_BALLS: f64 = 0.1;
