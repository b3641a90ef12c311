//! What agents that remember achieve, as Markdown: printed by `measure evaluate --carry`, and by `measure carried` for
//! the results of several folds.

use std::collections::BTreeMap;
use std::fmt::{self, Write as _};

use pathlight::agents::agent_name::AgentName;
use pathlight::benchmark::auccess::auccess;
use pathlight::benchmark::folds::FoldId;
use pathlight::puzzle::task::TaskId;
use pathlight::puzzle::templates::TEMPLATES;

use super::{MemoryUse, Report, Run};
use crate::measure::agents::row;
use crate::measure::report::{score_cell, score_of};
use crate::measure::task_set::TaskSet;

/// The parts of the learning curve: from which task of a template to which.
const PARTS: [(usize, usize); 6] = [(1, 1), (2, 5), (6, 10), (11, 20), (21, 50), (51, 100)];

const HEAD: &str = "# Agents that remember

`pathlight-lab measure carried results/carried` printed this from the files beside it, which `pathlight-lab measure \
evaluate --carry` wrote.

Here an agent meets the test tasks of a fold, or all tasks, one after the other, and what it learned at one is used \
for the next, as by PHYRE's DQN-O (56.2 across templates, in order of ids). This protocol differs from that of \
[the other results](../README.md), whose agents start each task afresh: do not compare across the two tables. Only \
counted attempts are simulated. The constants of the memory were chosen on dev tasks; some of \
those within are test tasks of cross 0. The formula that gives proposals of the paper's nets a chance by their rank \
was chosen on test tasks of cross 0, so the figures of these nets there may be somewhat too good.

Within a puzzle, “online, by balls” compares balls by place and radius, and “online” by imagined paths too. Shuffled \
orders are measured with the whole memory alone: without one, the order makes no difference.

Cells: auccess, and the percentage solved at the first attempt / within 10 / within 100; of shuffled orders the mean.
";

/// Returns the page of some results.
pub fn page(reports: &[Report]) -> Result<String, fmt::Error> {
    let mut text = HEAD.to_string();
    for report in reports {
        write!(text, "\n{}", report.markdown()?)?;
    }
    Ok(text)
}

impl MemoryUse {
    fn label(self) -> &'static str {
        match self {
            MemoryUse::None => "nothing: starts each task afresh",
            MemoryUse::All => "all",
            MemoryUse::ScenesAlike => "all, as if all scenes were alike",
            MemoryUse::NoFailures => "successes alone",
            MemoryUse::NoRelativePlaces => "all, by places in the scene alone",
        }
    }
}

impl Report {
    /// Returns the results as Markdown.
    ///
    /// # Errors
    /// Only if formatting fails.
    pub fn markdown(&self) -> Result<String, fmt::Error> {
        let mut text = String::new();
        let &Report { setup, fold, tasks_of, seed, simulator, agents_version, memory_version, ref runs, .. } = self;
        let tasks = runs.first().map_or(0, |run| run.first_solved.len());
        let mut shuffles: Vec<u64> = runs.iter().filter_map(|run| run.shuffle).collect();
        shuffles.sort_unstable();
        shuffles.dedup();
        writeln!(
            text,
            "## {}\n\nSeed {seed}, simulator {simulator}, agents {agents_version}, memory {memory_version}. Seeds of \
             the shuffled orders: {}.\n",
            tasks_of.heading(FoldId { setup, fold }, tasks),
            if shuffles.is_empty() { "none".to_string() } else { format!("{shuffles:?}").replace(['[', ']'], "") }
        )?;
        if tasks_of == TaskSet::All {
            writeln!(
                text,
                "The net has learned from random scenes alone, so it knows none of these tasks. But the constants of \
                 the memory were chosen on some of them, so these figures may be somewhat too good.\n"
            )?;
        }
        writeln!(text, "| agent | remembers | order of ids | shuffled |\n| --- | --- | ---: | ---: |")?;
        for (agent, memory) in self.kinds() {
            let [ids, shuffled] = [false, true].map(|shuffled| mean_score(self.of(agent, memory, shuffled)));
            writeln!(text, "| {} | {} | {ids} | {shuffled} |", row(agent).label, memory.label())?;
        }
        self.curve(&mut text)?;
        self.templates(&mut text)?;
        Ok(text)
    }

