//! The connections: many at once, and none for long that nothing moves on.
//!
//! `axum::serve` waits for a request without an end; then a client that opens connections and sends nothing takes all
//! that the system allows, and nobody else is answered.

use std::io;
use std::time::Duration;

use axum::Router;
use hyper::server::conn::http1;
use hyper_util::rt::{TokioIo, TokioTimer};
use hyper_util::service::TowerToHyperService;
use tokio::net::TcpListener;
use tokio_io_timeout::TimeoutStream;

/// Largest head of a request, bytes. A browser's has about 1,000.
const MAX_HEAD: usize = 1 << 15;

/// Connections and open files that are asked of the system, which often allows 1,024 unless it is asked.
const MAX_OPEN: u64 = 8192;

/// Time until accepting is tried again after the system has refused it.
const PAUSE: Duration = Duration::from_millis(100);

/// Answers requests until the process ends. A connection is closed once a request's head has not come within
/// `patience`, or its client has taken nothing of an answer for so long.
pub async fn serve(listener: TcpListener, router: Router, patience: Duration) {
    // With fewer it serves fewer at once.
    let _ = rlimit::increase_nofile_limit(MAX_OPEN);
    let service = TowerToHyperService::new(router.into_service());
    let mut builder = http1::Builder::new();
    builder.timer(TokioTimer::new()).header_read_timeout(patience).max_buf_size(MAX_HEAD);
    loop {
        let stream = match listener.accept().await {
            Ok((stream, _)) => stream,
            Err(error) => {
                // A client that is gone already is none; anything else passes once other connections end.
                if error.kind() != io::ErrorKind::ConnectionAborted {
                    tokio::time::sleep(PAUSE).await;
                }
                continue;
            }
        };
        let mut stream = TimeoutStream::new(stream);
        stream.set_write_timeout(Some(patience));
        let connection = builder.serve_connection(TokioIo::new(Box::pin(stream)), service.clone());
        // Nobody is told that a client is gone.
        tokio::spawn(async move { drop(connection.await) });
    }
}
