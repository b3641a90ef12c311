//! The binary `pathlight-serve`: the files and headers that a browser receives, and the requests that are refused.

use std::fs;
use std::io::{BufRead, BufReader, Read, Write};
use std::net::TcpStream;
use std::process::{Child, Command, Stdio};

use tempfile::{TempDir, tempdir};

mod encodings;
mod files;
mod hostile_clients;
mod requests;
mod start_and_stop;

/// The file that `Server::download` downloads.
const LARGE: &str = "large.safetensors";

/// The binary, without arguments.
fn pathlight_serve() -> Command {
    Command::new(env!("CARGO_BIN_EXE_pathlight-serve"))
}

/// Asserts that the server refuses to start: no standard output, an error that contains these words, exit code 2.
fn assert_refused(args: &[&str], words: &str) {
    let output = pathlight_serve().args(args).output().expect("the binary starts");
    let said = String::from_utf8(output.stderr).expect("messages are UTF-8");
    assert_eq!((output.status.code(), &output.stdout[..]), (Some(2), &b""[..]), "{args:?}: {said}");
    assert!(said.contains("error: ") && said.contains(words), "{args:?} said {said:?} without {words:?}");
}

/// A server of temporary folders on a free port. It ends with the test.
struct Server {
    child: Child,
    /// `127.0.0.1:PORT`
    address: String,
    folder: TempDir,
}

/// Creates the folders that are served by default: `page` and `assets`.
fn page() -> TempDir {
    let folder = tempdir().expect("a folder");
    let root = folder.path();
    for inner in ["page/pkg", "assets"] {
        fs::create_dir_all(root.join(inner)).expect("a folder");
    }
    fs::write(root.join("page/index.html"), "<!doctype html><title>page</title>".repeat(10)).expect("a file");
    fs::write(root.join("page/main.js"), "// script\n".repeat(100)).expect("a file");
    fs::write(root.join("page/style.css"), "a { color: red }").expect("a file");
    fs::write(root.join("page/pkg/pathlight_bg.wasm"), [b'w'; 100_000]).expect("a file");
    fs::write(root.join("assets/weights.safetensors"), [b's'; 5_000]).expect("a file");
    fs::write(root.join("secret.txt"), "secret").expect("a file");
    folder
}

impl Server {
    fn start() -> Server {
        Server::with(&[])
    }

    /// Starts the server with these arguments.
    fn with(args: &[&str]) -> Server {
        Server::serving(page(), args)
    }

    /// Starts the server in a folder with these arguments.
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

    /// Returns the head and body of the response. `path` is sent unchanged; `headers` are whole lines.
    fn get(&self, path: &str, headers: &[&str]) -> (String, Vec<u8>) {
        let host = format!("Host: {}", self.address);
        self.send(path, &[&[&*host], headers].concat())
    }

    /// Like `get`, but without a `Host` header.
    fn send(&self, target: &str, headers: &[&str]) -> (String, Vec<u8>) {
        let mut stream = TcpStream::connect(&self.address).expect("it listens");
        let headers: String = headers.iter().map(|header| format!("{header}\r\n")).collect();
        write!(stream, "GET {target} HTTP/1.1\r\nConnection: close\r\n{headers}\r\n").expect("it listens");
        let mut answer = Vec::new();
        stream.read_to_end(&mut answer).expect("an answer");
        let end = answer.windows(4).position(|bytes| bytes == b"\r\n\r\n").expect("the end of the head");
        (String::from_utf8(answer[..end].to_vec()).expect("ASCII").to_lowercase(), answer[end + 4..].to_vec())
    }

    /// Starts to download a file that is larger than the buffers of a connection; returns the connection and the size.
    fn download(&self) -> (TcpStream, usize) {
        let size = 1 << 26;
        let large = fs::File::create(self.folder.path().join("assets").join(LARGE)).expect("a file");
        large.set_len(size).expect("a sparse file");
        let mut stream = TcpStream::connect(&self.address).expect("it listens");
        write!(stream, "GET /assets/{LARGE} HTTP/1.1\r\nHost: localhost\r\nConnection: close\r\n\r\n")
            .expect("it listens");
        stream.read_exact(&mut [0; 100]).expect("the response starts");
        (stream, usize::try_from(size).expect("64 bits"))
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
