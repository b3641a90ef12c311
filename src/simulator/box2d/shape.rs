//! Convex shapes: b2PolygonShape, b2CircleShape and b2MassData.
//!
//! A circle is one vertex at the origin of its body, with a radius; a polygon has the thickness of its skin as its
//! radius. Box2D's distances use the same representation (b2DistanceProxy).

use rapier2d::geometry::Aabb;
use rapier2d::math::Vector;

use super::math::{Transform, clockwise, normalized};
use crate::puzzle::scene;
use crate::simulator::constants::{LINEAR_SLOP, MAX_POLYGON_VERTICES, POLYGON_RADIUS};
use crate::simulator::units::{metres, point_in_metres};

#[derive(Clone, Debug)]
pub(super) struct Shape {
    /// Distance of the surface from the vertices, m: the radius of a circle, or the thickness of a polygon's skin.
    pub(super) radius: f32,
    count: usize,
    vertices: [Vector; MAX_POLYGON_VERTICES],
    /// Outward normals of the edges from each vertex to the next.
    normals: [Vector; MAX_POLYGON_VERTICES],
}

/// Mass, kg, centre of mass, m, and rotational inertia about the origin of the body, kg m^2, of a shape (b2MassData).
pub(super) struct MassData {
    pub(super) mass: f32,
    pub(super) centre: Vector,
    pub(super) inertia: f32,
}

impl Shape {
    pub(super) fn new(shape: &scene::Shape) -> Shape {
        match shape {
            scene::Shape::Circle(radius) => Shape::circle(metres(*radius)),
            scene::Shape::Polygon(corners) => {
                Shape::polygon(&corners.iter().copied().map(point_in_metres).collect::<Vec<_>>())
            }
        }
    }

    pub(super) fn circle(radius: f32) -> Shape {
        Shape {
            radius,
            count: 1,
            vertices: [Vector::ZERO; MAX_POLYGON_VERTICES],
            normals: [Vector::ZERO; MAX_POLYGON_VERTICES],
        }
    }

    /// Returns the convex hull of at most `MAX_POLYGON_VERTICES` points, m, by gift wrapping (b2PolygonShape::Set).
    pub(super) fn polygon(points: &[Vector]) -> Shape {
        let mut distinct: Vec<Vector> = Vec::with_capacity(points.len());
        for &point in points {
            let is_near =
                |other: &Vector| (point - *other).length_squared() < (0.5 * LINEAR_SLOP) * (0.5 * LINEAR_SLOP);
            if !distinct.iter().any(is_near) {
                distinct.push(point);
            }
        }
        // Starts from the rightmost point; if there are several, from the lowest of them.
        let mut first = 0;
        for (index, point) in distinct.iter().enumerate() {
            let rightmost = distinct[first];
            if point.x > rightmost.x || (point.x == rightmost.x && point.y < rightmost.y) {
                first = index;
            }
        }
        let mut hull = Shape { count: 0, ..Shape::circle(POLYGON_RADIUS) };
        let mut last = first;
        while hull.count < MAX_POLYGON_VERTICES {
            hull.vertices[hull.count] = distinct[last];
            hull.count += 1;
            let mut next = 0;
            for index in 1..distinct.len() {
                let (best, edge) = (distinct[next] - distinct[last], distinct[index] - distinct[last]);
                let cross = best.perp_dot(edge);
                let is_outside = cross < 0.0 || (cross == 0.0 && edge.length_squared() > best.length_squared());
                if next == last || is_outside {
                    next = index;
                }
            }
            last = next;
            if last == first {
                break;
            }
        }
        for index in 0..hull.count {
            hull.normals[index] = normalized(clockwise(hull.vertices[hull.next(index)] - hull.vertices[index]));
        }
        hull
    }

    pub(super) fn is_circle(&self) -> bool {
        self.count == 1
    }

    #[inline(always)]
    pub(super) fn vertices(&self) -> &[Vector] {
        &self.vertices[..self.count]
    }

    #[inline(always)]
    pub(super) fn normals(&self) -> &[Vector] {
        &self.normals[..self.count]
    }

    /// Returns the index of the next vertex.
    #[inline(always)]
    pub(super) fn next(&self, index: usize) -> usize {
        if index + 1 < self.count { index + 1 } else { 0 }
    }

    /// Returns the index of the vertex that is farthest in a direction (b2DistanceProxy::GetSupport).
    #[inline(always)]
    pub(super) fn support(&self, direction: Vector) -> usize {
        let (mut best, mut farthest) = (0, self.vertices[0].dot(direction));
        for (index, vertex) in self.vertices().iter().enumerate().skip(1) {
            let along = vertex.dot(direction);
            if along > farthest {
                (best, farthest) = (index, along);
            }
        }
        best
    }

    /// Returns the mass of the shape for a density, kg/m^2 (ComputeMass). A polygon is split into triangles about the
    /// mean of its vertices.
    pub(super) fn mass_data(&self, density: f32) -> MassData {
        const THIRD: f32 = 1.0 / 3.0;
        if self.is_circle() {
            let mass = density * std::f32::consts::PI * self.radius * self.radius;
            return MassData { mass, centre: Vector::ZERO, inertia: mass * (0.5 * self.radius * self.radius) };
        }
        let sum = self.vertices().iter().fold(Vector::ZERO, |sum, &vertex| sum + vertex);
        let mean = (1.0 / self.count as f32) * sum;
        let (mut centre, mut area, mut inertia) = (Vector::ZERO, 0.0, 0.0);
        for index in 0..self.count {
            let (e1, e2) = (self.vertices[index] - mean, self.vertices[self.next(index)] - mean);
            let cross = e1.perp_dot(e2);
            let triangle = 0.5 * cross;
            area += triangle;
            centre += triangle * THIRD * (e1 + e2);
            let x_squared = e1.x * e1.x + e2.x * e1.x + e2.x * e2.x;
            let y_squared = e1.y * e1.y + e2.y * e1.y + e2.y * e2.y;
            inertia += (0.25 * THIRD * cross) * (x_squared + y_squared);
        }
        let mass = density * area;
        centre *= 1.0 / area;
        let from_origin = centre + mean;
        // From the mean of the vertices to the centre of mass, then to the origin.
        let shift = from_origin.dot(from_origin) - centre.dot(centre);
        MassData { mass, centre: from_origin, inertia: density * inertia + mass * shift }
    }

    /// Returns the bounding box of the surface at a transform (ComputeAABB).
    #[inline]
    pub(super) fn aabb(&self, transform: &Transform) -> Aabb {
        if self.is_circle() {
            let (centre, radius) = (transform.position, Vector::splat(self.radius));
            return Aabb { mins: centre - radius, maxs: centre + radius };
        }
        let first = transform.to_world(self.vertices[0]);
        let (mut mins, mut maxs) = (first, first);
        for &vertex in &self.vertices()[1..] {
            let vertex = transform.to_world(vertex);
            (mins, maxs) = (mins.min(vertex), maxs.max(vertex));
        }
        let radius = Vector::splat(self.radius);
        Aabb { mins: mins - radius, maxs: maxs + radius }
    }

    /// Returns the distance of the vertex that is farthest from a point, m.
    pub(super) fn reach(&self, from: Vector) -> f32 {
        self.vertices().iter().map(|&vertex| super::math::length(vertex - from)).fold(0.0, f32::max)
    }
}
