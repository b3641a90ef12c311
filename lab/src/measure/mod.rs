//! Measurements: agents and chances on the test tasks of a fold, forecasts there or in random scenes, and the fidelity
//! of the simulator to PHYRE's.

pub mod agents;
pub mod calibration;
pub mod evaluate;
pub mod fidelity;
pub mod forecasts;
pub mod measured_scenes;
pub mod publish_results;
pub mod report;
pub mod shipped;
pub mod task_set;
pub mod with_memory;
