//! The commands that have moved to the lab's binary.

use std::ffi::OsStr;

/// Old names, and what follows `pathlight-lab` now.
const MOVED: [(&str, &str); 17] = [
    ("collect", "data collect"),
    ("label", "data label"),
    ("merge", "data merge"),
    ("difficulty", "data difficulty"),
    ("solve-rates", "data solve-rates"),
    ("train", "train paths"),
    ("train-judge", "train success"),
    ("train-dynamics", "train dynamics"),
    ("train-dqn", "train dqn"),
    ("evaluate", "measure evaluate"),
    ("forecasts", "measure forecasts"),
    ("calibration", "measure calibration"),
    ("fidelity", "measure fidelity"),
    ("reproduce", "reproduce"),
    ("figures", "figures"),
    ("publish", "publish weights"),
    ("publish-results", "publish results"),
];

/// Returns the error that names the new command, if the first argument is the old name of one.
pub fn new_name(command: Option<&OsStr>) -> Option<anyhow::Error> {
    let (old, new) = MOVED.into_iter().find(|(old, _)| command.is_some_and(|command| command == *old))?;
    Some(anyhow::anyhow!("`{old}` is now `pathlight-lab {new}`"))
}
