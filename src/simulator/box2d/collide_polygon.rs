//! Contacts of two polygons: b2FindMaxSeparation, b2FindIncidentEdge, b2ClipSegmentToLine and b2CollidePolygons.

use rapier2d::math::Vector;

use super::manifold::{ContactId, Feature, Kind, Manifold};
use super::math::{Transform, clockwise, normalized};
use super::shape::Shape;
use crate::simulator::constants::LINEAR_SLOP;

/// Returns the largest separation of `b` from an edge of `a`, m, and this edge (b2FindMaxSeparation).
fn find_max_separation(a: &Shape, transform_a: &Transform, b: &Shape, transform_b: &Transform) -> (f32, usize) {
    let a_in_b = transform_b.relative(transform_a);
    let (mut max_separation, mut best) = (-f32::MAX, 0);
    for (index, (&vertex, &normal)) in a.vertices().iter().zip(a.normals()).enumerate() {
        let (vertex, normal) = (a_in_b.to_world(vertex), a_in_b.rotation.rotate(normal));
        let mut separation = f32::MAX;
        for &other in b.vertices() {
            let distance = normal.dot(other - vertex);
            if distance < separation {
                separation = distance;
            }
        }
        if separation > max_separation {
            (max_separation, best) = (separation, index);
        }
    }
    (max_separation, best)
}

/// A point of the incident edge, in world coordinates, during clipping (b2ClipVertex).
#[derive(Clone, Copy)]
struct ClipVertex {
    v: Vector,
    id: ContactId,
}

/// Returns the edge of `b` that faces an edge of `a` (b2FindIncidentEdge).
fn find_incident_edge(
    a: &Shape,
    transform_a: &Transform,
    edge: usize,
    b: &Shape,
    transform_b: &Transform,
) -> [ClipVertex; 2] {
    let normal = transform_b.rotation.rotate_back(transform_a.rotation.rotate(a.normals()[edge]));
    let (mut first, mut least) = (0, f32::MAX);
    for (index, other) in b.normals().iter().enumerate() {
        let along = normal.dot(*other);
        if along < least {
            (first, least) = (index, along);
        }
    }
    [first, b.next(first)].map(|vertex| ClipVertex {
        v: transform_b.to_world(b.vertices()[vertex]),
        id: ContactId { a: Feature::Face(edge as u8), b: Feature::Vertex(vertex as u8) },
    })
}

/// Clips a segment to the side of a line opposite to its normal; `None` if fewer than two points are left
/// (b2ClipSegmentToLine). `vertex` is the vertex of A that the line passes through.
fn clip_segment_to_line(
    segment: [ClipVertex; 2],
    normal: Vector,
    offset: f32,
    vertex: usize,
) -> Option<[ClipVertex; 2]> {
    let [first, second] = segment;
    let [distance1, distance2] = segment.map(|point| normal.dot(point.v) - offset);
    // The point where the segment crosses the line.
    let crossing = || {
        let fraction = distance1 / (distance1 - distance2);
        let (Feature::Vertex(index) | Feature::Face(index)) = first.id.b;
        let id = ContactId { a: Feature::Vertex(vertex as u8), b: Feature::Face(index) };
        ClipVertex { v: first.v + fraction * (second.v - first.v), id }
    };
    match (distance1 <= 0.0, distance2 <= 0.0, distance1 * distance2 < 0.0) {
        (true, true, _) => Some(segment),
        (true, false, true) => Some([first, crossing()]),
        (false, true, true) => Some([second, crossing()]),
        _ => None,
    }
}

/// b2CollidePolygons.
pub(super) fn collide_polygons(a: &Shape, transform_a: &Transform, b: &Shape, transform_b: &Transform) -> Manifold {
    let radius = a.radius + b.radius;
    let (separation_a, edge_a) = find_max_separation(a, transform_a, b, transform_b);
    if separation_a > radius {
        return Manifold::EMPTY;
    }
    let (separation_b, edge_b) = find_max_separation(b, transform_b, a, transform_a);
    if separation_b > radius {
        return Manifold::EMPTY;
    }
    // The reference edge belongs to A unless B's is clearly better, so that it does not change from step to step.
    let flip = separation_b > separation_a + 0.1 * LINEAR_SLOP;
    let (reference, transform1, edge, incident, transform2) =
        if flip { (b, transform_b, edge_b, a, transform_a) } else { (a, transform_a, edge_a, b, transform_b) };
    let segment = find_incident_edge(reference, transform1, edge, incident, transform2);

    let (vertex1, vertex2) = (edge, reference.next(edge));
    let (local1, local2) = (reference.vertices()[vertex1], reference.vertices()[vertex2]);
    let local_tangent = normalized(local2 - local1);
    let tangent = transform1.rotation.rotate(local_tangent);
    let normal = clockwise(tangent);
    let (v1, v2) = (transform1.to_world(local1), transform1.to_world(local2));
    // The sides of the reference edge, extended by the skins.
    let clipped = clip_segment_to_line(segment, -tangent, -tangent.dot(v1) + radius, vertex1)
        .and_then(|segment| clip_segment_to_line(segment, tangent, tangent.dot(v2) + radius, vertex2));
    let Some(clipped) = clipped else { return Manifold::EMPTY };

    let kind = if flip { Kind::FaceB } else { Kind::FaceA };
    let mut manifold = Manifold::with_reference(kind, clockwise(local_tangent), 0.5 * (local1 + local2));
    let front = normal.dot(v1);
    for ClipVertex { v, id: ContactId { a, b } } in clipped {
        if normal.dot(v) - front <= radius {
            let id = if flip { ContactId { a: b, b: a } } else { ContactId { a, b } };
            manifold.push(transform2.to_local(v), id);
        }
    }
    manifold
}
