//! `pathlight figures`: draws the figures of the results as SVG, each with a text alternative, and a page that shows
//! them.
//!
//! A module per figure draws it from the files that other commands measured; nothing is measured here. The same files
//! yield the same bytes.

use std::fmt::Write as _;
use std::io::{self, Write as _};
use std::path::PathBuf;

use super::replace_file::replace_file;
use super::shipped::Shipped;
use picture::Figure;

mod agent_style;
mod auccess_bars;
mod bar_table;
mod curves;
mod measured;
mod overlap;
mod picture;
mod scene_drawing;
mod strips;
mod templates;

/// Draw the figures of the results: templates, strips of what is imagined, curves, bars and overlaps by template
#[derive(clap::Args)]
pub struct Args {
    /// The folder of the results of `reproduce`, whose folder shipped/ has those of the models on the page
    #[arg(long, value_name = "DIR", default_value = "results")]
    results: PathBuf,

    /// Solutions of all tasks, from `pathlight collect`
    #[arg(long, default_value = "assets/solutions.jsonl")]
    solutions: PathBuf,

    /// The folder of the weights of the models on the page
    #[arg(long, value_name = "DIR", default_value = "assets")]
    assets: PathBuf,

    /// The folder of the figures [default: figures/ in that of the results]
    #[arg(long, value_name = "DIR")]
    out: Option<PathBuf>,
}

impl Args {
    pub fn run(self) -> anyhow::Result<()> {
        let shipped = Shipped { measurements: &self.results.join("shipped"), assets: &self.assets };
        let groups = measured::groups(&self.results, &shipped)?;
        let figures = [
            templates::draw(&self.solutions)?,
            strips::draw(&shipped)?,
            curves::draw(&groups),
            auccess_bars::draw(&groups),
            overlap::draw(&shipped)?,
        ];
        let folder = self.out.unwrap_or_else(|| self.results.join("figures"));
        let mut files: Vec<(String, String)> =
            figures.iter().map(|figure| (format!("{}.svg", figure.name), figure.to_svg())).collect();
        files.push(("README.md".to_string(), page(&figures)?));
        let mut written = String::new();
        for (name, content) in files {
            let path = folder.join(name);
            replace_file(&path, content.as_bytes())?;
            writeln!(written, "{}", path.display())?;
        }
        // All is written before anything is printed, so that a closed pipe does not stop halfway.
        io::stdout().write_all(written.as_bytes())?;
        Ok(())
    }
}

/// The page that shows the figures.
fn page(figures: &[Figure]) -> anyhow::Result<String> {
    let mut text = "# Figures\n\n`pathlight figures` draws them from the results and the models on the page. The text \
                    alternative of each file holds its numbers.\n"
        .to_string();
    for Figure { name, title, caption, .. } in figures {
        writeln!(text, "\n## {title}\n\n![{title}]({name}.svg)\n\n{caption}")?;
    }
    Ok(text)
}
