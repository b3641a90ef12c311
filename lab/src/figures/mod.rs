//! Draws the figures of the results as SVG, each with a text alternative, and a page that shows them.
//!
//! Each figure has a module that draws it from the files of measurements; nothing is measured here. The same files
//! yield the same bytes.

use std::fmt::Write as _;
use std::path::PathBuf;

use pathlight::benchmark::folds::{FoldId, Setup};
use pathlight::command_line::replace_file::replace_file;

use crate::measure::report::Report;
use crate::measure::shipped::Shipped;
use picture::Figure;

mod curves;
mod picture;
mod scene_drawing;
mod strips;

/// Where to read the results and write the figures.
pub struct Settings {
    /// Folder of the results; its subfolder shipped/ holds those of the models on the page.
    pub results: PathBuf,
    /// Folder with the weights of the models on the page.
    pub assets: PathBuf,
    /// Folder to write the figures to.
    pub out: PathBuf,
}

impl Settings {
    /// Draws all figures and the page that shows them; returns the files.
    ///
    /// # Errors
    /// If results are missing or do not belong together, or the folder cannot be written.
    pub fn draw(&self) -> anyhow::Result<Vec<PathBuf>> {
        let shipped = Shipped { measurements: &self.results.join("shipped"), assets: &self.assets };
        let report = |fold: FoldId| Ok(shipped.read::<Report>(&fold.to_string())?.0);
        let reports = shipped_folds().into_iter().map(report).collect::<anyhow::Result<Vec<_>>>()?;
        let figures = [strips::draw(&shipped)?, curves::draw(&reports)];
        let mut files: Vec<(String, String)> =
            figures.iter().map(|figure| (format!("{}.svg", figure.name), figure.to_svg())).collect();
        files.push(("README.md".to_string(), page(&figures)?));
        let mut written = Vec::new();
        for (name, content) in files {
            let path = self.out.join(name);
            replace_file(&path, content.as_bytes())?;
            written.push(path);
        }
        Ok(written)
    }
}

/// The folds of the models on the page.
fn shipped_folds() -> [FoldId; 2] {
    [Setup::Within, Setup::Cross].map(|setup| FoldId { setup, fold: 0 })
}

/// Returns the page that shows the figures.
fn page(figures: &[Figure]) -> anyhow::Result<String> {
    const HEAD: &str =
        "# Figures\n\nDrawn by `pathlight-lab figures`. The text alternative of each holds its numbers.\n";
    let mut text = HEAD.to_string();
    for Figure { name, title, caption, .. } in figures {
        writeln!(text, "\n## {title}\n\n![{title}]({name}.svg)\n\n{caption}")?;
    }
    Ok(text)
}
