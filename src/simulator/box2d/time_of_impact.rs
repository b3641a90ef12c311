//! The time at which two moving shapes meet within a step: b2TimeOfImpact and b2SeparationFunction.
//!
//! Without it, fast bodies would sink into static ones or tunnel through thin bars. `stays_apart` is a shortcut, not in
//! Box2D, for the most frequent result: the shapes do not meet.

use rapier2d::math::Vector;

use super::distance::{DistanceInput, SimplexCache, distance};
use super::math::{Transform, clamp, clockwise, max, normalized};
use super::shape::Shape;
use super::sweep::Sweep;
use crate::simulator::constants::{
    LINEAR_SLOP, MAX_POLYGON_VERTICES, MAX_TOI_ITERATIONS, MAX_TOI_ROOT_ITERATIONS, TOI_TOLERANCE,
};

/// Returns the distance of the vertices at which two shapes meet, m: their radii overlap by three slops.
fn target(a: &Shape, b: &Shape) -> f32 {
    max(LINEAR_SLOP, a.radius + b.radius - 3.0 * LINEAR_SLOP)
}

/// Returns the fraction of the rest of the sweeps after which two shapes touch (b2TimeOfImpact); `None` if they stay
/// apart, overlap from the start, or the search fails.
pub(super) fn time_of_impact(a: &Shape, sweep_a: &Sweep, b: &Shape, sweep_b: &Sweep) -> Option<f32> {
    let (sweep_a, sweep_b) = (&sweep_a.normalized(), &sweep_b.normalized());
    let target = target(a, b);
    let mut cache = SimplexCache::default();
    let mut t1 = 0.0;
    for _ in 0..MAX_TOI_ITERATIONS {
        let (transform_a, transform_b) = (sweep_a.transform(t1), sweep_b.transform(t1));
        let input = DistanceInput { a, transform_a: &transform_a, b, transform_b: &transform_b };
        let distance = distance(&mut cache, input);
        if distance <= 0.0 {
            return None;
        }
        if distance < target + TOI_TOLERANCE {
            return Some(t1);
        }
        let function = SeparationFunction::new(&cache, input, sweep_a, sweep_b);
        // Resolves the deepest point along the axis, then the next one, until all are apart.
        let mut t2 = 1.0;
        for _ in 0..MAX_POLYGON_VERTICES {
            let (s2, vertices) = function.find_min_separation(t2);
            if s2 > target + TOI_TOLERANCE {
                return None;
            }
            if s2 > target - TOI_TOLERANCE {
                t1 = t2;
                break;
            }
            let s1 = function.evaluate(vertices, t1);
            if s1 < target - TOI_TOLERANCE {
                return None;
            }
            if s1 <= target + TOI_TOLERANCE {
                return Some(t1);
            }
            if let Some(root) = function.root(vertices, target, [t1, t2], [s1, s2]) {
                t2 = root;
            }
        }
    }
    None
}

/// The separation of two moving shapes along an axis given by the nearest features (b2SeparationFunction).
struct SeparationFunction<'a> {
    a: &'a Shape,
    sweep_a: &'a Sweep,
    b: &'a Shape,
    sweep_b: &'a Sweep,
    axis: Axis,
}

enum Axis {
    /// From a vertex of A to one of B, in world coordinates.
    Points(Vector),
    /// The normal of an edge of A, and a point of the edge, both in A's frame.
    FaceA { normal: Vector, point: Vector },
    /// The same for an edge of B.
    FaceB { normal: Vector, point: Vector },
}

