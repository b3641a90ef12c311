//! Clients that mean harm, or are broken: everybody else is served all the same.

use std::io::{Read, Write};
use std::net::TcpStream;
use std::time::{Duration, Instant};

use super::{Server, is, value};

/// Connections at once.
const MANY: usize = 1000;

/// Longest time in which a well-behaved client is answered beside all others.
const AT_ONCE: Duration = Duration::from_secs(2);

/// Opens a connection that sends no more than this.
fn silent(server: &Server, sent: &str) -> TcpStream {
    let mut stream = TcpStream::connect(&server.address).expect("it listens");
    stream.write_all(sent.as_bytes()).expect("it listens");
    stream.set_read_timeout(Some(Duration::from_secs(20))).expect("a time");
    stream
}

/// Asserts that a browser is served at once; returns the time.
fn assert_served(server: &Server) -> Duration {
    let start = Instant::now();
    let (head, body) = server.get("/main.js", &[]);
    assert!(is(&head, 200) && !body.is_empty(), "{head}");
    assert!(start.elapsed() < AT_ONCE, "after {:?}", start.elapsed());
    start.elapsed()
}

#[test]
fn a_thousand_connections_that_never_ask_are_closed_and_keep_nobody_waiting() {
    let server = Server::with(&["--patience", "2"]);
    // As many as the system lets this process open.
    let start = Instant::now();
    let mut strangers = Vec::new();
    while strangers.len() < MANY {
        let Ok(mut stream) = TcpStream::connect(&server.address) else { break };
        let sent: &[u8] = if strangers.len() % 2 == 0 { b"GET / HTTP/1.1\r\nHost: 127" } else { b"" };
        stream.write_all(sent).expect("it listens");
        strangers.push(stream);
    }
    println!(
        "{} connections in {:?}; then an answer in {:?}",
        strangers.len(),
        start.elapsed(),
        assert_served(&server)
    );
    assert!(strangers.len() >= MANY / 2, "only {} connections could be opened", strangers.len());
    for mut stranger in strangers {
        stranger.set_read_timeout(Some(Duration::from_secs(20))).expect("a time");
        // The end, with or without a word; an error would be the time that is over.
        let closed = stranger.read_to_end(&mut Vec::new());
        let is_closed =
            closed.as_ref().map_or_else(|error| error.kind() == std::io::ErrorKind::ConnectionReset, |_| true);
        assert!(is_closed, "{closed:?}");
    }
    assert_served(&server);
}

#[test]
fn a_head_that_trickles_in_is_not_waited_for() {
    let server = Server::with(&["--patience", "1"]);
    let mut stream = silent(&server, "GET / HTTP/1.1\r\n");
    let start = Instant::now();
    while stream.write_all(b"a: b\r\n").is_ok() {
        assert!(start.elapsed() < Duration::from_secs(10), "it still waits");
        std::thread::sleep(Duration::from_millis(100));
    }
    assert_served(&server);
}

#[test]
fn an_answer_that_nobody_takes_is_given_up() {
    let server = Server::with(&["--patience", "1"]);
    // More than the system keeps for a connection.
    let large = std::fs::File::create(server.folder.path().join("assets/large.safetensors")).expect("a file");
    large.set_len(1 << 30).expect("a sparse file");
    let mut stream = silent(&server, "GET /assets/large.safetensors HTTP/1.1\r\nHost: localhost\r\n\r\n");
    std::thread::sleep(Duration::from_secs(4));
    let mut taken = 0;
    let mut piece = vec![0; 1 << 16];
    while let Ok(length @ 1..) = stream.read(&mut piece) {
        taken += length;
    }
    assert!(taken < 1 << 28, "all {taken} bytes came after all");
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
        let mut stream = TcpStream::connect(&server.address).expect("it listens");
        stream.set_read_timeout(Some(Duration::from_secs(20))).expect("a time");
        // It may close before it has read all.
        let _ = stream.write_all(head.as_bytes());
        let mut answer = Vec::new();
        let _ = stream.read_to_end(&mut answer);
        let answer = String::from_utf8_lossy(&answer);
        assert!(answer.is_empty() || answer.starts_with("HTTP/1.1 4"), "{answer}");
    }
    assert_served(&server);
}

#[test]
fn files_are_only_read() {
    let server = Server::start();
    for method in ["POST", "PUT", "DELETE", "PATCH", "OPTIONS", "TRACE", "CONNECT", "PROPFIND", "X"] {
        let mut stream = TcpStream::connect(&server.address).expect("it listens");
        write!(
            stream,
            "{method} /main.js HTTP/1.1\r\nHost: localhost\r\nConnection: close\r\nContent-Length: 3\r\n\r\nabc"
        )
        .expect("it listens");
        let mut answer = String::new();
        stream.read_to_string(&mut answer).expect("an answer");
        let answer = answer.to_lowercase();
        assert!(is(&answer, 405) || is(&answer, 400), "{method}: {answer}");
        assert!(!answer.contains("// script"), "{method}: {answer}");
    }
    let before = std::fs::read_to_string(server.folder.path().join("www/main.js")).expect("a file");
    assert_eq!(before, "// script\n".repeat(100));
}

#[test]
fn ranges_are_parts_of_the_file_and_never_more_than_it() {
    let server = Server::start();
    let asked = |range: &str| server.get("/assets/weights.safetensors", &[&format!("Range: bytes={range}")]);
    for (range, length, part) in
        [("0-9", 10, "0-9"), ("4990-", 10, "4990-4999"), ("-7", 7, "4993-4999"), ("10-99999", 4990, "10-4999")]
    {
        let (head, body) = asked(range);
        assert!(is(&head, 206) && body.len() == length, "{range}: {head}");
        assert_eq!(value(&head, "content-range"), Some(&*format!("bytes {part}/5000")), "{range}");
    }
    let (many, overlapping) = (vec!["0-0"; 1000].join(","), vec!["0-"; 1000].join(","));
    for range in ["5000-", "9-3", "-0", "x", "18446744073709551615-", "0-18446744073709551616", "", &many, &overlapping]
    {
        let (head, body) = asked(range);
        assert!(is(&head, 416) || is(&head, 400) || is(&head, 200) || is(&head, 206), "{range}: {head}");
        assert!(body.len() <= 5000, "{range}: {} bytes", body.len());
    }
}
