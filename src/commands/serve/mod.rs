//! `pathlight serve`: the page, on this machine.
//!
//! A file server that knows what a browser needs to know of these files: types, compression, a policy that lets
//! nothing in from elsewhere, and to ask each time whether a file has changed. `/assets/` holds the weights.

use std::io::{self, Write};
use std::path::PathBuf;

use anyhow::{Context, bail};
use axum::Router;
use axum::http::{HeaderName, HeaderValue, header};
use axum::routing::any;
use tokio::net::TcpListener;
use tower_http::CompressionLevel;
use tower_http::compression::CompressionLayer;
use tower_http::compression::predicate::{DefaultPredicate, NotForContentType, Predicate};
use tower_http::services::ServeDir;
use tower_http::set_header::SetResponseHeaderLayer;

mod folder;

use folder::Folder;

/// Serve the page to a browser on this machine
#[derive(clap::Args)]
pub struct Args {
    /// Listen on this port; 0 takes a free one
    #[arg(long, default_value_t = 8080)]
    port: u16,

    /// Listen on this address; any but a loopback address lets other machines in
    #[arg(long, default_value = "127.0.0.1")]
    host: String,

    /// Serve this folder: the page, with the wasm package in its subfolder pkg
    #[arg(long, default_value = "www")]
    dir: PathBuf,

    /// Serve this folder as /assets/
    #[arg(long, default_value = "assets")]
    assets: PathBuf,
}

/// Every answer carries these. The policy lets the page have its own scripts, wasm, styles and data, and no others.
const HEADERS: [(HeaderName, &str); 6] = [
    (
        header::CONTENT_SECURITY_POLICY,
        "default-src 'self'; script-src 'self' 'wasm-unsafe-eval'; img-src 'self' data: blob:; object-src 'none'; \
         base-uri 'none'; form-action 'none'; frame-ancestors 'none'",
    ),
    (header::X_CONTENT_TYPE_OPTIONS, "nosniff"),
    (header::REFERRER_POLICY, "no-referrer"),
    (HeaderName::from_static("cross-origin-opener-policy"), "same-origin"),
    (HeaderName::from_static("cross-origin-resource-policy"), "same-origin"),
    // Kept, but never used unasked: a rebuilt package reaches the page at its next load.
    (header::CACHE_CONTROL, "no-cache"),
];

impl Args {
    pub fn run(self) -> anyhow::Result<()> {
        let page = Folder::open(&self.dir)
            .with_context(|| format!("cannot serve {}: name the folder of the page with --dir", self.dir.display()))?;
        let assets = Folder::open(&self.assets).with_context(|| {
            format!("cannot serve {}: name the folder of the weights with --assets", self.assets.display())
        })?;
        if !self.dir.join("pkg").is_dir() {
            eprintln!("warning: {} has no wasm package, so the page cannot start: run `make play`", self.dir.display());
        }
        let runtime = tokio::runtime::Builder::new_current_thread().enable_all().build()?;
        runtime.block_on(async {
            let listener = listen(&self.host, self.port).await?;
            tokio::select! {
                // In this order: by the time anyone knows the address, Ctrl+C is listened for.
                biased;
                stopped = tokio::signal::ctrl_c() => Ok(stopped?),
                served = serve(listener, router(&page, &assets)) => served,
            }
        })
    }
}

/// Prints the address and serves for ever.
async fn serve(listener: TcpListener, router: Router) -> anyhow::Result<()> {
    let address = listener.local_addr()?;
    writeln!(io::stdout(), "Pathlight is at http://{address}/ (Ctrl+C ends it)")?;
    if !address.ip().is_loopback() {
        eprintln!("warning: every machine that reaches {} can open the page", address.ip());
    }
    Ok(axum::serve(listener, router).await?)
}

async fn listen(host: &str, port: u16) -> anyhow::Result<TcpListener> {
    match TcpListener::bind((host, port)).await {
        Ok(listener) => Ok(listener),
        Err(error) if error.kind() == io::ErrorKind::AddrInUse => {
            bail!("port {port} is taken by another program: choose another, with --port or `make play PORT=8081`")
        }
        Err(error) if error.kind() == io::ErrorKind::PermissionDenied => {
            bail!("port {port} is not for everyone: choose one from 1024 up")
        }
        Err(error) => Err(error).with_context(|| format!("cannot listen on {host}: give an address of this machine")),
    }
}

fn router(page: &Folder, assets: &Folder) -> Router {
    // Weights are as good as random numbers, and without compression a browser knows how much is still to come.
    let compressible = DefaultPredicate::new().and(NotForContentType::const_new("application/octet-stream"));
    // A cheap level: it is done anew for every load.
    let compression = CompressionLayer::new().quality(CompressionLevel::Fastest).compress_when(compressible);
    let router = files(page).nest("/assets", files(assets)).layer(compression);
    HEADERS.into_iter().fold(router, |router, (name, value)| {
        router.layer(SetResponseHeaderLayer::overriding(name, HeaderValue::from_static(value)))
    })
}

fn files(folder: &Folder) -> Router {
    let missing = any(|| async { "There is nothing here. The page is at /\n" });
    // `scripts/build-wasm` leaves the wasm compressed as well as can be beside it.
    let files =
        ServeDir::with_backend(folder.root(), folder.clone()).precompressed_br().redirect_to_trailing_slash(false);
    Router::new().fallback_service(files.not_found_service(missing))
}
