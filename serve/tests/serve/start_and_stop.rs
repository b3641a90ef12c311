//! Reasons to refuse to start, and ways to stop.

use std::io::Read;
use std::net::{TcpListener, TcpStream};
use std::process::Command;
use std::time::{Duration, Instant};

use super::{Server, assert_refused, is};

#[test]
fn a_taken_port_is_refused_with_the_remedy() {
    let server = Server::start();
    let (page, assets) = (server.folder.path().join("page"), server.folder.path().join("assets"));
    let folders = ["--dir", page.to_str().expect("UTF-8"), "--assets", assets.to_str().expect("UTF-8")];
    let args = [&["--port", server.port()][..], &folders].concat();
    assert_refused(&args, &format!("port {} is in use by another program: choose another", server.port()));
}

#[test]
fn a_folder_that_is_not_there_is_refused_in_words() {
    assert_refused(&["--dir", "no/such/folder"], "cannot serve no/such/folder");
}

#[test]
fn an_ipv6_address_may_be_in_brackets() {
    if TcpListener::bind("[::1]:0").is_err() {
        // Without IPv6, the text must still be parsed as an address.
        return assert_refused(&["--dir", ".", "--assets", ".", "--port", "0", "--host", "[::1]"], "os error");
    }
    let server = Server::with(&["--host", "[::1]"]);
    assert!(server.address.starts_with("[::1]:"), "{}", server.address);
    assert!(is(&server.get("/main.js", &[]).0, 200));
}

#[test]
fn a_server_on_all_addresses_prints_one_that_opens_and_answers_to_any_name() {
    let server = Server::with(&["--host", "0.0.0.0"]);
    assert!(server.address.starts_with("127.0.0.1:"), "{}", server.address);
    assert!(is(&server.send("/main.js", &["Host: any.example"]).0, 200));
    if TcpListener::bind("[::1]:0").is_ok() {
        let server = Server::with(&["--host", "::"]);
        assert!(server.address.starts_with("[::1]:"), "{}", server.address);
    }
}

/// Sends a signal to the server.
#[cfg(unix)]
pub fn signal(server: &Server, name: &str) {
    let sent = Command::new("kill").args([name, &server.child.id().to_string()]).status().expect("kill runs");
    assert!(sent.success());
}

#[cfg(unix)]
#[test]
fn signals_end_it_without_an_error() {
    for name in ["-INT", "-TERM"] {
        let mut server = Server::start();
        let kept = TcpStream::connect(&server.address).expect("it listens");
        signal(&server, name);
        assert_eq!(server.child.wait().expect("the binary ends").code(), Some(0), "{name}");
        drop(kept);
    }
}

#[cfg(unix)]
#[test]
fn open_requests_are_finished_first() {
    let mut server = Server::start();
    let (mut stream, size) = server.download();
    signal(&server, "-TERM");
    // The server stops listening when it handles the signal.
    while TcpStream::connect(&server.address).is_ok() {}
    let mut rest = Vec::new();
    stream.read_to_end(&mut rest).expect("the rest");
    assert!(rest.len() > size - 100, "{} of {size} bytes", rest.len());
    assert_eq!(server.child.wait().expect("the binary ends").code(), Some(0));
}

#[cfg(unix)]
#[test]
fn an_open_request_delays_the_end_for_a_limited_time() {
    // The client's time limit must not end the server.
    let mut server = Server::with(&["--patience", "60000"]);
    let (stream, _) = server.download();
    signal(&server, "-TERM");
    let start = Instant::now();
    let code = loop {
        if let Some(status) = server.child.try_wait().expect("a child") {
            break status.code();
        }
        assert!(start.elapsed() < Duration::from_secs(60), "it still runs");
        std::thread::sleep(Duration::from_millis(50));
    };
    assert_eq!(code, Some(0));
    drop(stream);
}
