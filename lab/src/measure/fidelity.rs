//! How well the simulator agrees with PHYRE's own.
//!
//! The reference folder has outcomes.jsonl (task, ball, kind, solved) and trajectories.jsonl (poses of rollouts); it is
//! not part of the project. With another engine than the first, the tables of the first come before its
//! own. The tables have columns for even and for odd task numbers: tune the simulator on the even
//! ones, the odd ones are held out.

use std::fs;
use std::io::Write;
use std::path::{Path, PathBuf};
use std::time::Instant;

use anyhow::{Context, bail};
use pathlight::puzzle::action::Ball;
use pathlight::puzzle::rollout::STEPS_PER_SECOND;
use pathlight::puzzle::task::{Task, TaskId};
use pathlight::puzzle::templates::TEMPLATES;
use pathlight::simulator::Engine;
use rayon::prelude::*;
use serde::Deserialize;
use serde::de::DeserializeOwned;

use crate::progress::Progress;

/// What to compare.
pub struct Settings {
    /// Folder with outcomes.jsonl and trajectories.jsonl.
    pub reference: PathBuf,
    /// Only the first tasks of each template.
    pub limit: usize,
    pub engine: Engine,
}

/// A line of outcomes.jsonl.
#[derive(Deserialize)]
struct Recorded {
    task: TaskId,
    ball: Ball,
    kind: Kind,
    solved: bool,
}

/// How a recorded ball was found.
#[derive(Clone, Copy, PartialEq, Eq, Deserialize)]
#[serde(rename_all = "lowercase")]
enum Kind {
    /// A solution that still solves after small shifts, on PHYRE's own engine.
    Stable,
    /// A solution that does not.
    Unstable,
    /// A uniform valid ball.
    Random,
}

/// A line of trajectories.jsonl: `poses[row][column]` is the pose of a moving body after step
/// `first_step + row * every`; the columns are those of `Rollout`.
#[derive(Deserialize)]
struct Trajectory {
    task: TaskId,
    ball: Option<Ball>,
    every: usize,
    first_step: usize,
    poses: Vec<Vec<[f64; 3]>>,
}

/// The columns of the table of outcomes: name, kind of ball, and recorded outcome.
const COLUMNS: [(&str, Kind, bool); 4] = [
    ("stable", Kind::Stable, true),
    ("unstable", Kind::Unstable, true),
    ("random misses", Kind::Random, false),
    ("random solves", Kind::Random, true),
];

/// Times at which poses are compared, s.
const TIMES: [usize; 4] = [1, 2, 4, 7];

/// How many outcomes agree, of how many.
#[derive(Clone, Copy, Default)]
struct Agreement {
    agree: usize,
    all: usize,
}

impl Settings {
    /// Writes the tables.
    ///
    /// # Errors
    /// If the reference cannot be used, or nobody takes the tables.
    pub fn compare(&self, out: &mut dyn Write, progress: &mut dyn Progress) -> anyhow::Result<()> {
        let recorded: Vec<Recorded> = read_lines(&self.reference.join("outcomes.jsonl"))?;
        let recorded: Vec<Recorded> = recorded.into_iter().filter(|line| self.wants(line.task)).collect();
        let trajectories: Vec<Trajectory> = read_lines(&self.reference.join("trajectories.jsonl"))?;
        let trajectories: Vec<Trajectory> = trajectories.into_iter().filter(|line| self.wants(line.task)).collect();
        // Another engine stands beside the first.
        let engines = [Engine::default(), self.engine];
        let engines = &engines[..if engines[1].is_first() { 1 } else { 2 }];
        for &engine in engines {
            let started = Instant::now();
            if engines.len() > 1 {
                writeln!(out, "{}Engine {engine}\n", if engine.is_first() { "" } else { "\n" })?;
            }
            write_agreements(out, engine, &recorded)?;
            write_distances(out, engine, &trajectories)?;
            progress.say(&format!("{engine} took {:.1} s", started.elapsed().as_secs_f64()));
        }
        Ok(())
    }

    /// Is it one of the first tasks of its template? Unknown tasks are kept, so that loading them names them.
    fn wants(&self, task: TaskId) -> bool {
        let selected = TEMPLATES.get(task.template).map_or(&[][..], |template| &template.task_numbers);
        selected.iter().take(self.limit).any(|&number| number == task.number) || !selected.contains(&task.number)
    }
}

