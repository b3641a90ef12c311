//! Serves the page to a browser on this machine: `pathlight serve`, and the separate binary `pathlight-serve`.
//!
//! This is a static file server with the features that the page needs: media types, precompressed files, a content
//! security policy, and caching with revalidation. `/assets/` holds the weights. All files are public and read-only.
//!
//! It is a separate crate so that `make play` need not compile the nets and their training.

use std::io::{self, Write};
use std::net::{Ipv4Addr, Ipv6Addr, SocketAddr};
use std::path::PathBuf;
use std::time::Duration;

use anyhow::{Context, bail};
use axum::Router;
use axum::http::{HeaderName, HeaderValue, header};
use axum::middleware;
use axum::routing::any;
use tokio::net::TcpListener;
use tower_http::services::ServeDir;
use tower_http::set_header::SetResponseHeaderLayer;

mod access_log;
mod connections;
mod folder;
mod host_check;
mod if_range;

use folder::Folder;
use host_check::Hosts;

/// Serve the page to a browser on this machine
#[derive(clap::Args)]
pub struct Args {
    /// Listen on this port; 0 chooses a free one
    #[arg(long, default_value_t = 8080)]
    port: u16,

    /// Listen on this address; addresses other than loopback let other machines connect
    #[arg(long, default_value = "127.0.0.1")]
    host: String,

    /// Folder to serve: the page as `make play` builds it into target/page, or as `make dist` does into dist
    #[arg(long, default_value = "page")]
    dir: PathBuf,

    /// Folder to serve as /assets/ [default: DIR/assets if it exists, otherwise assets]
    #[arg(long)]
    assets: Option<PathBuf>,

    /// Allow pages of these origins to show the page in a frame, for example `https://school.example`
    #[arg(long, value_name = "ORIGIN", num_args = 1.., value_parser = origin)]
    frame_ancestors: Vec<String>,

    /// Answer requests for these host names in addition to localhost and IP addresses, for example behind a proxy; by
    /// default, a server on a loopback address answers to no other names, and any other server answers to all
    #[arg(long, value_name = "NAME", num_args = 1.., value_parser = host_name)]
    allow_host: Vec<String>,

    /// Close connections that make no progress for this time
    #[arg(long, value_name = "SECONDS", default_value_t = 30, value_parser = clap::value_parser!(u16).range(1..))]
    patience: u16,

    /// Write a line for each request to standard output, in the Common Log Format
    #[arg(long)]
    log: bool,
}

/// Allows only the page's own scripts, wasm, styles and data. `policy` adds `frame-ancestors`.
const POLICY: &str = "default-src 'self'; script-src 'self' 'wasm-unsafe-eval'; img-src 'self' data: blob:; \
                      object-src 'none'; base-uri 'none'; form-action 'none'";

/// Other headers of every response.
const HEADERS: [(HeaderName, &str); 6] = [
    (header::X_CONTENT_TYPE_OPTIONS, "nosniff"),
    (header::REFERRER_POLICY, "no-referrer"),
    (HeaderName::from_static("cross-origin-opener-policy"), "same-origin"),
    (HeaderName::from_static("cross-origin-resource-policy"), "same-origin"),
    // Cached, but revalidated each time, so that the page's next load gets a rebuilt package.
    (header::CACHE_CONTROL, "no-cache"),
    // `ServeDir` omits it from 304 responses.
    (header::VARY, "accept-encoding"),
];

impl Args {
    /// Serves until Ctrl+C or SIGTERM.
    ///
    /// # Errors
    /// If a folder does not exist, or the server cannot listen on the address.
    pub fn run(self) -> anyhow::Result<()> {
        let page = Folder::open(&self.dir).with_context(|| {
            format!(
                "cannot serve {}: name the folder of the page with --dir, such as target/page, into which make play \
                 builds it",
                self.dir.display()
            )
        })?;
        let assets = self.assets.unwrap_or_else(|| {
            let own = self.dir.join("assets");
            if own.is_dir() { own } else { PathBuf::from("assets") }
        });
        let assets = Folder::open(&assets).with_context(|| {
            format!("cannot serve {}: name the folder of the weights with --assets", assets.display())
        })?;
        // `make dist` puts the wasm in a folder named after its version.
        if !self.dir.join("pkg").is_dir() && !self.dir.join("service-worker.js").is_file() {
            say(&format!(
                "warning: {} has no wasm package, so the page cannot start: run `make play`",
                self.dir.display()
            ));
        }
        let policy = policy(&self.frame_ancestors);
        let runtime = tokio::runtime::Builder::new_current_thread().enable_all().build()?;
        runtime.block_on(async {
            let listener = listen(&self.host, self.port).await?;
            let address = listener.local_addr()?;
            let knows_its_names = address.ip().is_loopback() || !self.allow_host.is_empty();
            let hosts = if knows_its_names { Hosts::Named(self.allow_host) } else { Hosts::Any };
            let router = router(&page, &assets, policy, hosts, self.log);
            // Signals are handled before the address is printed, so a script can stop the server as soon as it reads
            // the address.
            let stop = stop_signal()?;
            announce(address)?;
            connections::serve(listener, router, Duration::from_secs(self.patience.into()), stop).await;
            anyhow::Ok(())
        })?;
        // A file system that does not respond must not keep the program from ending.
        runtime.shutdown_background();
        Ok(())
    }
}

