//! Measurements: agents, forecasts and chances on the test tasks of a fold, forecasts and chances in scenes of other
//! kinds, and the simulator beside PHYRE's.

pub mod agents;
pub mod calibration;
pub mod carried;
pub mod evaluate;
pub mod fidelity;
pub mod fold_reports;
pub mod forecasts;
pub mod measured_scenes;
pub mod paper_table;
pub mod publish_results;
pub mod report;
pub mod shipped;
pub mod task_set;
