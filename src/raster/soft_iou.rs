//! The soft intersection over union of two 64 x 64 images: how well a predicted path agrees with the simulated one.
//!
//! Soft IoU (the Ruzicka or weighted Jaccard similarity) is the sum over the cells of the smaller value, divided by the
//! sum of the larger. For binary images it is the ordinary intersection over union. A confident prediction scores
//! higher than an uncertain one where it is right, and lower where it is wrong. The page uses it for the nets' maps and
//! for drawings by people, so that both are measured alike.

/// Returns the soft IoU of two images of equal size with values in 0..=1: 0 (disjoint) to 1 (equal). It is 0 for two
/// empty images. NaN counts as 0.
///
/// ```
/// use pathlight::raster::soft_iou::soft_iou;
///
/// assert_eq!(soft_iou(&[0.5, 0.0], &[1.0, 0.0]), 0.5);
/// ```
pub fn soft_iou(one: &[f32], other: &[f32]) -> f64 {
    let clean = |value: f32| if value.is_nan() { 0.0 } else { f64::from(value.clamp(0.0, 1.0)) };
    let pairs = || one.iter().zip(other).map(|(&a, &b)| (clean(a), clean(b)));
    let intersection: f64 = pairs().map(|(a, b)| a.min(b)).sum();
    let union: f64 = pairs().map(|(a, b)| a.max(b)).sum();
    if union > 0.0 { intersection / union } else { 0.0 }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn equal_images_score_one_and_disjoint_ones_zero() {
        assert_eq!(soft_iou(&[0.0, 1.0, 1.0], &[0.0, 1.0, 1.0]), 1.0);
        assert_eq!(soft_iou(&[1.0, 0.0, 0.0], &[0.0, 1.0, 1.0]), 0.0);
    }

    #[test]
    fn sets_have_the_usual_intersection_over_union_whichever_comes_first() {
        let (one, other) = ([1.0, 1.0, 0.0, 0.0], [0.0, 1.0, 1.0, 1.0]);
        assert_eq!(soft_iou(&one, &other), 0.25);
        assert_eq!(soft_iou(&other, &one), 0.25);
    }

    #[test]
    fn confidence_raises_the_score_where_right_and_lowers_it_where_wrong() {
        let real = [1.0, 0.0];
        assert!(soft_iou(&[0.9, 0.0], &real) > soft_iou(&[0.5, 0.0], &real));
        assert!(soft_iou(&[0.5, 0.9], &real) < soft_iou(&[0.5, 0.1], &real));
    }

    #[test]
    fn empty_images_and_nan_score_nothing() {
        assert_eq!(soft_iou(&[0.0; 4], &[0.0; 4]), 0.0);
        assert_eq!(soft_iou(&[], &[]), 0.0);
        assert_eq!(soft_iou(&[f32::NAN, 2.0], &[1.0, 1.0]), 0.5);
    }
}
