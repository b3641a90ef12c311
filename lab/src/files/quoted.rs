//! Paths in printed commands, so that they can be copied into a shell.

use std::path::Path;

/// Returns a path as one word of a shell command: in single quotes if it has characters that a shell may interpret.
pub fn quoted(path: &Path) -> String {
    let path = path.display().to_string();
    let is_plain = |character: char| character.is_alphanumeric() || "/._-+:@%".contains(character);
    if !path.is_empty() && path.chars().all(is_plain) { path } else { format!("'{}'", path.replace('\'', r"'\''")) }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_a_shell_may_interpret_is_quoted() {
        for (path, word) in [("target/a-1.json", "target/a-1.json"), ("my files", "'my files'"), ("it's", r"'it'\''s'")]
        {
            assert_eq!(quoted(Path::new(path)), word);
        }
    }
}
