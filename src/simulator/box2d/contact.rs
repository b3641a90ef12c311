//! A contact of two fixtures, which exists as long as their fat AABBs overlap: b2Contact.

use super::body::Body;
use super::fixture::Fixture;
use super::manifold::{Manifold, WorldManifold};

pub(super) struct Contact {
    /// The two fixtures. A polygon comes before a circle.
    pub(super) fixtures: [usize; 2],
    /// Their bodies.
    pub(super) bodies: [usize; 2],
    pub(super) manifold: Manifold,
    pub(super) touching: bool,
    /// False for the rest of a step if the two do not touch at their time of impact.
    pub(super) enabled: bool,
    pub(super) in_island: bool,
    /// The time of impact as a fraction of the step, once known; 1 if there is none.
    pub(super) toi: Option<f32>,
    /// Number of times of impact handled in this step.
    pub(super) toi_count: u32,
}

impl Contact {
    pub(super) fn new([first, second]: [usize; 2], fixtures: &[Fixture]) -> Contact {
        let is_circle = |fixture: usize| fixtures[fixture].shape.is_circle();
        let ordered = if is_circle(first) && !is_circle(second) { [second, first] } else { [first, second] };
        Contact {
            fixtures: ordered,
            bodies: ordered.map(|fixture| fixtures[fixture].body),
            manifold: Manifold::EMPTY,
            touching: false,
            enabled: true,
            in_island: false,
            toi: None,
            toi_count: 0,
        }
    }

    /// Returns the other body of the contact.
    pub(super) fn other(&self, body: usize) -> usize {
        let [a, b] = self.bodies;
        if a == body { b } else { a }
    }

    /// Computes the manifold for the current positions of the bodies, keeping the impulses of existing points, and
    /// wakes the bodies if they begin or cease to touch (Update).
    pub(super) fn update(&mut self, bodies: &mut [Body], fixtures: &[Fixture]) {
        self.enabled = true;
        let [shape_a, shape_b] = self.fixtures.map(|fixture| &fixtures[fixture].shape);
        let [transform_a, transform_b] = self.bodies.map(|body| &bodies[body].transform);
        let mut manifold = Manifold::new(shape_a, transform_a, shape_b, transform_b);
        for point in manifold.points_mut() {
            if let Some(old) = self.manifold.points().iter().find(|old| old.id == point.id) {
                point.impulse = old.impulse;
            }
        }
        self.manifold = manifold;
        let touching = !manifold.is_empty();
        if touching != self.touching {
            self.touching = touching;
            self.bodies.iter().for_each(|&body| bodies[body].wake());
        }
    }

    /// Returns the depth by which the shapes overlap, without the skins of polygons, m; 0 if they do not.
    pub(super) fn depth(&self, bodies: &[Body], fixtures: &[Fixture]) -> f32 {
        let shapes = self.fixtures.map(|fixture| &fixtures[fixture].shape);
        let transforms = self.bodies.map(|body| &bodies[body].transform);
        let radii = shapes.map(|shape| if shape.is_circle() { shape.radius } else { 0.0 });
        let separations = WorldManifold::new(&self.manifold, transforms, radii).separations;
        separations[..self.manifold.points().len()].iter().fold(0.0, |depth, separation| depth.max(-separation))
    }
}
