//! The contact solver: b2ContactSolver, with b2ContactVelocityConstraint, b2ContactPositionConstraint and
//! b2PositionSolverManifold.
//!
//! Solves velocities by sequential impulses, friction first, with the two normal impulses of a contact as a block. Then
//! solves positions by nonlinear Gauss-Seidel, which resolves overlap without adding velocity. Three shortcuts change
//! no bit of the result: a constraint is skipped if its two velocities are those for which it last changed nothing,
//! iterations end when none changes anything, and nothing is computed for a static body, whose changes would be zero.

use rapier2d::math::Vector;

use super::body::Body;
use super::fixture::Fixture;
use super::manifold::{Impulse, Kind, Manifold, WorldManifold};
use super::math::{Rotation, Transform, clamp, clockwise, max, min, normalized};
use crate::simulator::constants::{
    FRICTION, LINEAR_SLOP, MAX_CONDITION_NUMBER, MAX_LINEAR_CORRECTION, MAX_WARM_STARTING_IMPULSE, RESTITUTION,
    RESTITUTION_THRESHOLD, VELOCITY_ITERATIONS,
};

/// The position of a body of an island during solving (b2Position).
#[derive(Clone, Copy)]
pub(super) struct Position {
    /// The centre of mass, m.
    pub(super) centre: Vector,
    /// The angle, radians, not wrapped.
    pub(super) angle: f32,
    /// The rotation of the angle.
    rotation: Rotation,
    local_centre: Vector,
    is_round: bool,
}

impl Position {
    /// Returns the end of a body's sweep.
    pub(super) fn new(body: &Body) -> Position {
        let sweep = &body.sweep;
        Position {
            centre: sweep.centre,
            angle: sweep.angle,
            rotation: body.transform.rotation,
            local_centre: sweep.local_centre,
            is_round: sweep.is_round,
        }
    }

    pub(super) fn rotation(&self) -> Rotation {
        self.rotation
    }

    #[inline(always)]
    fn transform(&self) -> Transform {
        Transform::about(self.centre, self.local_centre, self.rotation)
    }

    #[inline(always)]
    pub(super) fn turn_to(&mut self, angle: f32) {
        if angle != self.angle {
            self.angle = angle;
            if !self.is_round {
                self.rotation = Rotation::new(angle);
            }
        }
    }
}

/// The velocity of a body of an island (b2Velocity).
#[derive(Clone, Copy)]
pub(super) struct Velocity {
    /// Velocity of the centre of mass, m/s.
    pub(super) linear: Vector,
    /// radians/s
    pub(super) angular: f32,
    /// How often a constraint has changed it.
    changes: u32,
}

impl Velocity {
    pub(super) fn new(linear: Vector, angular: f32) -> Velocity {
        Velocity { linear, angular, changes: 0 }
    }

    /// Returns the velocity of the point `arm` away from the centre of mass, m/s.
    #[inline(always)]
    fn at(&self, arm: Vector) -> Vector {
        self.linear + self.angular_at(arm)
    }

    /// Returns the part of `at` that comes from the rotation.
    #[inline(always)]
    fn angular_at(&self, arm: Vector) -> Vector {
        self.angular * arm.perp()
    }
}

/// The inverse mass, 1/kg, and inertia, 1/(kg m^2), of a body: zero for static ones.
#[derive(Clone, Copy)]
struct InverseMass {
    linear: f32,
    angular: f32,
}

impl InverseMass {
    fn of(body: &Body) -> InverseMass {
        InverseMass { linear: body.inv_mass, angular: body.inv_inertia }
    }
}

/// Returns the change of the relative velocity of two bodies along a direction per unit of impulse along it, 1/kg, for
/// a point at these levers: an entry of K in Box2D. `other_levers` belong to the point where the impulse acts.
#[inline(always)]
fn inverse_effective_mass(masses: &[InverseMass; 2], levers: [f32; 2], other_levers: [f32; 2]) -> f32 {
    let [a, b] = masses;
    a.linear + b.linear + a.angular * levers[0] * other_levers[0] + b.angular * levers[1] * other_levers[1]
}

