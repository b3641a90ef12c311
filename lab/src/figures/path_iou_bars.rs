//! The soft IoU of imagined paths and those that happen, by template.

use pathlight::puzzle::templates::TEMPLATES;
use svg::node::element::Definitions;

use super::bar_table::{self, Column, Columns, Scale};
use super::measured::shipped_folds;
use super::picture::Figure;
use crate::measure::forecasts::{Forecasts, PathIous};
use crate::measure::shipped::Shipped;

/// What is drawn of a template: two lines of a heading, a colour, the value, and one to compare with.
type Part = ([&'static str; 2], &'static str, fn(&PathIous) -> Option<f64>, fn(&PathIous) -> Option<f64>);

const NO_MARK: fn(&PathIous) -> Option<f64> = |_| None;

const PARTS: [Part; 7] = [
    (["base", "path"], "#0072b2", |ious| ious.base, NO_MARK),
    (["target", "path"], "#009e73", |ious| ious.target, NO_MARK),
    (["action", "path"], "#d55e00", |ious| ious.action, NO_MARK),
    (["object,", "solved"], "#009e73", |ious| ious.solved.object, |ious| ious.solved.resting),
    (["object,", "not solved"], "#009e73", |ious| ious.not_solved.object, |ious| ious.not_solved.resting),
    (["ball,", "solved"], "#d55e00", |ious| ious.solved.ball, NO_MARK),
    (["ball,", "not solved"], "#d55e00", |ious| ious.not_solved.ball, NO_MARK),
];

/// Draws the figure.
///
/// # Errors
/// If the measurements of `pathlight-lab measure forecasts` are missing or damaged.
pub fn draw(shipped: &Shipped) -> anyhow::Result<Figure> {
    let mut groups = Vec::new();
    let mut random = Vec::new();
    for fold in shipped_folds() {
        let (forecasts, _) = shipped.read::<Forecasts>(&fold.to_string())?;
        random.push(format!("{} {}", forecasts.balls, fold.setup));
        let columns = PARTS.map(|(headings, colour, value, mark)| {
            let values = |part: fn(&PathIous) -> Option<f64>| -> Vec<Option<f64>> {
                let of = |number: usize| {
                    forecasts.templates.iter().find(|ious| ious.template == number).and_then(|ious| part(&ious.overlap))
                };
                (0..TEMPLATES.len()).map(of).chain([part(&forecasts.all)]).collect()
            };
            Column { headings: headings.map(str::to_string), colour, values: values(value), marks: values(mark) }
        });
        let headings = [fold.setup.to_string(), format!("fold {}, the model on the page", fold.fold)];
        groups.push(Columns { headings, columns: columns.into() });
    }
    let scale = Scale { most: 1.0, decimals: 2 };
    let (content, size) = bar_table::draw(&groups, &scale);
    Ok(Figure {
        name: "overlap-by-template",
        title: "Overlap of imagined and real paths by template",
        caption: format!(
            "Soft IoU of imagined and real paths on the test tasks of fold 0, 0 to 1. Base, target and action path are \
             the maps of the four nets, target and action beside the known solutions. Object and ball are the paths \
             that the dynamics net imagines for balls that solve and for others: the known solutions, and random balls \
             for each task ({}). A black mark is that of an object that stays where it is.",
            random.join(", ")
        ),
        numbers: bar_table::sentences(&groups, &scale),
        size,
        definitions: Definitions::new(),
        content,
    })
}
