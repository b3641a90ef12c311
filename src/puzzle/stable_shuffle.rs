//! PHYRE's `stable_shuffle`: an order that looks random and depends only on the items and a salt.
//!
//! It determines the numbers of tasks and the folds of the benchmark.

use std::fmt::Display;

use md5::{Digest, Md5};

/// Sorts items by the MD5 of their text followed by the salt.
pub fn stable_shuffle<T: Display>(mut items: Vec<T>, salt: &str) -> Vec<T> {
    items.sort_by_cached_key(|item| <[u8; 16]>::from(Md5::digest(format!("{item}{salt}"))));
    items
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_are_ordered_by_the_md5_of_their_digits() {
        assert_eq!(stable_shuffle((0..10).collect(), ""), [6, 9, 7, 4, 1, 2, 8, 0, 5, 3]);
        let twenty = [6, 19, 9, 11, 18, 17, 7, 15, 4, 14, 12, 1, 13, 16, 2, 8, 0, 10, 5, 3];
        assert_eq!(stable_shuffle((0..20).collect(), ""), twenty);
    }
}
