//! Measures how well the simulator agrees with PHYRE's: how many rollouts are bit-identical, and how many outcomes
//! match PHYRE's record.
//!
//! The reference folder contains outcomes.jsonl (task, ball, kind, solved, digest) and is not part of the project. For
//! an engine other than the first, the table of the first engine is printed before its own.

use std::fs;
use std::io::Write;
use std::path::{Path, PathBuf};
use std::time::Instant;

use anyhow::{Context, bail};
use pathlight::puzzle::action::Ball;
use pathlight::puzzle::task::{Task, TaskId};
use pathlight::puzzle::templates::TEMPLATES;
use pathlight::puzzle::utf8::utf8;
use pathlight::simulator::Engine;
use rayon::prelude::*;
use serde::Deserialize;
use serde::de::DeserializeOwned;

use crate::progress::Progress;

/// What to compare.
pub struct Settings {
    /// Folder with outcomes.jsonl.
    pub reference: PathBuf,
    /// Maximum number of tasks per template; the first are used.
    pub limit: usize,
    pub engine: Engine,
}

/// A line of outcomes.jsonl.
#[derive(Deserialize)]
struct Recorded {
    task: TaskId,
    ball: Ball,
    kind: Kind,
    /// PHYRE's record; for random balls, the outcome in its Box2D.
    solved: bool,
    /// `simulator::Digest` of the rollout in its Box2D.
    digest: String,
}

/// How a recorded ball was found.
#[derive(Clone, Copy, PartialEq, Eq, Deserialize)]
#[serde(rename_all = "lowercase")]
enum Kind {
    /// A solution that still solves after small shifts, in PHYRE's own engine.
    Stable,
    /// A solution that is not stable.
    Unstable,
    /// A uniform valid ball.
    Random,
}

/// The columns of the table: name, kind of ball, and recorded outcome.
const COLUMNS: [(&str, Kind, bool); 4] = [
    ("stable", Kind::Stable, true),
    ("unstable", Kind::Unstable, true),
    ("random misses", Kind::Random, false),
    ("random solves", Kind::Random, true),
];

/// Number of bit-identical rollouts, of matching outcomes, and of all rollouts.
#[derive(Clone, Copy, Default)]
struct Agreement {
    same: usize,
    agree: usize,
    all: usize,
}

impl Settings {
    /// Writes the tables.
    ///
    /// # Errors
    /// If the reference cannot be used, or the tables cannot be written.
    pub fn compare(&self, out: &mut dyn Write, progress: &mut dyn Progress) -> anyhow::Result<()> {
        let recorded = read_lines(&self.reference.join("outcomes.jsonl"))?;
        let recorded: Vec<Recorded> = recorded.into_iter().filter(|line: &Recorded| self.wants(line.task)).collect();
        // Compare any other engine with the first.
        let engines = [Engine::default(), self.engine];
        let engines = &engines[..if engines[1].is_first() { 1 } else { 2 }];
        for &engine in engines {
            let started = Instant::now();
            if engines.len() > 1 {
                writeln!(out, "{}Engine {engine}\n", if engine.is_first() { "" } else { "\n" })?;
            }
            write_agreements(out, engine, &recorded)?;
            progress.say(&format!("{engine} took {:.1} s", started.elapsed().as_secs_f64()));
        }
        Ok(())
    }

    /// Whether a task is one of the first of its template. Unknown tasks are kept, so that loading them reports them.
    fn wants(&self, task: TaskId) -> bool {
        let selected = TEMPLATES.get(task.template).map_or(&[][..], |template| &template.task_numbers);
        selected.iter().take(self.limit).any(|&number| number == task.number) || !selected.contains(&task.number)
    }
}

fn write_agreements(out: &mut dyn Write, engine: Engine, lines: &[Recorded]) -> anyhow::Result<()> {
    let found: Vec<(bool, bool)> = lines
        .par_iter()
        .map(|line| {
            let scene = Task::load(line.task)?.scene;
            let (outcome, digest) = engine.digest(&scene, Some(line.ball)).with_context(|| description(line))?;
            Ok((digest.to_string() == line.digest, outcome.solved == line.solved))
        })
        .collect::<anyhow::Result<_>>()?;

    // [template, or all][column]
    let mut agreements = vec![[Agreement::default(); COLUMNS.len()]; TEMPLATES.len() + 1];
    for (line, (same, agrees)) in lines.iter().zip(found) {
        let column = COLUMNS.iter().position(|&(_, kind, recorded)| kind == line.kind && recorded == line.solved);
        let Some(column) = column else {
            bail!("{} is recorded as a solution that does not solve: correct outcomes.jsonl", description(line))
        };
        for row in [line.task.template, TEMPLATES.len()] {
            let agreement = &mut agreements[row][column];
            agreement.same += usize::from(same);
            agreement.agree += usize::from(agrees);
            agreement.all += 1;
        }
    }
    writeln!(out, "Bit-identical rollouts, outcomes that match PHYRE's record, % (of how many)")?;
    writeln!(out, "{:9}{}", "", COLUMNS.map(|(name, ..)| format!("{name:^27}")).concat())?;
    for (template, columns) in agreements.iter().enumerate() {
        let name = if template < TEMPLATES.len() { format!("{template:05}") } else { "all".into() };
        writeln!(out, "{name:9}{}", columns.map(cell).concat())?;
    }
    Ok(())
}

fn read_lines<T: DeserializeOwned>(path: &Path) -> anyhow::Result<Vec<T>> {
    let cannot_read = || format!("cannot read {}: name its folder with --reference", path.display());
    let bytes = fs::read(path).with_context(cannot_read)?;
    let text = utf8(&bytes).with_context(cannot_read)?;
    let parse =
        |(number, line)| serde_json::from_str(line).with_context(|| format!("{}, line {}", path.display(), number + 1));
    text.lines().enumerate().map(parse).collect()
}

fn description(line: &Recorded) -> String {
    format!("task {}, ball {}", line.task, line.ball)
}

/// Formats both counts as percentages, followed by the total.
fn cell(Agreement { same, agree, all }: Agreement) -> String {
    let percent = |count: usize| match all {
        0 => "-".to_string(),
        all => format!("{:.2}", 100.0 * count as f64 / all as f64),
    };
    format!("{:>9}{:>9}{:>9}", percent(same), percent(agree), format!("({all})"))
}
