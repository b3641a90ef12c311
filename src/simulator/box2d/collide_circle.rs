//! Contacts with circles: b2CollideCircles and b2CollidePolygonAndCircle.

use rapier2d::math::Vector;

use super::manifold::{Kind, Manifold};
use super::math::{Transform, normalized};
use super::shape::Shape;

/// b2CollideCircles.
pub(super) fn collide_circles(a: &Shape, transform_a: &Transform, b: &Shape, transform_b: &Transform) -> Manifold {
    let centres = transform_b.position - transform_a.position;
    let radius = a.radius + b.radius;
    if centres.length_squared() > radius * radius {
        return Manifold::EMPTY;
    }
    Manifold::EMPTY.with_centre()
}

/// b2CollidePolygonAndCircle.
pub(super) fn collide_polygon_and_circle(
    polygon: &Shape,
    transform_a: &Transform,
    circle: &Shape,
    transform_b: &Transform,
) -> Manifold {
    let centre = transform_a.to_local(transform_b.position);
    let radius = polygon.radius + circle.radius;
    let (vertices, normals) = (polygon.vertices(), polygon.normals());
    let (mut face, mut separation) = (0, -f32::MAX);
    for (index, (&vertex, &normal)) in vertices.iter().zip(normals).enumerate() {
        let distance = normal.dot(centre - vertex);
        if distance > radius {
            return Manifold::EMPTY;
        }
        if distance > separation {
            (face, separation) = (index, distance);
        }
    }
    let (v1, v2) = (vertices[face], vertices[polygon.next(face)]);
    let with_face = |normal, point| Manifold::with_reference(Kind::FaceA, normal, point).with_centre();
    let with_vertex = |vertex: Vector| {
        if (centre - vertex).length_squared() > radius * radius {
            return Manifold::EMPTY;
        }
        with_face(normalized(centre - vertex), vertex)
    };
    let middle = 0.5 * (v1 + v2);
    if separation < f32::EPSILON {
        // The centre is inside the polygon.
        with_face(normals[face], middle)
    } else if (centre - v1).dot(v2 - v1) <= 0.0 {
        with_vertex(v1)
    } else if (centre - v2).dot(v1 - v2) <= 0.0 {
        with_vertex(v2)
    } else if (centre - middle).dot(normals[face]) > radius {
        Manifold::EMPTY
    } else {
        with_face(normals[face], middle)
    }
}
