//! The parts of report and costs on DQN: how it was trained, what is smaller than the published net, and how long it took.

use std::fmt::{self, Write as _};

use super::dqn_result::DqnResult;
use super::fold_result::FoldResult;

/// Writes it; nothing if no result has DQN.
pub fn training(text: &mut String, results: &[FoldResult]) -> fmt::Result {
    if of_dqn(results).next().is_none() {
        return Ok(());
    }
    writeln!(
        text,
        "\n### DQN\n\n\
         As published, DQN classifies scene and action: a residual net reads the scene, a perceptron of the action multiplies \
         and shifts the channels before its last stage, and the loss is the binary cross-entropy on batches of which half are \
         solutions. A fixed list of 10,000 actions is ranked for every task. Smaller than published, so that one core trains \
         it in less than an hour: 64 x 64 cells instead of 256 x 256 pixels; one residual block in a stage instead of two and \
         none in the first; 16 to 96 channels instead of 64 to 512; no batch normalisation. Many balls share one reading of a \
         scene, batches are balanced in each scene, and scenes are mirrored.\n"
    )?;
    writeln!(
        text,
        "| setup | fold | balls | epochs x batch x balls | learning rate | loss | weights, MB | SHA-256 of the balls |\n|{} --- |",
        " ---: |".repeat(7)
    )?;
    for DqnResult { training, weights, report, .. } in of_dqn(results) {
        let card = &training.card;
        let loss = training.log.last().and_then(|(_, _, losses)| losses.last().copied()).unwrap_or(f32::NAN);
        writeln!(
            text,
            "| {} | {} | {} | {} x {} x {} | {} | {loss:.4} | {:.2} | `{}` |",
            report.setup,
            report.fold,
            card.balls,
            card.epochs,
            card.batch,
            card.balls_per_scene,
            card.learning_rate,
            *weights as f64 / 1e6,
            training.data,
        )?;
    }
    Ok(())
}

/// Writes how long it took; nothing if no result has DQN.
pub fn costs(text: &mut String, results: &[FoldResult]) -> fmt::Result {
    if of_dqn(results).next().is_none() {
        return Ok(());
    }
    writeln!(
        text,
        "\n## DQN, minutes of wall-clock time\n\n| setup | fold | training | evaluation |\n|{}",
        " ---: |".repeat(4)
    )?;
    for DqnResult { training, evaluation_seconds, report, .. } in of_dqn(results) {
        let (training, evaluation) = (training.seconds / 60.0, evaluation_seconds / 60.0);
        writeln!(text, "| {} | {} | {training:.1} | {evaluation:.1} |", report.setup, report.fold)?;
    }
    Ok(())
}

fn of_dqn(results: &[FoldResult]) -> impl Iterator<Item = &DqnResult> {
    results.iter().filter_map(|result| result.dqn.as_ref())
}
