//! Scan conversion: the pixels of shapes, line by line. There is one pixel per px; a pixel belongs to a shape if its
//! centre lies inside.

use crate::puzzle::rollout::Pose;
use crate::puzzle::scene::{Body, SIZE, Shape};

/// A run of pixels of a line, at least one, inside the scene.
pub(crate) struct Span {
    pub line: usize,
    pub start: usize,
    /// The pixel after the last.
    pub end: usize,
}

/// Scan-converts a body at a pose: marks the pixels whose centres lie inside.
pub(crate) fn body_spans(body: &Body, [x, y, angle]: Pose, mut mark: impl FnMut(Span)) {
    let placed = Body { x: x.into(), y: y.into(), angle: angle.into(), ..body.clone() };
    for shape in &placed.shapes {
        match shape {
            Shape::Circle(radius) => disc_spans(placed.x, placed.y, *radius, &mut mark),
            Shape::Polygon(corners) => {
                let corners: Vec<_> = corners.iter().map(|&corner| placed.to_scene(corner)).collect();
                polygon_spans(&corners, &mut mark);
            }
        }
    }
}

/// Marks the pixels of a disc; centre and radius in px.
pub(crate) fn disc_spans(x: f64, y: f64, radius: f64, mark: impl FnMut(Span)) {
    let ends = |height: f64| {
        let half = (radius * radius - (height - y) * (height - y)).max(0.0).sqrt();
        Some((x - half, x + half))
    };
    spans(y - radius, y + radius, ends, mark);
}

/// Marks the pixels of a convex polygon; corners in px.
pub(crate) fn polygon_spans(corners: &[[f64; 2]], mark: impl FnMut(Span)) {
    let bottom = corners.iter().map(|corner| corner[1]).fold(f64::INFINITY, f64::min);
    let top = corners.iter().map(|corner| corner[1]).fold(f64::NEG_INFINITY, f64::max);
    let ends = |height: f64| {
        let mut ends = None::<(f64, f64)>;
        for (a, b) in corners.iter().zip(corners.iter().cycle().skip(1)) {
            if (a[1] <= height) != (b[1] <= height) {
                let x = a[0] + (height - a[1]) / (b[1] - a[1]) * (b[0] - a[0]);
                ends = Some(ends.map_or((x, x), |(left, right)| (left.min(x), right.max(x))));
            }
        }
        ends
    };
    spans(bottom, top, ends, mark);
}

/// Marks the pixels of a shape line by line. `ends` returns the left and right end of a line at a height, all px.
fn spans(bottom: f64, top: f64, ends: impl Fn(f64) -> Option<(f64, f64)>, mut mark: impl FnMut(Span)) {
    for line in first_pixel(bottom)..end_pixel(top) {
        let Some((left, right)) = ends(line as f64 + 0.5) else { continue };
        let (start, end) = (first_pixel(left), end_pixel(right));
        if start < end {
            mark(Span { line, start, end });
        }
    }
}

/// Returns the first pixel whose centre is not before a coordinate (px), within the scene.
fn first_pixel(coordinate: f64) -> usize {
    (coordinate - 0.5).ceil().clamp(0.0, SIZE) as usize
}

/// Returns the pixel after the last one whose centre is not after a coordinate (px), within the scene.
fn end_pixel(coordinate: f64) -> usize {
    ((coordinate - 0.5).floor() + 1.0).clamp(0.0, SIZE) as usize
}
