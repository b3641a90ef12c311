//! The colours of scenes and of maps, the same on the page and in the figures.
//!
//! `palette` has those of the roles and of the paper, `imagined_maps` those of the maps, `outcomes` those of the map of
//! all solutions. Used by `nets`, `web` and the figures of the lab.

pub mod imagined_maps;
pub mod outcomes;
pub mod palette;
