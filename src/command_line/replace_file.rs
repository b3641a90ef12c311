//! Files that are written completely or not at all; used by the lab too.

use std::fs;
use std::io::{self, Write};
use std::path::{Path, PathBuf};

use anyhow::Context;
use tempfile::{Builder, NamedTempFile};

/// Writes a file, and creates its folder if necessary. Symbolic links are followed and kept, even if they lead to no
/// file yet. An existing file stays as it is until the new one is complete and on disk. A device or a pipe is written
/// to directly.
///
/// # Errors
///
/// If the file cannot be written. It is then unchanged.
pub fn replace_file(path: &Path, bytes: &[u8]) -> anyhow::Result<()> {
    let written = if is_special(path) { fs::write(path, bytes) } else { replace(path, bytes) };
    written.with_context(|| cannot_write(path))
}

/// Checks that a file can be written, before the work that produces its content. Creates its folder if necessary.
///
/// # Errors
///
/// If the file cannot be written.
pub fn check_replaceable(path: &Path) -> anyhow::Result<()> {
    let checked = match path.is_dir() {
        true => Err(io::ErrorKind::IsADirectory.into()),
        false if is_special(path) => Ok(()),
        false => without_links(path).and_then(|target| temporary_file(&target)).map(drop),
    };
    checked.with_context(|| cannot_write(path))
}

/// Returns the file that a path leads to, whether or not it exists.
///
/// # Errors
///
/// If symbolic links form a loop.
pub fn without_links(path: &Path) -> io::Result<PathBuf> {
    /// The number of links that Linux follows.
    const LINKS: usize = 40;
    let mut target = path.to_path_buf();
    for _ in 0..LINKS {
        let Ok(next) = fs::read_link(&target) else { return Ok(fs::canonicalize(&target).unwrap_or(target)) };
        target = target.parent().unwrap_or(Path::new("")).join(next);
    }
    Err(io::Error::other("its symbolic links form a loop"))
}

fn cannot_write(path: &Path) -> String {
    format!("cannot write {}: name a file in a writable folder", path.display())
}

/// Returns whether the path is a device or a pipe.
fn is_special(path: &Path) -> bool {
    fs::metadata(path).is_ok_and(|found| !found.is_file() && !found.is_dir())
}

/// Creates a temporary file next to another file.
fn temporary_file(path: &Path) -> io::Result<NamedTempFile> {
    let folder = path.parent().filter(|folder| !folder.as_os_str().is_empty()).unwrap_or(Path::new("."));
    fs::create_dir_all(folder)?;
    let mut builder = Builder::new();
    // The permissions with which programs usually create files. A temporary file is otherwise private to its owner.
    #[cfg(unix)]
    builder.permissions(std::os::unix::fs::PermissionsExt::from_mode(0o666));
    builder.prefix(".part-").tempfile_in(folder)
}

fn replace(path: &Path, bytes: &[u8]) -> io::Result<()> {
    let path = without_links(path)?;
    let mut part = temporary_file(&path)?;
    if let Ok(existing) = fs::metadata(&path) {
        part.as_file().set_permissions(existing.permissions())?;
    }
    part.write_all(bytes)?;
    part.as_file().sync_all()?;
    part.persist(path)?;
    Ok(())
}

#[cfg(all(test, unix))]
mod tests {
    use std::os::unix::fs::{MetadataExt, PermissionsExt};

    use super::*;

    #[test]
    fn links_and_devices_are_written_to_and_a_file_replaced() {
        let folder = tempfile::tempdir().expect("a folder");
        let [device, link, file] = ["device", "link", "new/file"].map(|name| folder.path().join(name));
        std::os::unix::fs::symlink("/dev/null", &device).expect("a link");
        std::os::unix::fs::symlink(&file, &link).expect("a link");
        replace_file(&device, b"lost").expect("written");
        assert!(device.is_symlink() && !device.is_file());
        for bytes in [b"first".as_slice(), b"second"] {
            replace_file(&file, bytes).expect("written");
            assert_eq!(fs::read(&file).expect("a file"), bytes);
        }
        replace_file(&link, b"through the link").expect("written");
        assert!(link.is_symlink());
        assert_eq!(fs::read(&file).expect("a file"), b"through the link");
        fs::remove_file(&file).expect("removed");
        replace_file(&link, b"through the link").expect("written");
        assert!(link.is_symlink());
        assert_eq!(fs::read(&file).expect("a file"), b"through the link");
        let [there, back] = ["there", "back"].map(|name| folder.path().join(name));
        std::os::unix::fs::symlink("there", &back).expect("a link");
        std::os::unix::fs::symlink("back", &there).expect("a link");
        replace_file(&there, b"").expect_err("a circle");
        assert!(there.is_symlink() && back.is_symlink());
    }

    #[test]
    fn a_file_has_the_mode_of_other_new_files_or_its_own_and_nothing_is_left_beside_it() {
        let folder = tempfile::tempdir().expect("a folder");
        let [ours, other] = ["ours", "other"].map(|name| folder.path().join(name));
        fs::write(&other, b"").expect("written");
        replace_file(&ours, b"").expect("written");
        let mode = |path: &Path| fs::metadata(path).expect("a file").mode();
        assert_eq!(mode(&ours), mode(&other));
        fs::set_permissions(&ours, PermissionsExt::from_mode(0o600)).expect("a mode");
        replace_file(&ours, b"again").expect("written");
        assert_eq!(mode(&ours) & 0o777, 0o600);
        fs::create_dir(folder.path().join("taken")).expect("a folder");
        replace_file(&folder.path().join("taken"), b"").expect_err("a folder is not replaced");
        check_replaceable(&folder.path().join("taken")).expect_err("a folder is not replaced");
        check_replaceable(&ours).expect("a file can be replaced");
        check_replaceable(&folder.path().join("none")).expect("a file can be made");
        assert_eq!(fs::read_dir(folder.path()).expect("a folder").count(), 3);
    }
}