/// A contact in the velocity solver (b2ContactVelocityConstraint).
pub(super) struct VelocityConstraint {
    /// From A to B, a unit vector.
    normal: Vector,
    points: [VelocityConstraintPoint; 2],
    /// The two points together. If absent, only the first is solved.
    block: Option<Block>,
    point_count: usize,
    /// Indices in the island.
    bodies: [usize; 2],
    masses: [InverseMass; 2],
    /// The `changes` of the velocities for which the last iteration changed nothing.
    settled: Option<[u32; 2]>,
}

/// A contact point in the velocity solver (b2VelocityConstraintPoint).
#[derive(Clone, Copy, Default)]
struct VelocityConstraintPoint {
    /// From the centres of mass of A and B to the point, m (rA and rB).
    arms: [Vector; 2],
    /// The accumulated impulse.
    impulse: Impulse,
    /// Effective masses, kg.
    normal_mass: f32,
    tangent_mass: f32,
    /// Normal velocity after the contact, by restitution, m/s.
    velocity_bias: f32,
}

/// The symmetric matrix K of the block solver, 1/kg, and its inverse, kg: the entries 11, 12 and 22.
#[derive(Clone, Copy)]
struct Block {
    k: [f32; 3],
    inverse: [f32; 3],
}

impl Block {
    /// `None` if the two points are so similar that one is enough.
    fn new([k11, k12, k22]: [f32; 3]) -> Option<Block> {
        let determinant = k11 * k22 - k12 * k12;
        (k11 * k11 < MAX_CONDITION_NUMBER * determinant).then(|| {
            let inv = 1.0 / determinant;
            Block { k: [k11, k12, k22], inverse: [inv * k22, -inv * k12, inv * k11] }
        })
    }
}

impl VelocityConstraint {
    /// Prepares a contact for the current positions and velocities of its island. With `warm_starting`, it starts from
    /// the impulses of the last step.
    pub(super) fn new(
        manifold: &Manifold,
        fixtures: [&Fixture; 2],
        bodies: [&Body; 2],
        positions: &[Position],
        velocities: &[Velocity],
        warm_starting: bool,
    ) -> VelocityConstraint {
        let indices = bodies.map(|body| body.island_index);
        let masses = bodies.map(InverseMass::of);
        let [position_a, position_b] = indices.map(|index| &positions[index]);
        let [velocity_a, velocity_b] = indices.map(|index| &velocities[index]);
        let radii = fixtures.map(|fixture| fixture.shape.radius);
        let transforms = [&position_a.transform(), &position_b.transform()];
        let WorldManifold { normal, points: world_points, .. } = WorldManifold::new(manifold, transforms, radii);
        let tangent = clockwise(normal);
        let mut points = [VelocityConstraintPoint::default(); 2];
        for ((point, old), world_point) in points.iter_mut().zip(manifold.points()).zip(world_points) {
            let arms = [world_point - position_a.centre, world_point - position_b.centre];
            let effective_mass = |direction: Vector| {
                let levers = arms.map(|arm| arm.perp_dot(direction));
                let k = inverse_effective_mass(&masses, levers, levers);
                if k > 0.0 { 1.0 / k } else { 0.0 }
            };
            let relative = velocity_b.at(arms[1]) - velocity_a.linear - velocity_a.angular_at(arms[0]);
            let approach = normal.dot(relative);
            *point = VelocityConstraintPoint {
                arms,
                impulse: if warm_starting { old.impulse } else { Impulse::default() },
                normal_mass: effective_mass(normal),
                tangent_mass: effective_mass(tangent),
                velocity_bias: if approach < -RESTITUTION_THRESHOLD { -RESTITUTION * approach } else { 0.0 },
            };
        }
        let block = (manifold.points().len() == 2).then(|| {
            let [first, second] = points.map(|point| point.arms.map(|arm| arm.perp_dot(normal)));
            let k = |levers, other_levers| inverse_effective_mass(&masses, levers, other_levers);
            Block::new([k(first, first), k(first, second), k(second, second)])
        });
        let block = block.flatten();
        let point_count = if block.is_some() { 2 } else { 1 };
        VelocityConstraint { normal, points, block, point_count, bodies: indices, masses, settled: None }
    }