    /// Auccess over the place of a task among those of its template.
    fn curve(&self, text: &mut String) -> fmt::Result {
        let names = PARTS.map(|(from, to)| if from == to { from.to_string() } else { format!("{from}–{to}") });
        writeln!(
            text,
            "\n### Learning curve\n\nAuccess over the n-th task of a template that the agent meets.\n\n| agent | \
             remembers | order | {} |\n| --- | --- | --- |{}",
            names.join(" | "),
            " ---: |".repeat(PARTS.len())
        )?;
        for (agent, memory) in self.kinds().filter(|(_, memory)| matches!(memory, MemoryUse::None | MemoryUse::All)) {
            for (order, shuffled) in [("of ids", false), ("shuffled", true)] {
                let runs: Vec<&Run> = self.of(agent, memory, shuffled).collect();
                if runs.is_empty() || (shuffled && memory == MemoryUse::None) {
                    continue;
                }
                let cells = PARTS.map(|(from, to)| {
                    let firsts: Vec<_> = runs.iter().flat_map(|run| run.of_places(from, to)).collect();
                    if firsts.is_empty() { "–".to_string() } else { format!("{:.0}", auccess(&firsts)) }
                });
                writeln!(text, "| {} | {} | {order} | {} |", row(agent).label, memory.label(), cells.join(" | "))?;
            }
        }
        Ok(())
    }

    /// Auccess by template, in order of ids.
    fn templates(&self, text: &mut String) -> fmt::Result {
        let kinds: Vec<_> =
            self.kinds().filter(|(_, memory)| matches!(memory, MemoryUse::None | MemoryUse::All)).collect();
        let names: Vec<String> = kinds
            .iter()
            .map(|&(agent, memory)| {
                format!("{}, {}", row(agent).label, if memory == MemoryUse::All { "remembers" } else { "afresh" })
            })
            .collect();
        writeln!(
            text,
            "\n### Templates\n\nAuccess in order of ids.\n\n| template | {} |\n| --- |{}",
            names.join(" | "),
            " ---: |".repeat(names.len())
        )?;
        let tasks = self.runs.first().map_or(&[][..], |run| &run.first_solved);
        let mut numbers: Vec<usize> = tasks.iter().map(|(task, _)| task.template).collect();
        numbers.dedup();
        for number in numbers {
            let cells = kinds.iter().map(|&(agent, memory)| {
                let of_template = self.of(agent, memory, false).flat_map(|run| &run.first_solved);
                let firsts: Vec<_> =
                    of_template.filter(|(task, _)| task.template == number).map(|&(_, first)| first).collect();
                format!("{:.0}", auccess(&firsts))
            });
            let cells: Vec<String> = cells.collect();
            writeln!(text, "| {number:05} {} | {} |", TEMPLATES[number].name, cells.join(" | "))?;
        }
        Ok(())
    }

    /// The agents and what they remember, in the order of the runs.
    fn kinds(&self) -> impl Iterator<Item = (AgentName, MemoryUse)> {
        let mut kinds: Vec<_> = self.runs.iter().map(|run| (run.agent, run.memory)).collect();
        kinds.dedup();
        kinds.into_iter()
    }

    fn of(&self, agent: AgentName, memory: MemoryUse, shuffled: bool) -> impl Iterator<Item = &Run> {
        self.runs.iter().filter(move |run| (run.agent, run.memory, run.shuffle.is_some()) == (agent, memory, shuffled))
    }
}

impl Run {
    /// The first solving attempts at the tasks that are met as the `from`-th to the `to`-th of their template.
    fn of_places(&self, from: usize, to: usize) -> impl Iterator<Item = Option<usize>> {
        let mut met: BTreeMap<usize, usize> = BTreeMap::new();
        self.first_solved.iter().filter_map(move |&(TaskId { template, .. }, first)| {
            let place = met.entry(template).or_default();
            *place += 1;
            (from..=to).contains(place).then_some(first)
        })
    }
}

/// The mean of some runs, as a cell.
fn mean_score<'a>(runs: impl Iterator<Item = &'a Run>) -> String {
    let scores: Vec<[f64; 4]> = runs
        .map(|run| {
            let firsts: Vec<_> = run.first_solved.iter().map(|&(_, first)| first).collect();
            score_of(&firsts)
        })
        .collect();
    if scores.is_empty() {
        return "–".to_string();
    }
    score_cell(std::array::from_fn(|of| scores.iter().map(|score| score[of]).sum::<f64>() / scores.len() as f64))
}
