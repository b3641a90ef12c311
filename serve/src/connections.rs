//! Accepts connections, and closes those that make no progress.
//!
//! `axum::serve` sets no time limit for a request's head and none for a client that stops reading. Such clients could
//! exhaust the system's limit on connections.

use std::net::SocketAddr;
use std::pin::pin;
use std::time::Duration;

use axum::Router;
use axum::serve::{Listener, ListenerExt};
use hyper::server::conn::http1;
use hyper_util::rt::{TokioIo, TokioTimer};
use hyper_util::server::graceful::GracefulShutdown;
use hyper_util::service::TowerToHyperService;
use tokio::net::{TcpListener, TcpStream};
use tokio_io_timeout::TimeoutStream;
use tower_http::add_extension::AddExtension;

/// Largest request head, bytes. A browser's has about 1,000.
const MAX_HEAD: usize = 1 << 15;

/// Limit on open files and connections to request from the system. The default is often 1,024.
const MAX_OPEN: u64 = 8192;

/// Time for open requests to finish once the server is asked to stop. Containers are killed after 10 s.
const DRAIN: Duration = Duration::from_secs(5);

/// Answers requests until `stop` resolves, then gives open requests a limited time to finish.
///
/// A connection is closed if a request's head takes longer than `patience`, or if the client reads none of a response
/// for that long. Each request carries its client's address as an extension.
pub async fn serve(listener: TcpListener, router: Router, patience: Duration, stop: impl Future<Output = ()>) {
    // If the limit cannot be raised, fewer connections are served at once.
    let _ = rlimit::increase_nofile_limit(MAX_OPEN);
    let mut listener = without_delay(listener);
    let service = router.into_service();
    let mut builder = http1::Builder::new();
    builder.timer(TokioTimer::new()).header_read_timeout(patience).max_buf_size(MAX_HEAD);
    // Some clients close their half after sending the request: `nc -N`.
    builder.half_close(true);
    let open = GracefulShutdown::new();
    let mut stop = pin!(stop);
    loop {
        let (stream, client) = tokio::select! {
            accepted = listener.accept() => accepted,
            () = &mut stop => break,
        };
        let mut stream = TimeoutStream::new(stream);
        stream.set_write_timeout(Some(patience));
        let service = TowerToHyperService::new(AddExtension::new(service.clone(), client));
        tokio::spawn(open.watch(builder.serve_connection(TokioIo::new(Box::pin(stream)), service)));
    }
    drop(listener);
    let _ = tokio::time::timeout(DRAIN, open.shutdown()).await;
}

/// Sets `TCP_NODELAY` on accepted connections. Otherwise the last part of a response on a kept-alive connection waits
/// for the client's delayed acknowledgement, 40 ms on Linux.
fn without_delay(listener: TcpListener) -> impl Listener<Io = TcpStream, Addr = SocketAddr> {
    listener.tap_io(|stream| {
        // Fails only if the client has already disconnected.
        let _ = stream.set_nodelay(true);
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[tokio::test]
    async fn accepted_connections_send_without_delay() {
        let listener = TcpListener::bind("127.0.0.1:0").await.expect("a free port");
        let address = listener.local_addr().expect("an address");
        let _client = std::net::TcpStream::connect(address).expect("it listens");
        let (stream, _) = without_delay(listener).accept().await;
        assert!(stream.nodelay().expect("an option"));
    }
}
