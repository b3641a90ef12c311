//! The colours of scenes and of maps, shared by the page and the figures.
//!
//! `palette` holds the colours of the roles and of the background, `imagined_maps` those of the maps, `outcomes` those
//! of the map of all solutions. Used by `nets`, `web` and the lab's figures.

pub mod imagined_maps;
pub mod outcomes;
pub mod palette;