impl<'a> SeparationFunction<'a> {
    fn new(
        cache: &SimplexCache,
        DistanceInput { a, transform_a, b, transform_b }: DistanceInput<'a>,
        sweep_a: &'a Sweep,
        sweep_b: &'a Sweep,
    ) -> SeparationFunction<'a> {
        // For an edge and the other shape's vertex, the normal that points to the vertex.
        let face = |shape: &Shape, edge: [usize; 2], transform: &Transform, vertex: Vector| {
            let [v1, v2] = edge.map(|index| shape.vertices()[index]);
            let normal = normalized(clockwise(v2 - v1));
            let point = 0.5 * (v1 + v2);
            let separation = (vertex - transform.to_world(point)).dot(transform.rotation.rotate(normal));
            (if separation < 0.0 { -normal } else { normal }, point)
        };
        let on_a = |index: usize| transform_a.to_world(a.vertices()[index]);
        let on_b = |index: usize| transform_b.to_world(b.vertices()[index]);
        let axis = match *cache.vertices() {
            [[a1, b1], [a2, b2], ..] if a1 == a2 => {
                let (normal, point) = face(b, [b1, b2], transform_b, on_a(a1));
                Axis::FaceB { normal, point }
            }
            [[a1, b1], [a2, _], ..] => {
                let (normal, point) = face(a, [a1, a2], transform_a, on_b(b1));
                Axis::FaceA { normal, point }
            }
            [[a1, b1]] => Axis::Points(normalized(on_b(b1) - on_a(a1))),
            [] => unreachable!("a simplex has a vertex"),
        };
        SeparationFunction { a, sweep_a, b, sweep_b, axis }
    }

    /// Returns the smallest separation at a time, m, and the vertices that have it (FindMinSeparation).
    fn find_min_separation(&self, t: f32) -> (f32, [usize; 2]) {
        let (transform_a, transform_b) = (self.sweep_a.transform(t), self.sweep_b.transform(t));
        let (to_a, to_b) = (transform_a.rotation, transform_b.rotation);
        let vertices = match self.axis {
            Axis::Points(axis) => [self.a.support(to_a.rotate_back(axis)), self.b.support(to_b.rotate_back(-axis))],
            Axis::FaceA { normal, .. } => [0, self.b.support(to_b.rotate_back(-to_a.rotate(normal)))],
            Axis::FaceB { normal, .. } => [self.a.support(to_a.rotate_back(-to_b.rotate(normal))), 0],
        };
        (self.separation(vertices, &transform_a, &transform_b), vertices)
    }

    /// Returns the separation of two vertices at a time, m (Evaluate).
    fn evaluate(&self, vertices: [usize; 2], t: f32) -> f32 {
        self.separation(vertices, &self.sweep_a.transform(t), &self.sweep_b.transform(t))
    }

    #[inline(always)]
    fn separation(&self, [vertex_a, vertex_b]: [usize; 2], transform_a: &Transform, transform_b: &Transform) -> f32 {
        let on_a = || transform_a.to_world(self.a.vertices()[vertex_a]);
        let on_b = || transform_b.to_world(self.b.vertices()[vertex_b]);
        match self.axis {
            Axis::Points(axis) => (on_b() - on_a()).dot(axis),
            Axis::FaceA { normal, point } => {
                (on_b() - transform_a.to_world(point)).dot(transform_a.rotation.rotate(normal))
            }
            Axis::FaceB { normal, point } => {
                (on_a() - transform_b.to_world(point)).dot(transform_b.rotation.rotate(normal))
            }
        }
    }

    /// Returns the time in `t1..t2` at which the separation of two vertices is `target`, by alternating bisection and
    /// the secant rule; `None` if it is not found.
    fn root(&self, vertices: [usize; 2], target: f32, [t1, t2]: [f32; 2], [s1, s2]: [f32; 2]) -> Option<f32> {
        let (mut t1, mut t2, mut s1, mut s2) = (t1, t2, s1, s2);
        for iteration in 0..MAX_TOI_ROOT_ITERATIONS {
            let is_secant = iteration % 2 == 1;
            let t = if is_secant { t1 + (target - s1) * (t2 - t1) / (s2 - s1) } else { 0.5 * (t1 + t2) };
            let s = self.evaluate(vertices, t);
            if (s - target).abs() < TOI_TOLERANCE {
                return Some(t);
            }
            if s > target {
                (t1, s1) = (t, s);
            } else {
                (t2, s2) = (t, s);
            }
        }
        None
    }
}

/// Shapes that stay at least this much farther apart than the distance at which they meet are not examined further, m.
/// This is far more than the rounding errors of all distances within a scene.
pub(super) const MARGIN: f32 = 1e-3;

/// Returns by how much more than `MARGIN` a vertex of a turning shape may leave the straight line between its positions
/// at the start and the end, m. It moves on an arc with a radius of at most `reach`; the height of an arc over its
/// chord is at most the radius times the squared angle over 8.
pub(super) fn arc_height(sweep: &Sweep, reach: f32) -> f32 {
    if sweep.is_round {
        return 0.0;
    }
    let turn = sweep.angle - sweep.angle0;
    reach * turn * turn * 0.125
}