    /// Applies the impulses from which the solver starts (WarmStart).
    pub(super) fn warm_start(&self, velocities: &mut [Velocity]) {
        let tangent = clockwise(self.normal);
        let [mut a, mut b] = self.bodies.map(|body| velocities[body]);
        for point in &self.points[..self.point_count] {
            let impulse = point.impulse.normal * self.normal + point.impulse.tangent * tangent;
            self.apply::<true, true>(&mut a, &mut b, impulse, point.arms.map(|arm| arm.perp_dot(impulse)));
        }
        let [index_a, index_b] = self.bodies;
        velocities[index_a] = a;
        velocities[index_b] = b;
    }

    /// Stores the impulses for the warm starting of the next step (StoreImpulses). Impulses above the limit are stored
    /// as zero.
    pub(super) fn store_impulses(&self, manifold: &mut Manifold) {
        for (to, from) in manifold.points_mut().iter_mut().zip(&self.points[..self.point_count]) {
            // The tangent impulse is at most the normal impulse times the friction coefficient.
            let is_limited = from.impulse.normal <= MAX_WARM_STARTING_IMPULSE;
            to.impulse = if is_limited { from.impulse } else { Impulse::default() };
        }
    }

    /// One iteration. Returns whether any impulse has changed.
    #[inline]
    fn solve(&mut self, velocities: &mut [Velocity]) -> bool {
        let changes = self.bodies.map(|body| velocities[body].changes);
        if self.settled == Some(changes) {
            return false;
        }
        let changed = self.iterate(velocities, 1);
        if changed {
            for (body, mass) in self.bodies.into_iter().zip(self.masses) {
                velocities[body].changes += u32::from(mass.linear > 0.0);
            }
        } else {
            self.settled = Some(changes);
        }
        changed
    }

    /// Iterates until nothing changes. Returns whether the last iteration changed any impulse.
    fn iterate(&mut self, velocities: &mut [Velocity], iterations: usize) -> bool {
        match self.masses.map(|mass| mass.linear > 0.0) {
            [false, true] => self.iterate_moving::<false, true>(velocities, iterations),
            [true, false] => self.iterate_moving::<true, false>(velocities, iterations),
            _ => self.iterate_moving::<true, true>(velocities, iterations),
        }
    }

    /// `A` and `B` say which of the bodies move; at least one does.
    #[inline(always)]
    fn iterate_moving<const A: bool, const B: bool>(&mut self, velocities: &mut [Velocity], iterations: usize) -> bool {
        let [index_a, index_b] = self.bodies;
        let (mut a, mut b) = (velocities[index_a], velocities[index_b]);
        let mut changed = false;
        for _ in 0..iterations {
            changed = self.solve_tangents::<A, B>(&mut a, &mut b);
            changed |= match self.block {
                Some(block) => self.solve_block::<A, B>(block, &mut a, &mut b),
                None => self.solve_normal::<A, B>(&mut a, &mut b),
            };
            if !changed {
                break;
            }
        }
        if A {
            velocities[index_a] = a;
        }
        if B {
            velocities[index_b] = b;
        }
        changed
    }

    #[inline(always)]
    fn solve_tangents<const A: bool, const B: bool>(&mut self, a: &mut Velocity, b: &mut Velocity) -> bool {
        let tangent = clockwise(self.normal);
        let mut changed = false;
        for index in 0..self.point_count {
            let point = &mut self.points[index];
            let velocity = point.relative_velocity::<A, B>(a, b).dot(tangent);
            let max_friction = FRICTION * point.impulse.normal;
            let unlimited = point.impulse.tangent + point.tangent_mass * -velocity;
            let total = clamp(unlimited, -max_friction, max_friction);
            let change = total - point.impulse.tangent;
            point.impulse.tangent = total;
            let (impulse, arms) = (change * tangent, point.arms);
            self.apply::<A, B>(a, b, impulse, arms.map(|arm| arm.perp_dot(impulse)));
            changed |= change != 0.0;
        }
        changed
    }

