//! Merges the files of `data collect` or `data label` for single templates (`--template`) into the one file that a
//! run over all templates writes, byte for byte. So the data are made in as many jobs as there are templates, or in
//! fewer.
//!
//! That works because tasks of different templates share nothing.

use std::collections::BTreeMap;
use std::fs;
use std::num::NonZeroUsize;
use std::path::{Path, PathBuf};

use anyhow::{Context, ensure};
use pathlight::benchmark::folds::Fold;
use pathlight::puzzle::task::{TaskId, ids};
use pathlight::puzzle::templates::TEMPLATES;
use serde::Serialize;

use crate::data::label::Scenes;
use crate::data::labels::LabelledBalls;
use crate::data::solutions::TaskSolutions;
use crate::files::differences::differences;
use crate::files::journal::{self, Entry, is_file_of};
use crate::files::replace_file::replace_file;

/// The file of one template.
struct Shard<E: Entry> {
    path: PathBuf,
    template: usize,
    /// Those of the file of all templates, but for the number of tasks.
    settings: E::Settings,
    entries: Vec<E>,
}

/// Merges files of one kind, each of one template and all with the same other settings, into a file. Returns whether it
/// was written; it is not if it exists with these contents.
///
/// # Errors
/// If the files do not belong together or are not complete, or the file exists with other contents.
pub fn merge(files: &[PathBuf], out: &Path) -> anyhow::Result<bool> {
    let first = files.first().context("no file to merge is named")?;
    let collected = is_file_of::<TaskSolutions>(first)?;
    let merged = if collected { merged_solutions(files)? } else { merged_labels(files)? };
    if let Ok(existing) = fs::read(out) {
        ensure!(existing == merged, "{} exists with other contents: choose another --out, or remove it", out.display());
        return Ok(false);
    }
    replace_file(out, &merged)?;
    Ok(true)
}

/// Reads shards, by ascending template. `template` is the field of the settings, which is emptied.
fn read<E: Entry>(
    files: &[PathBuf],
    template: impl Fn(&mut E::Settings) -> &mut Option<usize>,
) -> anyhow::Result<Vec<Shard<E>>> {
    let mut shards: BTreeMap<usize, Shard<E>> = BTreeMap::new();
    for path in files {
        let name = path.display();
        let (mut settings, entries) = journal::read::<E>(path)?;
        let template = template(&mut settings).take().with_context(|| {
            format!("{name} is not of one template: make it with `pathlight-lab {} --template`", E::COMMAND)
        })?;
        ensure!(template < TEMPLATES.len(), "{name} names a template that does not exist: make it again");
        if let Some(other) = shards.get(&template) {
            anyhow::bail!("{name} and {} are of the same template: leave one out", other.path.display());
        }
        shards.insert(template, Shard { path: path.clone(), template, settings, entries });
    }
    Ok(shards.into_values().collect())
}

/// Checks that shards differ in nothing but the template, and are of all templates that have tasks.
fn check<E: Entry>(shards: &[Shard<E>], tasks: &[TaskId]) -> anyhow::Result<()> {
    let first = &shards[0];
    for shard in shards {
        let other = differences(&shard.settings, &first.settings);
        let (name, first) = (shard.path.display(), first.path.display());
        ensure!(other.is_empty(), "{name} has other settings than {first} ({other}): make one of them again");
    }
    let has = |template| shards.iter().any(|shard| shard.template == template);
    let mut lacking: Vec<usize> = tasks.iter().map(|task| task.template).filter(|&template| !has(template)).collect();
    lacking.dedup();
    let named: Vec<String> = lacking.iter().map(|template| format!("{template:05}")).collect();
    ensure!(
        lacking.is_empty(),
        "no file is of {}: make those with `pathlight-lab {} --template`, and name all files",
        named.join(", "),
        E::COMMAND
    );
    Ok(())
}

/// The first tasks of each template.
fn tasks(limit: usize) -> Vec<TaskId> {
    TEMPLATES.iter().flat_map(|template| ids(template).take(limit)).collect()
}

fn merged_solutions(files: &[PathBuf]) -> anyhow::Result<Vec<u8>> {
    let shards = read::<TaskSolutions>(files, |settings| &mut settings.template)?;
    let settings = &shards[0].settings;
    check(&shards, &tasks(settings.limit))?;
    let mut lines = Lines::new(settings)?;
    for Shard { path, template, entries, .. } in &shards {
        let name = path.display();
        ensure!(
            entries.len() == ids(TEMPLATES[*template]).take(settings.limit).count(),
            "{name} is not complete: continue it with the `pathlight-lab data collect` that began it"
        );
        entries.iter().try_for_each(|entry| lines.push(entry))?;
    }
    Ok(lines.0)
}

fn merged_labels(files: &[PathBuf]) -> anyhow::Result<Vec<u8>> {
    let mut shards = read::<LabelledBalls>(files, |settings| &mut settings.template)?;
    let per_round: Vec<usize> = shards.iter().map(|shard| shard.settings.tasks.get()).collect();
    let settings = &shards[0].settings;
    let mut tasks = tasks(settings.limit);
    if let Some((setup, fold)) = settings.training_tasks_of {
        let training = Fold::new(setup, fold).all_train();
        tasks.retain(|task| training.binary_search(task).is_ok());
    }
    let scenes = match settings.scenes() {
        Scenes::Unlisted(_) => per_round.iter().sum(),
        _ => tasks.len(),
    };
    let all = NonZeroUsize::new(scenes).context("the files are of no tasks: make them again")?;
    shards.iter_mut().for_each(|shard| shard.settings.tasks = all);
    check(&shards, &tasks)?;
    let rounds = shards[0].entries.len() / per_round[0];
    for (shard, per_round) in shards.iter().zip(&per_round) {
        ensure!(
            shard.entries.len() == rounds * per_round,
            "{} and {} do not have equally many whole rounds: continue them with the `pathlight-lab data label` that \
             began them",
            shards[0].path.display(),
            shard.path.display()
        );
    }
    let mut lines = Lines::new(&shards[0].settings)?;
    for round in 0..rounds {
        for (shard, per_round) in shards.iter().zip(&per_round) {
            shard.entries[round * per_round..][..*per_round].iter().try_for_each(|entry| lines.push(entry))?;
        }
    }
    Ok(lines.0)
}

/// JSON lines, beginning with settings.
struct Lines(Vec<u8>);

impl Lines {
    fn new(settings: &impl Serialize) -> anyhow::Result<Lines> {
        let mut lines = Lines(Vec::new());
        lines.push(settings)?;
        Ok(lines)
    }

    fn push(&mut self, line: &impl Serialize) -> anyhow::Result<()> {
        serde_json::to_writer(&mut self.0, line)?;
        self.0.push(b'\n');
        Ok(())
    }
}
