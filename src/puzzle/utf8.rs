//! Decodes text that people saved, in a file or in a line of one. All code that reads such bytes starts here.

/// Why bytes are not text.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
#[allow(missing_docs, reason = "the messages say it")]
pub enum NotUtf8 {
    #[error("this is UTF-16: save it as UTF-8")]
    Utf16,
    #[error("this is not UTF-8: save it as UTF-8")]
    Other,
}

/// Decodes UTF-8, without the byte order mark that some editors write.
///
/// # Errors
///
/// If the bytes are not UTF-8. The error distinguishes UTF-16, which PowerShell 5 writes, with or without a byte order
/// mark.
pub fn utf8(bytes: &[u8]) -> Result<&str, NotUtf8> {
    let is_utf16 = match *bytes {
        [0xff, 0xfe, ..] | [0xfe, 0xff, ..] => true,
        // JSON begins with two ASCII characters. A line that was cut after one byte of a newline begins with the other
        // byte.
        [a, b, c, d, ..] => (a == 0) == (c == 0) && (b == 0) == (d == 0) && (a == 0) != (b == 0),
        _ => false,
    };
    if is_utf16 {
        return Err(NotUtf8::Utf16);
    }
    let text = std::str::from_utf8(bytes).map_err(|_| NotUtf8::Other)?;
    Ok(text.strip_prefix('\u{feff}').unwrap_or(text))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_byte_order_mark_is_skipped_and_other_encodings_are_named() {
        for text in ["", "{", "{}", "{\"name\":\"Über\"}", "\u{feff}", "\u{feff}{}", "\0", "a\0b", "\0\0\0\0"] {
            assert_eq!(utf8(text.as_bytes()), Ok(text.trim_start_matches('\u{feff}')));
        }
        let text = "{\"name\":\"Über\"}\n{}";
        for text in [text.to_string(), format!("\u{feff}{text}")] {
            let units = || text.encode_utf16();
            let little: Vec<u8> = units().flat_map(u16::to_le_bytes).collect();
            let big: Vec<u8> = units().flat_map(u16::to_be_bytes).collect();
            for bytes in [little, big] {
                for line in bytes.split(|&byte| byte == b'\n') {
                    assert_eq!(utf8(line), Err(NotUtf8::Utf16), "{line:?}");
                }
            }
        }
        // Windows-1252, and truncated UTF-8.
        for bytes in [b"{\"name\":\"\xdcber\"}".as_slice(), b"\xef\xbb", b"\xff"] {
            assert_eq!(utf8(bytes), Err(NotUtf8::Other), "{bytes:?}");
        }
    }
}
