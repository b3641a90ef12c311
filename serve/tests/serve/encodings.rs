//! Precompressed files and caching.

use std::fs;

use super::{Server, is, value};

#[test]
fn a_browser_asks_again_and_gets_what_changed() {
    let server = Server::start();
    let (head, _) = server.get("/main.js", &[]);
    assert_eq!(value(&head, "cache-control"), Some("no-cache"));
    let known = format!("If-None-Match: {}", value(&head, "etag").expect("an ETag"));
    assert!(is(&server.get("/main.js", &[&known]).0, 304));
    fs::write(server.folder.path().join("page/main.js"), "// rebuilt").expect("a file");
    let (head, body) = server.get("/main.js", &[&known]);
    assert!(is(&head, 200), "{head}");
    assert_eq!(body, b"// rebuilt");
}

/// Writes placeholders for the compressed versions of a file next to it.
fn compress(server: &Server, path: &str) {
    for encoding in ["br", "gz"] {
        let path = server.folder.path().join(format!("{path}.{encoding}"));
        fs::write(path, format!("{encoding} form")).expect("a file");
    }
}

#[test]
fn files_are_sent_as_they_lie_compressed_beside_them() {
    let server = Server::start();
    for (path, file) in [
        ("/", "page/index.html"),
        ("/main.js", "page/main.js"),
        ("/pkg/pathlight_bg.wasm", "page/pkg/pathlight_bg.wasm"),
        ("/assets/weights.safetensors", "assets/weights.safetensors"),
    ] {
        compress(&server, file);
        let (plain, _) = server.get(path, &[]);
        assert_eq!(value(&plain, "content-encoding"), None, "{path}");
        for (accepted, encoding, form) in [
            ("gzip, deflate, br", "br", "br form"),
            ("gzip, deflate", "gzip", "gz form"),
            ("gzip, br;q=0", "gzip", "gz form"),
        ] {
            let (head, body) = server.get(path, &[&format!("Accept-Encoding: {accepted}")]);
            assert!(is(&head, 200), "{path}: {head}");
            assert_eq!(value(&head, "content-encoding"), Some(encoding), "{path} for {accepted}");
            assert_eq!(String::from_utf8_lossy(&body), form, "{path} for {accepted}");
            assert_eq!(value(&head, "content-length"), Some("7"), "{path}");
            assert_eq!(value(&head, "content-type"), value(&plain, "content-type"), "{path}");
            assert_eq!(value(&head, "vary"), Some("accept-encoding"), "{path}");
        }
    }
}

#[test]
fn nothing_is_compressed_for_a_request() {
    let server = Server::start();
    for encoding in ["br", "gzip"] {
        let (head, body) = server.get("/main.js", &[&format!("Accept-Encoding: {encoding}")]);
        assert_eq!(value(&head, "content-encoding"), None, "{head}");
        assert_eq!(body.len(), 1000);
    }
}

#[test]
fn each_encoding_has_its_own_etag() {
    let server = Server::start();
    compress(&server, "page/main.js");
    fs::write(server.folder.path().join("page/main.js.gz"), "another length").expect("a file");
    let encodings = ["identity", "gzip", "br"].map(|encoding| format!("Accept-Encoding: {encoding}"));
    let etags = encodings.each_ref().map(|accept| {
        let (head, _) = server.get("/main.js", &[accept]);
        value(&head, "etag").expect("an ETag").to_string()
    });
    for (etag, own) in etags.iter().zip(&encodings) {
        for accept in &encodings {
            let (head, _) = server.get("/main.js", &[accept, &format!("If-None-Match: {etag}")]);
            let expected = if accept == own { 304 } else { 200 };
            assert!(is(&head, expected), "{etag} of {own} for {accept}: {head}");
            assert_eq!(value(&head, "vary"), Some("accept-encoding"), "{head}");
        }
    }
}
