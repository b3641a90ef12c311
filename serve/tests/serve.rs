//! The server by its own binary, `pathlight-serve`: the files and headers a browser receives, and what is refused.

use std::fs;
use std::io::{BufRead, BufReader, Read, Write};
use std::net::TcpStream;
use std::process::{Child, Command, Stdio};

use tempfile::{TempDir, tempdir};

mod strangers;

/// The binary, without arguments yet.
fn pathlight_serve() -> Command {
    Command::new(env!("CARGO_BIN_EXE_pathlight-serve"))
}

/// Asserts that a start is refused: nothing on standard output, an error that contains these words, exit code 2.
fn assert_refused(args: &[&str], words: &str) {
    let output = pathlight_serve().args(args).output().expect("the binary starts");
    let said = String::from_utf8(output.stderr).expect("messages are UTF-8");
    assert_eq!((output.status.code(), &output.stdout[..]), (Some(2), &b""[..]), "{args:?}: {said}");
    assert!(said.contains("error: ") && said.contains(words), "{args:?} said {said:?} without {words:?}");
}

/// A server of temporary folders on a free port; ends with the test.
struct Server {
    child: Child,
    /// `127.0.0.1:PORT`
    address: String,
    folder: TempDir,
}

/// Makes a folder as `make play` serves it: `www` and `assets`.
fn page() -> TempDir {
    let folder = tempdir().expect("a folder");
    let root = folder.path();
    for inner in ["www/pkg", "assets"] {
        fs::create_dir_all(root.join(inner)).expect("a folder");
    }
    fs::write(root.join("www/index.html"), "<!doctype html><title>page</title>".repeat(10)).expect("a file");
    fs::write(root.join("www/main.js"), "// script\n".repeat(100)).expect("a file");
    fs::write(root.join("www/style.css"), "a { color: red }").expect("a file");
    fs::write(root.join("www/pkg/pathlight_bg.wasm"), [b'w'; 100_000]).expect("a file");
    fs::write(root.join("assets/weights.safetensors"), [b's'; 5_000]).expect("a file");
    fs::write(root.join("secret.txt"), "secret").expect("a file");
    folder
}

impl Server {
    fn start() -> Server {
        Server::with(&[])
    }

    /// Starts it with these arguments.
    fn with(args: &[&str]) -> Server {
        Server::serving(page(), args)
    }

    /// Starts it in a folder.
    fn serving(folder: TempDir, args: &[&str]) -> Server {
        let mut child = pathlight_serve()
            .args(["--port", "0"])
            .args(args)
            .current_dir(folder.path())
            .stdout(Stdio::piped())
            .spawn()
            .expect("the binary starts");
        let mut line = String::new();
        BufReader::new(child.stdout.as_mut().expect("piped")).read_line(&mut line).expect("a line");
        let address = line.split("http://").nth(1).and_then(|rest| rest.split('/').next());
        let address = address.unwrap_or_else(|| panic!("no address in {line:?}")).to_string();
        Server { child, address, folder }
    }

    /// Returns head and body of the response; `path` is sent unchanged, `headers` are whole lines.
    fn get(&self, path: &str, headers: &[&str]) -> (String, Vec<u8>) {
        let mut stream = TcpStream::connect(&self.address).expect("it listens");
        let headers: String = headers.iter().map(|header| format!("{header}\r\n")).collect();
        write!(stream, "GET {path} HTTP/1.1\r\nHost: {}\r\nConnection: close\r\n{headers}\r\n", self.address)
            .expect("it listens");
        let mut answer = Vec::new();
        stream.read_to_end(&mut answer).expect("an answer");
        let end = answer.windows(4).position(|four| four == b"\r\n\r\n").expect("the end of the head");
        (String::from_utf8(answer[..end].to_vec()).expect("ASCII").to_lowercase(), answer[end + 4..].to_vec())
    }

    fn port(&self) -> &str {
        self.address.rsplit(':').next().expect("a port")
    }
}

impl Drop for Server {
    fn drop(&mut self) {
        let _ = self.child.kill();
        let _ = self.child.wait();
    }
}

fn is(head: &str, status: u16) -> bool {
    head.starts_with(&format!("http/1.1 {status} "))
}

