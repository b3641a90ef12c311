//! Files that are written completely or not at all.

use std::fs;
use std::path::Path;

use anyhow::Context;

/// Writes a file, and its folder if that is missing. A file that is there already stays as it is until the new one is
/// complete. A device, a pipe or a link, which are not to be replaced, is written to.
///
/// # Errors
/// If it cannot be written; then nothing has changed.
pub fn replace_file(path: &Path, bytes: &[u8]) -> anyhow::Result<()> {
    let failed = || format!("cannot write {}", path.display());
    if fs::symlink_metadata(path).is_ok_and(|found| !found.is_file() && !found.is_dir()) {
        return fs::write(path, bytes).with_context(failed);
    }
    let mut part = path.as_os_str().to_owned();
    part.push(".part");
    let folder = path.parent().map_or(Ok(()), fs::create_dir_all);
    let written = folder.and_then(|()| fs::write(&part, bytes)).and_then(|()| fs::rename(&part, path));
    if written.is_err() {
        // On a full disk it would take the last room.
        let _ = fs::remove_file(&part);
    }
    written.with_context(failed)
}

#[cfg(all(test, unix))]
mod tests {
    use super::*;

    #[test]
    fn links_and_devices_are_written_to_and_a_file_replaced() {
        let folder = tempfile::tempdir().expect("a folder");
        let [device, link, file] = ["device", "link", "new/file"].map(|name| folder.path().join(name));
        std::os::unix::fs::symlink("/dev/null", &device).expect("a link");
        std::os::unix::fs::symlink(&file, &link).expect("a link");
        replace_file(&device, b"lost").expect("written");
        assert!(device.is_symlink() && !device.is_file());
        for bytes in [b"one".as_slice(), b"other"] {
            replace_file(&file, bytes).expect("written");
            assert_eq!(fs::read(&file).expect("a file"), bytes);
        }
        replace_file(&link, b"through the link").expect("written");
        assert!(link.is_symlink());
        assert_eq!(fs::read(&file).expect("a file"), b"through the link");
    }
}
