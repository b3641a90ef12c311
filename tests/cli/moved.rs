//! The commands that are now those of `pathlight-lab`: whoever types an old name is told the new one.

use super::assert_refused;

#[test]
fn an_old_name_is_answered_with_the_new_one() {
    let moved = [
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
    for (old, new) in moved {
        for args in [&[old][..], &[old, "--setup", "within"], &[old, "--help"]] {
            assert_refused(args, &format!("error: `{old}` is now `pathlight-lab {new}`\n"));
        }
    }
    assert_refused(&["agent", "--agent", "train", "--weights", "none"], "invalid value 'train'");
}