/// Starts to listen for Ctrl+C and SIGTERM. The future resolves at the first signal.
///
/// The kernel ignores a SIGTERM that PID 1 does not handle. Without this, a container would have to be killed.
#[cfg(unix)]
fn stop_signal() -> io::Result<impl Future<Output = ()>> {
    use tokio::signal::unix::{SignalKind, signal};
    let mut interrupt = signal(SignalKind::interrupt())?;
    let mut terminate = signal(SignalKind::terminate())?;
    Ok(async move {
        tokio::select! {
            _ = interrupt.recv() => {}
            _ = terminate.recv() => {}
        }
    })
}

/// Starts to listen for Ctrl+C.
#[cfg(windows)]
fn stop_signal() -> io::Result<impl Future<Output = ()>> {
    let mut interrupt = tokio::signal::windows::ctrl_c()?;
    Ok(async move { drop(interrupt.recv().await) })
}

/// Prints a line on standard error.
fn say(line: &str) {
    // `eprintln!` panics if the reader is gone.
    let _ = writeln!(io::stderr(), "{line}");
}

/// Prints the URL for a browser on this machine.
fn announce(address: SocketAddr) -> anyhow::Result<()> {
    let mut opened = address;
    // Not every system accepts the unspecified address as a destination.
    if address.ip().is_unspecified() {
        opened.set_ip(if address.is_ipv4() { Ipv4Addr::LOCALHOST.into() } else { Ipv6Addr::LOCALHOST.into() });
    }
    writeln!(io::stdout(), "Pathlight is at http://{opened}/ (Ctrl+C ends it)")?;
    if !address.ip().is_loopback() {
        say("warning: every machine that can reach this one can open the page at its address");
    }
    Ok(())
}

async fn listen(host: &str, port: u16) -> anyhow::Result<TcpListener> {
    // URLs enclose an IPv6 address in brackets.
    let host = host.strip_prefix('[').and_then(|rest| rest.strip_suffix(']')).unwrap_or(host);
    match TcpListener::bind((host, port)).await {
        Ok(listener) => Ok(listener),
        Err(error) if error.kind() == io::ErrorKind::AddrInUse => {
            bail!("port {port} is in use by another program: choose another, with --port or `make play PORT=8081`")
        }
        Err(error) if error.kind() == io::ErrorKind::PermissionDenied => {
            bail!("port {port} needs administrator rights: choose one from 1024 up")
        }
        Err(error) => {
            Err(error).with_context(|| format!("cannot listen on {host}: name an address of this machine with --host"))
        }
    }
}

/// Parses an origin that may frame the page: scheme, host and port. None of the allowed characters can end the rule in
/// the policy.
fn origin(text: &str) -> Result<String, String> {
    let host = text.strip_prefix("https://").or_else(|| text.strip_prefix("http://")).unwrap_or_default();
    if !host.is_empty() && host.bytes().all(|byte| byte.is_ascii_alphanumeric() || b".-:[]*".contains(&byte)) {
        Ok(text.to_string())
    } else {
        Err("name a scheme, a host and no path, like https://school.example or http://127.0.0.1:8000".to_string())
    }
}

/// Parses a host name, which `Hosts` compares with the `Host` header.
fn host_name(text: &str) -> Result<String, String> {
    if !text.is_empty() && text.bytes().all(|byte| byte.is_ascii_alphanumeric() || b".-_".contains(&byte)) {
        Ok(text.to_string())
    } else {
        Err("give the name or the IPv4 address alone, without scheme and port, like play.example".to_string())
    }
}

/// Returns the content security policy, including the origins that may frame the page.
fn policy(frame_ancestors: &[String]) -> HeaderValue {
    let ancestors = if frame_ancestors.is_empty() { "'none'".to_string() } else { frame_ancestors.join(" ") };
    let policy = format!("{POLICY}; frame-ancestors {ancestors}");
    HeaderValue::from_str(&policy).expect("`origin` accepts only visible ASCII characters")
}

fn router(page: &Folder, assets: &Folder, policy: HeaderValue, hosts: Hosts, log: bool) -> Router {
    let check_host = middleware::from_fn(move |request, next| host_check::check(hosts.clone(), request, next));
    let router =
        files(page).nest("/assets", files(assets)).layer(middleware::from_fn(if_range::evaluate)).layer(check_host);
    let headers = HEADERS.map(|(name, value)| (name, HeaderValue::from_static(value)));
    let router = headers
        .into_iter()
        .chain([(header::CONTENT_SECURITY_POLICY, policy)])
        .fold(router, |router, (name, value)| router.layer(SetResponseHeaderLayer::overriding(name, value)));
    if !log {
        return router;
    }
    let lines = access_log::start();
    router
        .layer(middleware::from_fn(move |client, request, next| access_log::log(lines.clone(), client, request, next)))
}

/// Serves a folder. A file that has a `.br` or `.gz` version next to it is sent compressed. Nothing is compressed per
/// request, so each encoding has its own length, ranges and ETag.
fn files(folder: &Folder) -> Router {
    let missing = any(|| async { "There is nothing here. The page is at /\n" });
    let files = ServeDir::with_backend(folder.root(), folder.clone())
        .precompressed_br()
        .precompressed_gzip()
        .redirect_to_trailing_slash(false)
        .not_found_service(missing);
    Router::new().fallback_service(files)
}
