//! Draws the figures of the results as SVG, each with a text alternative, and a page that shows them.
//!
//! A module per figure draws it from the files of what was measured; nothing is measured here. The same files
//! yield the same bytes.

use std::fmt::Write as _;
use std::path::PathBuf;

use crate::files::replace_file::replace_file;
use crate::measure::shipped::Shipped;
use picture::Figure;
use strip_choice::Choice;

mod auccess_bars;
mod bar_table;
mod curves;
mod measured;
mod path_iou_bars;
mod picture;
mod scene_drawing;
mod strip_choice;
mod strips;
mod templates;

/// Where the results are, and the figures go.
pub struct Settings {
    /// The folder of the results of `reproduce`, whose folders shipped/ and paper/ have those of the models on the page
    /// and of the paper's nets.
    pub results: PathBuf,
    /// Solutions of all tasks.
    pub solutions: PathBuf,
    /// The folder of the weights of the models on the page.
    pub assets: PathBuf,
    /// The folder of the figures.
    pub out: PathBuf,
}

impl Settings {
    /// Draws all figures and the page that shows them; returns the files.
    ///
    /// # Errors
    /// If results are missing or do not belong together, or the folder cannot be written.
    pub fn draw(&self) -> anyhow::Result<Vec<PathBuf>> {
        let shipped = Shipped { measurements: &self.results.join("shipped"), assets: &self.assets };
        let groups = measured::groups(&self.results, &shipped)?;
        let figures = [
            templates::draw(&self.solutions)?,
            strips::draw(&shipped, Choice::Outcomes)?,
            strips::draw(&shipped, Choice::Weakest)?,
            curves::draw(&groups),
            auccess_bars::draw(&groups),
            path_iou_bars::draw(&shipped)?,
        ];
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

/// The page that shows the figures.
fn page(figures: &[Figure]) -> anyhow::Result<String> {
    let mut text =
        "# Figures\n\n`pathlight-lab figures` draws them from the results and the models on the page. The text \
                    alternative of each file holds its numbers.\n"
            .to_string();
    for Figure { name, title, caption, .. } in figures {
        writeln!(text, "\n## {title}\n\n![{title}]({name}.svg)\n\n{caption}")?;
    }
    Ok(text)
}
