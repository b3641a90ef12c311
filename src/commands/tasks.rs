//! `pathlight tasks`: lists the templates or the tasks of a template or a fold, or prints scenes as JSON.
//!
//! The JSON of a task is that of `pathlight::puzzle::task::Task`.

use std::io::{self, BufWriter, Write};
use std::path::PathBuf;

use clap::ValueEnum;
use pathlight::benchmark::folds::{Fold, Setup};
use pathlight::command_line::fold_args;
use pathlight::command_line::template_arg::template;
use pathlight::puzzle::custom_scene::CustomScene;
use pathlight::puzzle::scene::Scene;
use pathlight::puzzle::task::{Task, TaskId};
use pathlight::puzzle::templates::{TEMPLATES, Template};
use serde::Serialize;
use serde_json::{Map, Value};

use super::custom_scene_file;

/// List the templates, the tasks of a template or of a fold, or print scenes as JSON
#[derive(clap::Args)]
pub struct Args {
    /// List the 100 tasks of this template, with their parameters
    #[arg(long, value_name = "TEMPLATE", value_parser = template)]
    template: Option<&'static Template>,

    /// List the tasks of this fold of the benchmark, 0 to 9
    #[arg(long, value_name = "N", value_parser = fold_args::fold, conflicts_with = "template")]
    fold: Option<u8>,

    /// Setup of the fold: what an agent must generalise to
    #[arg(long, value_parser = fold_args::setup(), default_value = "within", requires = "fold")]
    setup: Setup,

    /// Part of the fold
    #[arg(long, value_enum, default_value_t = Part::Test, requires = "fold")]
    part: Part,

    /// Print scenes as JSON, one per line: the scene of this task, like 00007:008; without a task, the scenes of the
    /// template or the fold, or of all tasks
    #[arg(long, value_name = "TASK", num_args = 0..=1)]
    json: Option<Option<TaskId>>,

    /// Print the custom scene in this file ("-" is standard input) as JSON, as it is simulated
    #[arg(long, value_name = "FILE", conflicts_with_all = ["template", "fold", "json"])]
    scene: Option<PathBuf>,

    /// Print this task as a custom scene, which can be edited and played with --scene
    #[arg(long, value_name = "TASK", conflicts_with_all = ["template", "fold", "json", "scene"])]
    custom: Option<TaskId>,

    /// Print the JSON Schema of custom scenes
    #[arg(long, conflicts_with_all = ["template", "fold", "json", "scene", "custom"])]
    schema: bool,
}

/// The parts of a fold.
#[derive(Clone, Copy, ValueEnum)]
enum Part {
    /// The tasks to test on
    Test,
    /// The training tasks to choose settings on
    Dev,
    /// The other training tasks
    Train,
}

impl Args {
    pub fn run(self) -> anyhow::Result<()> {
        let mut out = BufWriter::new(io::stdout().lock());
        if self.schema {
            serde_json::to_writer_pretty(&mut out, &schemars::schema_for!(CustomScene))?;
            writeln!(out)?;
        } else if let Some(task) = self.custom {
            let custom = CustomScene::of(&Task::load(task)?.scene).expect("a template uses the four shapes");
            writeln!(out, "{}", serde_json::to_string(&custom)?)?;
        } else if let Some(file) = &self.scene {
            let puzzle = custom_scene_file::read(file)?;
            writeln!(out, "{}", serde_json::to_string(&CustomTask { goal: &puzzle.goal, scene: &puzzle.scene })?)?;
        } else {
            self.print_tasks(&mut out)?;
        }
        Ok(out.flush()?)
    }

    fn print_tasks(&self, out: &mut impl Write) -> anyhow::Result<()> {
        match (self.json, self.template, self.fold) {
            (Some(Some(id)), None, None) => print_json(out, &Task::load(id)?)?,
            (Some(Some(_)), ..) => anyhow::bail!("--json names a single task: omit --template and --fold"),
            (Some(None), _, Some(fold)) => {
                for id in self.part_of(fold) {
                    print_json(out, &Task::load(id)?)?;
                }
            }
            (Some(None), Some(template), None) => print_all_json(out, template)?,
            (Some(None), None, None) => TEMPLATES.iter().try_for_each(|template| print_all_json(out, template))?,
            (None, _, Some(fold)) => self.part_of(fold).iter().try_for_each(|id| writeln!(out, "{id}"))?,
            (None, Some(template), None) => list_tasks(out, template)?,
            (None, None, None) => list_templates(out)?,
        }
        Ok(())
    }

    fn part_of(&self, fold: u8) -> Vec<TaskId> {
        let Fold { train, dev, test } = Fold::new(self.setup, fold);
        match self.part {
            Part::Test => test,
            Part::Dev => dev,
            Part::Train => train,
        }
    }
}

/// A custom scene as it is simulated.
#[derive(Serialize)]
struct CustomTask<'a> {
    goal: &'a str,
    #[serde(flatten)]
    scene: &'a Scene,
}

/// One line per template: id, name, and the goal sentence, which is the same for all its tasks.
fn list_templates(out: &mut impl Write) -> io::Result<()> {
    let width = TEMPLATES.iter().map(|template| template.name.len()).max().unwrap_or(0);
    for template in TEMPLATES {
        let first = Task::of(template).next().expect("every template has tasks");
        writeln!(out, "{:05}  {:width$}  {}", template.number, template.name, first.goal)?;
    }
    Ok(())
}

/// One line per task: id, then a column per parameter.
fn list_tasks(out: &mut impl Write, template: &'static Template) -> io::Result<()> {
    let tasks: Vec<Task> = Task::of(template).collect();
    let widths: Vec<usize> = template
        .grid
        .iter()
        .map(|(name, _)| tasks.iter().map(|task| setting(&task.params, name).len()).max().unwrap_or(0))
        .collect();
    for task in &tasks {
        write!(out, "{}", task.id)?;
        let (last, others) = template.grid.split_last().expect("every template has parameters");
        for ((name, _), width) in others.iter().zip(&widths) {
            write!(out, "  {:width$}", setting(&task.params, name))?;
        }
        writeln!(out, "  {}", setting(&task.params, last.0))?;
    }
    Ok(())
}

/// Formats a parameter as `name=value`, strings without quotes.
fn setting(params: &Map<String, Value>, name: &str) -> String {
    match &params[name] {
        Value::String(word) => format!("{name}={word}"),
        value => format!("{name}={value}"),
    }
}

fn print_all_json(out: &mut impl Write, template: &'static Template) -> io::Result<()> {
    Task::of(template).try_for_each(|task| print_json(out, &task))
}

fn print_json(out: &mut impl Write, task: &Task) -> io::Result<()> {
    serde_json::to_writer(&mut *out, task)?;
    writeln!(out)
}