/// Returns whether a moving shape stays so far from a fixed one, along one fixed direction, that `time_of_impact` finds
/// nothing.
///
/// If both ends of the motion are on the far side of a line, so is everything in between, up to `arc_height`. This
/// settles nineteen of twenty cases at a fraction of the cost. `end` is the moving body's frame at the end of its
/// sweep; `reach` is the maximum distance of the moving shape's vertices from the centre of mass, m. `normal` is a
/// guess of the direction, from the fixed shape to the moving one: the normal of their contact, or zero to try the
/// fixed shape's edges.
pub(super) fn stays_apart(
    (fixed, transform): (&Shape, &Transform),
    (moving, sweep, end): (&Shape, &Sweep, &Transform),
    reach: f32,
    normal: Vector,
) -> bool {
    let near = target(fixed, moving) + TOI_TOLERANCE + MARGIN;
    if sweep.is_round {
        if fixed.is_circle() {
            // The distance between a point and a segment.
            let (from, along) = (sweep.centre0 - transform.position, sweep.centre - sweep.centre0);
            let squared = along.length_squared();
            let nearest = if squared > 0.0 { clamp(-from.dot(along) / squared, 0.0, 1.0) } else { 0.0 };
            return (from + nearest * along).length_squared() > near * near;
        }
        let (centre0, centre) = (transform.to_local(sweep.centre0), transform.to_local(sweep.centre));
        let is_beyond = |normal: Vector, on_line: Vector| {
            normal.dot(centre0 - on_line) > near && normal.dot(centre - on_line) > near
        };
        if fixed.normals().iter().zip(fixed.vertices()).any(|(&normal, &vertex)| is_beyond(normal, vertex)) {
            return true;
        }
        let normal = transform.rotation.rotate_back(normal);
        return normal != Vector::ZERO && is_beyond(normal, fixed.vertices()[fixed.support(normal)]);
    }
    let rotation = if sweep.angle == sweep.angle0 { end.rotation } else { sweep.rotation(sweep.angle0) };
    let start = Transform::about(sweep.centre0, sweep.local_centre, rotation);
    let near = near + arc_height(sweep, reach);
    let is_beyond = |normal: Vector, on_line: Vector| {
        [&start, end].into_iter().all(|transform| {
            let lowest = moving.vertices()[moving.support(transform.rotation.rotate_back(-normal))];
            normal.dot(transform.to_world(lowest)) - normal.dot(on_line) > near
        })
    };
    if normal != Vector::ZERO {
        let farthest = fixed.vertices()[fixed.support(transform.rotation.rotate_back(normal))];
        return is_beyond(normal, transform.to_world(farthest));
    }
    !fixed.is_circle()
        && fixed
            .normals()
            .iter()
            .zip(fixed.vertices())
            .any(|(&normal, &vertex)| is_beyond(transform.rotation.rotate(normal), transform.to_world(vertex)))
}

#[cfg(all(test, not(target_arch = "wasm32")))]
mod tests {
    use proptest::prelude::*;

    use super::*;

    /// A ball, or a bar as long as those of the scenes.
    fn shape() -> impl Strategy<Value = Shape> {
        let bar =
            |(w, h): (f32, f32)| Shape::polygon(&[(w, h), (-w, h), (-w, -h), (w, -h)].map(|(x, y)| Vector::new(x, y)));
        prop_oneof![(0.3..5.0f32).prop_map(Shape::circle), (0.3..20.0f32, 0.3..2.0f32).prop_map(bar)]
    }

    /// A motion over a step, from near the origin, of a centred body that may turn.
    fn sweep() -> impl Strategy<Value = Sweep> {
        let coordinate = || -15.0..15.0f32;
        let displacement = || -1.0..1.0f32;
        (coordinate(), coordinate(), displacement(), displacement(), -7.0..7.0f32, -0.4..0.4f32, any::<bool>())
            .prop_map(|(x, y, dx, dy, angle, turn, turns)| {
                let angle0 = if turns { angle - turn } else { angle };
                let (centre0, centre) = (Vector::new(x, y), Vector::new(x + dx, y + dy));
                Sweep { local_centre: Vector::ZERO, centre0, centre, angle0, angle, alpha0: 0.0, is_round: false }
            })
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(4000))]

        #[test]
        fn what_stays_apart_has_no_time_of_impact(
            fixed in shape(), moving in shape(), place in sweep(), mut sweep in sweep(), towards in any::<bool>(),
        ) {
            sweep.is_round = moving.is_circle();
            let still = Sweep { centre0: place.centre, angle0: place.angle, is_round: fixed.is_circle(), ..place };
            let normal = if towards { normalized(sweep.centre - still.centre) } else { Vector::ZERO };
            let (transform, end) = (still.transform(0.0), sweep.transform(1.0));
            let reach = moving.reach(Vector::ZERO);
            if stays_apart((&fixed, &transform), (&moving, &sweep, &end), reach, normal) {
                prop_assert_eq!(time_of_impact(&fixed, &still, &moving, &sweep), None);
            }
        }
    }

    #[test]
    fn a_fast_ball_meets_a_bar_where_their_surfaces_touch() {
        let (bar, ball) = (
            Shape::polygon(&[[9.0, 0.5], [-9.0, 0.5], [-9.0, -0.5], [9.0, -0.5]].map(Vector::from)),
            Shape::circle(1.0),
        );
        let still = Sweep {
            local_centre: Vector::ZERO,
            centre0: Vector::ZERO,
            centre: Vector::ZERO,
            angle0: 0.0,
            angle: 0.0,
            alpha0: 0.0,
            is_round: false,
        };
        // It would pass through within a step.
        let falling = Sweep { centre0: Vector::new(0.0, 4.0), centre: Vector::new(0.0, -4.0), is_round: true, ..still };
        let time = time_of_impact(&bar, &still, &ball, &falling).expect("they meet");
        let height = 4.0 - 8.0 * time;
        assert!((height - 0.5 - target(&bar, &ball)).abs() < TOI_TOLERANCE, "at {height} m");
        assert_eq!(time_of_impact(&bar, &still, &ball, &Sweep { centre: Vector::new(0.0, 2.0), ..falling }), None);
    }
}
