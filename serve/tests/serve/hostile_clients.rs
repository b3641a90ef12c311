//! Hostile or broken clients do not keep other clients from being served.

use std::io::{Read, Write};
use std::net::TcpStream;
use std::time::{Duration, Instant};

use super::{Server, is};

/// After this time the server should have dropped the client, however busy the machine is.
const LIMIT: Duration = Duration::from_secs(60);

/// Simultaneous connections.
const MANY: usize = 1000;

/// Opens a connection that sends `sent` and nothing more.
fn silent(server: &Server, sent: &str) -> TcpStream {
    let mut stream = TcpStream::connect(&server.address).expect("it listens");
    stream.write_all(sent.as_bytes()).expect("it listens");
    stream.set_read_timeout(Some(LIMIT)).expect("a time");
    stream
}

/// Asserts that a well-behaved client is served.
fn assert_served(server: &Server) {
    let (head, body) = server.get("/main.js", &[]);
    assert!(is(&head, 200) && !body.is_empty(), "{head}");
}

#[test]
fn a_thousand_idle_connections_block_nobody() {
    let server = Server::with(&["--patience", "60000"]);
    // As many connections as the system lets this process open.
    let mut clients = Vec::new();
    while clients.len() < MANY {
        let Ok(mut stream) = TcpStream::connect(&server.address) else { break };
        let sent: &[u8] = if clients.len() % 2 == 0 { b"GET / HTTP/1.1\r\nHost: 127" } else { b"" };
        stream.write_all(sent).expect("it listens");
        clients.push(stream);
    }
    assert!(clients.len() >= MANY / 2, "only {} connections could be opened", clients.len());
    assert_served(&server);
}

#[test]
fn an_idle_connection_is_closed() {
    let server = Server::with(&["--patience", "1"]);
    let kept_alive = "GET /main.js HTTP/1.1\r\nHost: localhost\r\n\r\n";
    for sent in ["", "GET / HTTP/1.1\r\nHost: 127", kept_alive] {
        let closed = silent(&server, sent).read_to_end(&mut Vec::new());
        assert!(closed.is_ok(), "{sent:?}: {closed:?}");
    }
}

#[test]
fn a_head_that_arrives_slowly_is_given_up() {
    let server = Server::with(&["--patience", "1"]);
    let mut stream = silent(&server, "GET / HTTP/1.1\r\n");
    let start = Instant::now();
    while stream.write_all(b"a: b\r\n").is_ok() {
        assert!(start.elapsed() < LIMIT, "it still waits");
        std::thread::sleep(Duration::from_millis(100));
    }
    assert_served(&server);
}

#[cfg(target_os = "linux")]
#[test]
fn a_response_that_nobody_reads_is_given_up() {
    let server = Server::with(&["--patience", "5"]);
    let (_stream, _) = server.download();
    let files = format!("/proc/{}/fd", server.child.id());
    let is_open = || {
        let mut files = std::fs::read_dir(&files).expect("a process");
        files.any(|file| file.and_then(|file| file.path().read_link()).is_ok_and(|path| path.ends_with(super::LARGE)))
    };
    assert!(is_open(), "the download has not started");
    let start = Instant::now();
    while is_open() {
        assert!(start.elapsed() < LIMIT, "it still waits");
        std::thread::sleep(Duration::from_millis(100));
    }
    assert_served(&server);
}

#[test]
fn a_head_that_is_too_large_is_refused() {
    let server = Server::start();
    for head in [
        format!("GET / HTTP/1.1\r\nHost: localhost\r\na: {}\r\n\r\n", "b".repeat(1 << 20)),
        format!("GET / HTTP/1.1\r\nHost: localhost\r\n{}\r\n", "a: b\r\n".repeat(10_000)),
        format!("GET /{} HTTP/1.1\r\nHost: localhost\r\n\r\n", "a".repeat(1 << 20)),
        "\0".repeat(1 << 20),
    ] {
        let mut stream = silent(&server, "");
        // The server may close the connection before it has read the whole head.
        let _ = stream.write_all(head.as_bytes());
        let mut answer = Vec::new();
        let _ = stream.read_to_end(&mut answer);
        let answer = String::from_utf8_lossy(&answer);
        assert!(answer.is_empty() || answer.starts_with("HTTP/1.1 4"), "{answer}");
    }
    assert_served(&server);
}
