//! How deep bodies overlap before the first step, measured by the contacts that the first step would have. Used to
//! check scenes that people make.

use super::box2d::World;
use super::simulation::EngineWorld;
use super::units::PX_PER_METRE;
use crate::puzzle::scene::Scene;

/// Two bodies of a scene that overlap at the start.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Overlap {
    /// Their indices in the scene, ascending.
    pub bodies: [usize; 2],
    /// The penetration depth of their shapes, px: the distance by which one would have to move.
    pub depth: f64,
}

/// Returns the pairs of bodies that overlap at the start, at least one of them dynamic.
pub fn overlaps(scene: &Scene) -> Vec<Overlap> {
    let mut world = World::default();
    for body in &scene.bodies {
        world.add(body);
    }
    let mut overlaps: Vec<Overlap> = Vec::new();
    for (bodies, depth) in world.depths() {
        let depth = f64::from(depth * PX_PER_METRE);
        match overlaps.iter_mut().find(|overlap| overlap.bodies == bodies) {
            _ if depth <= 0.0 => {}
            Some(overlap) => overlap.depth = overlap.depth.max(depth),
            None => overlaps.push(Overlap { bodies, depth }),
        }
    }
    overlaps
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::puzzle::custom_scene::{CustomBody, CustomScene};
    use crate::puzzle::dimensions::Dimensions;

    /// A scene of two bodies, the first of which is dynamic, side by side: the origins are `apart` px from each other.
    fn side_by_side(shapes: [Dimensions; 2], apart: f64, second_moves: bool) -> Scene {
        let body = |dimensions, x, dynamic| CustomBody { dimensions, x, y: 100.0, angle: 0.0, dynamic };
        let bodies = vec![body(shapes[0], 100.0, true), body(shapes[1], 100.0 + apart, second_moves)];
        CustomScene { version: 1, name: None, body1: 0, body2: 1, bodies }.to_scene()
    }

    #[test]
    fn the_depth_is_by_how_much_shapes_overlap() {
        let (ball, bar) = (Dimensions::Ball { radius: 10.0 }, Dimensions::Bar { length: 20.0, thickness: 20.0 });
        for shapes in [[ball, ball], [ball, bar], [bar, ball], [bar, bar]] {
            for second_moves in [false, true] {
                assert_eq!(overlaps(&side_by_side(shapes, 20.1, second_moves)), [], "{shapes:?}");
                let overlaps = overlaps(&side_by_side(shapes, 17.0, second_moves));
                let [Overlap { bodies: [0, 1], depth }] = overlaps[..] else { panic!("{shapes:?}: {overlaps:?}") };
                assert!((depth - 3.0).abs() < 1e-3, "{shapes:?}: {depth}");
            }
        }
    }

    #[test]
    fn static_bodies_may_overlap() {
        let bar = Dimensions::Bar { length: 20.0, thickness: 20.0 };
        let mut scene = side_by_side([bar, bar], 5.0, false);
        scene.bodies[0].dynamic = false;
        assert_eq!(overlaps(&scene), []);
    }
}
