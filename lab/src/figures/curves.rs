//! The success curves: the share of the test tasks that each agent solves within k attempts.
//!
//! The attempts axis is scaled as in AUCCESS: attempt k is as wide as its weight, ln(k + 1) - ln(k). So the area under
//! a curve, in percent of the panel, is AUCCESS.

use pathlight::benchmark::auccess::{MAX_ATTEMPTS, solved_within};
use svg::node::element::path::Data;
use svg::node::element::{Definitions, Group, Path};

use super::picture::{Anchor, FAINT, Figure, MUTED, line, px, words};
use crate::measure::agents::row;
use crate::measure::report::{Report, Score};

/// The plot area of a panel, px: its position in the panel and its size.
const PLOT: [f64; 4] = [58.0, 38.0, 330.0, 230.0];

/// Width and height of a panel with its axes and labels, px.
const PANEL: [f64; 2] = [520.0, 322.0];

/// Minimum distance between two labels of curves, px.
const LABEL: f64 = 16.0;

const TICKS: [usize; 7] = [1, 2, 5, 10, 20, 50, 100];

/// Draws the figure: one panel per report, side by side.
pub fn draw(reports: &[Report]) -> Figure {
    let mut content = Group::new();
    for (column, report) in reports.iter().enumerate() {
        let left = px(column as f64 * PANEL[0]);
        content = content.add(panel(report).set("transform", format!("translate({left} 0)")));
    }
    let numbers = reports.iter().map(|report| {
        let agents: Vec<String> = report.agents.iter().map(sentence).collect();
        format!("{}: {}.", heading(report), agents.join("; "))
    });
    Figure {
        name: "curves",
        title: "Tasks solved within k attempts",
        caption: "The share of the test tasks that each agent solves within k attempts, with the models on the page. \
                  An attempt is as wide as its weight in AUCCESS, so the area under a curve is the AUCCESS next to it."
            .to_string(),
        numbers: numbers.collect::<Vec<_>>().join(" "),
        size: [reports.len() as f64 * PANEL[0], PANEL[1]],
        definitions: Definitions::new(),
        content,
    }
}

fn heading(report: &Report) -> String {
    format!("{}, fold {}", report.setup, report.fold)
}

/// Describes a curve in words.
fn sentence(score: &Score) -> String {
    let [first, ten, hundred] = [1, 10, MAX_ATTEMPTS].map(|attempts| 100.0 * solved(score, attempts));
    format!(
        "{} {first:.0} % at the first attempt, {ten:.0} % within 10, {hundred:.0} % within {MAX_ATTEMPTS}",
        label(score)
    )
}

/// The share of tasks solved within a number of attempts, 0..=1.
fn solved(score: &Score, attempts: usize) -> f64 {
    solved_within(&score.first_solved, attempts)
}

/// Returns the label of a curve: the agent and its auccess.
fn label(score: &Score) -> String {
    format!("{} {:.1}", score.player, score.auccess)
}

/// The x coordinate at which an attempt begins, px.
fn x(attempt: usize) -> f64 {
    let [left, _, width, _] = PLOT;
    left + width * (attempt as f64).ln() / ((MAX_ATTEMPTS + 1) as f64).ln()
}

/// The y coordinate of a share, 0..=1, px.
fn y(share: f64) -> f64 {
    let [_, top, _, height] = PLOT;
    top + height * (1.0 - share)
}

fn panel(report: &Report) -> Group {
    let [left, top, width, height] = PLOT;
    let mut panel =
        Group::new().add(words(heading(report), [left, top - 14.0], 13.0, Anchor::Start).set("font-weight", "bold"));
    for percent in [0, 20, 40, 60, 80, 100] {
        let at = y(f64::from(percent) / 100.0);
        panel = panel
            .add(line([left, at], [left + width, at], FAINT))
            .add(words(percent.to_string(), [left - 7.0, at + 4.0], 11.0, Anchor::End).set("fill", MUTED));
    }
    for attempt in TICKS {
        panel = panel.add(line([x(attempt), top + height], [x(attempt), top + height + 4.0], MUTED)).add(
            words(attempt.to_string(), [x(attempt), top + height + 17.0], 11.0, Anchor::Middle).set("fill", MUTED),
        );
    }
    let middle = top + height / 2.0;
    let upwards = words("tasks solved, %", [0.0, 0.0], 11.0, Anchor::Middle).set("fill", MUTED);
    panel = panel
        .add(words("attempts", [left + width / 2.0, top + height + 34.0], 11.0, Anchor::Middle).set("fill", MUTED))
        .add(upwards.set("transform", format!("translate({} {}) rotate(-90)", px(left - 38.0), px(middle))));
    // Draw the first agents last, on top of the others: they are the best ones.
    for score in report.agents.iter().rev() {
        panel = panel.add(curve(score));
    }
    let ends: Vec<f64> = report.agents.iter().map(|score| y(solved(score, MAX_ATTEMPTS))).collect();
    for ((score, at), &last) in report.agents.iter().zip(apart(&ends)).zip(&ends) {
        let (colour, _) = row(score.player.agent).style;
        let end = left + width;
        let leader = line([end + 2.0, last], [end + 16.0, at], colour);
        panel = panel.add(leader.set("stroke-width", 2)).add(words(
            label(score),
            [end + 20.0, at + 4.0],
            12.0,
            Anchor::Start,
        ));
    }
    panel
}

fn curve(score: &Score) -> Group {
    let mut share = solved(score, 1);
    let mut data = Data::new().move_to((px(x(1)), px(y(share))));
    for attempt in 2..=MAX_ATTEMPTS {
        let next = solved(score, attempt);
        if next != share {
            data = data.horizontal_line_to(px(x(attempt))).vertical_line_to(px(y(next)));
            share = next;
        }
    }
    let (colour, dashes) = row(score.player.agent).style;
    let path =
        Path::new().set("d", data.horizontal_line_to(px(x(MAX_ATTEMPTS + 1)))).set("class", score.player.to_string());
    Group::new()
        .add(path.set("fill", "none").set("stroke", colour).set("stroke-width", 2).set("stroke-dasharray", dashes))
}

/// Moves the positions of labels, px, as little as needed to keep them `LABEL` apart and in the same order from top to
/// bottom.
fn apart(places: &[f64]) -> Vec<f64> {
    let mut order: Vec<usize> = (0..places.len()).collect();
    order.sort_by(|&a, &b| places[a].total_cmp(&places[b]));
    let mut moved = places.to_vec();
    // Move labels down, then move those that left the plot up again.
    for pair in 1..order.len() {
        moved[order[pair]] = moved[order[pair]].max(moved[order[pair - 1]] + LABEL);
    }
    let mut limit = PLOT[1] + PLOT[3];
    for &index in order.iter().rev() {
        moved[index] = moved[index].min(limit);
        limit = moved[index] - LABEL;
    }
    moved
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn labels_keep_their_order_and_lie_apart() {
        let bottom = PLOT[1] + PLOT[3];
        for places in [vec![], vec![50.0], vec![60.0, 50.0, 55.0], vec![bottom, bottom - 1.0, bottom, 40.0]] {
            let moved = apart(&places);
            let mut sorted = moved.clone();
            sorted.sort_by(f64::total_cmp);
            assert!(sorted.windows(2).all(|pair| pair[1] - pair[0] > LABEL - 1e-9), "{moved:?}");
            assert!(moved.iter().all(|&place| place <= bottom), "{moved:?}");
            for (a, b) in (1..places.len()).map(|index| (index - 1, index)) {
                assert!(places[a] == places[b] || (places[a] < places[b]) == (moved[a] < moved[b]));
            }
        }
    }
}
