//! The part of the report on how the nets of each fold were trained.

use std::fmt::{self, Write as _};

use super::fold_result::FoldResult;
use crate::training::training_run::Checkpoint;

/// Writes it: a table for each kind of net.
pub fn write(text: &mut String, results: &[FoldResult]) -> fmt::Result {
    writeln!(
        text,
        "\n## Training\n\nThe success net and the dynamics net are trained alike, from fresh weights, so the \
         difference between them shows what imagining brings. Learning rates are peak values; they warm up, then decay \
         linearly to zero. A loss is the mean over the last batches. `costs.md` has the times."
    )?;
    table(
        text,
        "The success net",
        "balls | epochs x batch x balls | optimiser | learning rate | loss",
        results,
        |FoldResult { success, .. }| {
            let card = success.card.success.as_ref()?;
            Some(format!(
                "{} | {} x {} x {} | {} | {} | {:.4}",
                card.balls,
                card.epochs,
                card.batch,
                card.balls_per_scene,
                card.optimiser,
                card.learning_rate,
                last_loss(success, "success")
            ))
        },
    )?;
    table(
        text,
        "The dynamics net",
        "balls | epochs x batch x balls (imagined) | optimiser | learning rate | path weight, of solving balls | \
         loss of a ball",
        results,
        |FoldResult { dynamics, .. }| {
            let card = dynamics.card.dynamics.as_ref()?;
            Some(format!(
                "{} | {} x {} x {} ({}) | {} | {} | {}, {} | {:.4}",
                card.balls,
                card.epochs,
                card.batch,
                card.balls_per_scene,
                card.imagined_per_scene,
                card.optimiser,
                card.learning_rate,
                card.path_weights.all,
                card.path_weights.solving,
                last_loss(dynamics, "ball")
            ))
        },
    )?;
    table(
        text,
        "DQN",
        "balls | epochs x batch x balls | optimiser | learning rate | loss",
        results,
        |FoldResult { dqn, .. }| {
            let card = &dqn.card;
            Some(format!(
                "{} | {} x {} x {} | {} | {} | {:.4}",
                card.balls,
                card.epochs,
                card.batch,
                card.balls_per_scene,
                card.optimiser,
                card.learning_rate,
                last_loss(dqn, "dqn")
            ))
        },
    )?;
    writeln!(
        text,
        "\nAs published, DQN classifies scene and action: a residual net reads the scene, a perceptron of the action \
         multiplies and shifts the channels before its last stage, and the loss is the binary cross-entropy on batches \
         of which half are solutions. A fixed list of 10,000 actions is ranked for every task. Smaller than published, \
         so that one core trains it in less than an hour: 64 x 64 cells instead of 256 x 256 pixels; one residual \
         block in a stage instead of two and none in the first; 16 to 96 channels instead of 64 to 512; no batch \
         normalisation. Many balls share one reading of a scene, batches are balanced in each scene, and scenes are \
         mirrored."
    )
}

/// Writes a table with a line for each result.
fn table(
    text: &mut String,
    title: &str,
    columns: &str,
    results: &[FoldResult],
    cells: impl Fn(&FoldResult) -> Option<String>,
) -> fmt::Result {
    let count = columns.split(" | ").count();
    writeln!(text, "\n### {title}\n\n| setup | fold | {columns} |\n| --- |{}", " ---: |".repeat(count + 1))?;
    for result in results {
        if let Some(cells) = cells(result) {
            writeln!(text, "| {} | {} | {cells} |", result.report.setup, result.report.fold)?;
        }
    }
    Ok(())
}

/// The last value of a loss, by its name; NaN if the run has none.
fn last_loss<C>(run: &Checkpoint<C>, name: &str) -> f32 {
    let index = run.losses.iter().position(|loss| loss == name);
    let last = run.log.last().zip(index).and_then(|((_, _, losses), index)| losses.get(index));
    last.copied().unwrap_or(f32::NAN)
}
