//! The files that are served, and their headers.

use std::fs;
#[cfg(unix)]
use std::process::Command;

use super::{Server, assert_refused, is, page, value};

#[test]
fn every_file_has_its_type() {
    let server = Server::start();
    for (path, mime) in [
        ("/", "text/html"),
        ("/main.js", "text/javascript"),
        ("/style.css", "text/css"),
        ("/pkg/pathlight_bg.wasm", "application/wasm"),
        ("/assets/weights.safetensors", "application/octet-stream"),
    ] {
        let (head, body) = server.get(path, &[]);
        assert!(is(&head, 200) && !body.is_empty(), "{path}: {head}");
        assert_eq!(value(&head, "content-type"), Some(mime), "{path}");
    }
}

#[test]
fn every_answer_carries_the_policy() {
    let server = Server::start();
    for path in ["/", "/main.js", "/assets/weights.safetensors", "/nowhere", "/../secret.txt"] {
        let (head, _) = server.get(path, &[]);
        let policy = value(&head, "content-security-policy").unwrap_or_else(|| panic!("{path}: {head}"));
        for rule in [
            "default-src 'self'",
            "script-src 'self' 'wasm-unsafe-eval'",
            "object-src 'none'",
            "base-uri 'none'",
            "form-action 'none'",
            "frame-ancestors 'none'",
        ] {
            assert!(policy.split("; ").any(|part| part == rule), "{path}: {policy}");
        }
        assert!(!policy.contains("unsafe-inline"), "{policy}");
        assert_eq!(value(&head, "x-content-type-options"), Some("nosniff"), "{path}");
    }
}

#[test]
fn only_the_origins_that_are_named_may_frame_the_page() {
    let origins = ["https://school.example", "http://127.0.0.1:8000"];
    let server = Server::with(&[&["--frame-ancestors"], &origins[..]].concat());
    let (head, _) = server.get("/", &[]);
    let policy = value(&head, "content-security-policy").expect("a policy");
    let rule = policy.split("; ").find(|part| part.starts_with("frame-ancestors"));
    assert_eq!(rule, Some("frame-ancestors https://school.example http://127.0.0.1:8000"), "{policy}");
    assert_eq!(policy.matches("frame-ancestors").count(), 1, "{policy}");
}

#[test]
fn what_is_not_an_origin_is_refused() {
    for text in [
        "school.example",
        "https://",
        "https://school.example/",
        "https://a b",
        "https://a; script-src *",
        "*",
        "ftp://a",
    ] {
        assert_refused(&["--frame-ancestors", text], "name a scheme, a host and no path");
    }
}

#[cfg(unix)]
#[test]
fn a_pipe_is_not_there() {
    let server = Server::start();
    let pipe = server.folder.path().join("page/pipe");
    assert!(Command::new("mkfifo").arg(pipe).status().expect("mkfifo runs").success());
    assert!(is(&server.get("/pipe", &[]).0, 404));
}

#[test]
fn what_is_not_a_host_name_is_refused() {
    for text in ["", "https://play.example", "play.example:8080", "[fd00::1]", "play.example/", "*.play.example"] {
        assert_refused(&["--allow-host", text], "without scheme and port");
    }
}

#[test]
fn nothing_outside_the_folders_is_served() {
    let server = Server::start();
    for path in [
        "/../secret.txt",
        "/pkg/../../secret.txt",
        "/%2e%2e/secret.txt",
        "/%2e%2e%2fsecret.txt",
        "/..%2fsecret.txt",
        "/..%5csecret.txt",
        "/%252e%252e/secret.txt",
        "//../secret.txt",
        "/assets/../secret.txt",
        "/assets/../../secret.txt",
        "/assets/%2e%2e/secret.txt",
        "/assets/..%2fsecret.txt",
        "/%00",
        "/index.html/..%2f..%2fsecret.txt",
    ] {
        let (head, body) = server.get(path, &[]);
        assert!(is(&head, 404), "{path}: {head}");
        assert!(!String::from_utf8_lossy(&body).contains("secret"), "{path}");
    }
    let (head, _) = server.get(&format!("/{}", "a".repeat(5000)), &[]);
    assert!(is(&head, 404), "{head}");
}

#[cfg(unix)]
#[test]
fn a_link_that_leads_out_is_not_followed() {
    let server = Server::start();
    let page = server.folder.path().join("page");
    std::os::unix::fs::symlink("../secret.txt", page.join("out.txt")).expect("a link");
    std::os::unix::fs::symlink("..", page.join("up")).expect("a link");
    std::os::unix::fs::symlink("main.js", page.join("in.js")).expect("a link");
    assert!(is(&server.get("/out.txt", &[]).0, 404));
    assert!(is(&server.get("/up/secret.txt", &[]).0, 404));
    assert!(is(&server.get("/in.js", &[]).0, 200));
}

#[test]
fn a_built_page_brings_its_weights_along() {
    let folder = page();
    let dist = folder.path().join("dist");
    fs::create_dir_all(dist.join("assets")).expect("a folder");
    fs::write(dist.join("service-worker.js"), "// worker").expect("a file");
    fs::write(dist.join("assets/weights-0123.safetensors"), "weights").expect("a file");
    let server = Server::serving(folder, &["--dir", "dist"]);
    let (head, body) = server.get("/assets/weights-0123.safetensors", &[]);
    assert!(is(&head, 200), "{head}");
    assert_eq!(body, b"weights");
}