fn value<'a>(head: &'a str, name: &str) -> Option<&'a str> {
    head.lines().find_map(|line| line.strip_prefix(name)?.strip_prefix(": "))
}

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
    let www = server.folder.path().join("www");
    std::os::unix::fs::symlink("../secret.txt", www.join("out.txt")).expect("a link");
    std::os::unix::fs::symlink("..", www.join("up")).expect("a link");
    std::os::unix::fs::symlink("main.js", www.join("in.js")).expect("a link");
    assert!(is(&server.get("/out.txt", &[]).0, 404));
    assert!(is(&server.get("/up/secret.txt", &[]).0, 404));
    assert!(is(&server.get("/in.js", &[]).0, 200));
}

#[test]
fn wasm_comes_compressed_and_weights_with_their_length() {
    let server = Server::start();
    for encoding in ["br", "gzip"] {
        let accept = format!("Accept-Encoding: {encoding}");
        let (head, body) = server.get("/pkg/pathlight_bg.wasm", &[&accept]);
        assert_eq!(value(&head, "content-encoding"), Some(encoding));
        assert!(body.len() < 10_000, "{} bytes", body.len());
        let (head, body) = server.get("/assets/weights.safetensors", &[&accept]);
        assert_eq!(value(&head, "content-encoding"), None);
        assert_eq!((value(&head, "content-length"), body.len()), (Some("5000"), 5000));
    }
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

#[test]
fn a_browser_asks_again_and_gets_what_changed() {
    let server = Server::start();
    let (head, _) = server.get("/main.js", &[]);
    assert_eq!(value(&head, "cache-control"), Some("no-cache"));
    let known = format!("If-None-Match: {}", value(&head, "etag").expect("an ETag"));
    assert!(is(&server.get("/main.js", &[&known]).0, 304));
    fs::write(server.folder.path().join("www/main.js"), "// rebuilt").expect("a file");
    let (head, body) = server.get("/main.js", &[&known]);
    assert!(is(&head, 200), "{head}");
    assert_eq!(body, b"// rebuilt");
}

#[test]
fn names_of_other_machines_are_refused_with_the_remedy_unless_they_are_allowed() {
    let asked = |server: &Server, host: &str| {
        let mut stream = TcpStream::connect(&server.address).expect("it listens");
        write!(stream, "GET /main.js HTTP/1.1\r\nConnection: close\r\n{host}\r\n").expect("it listens");
        let mut answer = String::new();
        stream.read_to_string(&mut answer).expect("an answer");
        answer.to_lowercase()
    };
    let server = Server::start();
    for host in ["Host: localhost\r\n", "Host: [::1]:1\r\n"] {
        assert!(is(&asked(&server, host), 200), "{host}");
    }
    for host in ["Host: evil.example\r\n", "Host: play.example\r\n", "Host: \r\n", ""] {
        let answer = asked(&server, host);
        assert!(
            is(&answer, 421) && answer.contains("--allow-host") && answer.contains("default-src 'self'"),
            "{host}: {answer}"
        );
    }
    assert!(is(&asked(&Server::with(&["--allow-host", "play.example"]), "Host: play.example\r\n"), 200));
}

#[test]
fn a_taken_port_is_refused_with_the_remedy() {
    let server = Server::start();
    let (www, assets) = (server.folder.path().join("www"), server.folder.path().join("assets"));
    let folders = ["--dir", www.to_str().expect("UTF-8"), "--assets", assets.to_str().expect("UTF-8")];
    let args = [&["--port", server.port()][..], &folders].concat();
    assert_refused(&args, &format!("port {} is in use by another program: choose another", server.port()));
}

#[test]
fn a_folder_that_is_not_there_is_refused_in_words() {
    assert_refused(&["--dir", "no/such/folder"], "cannot serve no/such/folder");
}

#[cfg(unix)]
#[test]
fn ctrl_c_ends_it_without_an_error() {
    let mut server = Server::start();
    let kept = TcpStream::connect(&server.address).expect("it listens");
    let sent = Command::new("kill").args(["-INT", &server.child.id().to_string()]).status().expect("kill runs");
    assert!(sent.success());
    assert_eq!(server.child.wait().expect("the binary ends").code(), Some(0));
    drop(kept);
}
