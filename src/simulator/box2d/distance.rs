//! The distance of two convex shapes without their radii, by the algorithm of Gilbert, Johnson and Keerthi: b2Distance,
//! b2Simplex and b2SimplexCache.

use rapier2d::math::Vector;

use super::math::{Transform, clockwise, length};
use super::shape::Shape;

/// Maximum number of iterations (k_maxIters).
const MAX_ITERATIONS: usize = 20;

/// The vertices of the last simplex, from which the next call starts (b2SimplexCache).
#[derive(Clone, Copy, Default)]
pub(super) struct SimplexCache {
    /// Length or area of the simplex, m or m^2.
    metric: f32,
    count: usize,
    /// Pairs of vertices of A and of B.
    vertices: [[usize; 2]; 3],
}

impl SimplexCache {
    /// Returns the pairs of vertices of A and B whose differences are the vertices of the simplex.
    pub(super) fn vertices(&self) -> &[[usize; 2]] {
        &self.vertices[..self.count]
    }
}

/// A vertex of the Minkowski difference of B and A (b2SimplexVertex).
#[derive(Clone, Copy, Default)]
struct SimplexVertex {
    /// The vertices of A and B whose difference it is, in world coordinates, m, and their indices.
    on_a: Vector,
    on_b: Vector,
    indices: [usize; 2],
    /// `on_b - on_a`.
    w: Vector,
    /// The barycentric coordinate of the point that is nearest to the origin.
    weight: f32,
}

struct Simplex {
    vertices: [SimplexVertex; 3],
    count: usize,
}

/// The two shapes, each with its transform.
#[derive(Clone, Copy)]
pub(super) struct DistanceInput<'a> {
    pub(super) a: &'a Shape,
    pub(super) transform_a: &'a Transform,
    pub(super) b: &'a Shape,
    pub(super) transform_b: &'a Transform,
}

impl DistanceInput<'_> {
    #[inline(always)]
    fn vertex(&self, indices: [usize; 2]) -> SimplexVertex {
        let on_a = self.transform_a.to_world(self.a.vertices()[indices[0]]);
        let on_b = self.transform_b.to_world(self.b.vertices()[indices[1]]);
        SimplexVertex { on_a, on_b, indices, w: on_b - on_a, weight: 0.0 }
    }
}

/// Returns the distance, m; 0 if the shapes overlap (b2Distance).
pub(super) fn distance(cache: &mut SimplexCache, input: DistanceInput) -> f32 {
    let mut simplex = Simplex::read_cache(cache, &input);
    for _ in 0..MAX_ITERATIONS {
        let (visited, count) = (simplex.vertices.map(|vertex| vertex.indices), simplex.count);
        match count {
            2 => simplex.solve2(),
            3 => simplex.solve3(),
            _ => {}
        }
        if simplex.count == 3 {
            // The origin is inside: the shapes overlap.
            break;
        }
        let direction = simplex.search_direction();
        if direction.length_squared() < f32::EPSILON * f32::EPSILON {
            break;
        }
        let indices = [
            input.a.support(input.transform_a.rotation.rotate_back(-direction)),
            input.b.support(input.transform_b.rotation.rotate_back(direction)),
        ];
        if visited[..count].contains(&indices) {
            // No vertex is nearer.
            break;
        }
        simplex.vertices[simplex.count] = input.vertex(indices);
        simplex.count += 1;
    }
    *cache = SimplexCache {
        metric: simplex.metric(),
        count: simplex.count,
        vertices: simplex.vertices.map(|vertex| vertex.indices),
    };
    simplex.distance()
}

impl Simplex {
    #[inline(always)]
    fn read_cache(cache: &SimplexCache, input: &DistanceInput) -> Simplex {
        let mut simplex = Simplex { vertices: Default::default(), count: cache.count };
        for (vertex, &indices) in simplex.vertices.iter_mut().zip(cache.vertices()) {
            *vertex = input.vertex(indices);
        }
        if simplex.count > 1 {
            // A simplex that has changed much does not help.
            let (old, new) = (cache.metric, simplex.metric());
            if new < 0.5 * old || 2.0 * old < new || new < f32::EPSILON {
                simplex.count = 0;
            }
        }
        if simplex.count == 0 {
            simplex.vertices[0] = SimplexVertex { weight: 1.0, ..input.vertex([0, 0]) };
            simplex.count = 1;
        }
        simplex
    }

