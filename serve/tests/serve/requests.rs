//! Hosts, methods and ranges of requests, and the access log.

use std::fs;
use std::io::{BufRead, BufReader, Read, Write};
use std::net::{Shutdown, TcpStream};

#[cfg(unix)]
use super::start_and_stop::signal;
use super::{Server, is, value};

#[test]
fn names_of_other_machines_are_refused_with_the_remedy_unless_they_are_allowed() {
    let server = Server::start();
    for host in ["Host: localhost", "Host: [::1]:1"] {
        let (head, _) = server.send("/main.js", &[host]);
        assert!(is(&head, 200), "{host}: {head}");
    }
    for host in ["Host: evil.example", "Host: play.example", "Host: "] {
        let (head, body) = server.send("/main.js", &[host]);
        assert!(is(&head, 421) && head.contains("default-src 'self'"), "{host}: {head}");
        assert!(String::from_utf8_lossy(&body).contains("--allow-host"), "{host}");
    }
    for host in [&[][..], &["--host", "0.0.0.0"]] {
        let server = Server::with(&[&["--allow-host", "play.example"], host].concat());
        for (name, status) in [("play.example", 200), ("10.0.0.1", 200), ("evil.example", 421)] {
            let (head, _) = server.send("/main.js", &[&format!("Host: {name}")]);
            assert!(is(&head, status), "{host:?} {name}: {head}");
        }
    }
}

#[test]
fn a_request_names_exactly_one_host() {
    let server = Server::start();
    let own = &*format!("Host: {}", server.address);
    for headers in [&[][..], &[own, own], &[own, "Host: evil.example"], &["Host: evil.example", own]] {
        let (head, _) = server.send("/main.js", headers);
        assert!(is(&head, 400), "{headers:?}: {head}");
    }
    let (head, _) = server.send("http://evil.example/main.js", &[own]);
    assert!(is(&head, 400), "{head}");
    let (head, _) = server.send("http://evil.example/main.js", &["Host: evil.example"]);
    assert!(is(&head, 421), "{head}");
    let (head, _) = server.send(&format!("http://{}/main.js", server.address), &[own]);
    assert!(is(&head, 200), "{head}");
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
    let before = std::fs::read_to_string(server.folder.path().join("page/main.js")).expect("a file");
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

#[test]
fn a_range_of_a_file_that_has_changed_is_answered_with_the_whole() {
    let server = Server::start();
    let path = "/assets/weights.safetensors";
    let (head, _) = server.get(path, &[]);
    let etag = value(&head, "etag").expect("an ETag").to_string();
    let part = |validator: &str| server.get(path, &["Range: bytes=4990-", &format!("If-Range: {validator}")]);
    let (head, body) = part(&etag);
    assert!(is(&head, 206) && body.len() == 10, "{head}");
    fs::write(server.folder.path().join("assets/weights.safetensors"), [b'n'; 6_000]).expect("a file");
    for validator in [&*etag, "\"another\"", "Sun, 06 Nov 1994 08:49:37 GMT"] {
        let (head, body) = part(validator);
        assert!(is(&head, 200) && body == [b'n'; 6_000], "{validator}: {head}");
    }
}

#[test]
fn a_client_that_has_asked_may_close_its_half() {
    let server = Server::start();
    for _ in 0..20 {
        let mut stream = TcpStream::connect(&server.address).expect("it listens");
        write!(stream, "GET /main.js HTTP/1.1\r\nHost: {}\r\n\r\n", server.address).expect("a request");
        stream.shutdown(Shutdown::Write).expect("it is open");
        let mut answer = String::new();
        stream.read_to_string(&mut answer).expect("an answer");
        assert!(answer.starts_with("HTTP/1.1 200 "), "{answer:?}");
    }
}

#[test]
fn the_log_has_a_line_for_each_request() {
    let mut server = Server::with(&["--log"]);
    server.get("/main.js?a=%22b", &[]);
    server.get("/no\"where", &[]);
    server.send("/main.js", &["Host: evil.example"]);
    let mut lines = BufReader::new(server.child.stdout.take().expect("piped")).lines();
    let expected = [
        "\"GET /main.js?a=%22b HTTP/1.1\" 200 1000",
        "\"GET /no\\\"where HTTP/1.1\" 404 ",
        "\"GET /main.js HTTP/1.1\" 421 ",
    ];
    for request in expected {
        let line = lines.next().expect("a line").expect("UTF-8");
        assert!(line.starts_with("127.0.0.1 - - [") && line.contains(&format!(" +0000] {request}")), "{line}");
    }
    server.child.kill().expect("it runs");
    assert_eq!(lines.count(), 0);
}

#[cfg(unix)]
#[test]
fn a_log_that_nobody_reads_holds_nothing_up() {
    let mut server = Server::with(&["--log"]);
    // More than the capacity of a pipe.
    let long = format!("/main.js?{}", "a".repeat(20_000));
    for _ in 0..20 {
        assert!(is(&server.get(&long, &[]).0, 200));
    }
    signal(&server, "-TERM");
    assert_eq!(server.child.wait().expect("it ends").code(), Some(0));
}
