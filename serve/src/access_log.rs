//! The access log, in the Common Log Format that log analysers read.

use std::io::{self, Write};
use std::net::SocketAddr;
use std::sync::mpsc::{SyncSender, sync_channel};
use std::thread;
use std::time::SystemTime;

use axum::Extension;
use axum::extract::Request;
use axum::http::header;
use axum::middleware::Next;
use axum::response::Response;

/// Lines queued for a reader that has paused; further lines are dropped.
const WAITING_LINES: usize = 1024;

/// The queue of lines to write.
pub type Lines = SyncSender<String>;

/// Starts a thread that writes the lines to standard output, so that a paused reader does not block the server.
pub fn start() -> Lines {
    let (sender, lines) = sync_channel::<String>(WAITING_LINES);
    thread::spawn(move || {
        for line in lines {
            // `println!` would panic when the reader is gone.
            let _ = writeln!(io::stdout(), "{line}");
        }
    });
    sender
}

/// Writes one line per request when its response starts.
pub async fn log(lines: Lines, Extension(client): Extension<SocketAddr>, request: Request, next: Next) -> Response {
    let request_line = format!("{} {} {:?}", request.method(), request.uri(), request.version());
    let time = timestamp(SystemTime::now());
    let response = next.run(request).await;
    let length = response.headers().get(header::CONTENT_LENGTH).and_then(|length| length.to_str().ok()).unwrap_or("-");
    // `Debug` quotes the request line and escapes quotes inside it.
    let status = response.status().as_u16();
    let _ = lines.try_send(format!("{} - - [{time}] {request_line:?} {status} {length}", client.ip()));
    response
}

/// Formats a time as `24/Nov/2026:17:27:03 +0000`.
fn timestamp(time: SystemTime) -> String {
    // `Tue, 24 Nov 2026 17:27:03 GMT`
    let date = httpdate::fmt_http_date(time);
    format!("{}/{}/{}:{} +0000", &date[5..7], &date[8..11], &date[12..16], &date[17..25])
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::time::Duration;

    #[test]
    fn times_have_the_format_of_access_logs() {
        let time = SystemTime::UNIX_EPOCH + Duration::from_secs(784_111_777);
        assert_eq!(timestamp(time), "06/Nov/1994:08:49:37 +0000");
    }
}
