//! The access log, in the Common Log Format that log analysers read.

use std::io::{self, Write};
use std::net::SocketAddr;
use std::time::SystemTime;

use axum::Extension;
use axum::extract::Request;
use axum::http::header;
use axum::middleware::Next;
use axum::response::Response;

/// Writes one line to standard output for each request, when its response starts.
pub async fn log(Extension(client): Extension<SocketAddr>, request: Request, next: Next) -> Response {
    let request_line = format!("{} {} {:?}", request.method(), request.uri(), request.version());
    let time = timestamp(SystemTime::now());
    let response = next.run(request).await;
    let length = response.headers().get(header::CONTENT_LENGTH).and_then(|length| length.to_str().ok()).unwrap_or("-");
    // `Debug` quotes the request line and escapes quotes in it. `println!` would panic when the reader is gone.
    let status = response.status().as_u16();
    let _ = writeln!(io::stdout(), "{} - - [{time}] {request_line:?} {status} {length}", client.ip());
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
