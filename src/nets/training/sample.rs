//! What the four nets learn from.

use crate::raster::{Bitmap, CHANNELS};

/// The images of a scene and a ball that solves it: 9 of 512 bytes.
#[derive(Clone, Debug, PartialEq)]
pub struct Sample {
    /// Input of the nets: green object, blue goal, purple goal, gray, black.
    pub scene: [Bitmap; CHANNELS],
    /// Target maps: base path, target path, action path, placement.
    pub targets: [Bitmap; 4],
}