    #[inline(always)]
    fn solve_normal<const A: bool, const B: bool>(&mut self, a: &mut Velocity, b: &mut Velocity) -> bool {
        let point = &mut self.points[0];
        let velocity = point.relative_velocity::<A, B>(a, b).dot(self.normal);
        let unlimited = point.impulse.normal - point.normal_mass * (velocity - point.velocity_bias);
        let total = max(unlimited, 0.0);
        let change = total - point.impulse.normal;
        point.impulse.normal = total;
        let (impulse, arms) = (change * self.normal, point.arms);
        self.apply::<A, B>(a, b, impulse, arms.map(|arm| arm.perp_dot(impulse)));
        change != 0.0
    }

    /// The block solver: solves the linear complementarity problem of two normal impulses by total enumeration of its
    /// four cases. Both impulses are at least zero, and an impulse is zero unless its point would otherwise approach.
    #[inline(always)]
    fn solve_block<const A: bool, const B: bool>(&mut self, block: Block, a: &mut Velocity, b: &mut Velocity) -> bool {
        let Block { k: [k11, k12, k22], inverse: [inv11, inv12, inv22] } = block;
        let normal = self.normal;
        let [first, second] = &mut self.points;
        let (old1, old2) = (first.impulse.normal, second.impulse.normal);
        let error1 = first.relative_velocity::<A, B>(a, b).dot(normal) - first.velocity_bias;
        let error2 = second.relative_velocity::<A, B>(a, b).dot(normal) - second.velocity_bias;
        let b1 = error1 - (k11 * old1 + k12 * old2);
        let b2 = error2 - (k12 * old1 + k22 * old2);
        let (both1, both2) = (-(inv11 * b1 + inv12 * b2), -(inv12 * b1 + inv22 * b2));
        let (only1, only2) = (-first.normal_mass * b1, -second.normal_mass * b2);
        let (new1, new2) = if both1 >= 0.0 && both2 >= 0.0 {
            (both1, both2)
        } else if only1 >= 0.0 && k12 * only1 + b2 >= 0.0 {
            (only1, 0.0)
        } else if only2 >= 0.0 && k12 * only2 + b1 >= 0.0 {
            (0.0, only2)
        } else if b1 >= 0.0 && b2 >= 0.0 {
            (0.0, 0.0)
        } else {
            return false;
        };
        let (change1, change2) = (new1 - old1, new2 - old2);
        let (impulse1, impulse2) = (change1 * normal, change2 * normal);
        let torque = |side: usize| first.arms[side].perp_dot(impulse1) + second.arms[side].perp_dot(impulse2);
        let torques = [torque(0), torque(1)];
        first.impulse.normal = new1;
        second.impulse.normal = new2;
        self.apply::<A, B>(a, b, impulse1 + impulse2, torques);
        change1 != 0.0 || change2 != 0.0
    }

    /// Applies an impulse, kg m/s, to B, and its opposite to A; `torques` are about the two centres of mass.
    #[inline(always)]
    fn apply<const A: bool, const B: bool>(
        &self,
        a: &mut Velocity,
        b: &mut Velocity,
        impulse: Vector,
        torques: [f32; 2],
    ) {
        let [mass_a, mass_b] = self.masses;
        if A {
            a.linear -= mass_a.linear * impulse;
            a.angular -= mass_a.angular * torques[0];
        }
        if B {
            b.linear += mass_b.linear * impulse;
            b.angular += mass_b.angular * torques[1];
        }
    }
}

