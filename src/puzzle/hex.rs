//! Bytes as hexadecimal text.

/// Returns bytes in hexadecimal, lower case.
pub fn hex(bytes: impl AsRef<[u8]>) -> String {
    bytes.as_ref().iter().map(|byte| format!("{byte:02x}")).collect()
}
