//! A table of bars: a row per template, a column per thing that was measured, and the number in each cell.

use pathlight::puzzle::templates::TEMPLATES;
use svg::node::element::{Group, Rectangle};

use super::picture::{Anchor, FAINT, MUTED, line, px, words};

/// Width of the names of the templates, of a cell, of its bar, and between two groups of columns; height of a row, px.
const NAMES: f64 = 176.0;
const CELL: f64 = 66.0;
const BAR: f64 = 34.0;
const BETWEEN: f64 = 16.0;
const ROW: f64 = 17.0;

/// Height of the headings, and the space around all, px.
const HEAD: f64 = 70.0;
const MARGIN: f64 = 16.0;

/// Columns below one heading.
pub struct Columns {
    pub headings: [String; 2],
    pub columns: Vec<Column>,
}

/// One thing that was measured, with its value for each template.
pub struct Column {
    pub headings: [String; 2],
    pub colour: &'static str,
    /// The value of each template, and then of all together; none where nothing was measured.
    pub values: Vec<Option<f64>>,
    /// A value to compare with, marked on each bar.
    pub marks: Vec<Option<f64>>,
}

/// How a number is written.
pub struct Scale {
    /// The value of a full bar.
    pub most: f64,
    pub decimals: usize,
}

/// Draws the table; returns it with its size, px.
pub fn draw(groups: &[Columns], scale: &Scale) -> (Group, [f64; 2]) {
    let names: Vec<String> = row_names();
    let bottom = MARGIN + HEAD + ROW * names.len() as f64 + 4.0;
    let mut table = Group::new();
    let mut x = MARGIN + NAMES;
    for (row, name) in names.iter().enumerate() {
        let weight = if row == TEMPLATES.len() { "bold" } else { "normal" };
        table =
            table.add(words(name.as_str(), [MARGIN, baseline(row)], 11.0, Anchor::Start).set("font-weight", weight));
    }
    for Columns { headings, columns } in groups {
        for (index, heading) in headings.iter().enumerate() {
            let at = [x, MARGIN + 10.0 + 15.0 * index as f64];
            let weight = if index == 0 { "bold" } else { "normal" };
            table = table.add(words(heading.as_str(), at, 11.0, Anchor::Start).set("font-weight", weight));
        }
        for column in columns {
            table = table.add(draw_column(column, x, scale));
            x += CELL;
        }
        x += BETWEEN;
    }
    let right = x - BETWEEN;
    let rule = |y| line([MARGIN, y], [right, y], FAINT);
    let above_all = top(TEMPLATES.len());
    (table.add(rule(MARGIN + HEAD - 4.0)).add(rule(above_all + 1.0)), [right + MARGIN, bottom + MARGIN])
}

/// Returns the names of the rows.
fn row_names() -> Vec<String> {
    let templates = TEMPLATES.iter().map(|template| format!("{:05} {}", template.number, template.name));
    templates.chain(["all".to_string()]).collect()
}

/// Returns the numbers as sentences, row by row.
pub fn sentences(groups: &[Columns], scale: &Scale) -> String {
    let sentence = |(row, name): (usize, String)| {
        let cells = groups.iter().flat_map(|Columns { headings, columns }| {
            columns.iter().filter_map(move |column| {
                let what = format!("{} {}", headings.join(" "), column.headings.join(" "));
                Some(format!("{} {}", what.trim(), scale.number(column.values[row]?)))
            })
        });
        format!("{name}: {}.", cells.collect::<Vec<_>>().join("; "))
    };
    row_names().into_iter().enumerate().map(sentence).collect::<Vec<_>>().join(" ")
}

/// Top of a row, px.
fn top(row: usize) -> f64 {
    MARGIN + HEAD + ROW * row as f64 + if row == TEMPLATES.len() { 4.0 } else { 0.0 }
}

/// Where the words of a row stand, px.
fn baseline(row: usize) -> f64 {
    top(row) + ROW - 4.5
}

fn draw_column(Column { headings, colour, values, marks }: &Column, x: f64, scale: &Scale) -> Group {
    let mut group = Group::new();
    for (index, heading) in headings.iter().enumerate() {
        let at = [x, MARGIN + HEAD - 23.0 + 13.0 * index as f64];
        group = group.add(words(heading.as_str(), at, 10.5, Anchor::Start).set("fill", MUTED));
    }
    for (row, value) in values.iter().enumerate() {
        let Some(value) = *value else { continue };
        let bar = |width: f64, colour: &str| {
            let bar = Rectangle::new().set("x", px(x)).set("y", px(top(row) + 3.0)).set("height", ROW - 6.0);
            bar.set("width", px(width)).set("fill", colour)
        };
        let length = |value: f64| BAR * (value / scale.most).clamp(0.0, 1.0);
        group = group.add(bar(BAR, FAINT).set("fill-opacity", 0.55)).add(bar(length(value), colour));
        if let Some(mark) = marks.get(row).copied().flatten() {
            let at = x + length(mark);
            group =
                group.add(line([at, top(row) + 1.0], [at, top(row) + ROW - 1.0], "#16181c").set("stroke-width", 1.6));
        }
        let number = scale.number(value);
        group = group.add(words(number, [x + BAR + 4.0, baseline(row)], 10.5, Anchor::Start).set("class", "value"));
    }
    group
}

impl Scale {
    fn number(&self, value: f64) -> String {
        format!("{value:.*}", self.decimals)
    }
}