impl VelocityConstraintPoint {
    /// Returns the velocity of B relative to A at the point, m/s: positive along the normal if they separate.
    #[inline(always)]
    fn relative_velocity<const A: bool, const B: bool>(&self, a: &Velocity, b: &Velocity) -> Vector {
        match (A, B) {
            (false, _) => b.at(self.arms[1]),
            (_, false) => -a.linear - a.angular_at(self.arms[0]),
            _ => b.at(self.arms[1]) - a.linear - a.angular_at(self.arms[0]),
        }
    }
}

/// Changes the velocities so that no contact point approaches (SolveVelocityConstraints).
pub(super) fn solve_velocity_constraints(constraints: &mut [VelocityConstraint], velocities: &mut [Velocity]) {
    if let [constraint] = constraints {
        constraint.iterate(velocities, VELOCITY_ITERATIONS);
        return;
    }
    for _ in 0..VELOCITY_ITERATIONS {
        let mut changed = false;
        for constraint in &mut *constraints {
            changed |= constraint.solve(velocities);
        }
        if !changed {
            break;
        }
    }
}

/// A contact in the position solver (b2ContactPositionConstraint).
pub(super) struct PositionConstraint {
    kind: Kind,
    local_normal: Vector,
    local_point: Vector,
    local_points: [Vector; 2],
    point_count: usize,
    radii: [f32; 2],
    /// Indices in the island.
    bodies: [usize; 2],
    masses: [InverseMass; 2],
}

impl PositionConstraint {
    pub(super) fn new(manifold: &Manifold, fixtures: [&Fixture; 2], bodies: [&Body; 2]) -> PositionConstraint {
        let mut local_points = [Vector::ZERO; 2];
        local_points.iter_mut().zip(manifold.points()).for_each(|(to, from)| *to = from.local);
        PositionConstraint {
            kind: manifold.kind,
            local_normal: manifold.local_normal,
            local_point: manifold.local_point,
            local_points,
            point_count: manifold.points().len(),
            radii: fixtures.map(|fixture| fixture.shape.radius),
            bodies: bodies.map(|body| body.island_index),
            masses: bodies.map(InverseMass::of),
        }
    }

    /// Returns the normal, point and separation, m, of a contact point (b2PositionSolverManifold).
    #[inline(always)]
    fn manifold(&self, point: usize, transform_a: &Transform, transform_b: &Transform) -> (Vector, Vector, f32) {
        let [radius_a, radius_b] = self.radii;
        match self.kind {
            Kind::Circles => {
                let centre_a = transform_a.to_world(self.local_point);
                let centre_b = transform_b.to_world(self.local_points[0]);
                let normal = normalized(centre_b - centre_a);
                let separation = (centre_b - centre_a).dot(normal) - radius_a - radius_b;
                (normal, 0.5 * (centre_a + centre_b), separation)
            }
            Kind::FaceA => {
                let normal = transform_a.rotation.rotate(self.local_normal);
                let plane_point = transform_a.to_world(self.local_point);
                let clip = transform_b.to_world(self.local_points[point]);
                (normal, clip, (clip - plane_point).dot(normal) - radius_a - radius_b)
            }
            Kind::FaceB => {
                let normal = transform_b.rotation.rotate(self.local_normal);
                let plane_point = transform_b.to_world(self.local_point);
                let clip = transform_a.to_world(self.local_points[point]);
                (-normal, clip, (clip - plane_point).dot(normal) - radius_a - radius_b)
            }
        }
    }