fn write_agreements(out: &mut dyn Write, engine: Engine, lines: &[Recorded]) -> anyhow::Result<()> {
    let solved: Vec<bool> = lines
        .par_iter()
        .map(|line| {
            let scene = Task::load(line.task)?.scene;
            Ok(engine.outcome(&scene, Some(line.ball)).with_context(|| description(line))?.solved)
        })
        .collect::<anyhow::Result<_>>()?;

    // [template, or all][column][even or odd]
    let mut agreements = vec![[[Agreement::default(); 2]; COLUMNS.len()]; TEMPLATES.len() + 1];
    for (line, solved) in lines.iter().zip(solved) {
        let column = COLUMNS.iter().position(|&(_, kind, recorded)| kind == line.kind && recorded == line.solved);
        let Some(column) = column else {
            bail!("{} is recorded as a solution that does not solve: correct outcomes.jsonl", description(line))
        };
        for row in [line.task.template, TEMPLATES.len()] {
            let agreement = &mut agreements[row][column][usize::from(line.task.number % 2)];
            agreement.agree += usize::from(solved == line.solved);
            agreement.all += 1;
        }
    }
    writeln!(out, "Outcomes that agree, %: even task numbers, odd ones, both (of how many)")?;
    writeln!(out, "{:9}{}", "", COLUMNS.map(|(name, ..)| format!("{name:^30}")).concat())?;
    for (template, columns) in agreements.iter().enumerate() {
        let name = if template < TEMPLATES.len() { format!("{template:05}") } else { "all".into() };
        writeln!(out, "{name:9}{}", columns.map(cell).concat())?;
    }
    Ok(())
}

fn write_distances(out: &mut dyn Write, engine: Engine, lines: &[Trajectory]) -> anyhow::Result<()> {
    let errors: Vec<[Vec<f64>; TIMES.len()]> =
        lines.par_iter().map(|line| errors(line, engine)).collect::<anyhow::Result<_>>()?;
    writeln!(out, "\nDistance from the reference position of each moving body, px: median, 90th percentile (bodies)")?;
    writeln!(out, "{:14}{}", "", TIMES.map(|time| format!("{:^26}", format!("{time} s"))).concat())?;
    for (name, with_ball) in [("without a ball", false), ("with a ball", true)] {
        let cells = [0, 1, 2, 3].map(|time| {
            let of_kind = lines.iter().zip(&errors).filter(|(line, _)| line.ball.is_some() == with_ball);
            let mut errors: Vec<f64> = of_kind.flat_map(|(_, errors)| &errors[time]).copied().collect();
            errors.sort_by(f64::total_cmp);
            format!("{:>9} {:>8} {:>7}", quantile(&errors, 0.5), quantile(&errors, 0.9), format!("({})", errors.len()))
        });
        writeln!(out, "{name:14}{}", cells.concat())?;
    }
    Ok(())
}

/// Returns the distances of the bodies from their reference positions at each of the times, px; empty where either
/// rollout has ended.
fn errors(line: &Trajectory, engine: Engine) -> anyhow::Result<[Vec<f64>; TIMES.len()]> {
    let Trajectory { task, every, first_step, .. } = *line;
    let rollout = engine.simulate(&Task::load(task)?.scene, line.ball).with_context(|| task.to_string())?;
    Ok(TIMES.map(|time| {
        // The first row at this time or after it.
        let row = (time * STEPS_PER_SECOND).saturating_sub(first_step).div_ceil(every.max(1));
        let step = first_step + row * every;
        let Some(expected) = line.poses.get(row).filter(|_| step <= rollout.steps) else { return Vec::new() };
        let distance =
            |(&[x, y, _], &[u, v, _]): (&[f32; 3], &[f64; 3])| libm::hypot(f64::from(x) - u, f64::from(y) - v);
        rollout.row(step).iter().zip(expected).map(distance).collect()
    }))
}

fn read_lines<T: DeserializeOwned>(path: &Path) -> anyhow::Result<Vec<T>> {
    let text = fs::read_to_string(path)
        .with_context(|| format!("cannot read {}: --reference names the folder it is in", path.display()))?;
    let parse =
        |(number, line)| serde_json::from_str(line).with_context(|| format!("{}, line {}", path.display(), number + 1));
    text.lines().enumerate().map(parse).collect()
}

fn description(line: &Recorded) -> String {
    format!("task {}, ball {}", line.task, line.ball)
}

/// Formats even, odd and both as percentages, and how many there are.
fn cell([even, odd]: [Agreement; 2]) -> String {
    let both = Agreement { agree: even.agree + odd.agree, all: even.all + odd.all };
    let percent = |agreement: Agreement| match agreement.all {
        0 => "-".to_string(),
        all => format!("{:.1}", 100.0 * agreement.agree as f64 / all as f64),
    };
    format!("{:>7}{:>7}{:>7}{:>9}", percent(even), percent(odd), percent(both), format!("({})", both.all))
}

/// Formats the nearest-rank quantile of ascending values.
fn quantile(sorted: &[f64], fraction: f64) -> String {
    match sorted.len() {
        0 => "-".into(),
        count => format!("{:.2}", sorted[((fraction * count as f64).ceil() as usize).clamp(1, count) - 1]),
    }
}
