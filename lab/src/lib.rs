//! The research behind Pathlight: plain functions on plain settings, which report their progress through a trait.
//!
//! No module prints or takes arguments; `main.rs` and `commands/` do. The modules in order, each using only
//! those above it (`tests/architecture` checks that):
//!
//! | module | holds |
//! | --- | --- |
//! | `progress` | what a long piece of work tells whoever started it |
//! | `files` | journals that can be continued, JSON, weights |
//! | `data` | what nets learn from: solutions, labelled balls, random scenes |
//! | `training` | the training runs of all nets, and publishing their weights |
//! | `measure` | agents, forecasts and chances on test tasks; the simulator beside PHYRE's |
//! | `reproduce` | the results: the recipe of each row, and the table |
//! | `figures` | the results as SVG |

pub mod data;
pub mod figures;
pub mod files;
pub mod measure;
pub mod progress;
pub mod reproduce;
pub mod training;