    fn metric(&self) -> f32 {
        let [v1, v2, v3] = &self.vertices;
        match self.count {
            1 => 0.0,
            2 => length(v1.w - v2.w),
            _ => (v2.w - v1.w).perp_dot(v3.w - v1.w),
        }
    }

    /// Returns a vector towards the origin.
    fn search_direction(&self) -> Vector {
        let [v1, v2, _] = &self.vertices;
        if self.count == 1 {
            return -v1.w;
        }
        let edge = v2.w - v1.w;
        if edge.perp_dot(-v1.w) > 0.0 { edge.perp() } else { clockwise(edge) }
    }

    /// Keeps one vertex: the one that is nearest to the origin.
    fn keep1(&mut self, vertex: usize) {
        self.vertices[0] = SimplexVertex { weight: 1.0, ..self.vertices[vertex] };
        self.count = 1;
    }

    /// Keeps the edge from `first` to `second`. The nearest point divides it by these weights, which are normalised
    /// here.
    fn keep2(&mut self, [first, second]: [usize; 2], [weight1, weight2]: [f32; 2]) {
        let inv_sum = 1.0 / (weight1 + weight2);
        self.vertices[first].weight = weight1 * inv_sum;
        self.vertices[second].weight = weight2 * inv_sum;
        // The order decides the slot of the next vertex: the last one moves into the gap.
        if second == 2 {
            self.vertices[if first == 0 { 1 } else { 0 }] = self.vertices[2];
        }
        self.count = 2;
    }

    /// Finds the point of an edge that is nearest to the origin (b2Simplex::Solve2).
    #[inline(always)]
    fn solve2(&mut self) {
        let (w1, w2) = (self.vertices[0].w, self.vertices[1].w);
        let edge = w2 - w1;
        let d2 = -w1.dot(edge);
        if d2 <= 0.0 {
            return self.keep1(0);
        }
        let d1 = w2.dot(edge);
        if d1 <= 0.0 {
            return self.keep1(1);
        }
        self.keep2([0, 1], [d1, d2]);
    }

    /// Finds the point of a triangle that is nearest to the origin (b2Simplex::Solve3).
    fn solve3(&mut self) {
        let [w1, w2, w3] = self.vertices.map(|vertex| vertex.w);
        let (e12, e13, e23) = (w2 - w1, w3 - w1, w3 - w2);
        let (d12_1, d12_2) = (w2.dot(e12), -w1.dot(e12));
        let (d13_1, d13_2) = (w3.dot(e13), -w1.dot(e13));
        let (d23_1, d23_2) = (w3.dot(e23), -w2.dot(e23));
        let n123 = e12.perp_dot(e13);
        let (d1, d2, d3) = (n123 * w2.perp_dot(w3), n123 * w3.perp_dot(w1), n123 * w1.perp_dot(w2));
        if d12_2 <= 0.0 && d13_2 <= 0.0 {
            self.keep1(0);
        } else if d12_1 > 0.0 && d12_2 > 0.0 && d3 <= 0.0 {
            self.keep2([0, 1], [d12_1, d12_2]);
        } else if d13_1 > 0.0 && d13_2 > 0.0 && d2 <= 0.0 {
            self.keep2([0, 2], [d13_1, d13_2]);
        } else if d12_1 <= 0.0 && d23_2 <= 0.0 {
            self.keep1(1);
        } else if d13_1 <= 0.0 && d23_1 <= 0.0 {
            self.keep1(2);
        } else if d23_1 > 0.0 && d23_2 > 0.0 && d1 <= 0.0 {
            self.keep2([1, 2], [d23_1, d23_2]);
        } else {
            let inv_sum = 1.0 / (d1 + d2 + d3);
            let weights = [d1 * inv_sum, d2 * inv_sum, d3 * inv_sum];
            self.vertices.iter_mut().zip(weights).for_each(|(vertex, weight)| vertex.weight = weight);
            self.count = 3;
        }
    }

    /// Returns the distance of the nearest points of A and B.
    fn distance(&self) -> f32 {
        let [v1, v2, _] = &self.vertices;
        match self.count {
            1 => length(v1.on_a - v1.on_b),
            2 => length((v1.weight * v1.on_a + v2.weight * v2.on_a) - (v1.weight * v1.on_b + v2.weight * v2.on_b)),
            _ => 0.0,
        }
    }
}
