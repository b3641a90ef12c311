//! The commands that are now those of `pathlight-lab`: whoever types an old name is told the new one.

use super::assert_refused;

#[test]
fn an_old_name_is_answered_with_the_new_one() {
    let moved = [("train-judge", "train success"), ("figures", "figures"), ("publish-results", "publish results")];
    for (old, new) in moved {
        for args in [&[old][..], &[old, "--setup", "within"], &[old, "--help"]] {
            assert_refused(args, &format!("error: `{old}` is now `pathlight-lab {new}`\n"));
        }
    }
    assert_refused(&["agent", "--agent", "train", "--weights", "none"], "invalid value 'train'");
}
