//! The research behind Pathlight: functions that take plain settings and report their progress through a trait.
//!
//! No module prints or parses arguments; `main.rs` and `commands/` do. Each module uses only those above it, which
//! `tests/architecture` checks:
//!
//! | module | holds |
//! | --- | --- |
//! | `progress` | the trait that receives the progress of long work |
//! | `files` | journals that can be continued, JSON, weights |
//! | `data` | training data: solutions, labelled balls, random scenes |
//! | `training` | the training runs of all nets, and publishing their weights |
//! | `measure` | measurements of agents, forecasts and chances on test tasks, and of the simulator against PHYRE's |
//! | `reproduce` | the results: the recipe of each row, and the table |
//! | `figures` | the results as SVG |

pub mod data;
pub mod figures;
pub mod files;
pub mod measure;
pub mod progress;
pub mod reproduce;
pub mod training;
