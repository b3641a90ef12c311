//! The plot of the report: bars of auccess per template, one bar per agent, one panel per setup.

use std::path::Path;

use anyhow::anyhow;
use pathlight::benchmark::auccess::auccess;
use pathlight::benchmark::folds::Setup;
use pathlight::puzzle::templates::TEMPLATES;
use plotters::coord::Shift;
use plotters::coord::ranged1d::SegmentValue;
use plotters::prelude::*;

use super::fold_result::FoldResult;
use super::report::{AGENTS, of};

/// Size of a panel, px.
const PANEL: (u32, u32) = (560, 920);

/// One colour per agent; they differ in greyscale and for people who do not see red or green.
const COLOURS: [RGBColor; AGENTS.len()] =
    [RGBColor(0, 90, 160), RGBColor(110, 50, 110), RGBColor(240, 150, 30), RGBColor(170, 170, 170)];

/// Space around the bars of a template, and height of a bar, px.
const GAP: u32 = 4;
const BAR: u32 = 6;

/// Rows below the last template that the legend takes.
const LEGEND: usize = 2;

/// Draws the plot as SVG.
///
/// # Errors
/// If it cannot be written.
pub fn draw(results: &[FoldResult], path: &Path) -> anyhow::Result<()> {
    let root = SVGBackend::new(path, (2 * PANEL.0, PANEL.1)).into_drawing_area();
    let drawn = (|| {
        root.fill(&WHITE)?;
        for (panel, setup) in root.split_evenly((1, 2)).iter().zip([Setup::Within, Setup::Cross]) {
            bars(&of(results, setup).collect::<Vec<_>>(), setup, panel)?;
        }
        root.present()
    })();
    drawn.map_err(|error| anyhow!("cannot draw {}: {error}", path.display()))
}

type Drawn = Result<(), DrawingAreaErrorKind<std::io::Error>>;

/// Draws one panel.
fn bars(results: &[&FoldResult], setup: Setup, panel: &DrawingArea<SVGBackend, Shift>) -> Drawn {
    let count = TEMPLATES.len();
    // The first template is at the top; below the last there is room for the legend.
    let last = count + LEGEND - 1;
    let place = |template: usize| SegmentValue::Exact(last - template);
    let mut chart = ChartBuilder::on(panel)
        .caption(format!("{setup}, mean over the folds that test it"), ("sans-serif", 18))
        .margin(10)
        .margin_right(20)
        .x_label_area_size(40)
        .y_label_area_size(190)
        .build_cartesian_2d(0.0..100.0, (0..last).into_segmented())?;
    chart
        .configure_mesh()
        .disable_y_mesh()
        .light_line_style(TRANSPARENT)
        .x_desc("auccess")
        .y_labels(last + 1)
        .x_label_formatter(&|auccess| format!("{auccess:.0}"))
        .y_label_formatter(&|place| match place {
            SegmentValue::Exact(place) | SegmentValue::CenterOf(place) => {
                let template = last.checked_sub(*place).and_then(|number| TEMPLATES.get(number));
                template.map(|one| format!("{:05} {}", one.number, one.name)).unwrap_or_default()
            }
            SegmentValue::Last => String::new(),
        })
        .draw()?;
    for (bar, ((agent, name), colour)) in (0..).zip(AGENTS.into_iter().zip(COLOURS)) {
        let rectangles = (0..count).filter_map(|template| {
            let scores: Vec<f64> = results
                .iter()
                .map(|result| result.first_solved(agent, Some(template)))
                .filter(|firsts| !firsts.is_empty())
                .map(|firsts| auccess(&firsts))
                .collect();
            let mean = scores.iter().sum::<f64>() / scores.len() as f64;
            let above = if template == 0 { SegmentValue::Last } else { place(template - 1) };
            let mut rectangle = Rectangle::new([(0.0, place(template)), (mean, above)], colour.filled());
            let (top, bottom) = (GAP + BAR * bar, GAP + BAR * (AGENTS.len() as u32 - 1 - bar));
            rectangle.set_margin(top, bottom, 0, 0);
            (!scores.is_empty()).then_some(rectangle)
        });
        chart
            .draw_series(rectangles)?
            .label(name)
            .legend(move |(x, y)| Rectangle::new([(x, y - 4), (x + 14, y + 4)], colour.filled()));
    }
    chart
        .configure_series_labels()
        .position(SeriesLabelPosition::LowerRight)
        .background_style(WHITE.mix(0.85))
        .border_style(TRANSPARENT)
        .draw()
}
