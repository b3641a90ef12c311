//! Building blocks of the figures: the SVG document with its text alternative, text and lines.
//!
//! A figure has its own background, so that it is legible on any page. Numbers are rounded, so that the same input
//! yields the same bytes.

use pathlight::colour::palette::palette;
use svg::Document;
use svg::node::Text as Words;
use svg::node::element::{Definitions, Description, Group, Line, Rectangle, Text, Title};

/// Colour of axes and captions.
pub const MUTED: &str = "#5b626c";

/// Colour of lines behind the data.
pub const FAINT: &str = "#dcdad3";

/// A figure and its text alternative.
pub struct Figure {
    /// File name without extension.
    pub name: &'static str,
    pub title: &'static str,
    /// What the figure shows, and how its content was chosen.
    pub caption: String,
    /// The numbers of the figure, as sentences.
    pub numbers: String,
    /// Width and height, px.
    pub size: [f64; 2],
    pub definitions: Definitions,
    pub content: Group,
}

impl Figure {
    /// Returns the SVG file.
    pub fn to_svg(&self) -> String {
        let [width, height] = self.size.map(px);
        let paper = Rectangle::new().set("width", width).set("height", height).set("rx", 6);
        let document = Document::new()
            .set("viewBox", (0, 0, width, height))
            .set("width", width)
            .set("height", height)
            .set("role", "img")
            .set("aria-labelledby", "title desc")
            .set("font-family", "sans-serif")
            .add(Title::new(self.title).set("id", "title"))
            .add(Description::new().set("id", "desc").add(Words::new(format!("{} {}", self.caption, self.numbers))))
            .add(self.definitions.clone())
            .add(paper.set("fill", palette(false).paper))
            .add(self.content.clone());
        format!("{document}\n")
    }
}

/// Rounds a coordinate to a hundredth of a px.
pub fn px(value: f64) -> f64 {
    // Adding zero turns -0 into 0.
    (value * 100.0).round() / 100.0 + 0.0
}

/// Alignment of text relative to its point.
#[derive(Clone, Copy)]
pub enum Anchor {
    Start,
    Middle,
    End,
}

/// Returns a text element; `size` is the font size, px.
pub fn words(text: impl Into<String>, [x, y]: [f64; 2], size: f64, anchor: Anchor) -> Text {
    let anchor = match anchor {
        Anchor::Start => "start",
        Anchor::Middle => "middle",
        Anchor::End => "end",
    };
    let text = Text::new(text).set("x", px(x)).set("y", px(y)).set("font-size", size);
    text.set("text-anchor", anchor).set("fill", palette(false).ink)
}

/// Returns a straight line, 1 px wide.
pub fn line([x, y]: [f64; 2], [u, v]: [f64; 2], colour: &str) -> Line {
    Line::new().set("x1", px(x)).set("y1", px(y)).set("x2", px(u)).set("y2", px(v)).set("stroke", colour)
}