    /// Runs one iteration, which resolves the fraction `baumgarte` of the overlap at each point. Returns the smallest
    /// separation encountered, m, at most 0.
    #[inline]
    fn solve(&self, positions: &mut [Position], baumgarte: f32) -> f32 {
        let [index_a, index_b] = self.bodies;
        let [mass_a, mass_b] = self.masses;
        let (mut a, mut b) = (positions[index_a], positions[index_b]);
        let mut min_separation = 0.0;
        for index in 0..self.point_count {
            let (normal, point, separation) = self.manifold(index, &a.transform(), &b.transform());
            min_separation = min(min_separation, separation);
            let correction = clamp(baumgarte * (separation + LINEAR_SLOP), -MAX_LINEAR_CORRECTION, 0.0);
            if correction == 0.0 {
                // The impulse would be zero.
                continue;
            }
            let arms = [point - a.centre, point - b.centre];
            let levers = arms.map(|arm| arm.perp_dot(normal));
            let k = inverse_effective_mass(&self.masses, levers, levers);
            let impulse = (if k > 0.0 { -correction / k } else { 0.0 }) * normal;
            a.centre -= mass_a.linear * impulse;
            a.turn_to(a.angle - mass_a.angular * arms[0].perp_dot(impulse));
            b.centre += mass_b.linear * impulse;
            b.turn_to(b.angle + mass_b.angular * arms[1].perp_dot(impulse));
        }
        positions[index_a] = a;
        positions[index_b] = b;
        min_separation
    }
}

/// Moves the bodies once so that contact points overlap less (SolvePositionConstraints and
/// SolveTOIPositionConstraints). Returns the smallest separation encountered, m, at most 0.
pub(super) fn solve_position_constraints(
    constraints: &[PositionConstraint],
    positions: &mut [Position],
    baumgarte: f32,
) -> f32 {
    constraints.iter().map(|constraint| constraint.solve(positions, baumgarte)).fold(0.0, min)
}

#[cfg(test)]
mod tests {
    use super::super::world::World;
    use super::*;
    use crate::puzzle::scene::walls;
    use crate::puzzle::task::Task;
    use crate::puzzle::templates::TEMPLATES;
    use crate::simulator::simulation::EngineWorld;

    /// All touching contacts of a world as one island, with its velocities.
    fn island(world: &mut World) -> (Vec<VelocityConstraint>, Vec<Velocity>) {
        world.bodies.iter_mut().enumerate().for_each(|(index, body)| body.island_index = index);
        let positions: Vec<Position> = world.bodies.iter().map(Position::new).collect();
        let velocity = |body: &Body| Velocity::new(body.velocity, body.angular_velocity);
        let velocities: Vec<Velocity> = world.bodies.iter().map(velocity).collect();
        let contacts = world.contact_manager.order.iter().map(|&id| &world.contact_manager[id]);
        let constraint = |contact: &super::super::contact::Contact| {
            let fixtures = contact.fixtures.map(|fixture| &world.fixtures[fixture]);
            let bodies = contact.bodies.map(|body| &world.bodies[body]);
            VelocityConstraint::new(&contact.manifold, fixtures, bodies, &positions, &velocities, true)
        };
        (contacts.filter(|contact| contact.touching).map(constraint).collect(), velocities)
    }

    #[test]
    fn the_shortcuts_change_no_bit() {
        let (mut compared, mut cut) = (0, 0);
        for Task { id, scene, .. } in TEMPLATES.into_iter().filter_map(|template| Task::of(template).next()) {
            let mut world = World::default();
            for body in walls().iter().chain(&scene.bodies) {
                world.add(body);
            }
            for step in 0..200 {
                world.step();
                if step % 10 != 0 {
                    continue;
                }
                let (mut constraints, mut velocities) = island(&mut world);
                let (mut long_way, mut expected) = island(&mut world);
                solve_velocity_constraints(&mut constraints, &mut velocities);
                for _ in 0..VELOCITY_ITERATIONS {
                    for constraint in &mut long_way {
                        constraint.iterate_moving::<true, true>(&mut expected, 1);
                    }
                }
                let bits =
                    |velocity: &Velocity| [velocity.linear.x, velocity.linear.y, velocity.angular].map(|v| v + 0.0);
                assert!(velocities.iter().map(bits).eq(expected.iter().map(bits)), "{id}, step {step}");
                compared += constraints.len();
                cut += constraints.iter().filter(|constraint| constraint.settled.is_some()).count();
            }
        }
        assert!(compared > 100 && cut > 10, "{cut} of {compared} constraints settled");
    }
}
