//! The points in which the paper's published code differs from ours, each switched on by its name in PATHLIGHT_SUSPECTS.

use std::sync::OnceLock;

/// Whether a difference is switched on.
pub fn on(name: &str) -> bool {
    static NAMES: OnceLock<Vec<String>> = OnceLock::new();
    let names = NAMES.get_or_init(|| {
        std::env::var("PATHLIGHT_SUSPECTS").unwrap_or_default().split(',').map(str::to_string).collect()
    });
    names.iter().any(|known| known == name)
}
