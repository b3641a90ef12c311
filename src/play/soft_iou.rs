//! How well two 64 x 64 pictures agree, as one number: what was imagined against what came of it.
//!
//! The measure is the soft intersection over union: the sum of the smaller value of each cell by the sum of
//! the larger. For pictures of set and unset cells it is the usual intersection over union; an unsure map gains
//! less than a sure one that is right, and loses less than a sure one that is wrong. Used by the page for the
//! nets' maps and for what a person draws, so that both are measured alike.

/// The overlap of two pictures of as many cells, values in 0..=1: 0 (nothing in common) to 1 (the same). Two
/// empty pictures have nothing in common. A value that is no number counts as 0.
pub fn overlap(one: &[f32], other: &[f32]) -> f64 {
    let share = |value: f32| if value.is_nan() { 0.0 } else { f64::from(value.clamp(0.0, 1.0)) };
    let pairs = || one.iter().zip(other).map(|(&a, &b)| (share(a), share(b)));
    let common: f64 = pairs().map(|(a, b)| a.min(b)).sum();
    let all: f64 = pairs().map(|(a, b)| a.max(b)).sum();
    if all > 0.0 { common / all } else { 0.0 }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_same_picture_overlaps_wholly_and_a_disjoint_one_not_at_all() {
        assert_eq!(overlap(&[0.0, 1.0, 1.0], &[0.0, 1.0, 1.0]), 1.0);
        assert_eq!(overlap(&[1.0, 0.0, 0.0], &[0.0, 1.0, 1.0]), 0.0);
    }

    #[test]
    fn sets_have_the_usual_intersection_over_union_whichever_comes_first() {
        let (one, other) = ([1.0, 1.0, 0.0, 0.0], [0.0, 1.0, 1.0, 1.0]);
        assert_eq!(overlap(&one, &other), 0.25);
        assert_eq!(overlap(&other, &one), 0.25);
    }

    #[test]
    fn being_sure_pays_where_it_is_right_and_costs_where_it_is_wrong() {
        let real = [1.0, 0.0];
        assert!(overlap(&[0.9, 0.0], &real) > overlap(&[0.5, 0.0], &real));
        assert!(overlap(&[0.5, 0.9], &real) < overlap(&[0.5, 0.1], &real));
    }

    #[test]
    fn nothing_and_what_is_no_number_overlap_nothing() {
        assert_eq!(overlap(&[0.0; 4], &[0.0; 4]), 0.0);
        assert_eq!(overlap(&[], &[]), 0.0);
        assert_eq!(overlap(&[f32::NAN, 2.0], &[1.0, 1.0]), 0.5);
    }
}
