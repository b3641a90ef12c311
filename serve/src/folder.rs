//! A folder of files to serve, with no access to anything outside it.
//!
//! `ServeDir` refuses `..` in every encoding but follows symbolic links, which can lead out of the folder. Each path is
//! therefore resolved before it is opened.

use std::io;
use std::path::{Path, PathBuf};
use std::pin::Pin;

use tower_http::services::fs::{Backend, TokioBackend, TokioFile};

#[derive(Clone, Debug)]
pub struct Folder {
    /// Canonical path, with all symbolic links resolved.
    root: PathBuf,
}

impl Folder {
    /// Opens a folder.
    ///
    /// # Errors
    /// If the folder does not exist.
    pub fn open(path: &Path) -> io::Result<Folder> {
        let root = path.canonicalize()?;
        if !root.is_dir() {
            return Err(io::ErrorKind::NotADirectory.into());
        }
        Ok(Folder { root })
    }

    pub fn root(&self) -> &Path {
        &self.root
    }

    /// Resolves all symbolic links of a path.
    ///
    /// # Errors
    /// Not found if the result is outside the folder or does not exist.
    async fn resolve(self, path: PathBuf) -> io::Result<PathBuf> {
        let path = tokio::fs::canonicalize(path).await.ok();
        path.filter(|path| path.starts_with(&self.root)).ok_or(io::ErrorKind::NotFound.into())
    }
}

impl Backend for Folder {
    type File = TokioFile;
    type Metadata = std::fs::Metadata;
    type OpenFuture = Pin<Box<dyn Future<Output = io::Result<TokioFile>> + Send>>;
    type MetadataFuture = Pin<Box<dyn Future<Output = io::Result<std::fs::Metadata>> + Send>>;

    fn open(&self, path: PathBuf) -> Self::OpenFuture {
        let folder = self.clone();
        Box::pin(async move {
            let path = folder.resolve(path).await?;
            // Opening a pipe would block until something writes to it.
            if !tokio::fs::metadata(&path).await?.is_file() {
                return Err(io::ErrorKind::NotFound.into());
            }
            TokioBackend.open(path).await
        })
    }

    fn metadata(&self, path: PathBuf) -> Self::MetadataFuture {
        let folder = self.clone();
        Box::pin(async move { TokioBackend.metadata(folder.resolve(path).await?).await })
    }
}
