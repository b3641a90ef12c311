//! Serves the page to a browser on this machine: `pathlight serve`, and `pathlight-serve` alone.
//!
//! A static file server with what this page needs: media types, compression, a content security policy, and no caching
//! without revalidation. `/assets/` holds the weights. All files are public; requests only read them.
//!
//! A crate of its own, so that whoever wants to play does not wait for the nets and their training to compile.

use std::io::{self, Write};
use std::net::SocketAddr;
use std::path::PathBuf;
use std::time::Duration;

use anyhow::{Context, bail};
use axum::Router;
use axum::http::{HeaderName, HeaderValue, header};
use axum::middleware;
use axum::routing::any;
use tokio::net::TcpListener;
use tower_http::CompressionLevel;
use tower_http::compression::CompressionLayer;
use tower_http::compression::predicate::{DefaultPredicate, NotForContentType, Predicate};
use tower_http::services::ServeDir;
use tower_http::set_header::SetResponseHeaderLayer;

mod connections;
mod folder;
mod host_check;

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

    /// Folder to serve: the page, with the wasm package in its subfolder pkg, or what `make dist` builds
    #[arg(long, default_value = "www")]
    dir: PathBuf,

    /// Folder to serve as /assets/; by default the subfolder assets of DIR, or if it has none, `assets`
    #[arg(long)]
    assets: Option<PathBuf>,

    /// Let pages of these origins show the page in a frame, like `https://school.example`; by default none may
    #[arg(long, value_name = "ORIGIN", num_args = 1.., value_parser = origin)]
    frame_ancestors: Vec<String>,

    /// Also answer requests to these names, as those that come through a proxy; while only this machine can connect,
    /// others than its own are refused
    #[arg(long, value_name = "NAME", num_args = 1..)]
    allow_host: Vec<String>,

    /// Close connections on which nothing moves for this time, s
    #[arg(long, value_name = "SECONDS", default_value_t = 30, value_parser = clap::value_parser!(u16).range(1..))]
    patience: u16,
}

/// Allows only the page's own scripts, wasm, styles and data. `frame-ancestors` comes on top.
const POLICY: &str = "default-src 'self'; script-src 'self' 'wasm-unsafe-eval'; img-src 'self' data: blob:; \
                      object-src 'none'; base-uri 'none'; form-action 'none'";

/// Further headers of every response.
const HEADERS: [(HeaderName, &str); 5] = [
    (header::X_CONTENT_TYPE_OPTIONS, "nosniff"),
    (header::REFERRER_POLICY, "no-referrer"),
    (HeaderName::from_static("cross-origin-opener-policy"), "same-origin"),
    (HeaderName::from_static("cross-origin-resource-policy"), "same-origin"),
    // Cached, but revalidated each time, so that a rebuilt package reaches the page at its next load.
    (header::CACHE_CONTROL, "no-cache"),
];

impl Args {
    /// Serves until Ctrl+C.
    ///
    /// # Errors
    /// If a folder is not there, or the address cannot be listened on.
    pub fn run(self) -> anyhow::Result<()> {
        let page = Folder::open(&self.dir)
            .with_context(|| format!("cannot serve {}: name the folder of the page with --dir", self.dir.display()))?;
        let assets = self.assets.unwrap_or_else(|| {
            let own = self.dir.join("assets");
            if own.is_dir() { own } else { PathBuf::from("assets") }
        });
        let assets = Folder::open(&assets).with_context(|| {
            format!("cannot serve {}: name the folder of the weights with --assets", assets.display())
        })?;
        // A built page has its wasm in the folder of its version.
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
            let hosts = if address.ip().is_loopback() { Hosts::Local(self.allow_host) } else { Hosts::Any };
            let (router, patience) = (router(&page, &assets, policy, hosts), Duration::from_secs(self.patience.into()));
            tokio::select! {
                // In this order, so that Ctrl+C is handled before the address is printed.
                biased;
                stopped = tokio::signal::ctrl_c() => Ok(stopped?),
                served = async {
                    announce(address)?;
                    connections::serve(listener, router, patience).await;
                    Ok(())
                } => served,
            }
        })
    }
}

/// Prints a line on standard error.
fn say(line: &str) {
    // `eprintln!` panics if nobody reads any more.
    let _ = writeln!(io::stderr(), "{line}");
}

/// Prints the address.
fn announce(address: SocketAddr) -> anyhow::Result<()> {
    writeln!(io::stdout(), "Pathlight is at http://{address}/ (Ctrl+C ends it)")?;
    if !address.ip().is_loopback() {
        say(&format!("warning: every machine that reaches {} can open the page", address.ip()));
    }
    Ok(())
}

async fn listen(host: &str, port: u16) -> anyhow::Result<TcpListener> {
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

/// Parses an origin that may frame the page: scheme, host and port. The characters of a host cannot end the policy's
/// rule.
fn origin(text: &str) -> Result<String, String> {
    let host = text.strip_prefix("https://").or_else(|| text.strip_prefix("http://")).unwrap_or_default();
    if !host.is_empty() && host.bytes().all(|byte| byte.is_ascii_alphanumeric() || b".-:[]*".contains(&byte)) {
        Ok(text.to_string())
    } else {
        Err("name a scheme, a host and no path, like https://school.example or http://127.0.0.1:8000".to_string())
    }
}

/// Returns the content security policy of a page that these origins may frame.
fn policy(frame_ancestors: &[String]) -> HeaderValue {
    let ancestors = if frame_ancestors.is_empty() { "'none'".to_string() } else { frame_ancestors.join(" ") };
    let policy = format!("{POLICY}; frame-ancestors {ancestors}");
    HeaderValue::from_str(&policy).expect("`origin` lets only letters, digits and punctuation through")
}

fn router(page: &Folder, assets: &Folder, policy: HeaderValue, hosts: Hosts) -> Router {
    // A fast level makes weights hardly smaller; `make dist` writes them compressed.
    let compressible = DefaultPredicate::new().and(NotForContentType::const_new("application/octet-stream"));
    // A fast level, because each response is compressed when it is sent.
    let compression = CompressionLayer::new().quality(CompressionLevel::Fastest).compress_when(compressible);
    let hosts = middleware::from_fn(move |request, next| host_check::check(hosts.clone(), request, next));
    let router = files(page).nest("/assets", files(assets)).layer(compression).layer(hosts);
    let headers = HEADERS.map(|(name, value)| (name, HeaderValue::from_static(value)));
    headers
        .into_iter()
        .chain([(header::CONTENT_SECURITY_POLICY, policy)])
        .fold(router, |router, (name, value)| router.layer(SetResponseHeaderLayer::overriding(name, value)))
}

fn files(folder: &Folder) -> Router {
    let missing = any(|| async { "There is nothing here. The page is at /\n" });
    // `scripts/build-wasm` writes the wasm beside it, compressed at the highest level.
    let files =
        ServeDir::with_backend(folder.root(), folder.clone()).precompressed_br().redirect_to_trailing_slash(false);
    Router::new().fallback_service(files.not_found_service(missing))
}
