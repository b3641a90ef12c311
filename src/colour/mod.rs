//! The colours of scenes and of maps, the same on the page and in the figures.
//!
//! `palette` has those of the roles and of the paper, `maps` those of the maps. Used by `web` and `commands`.

pub mod imagined_maps;
pub mod palette;
