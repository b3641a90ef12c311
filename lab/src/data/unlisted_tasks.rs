//! Tasks of the templates that the benchmark does not list, to train on more than the 100 listed tasks per template.
//!
//! Most combinations of a template's parameters are valid and not among the 100. These tasks differ from test tasks but
//! resemble them, so results of nets trained on them are reported separately.

use pathlight::puzzle::scene::Scene;
use pathlight::puzzle::stable_shuffle::stable_shuffle;
use pathlight::puzzle::task::Task;
use pathlight::puzzle::templates::Template;
use pathlight::simulator::outcome;

/// Returns the parameter combinations of up to `count` unlisted tasks, the first in PHYRE's order. Combinations that
/// lay out the scene of a listed task, or a scene that is solved without a ball, are left out.
pub fn unlisted_tasks(template: &'static Template, count: usize) -> Vec<u32> {
    let listed: Vec<Scene> = Task::of(template).map(|task| task.scene).collect();
    let combinations = stable_shuffle((0..template.combinations()).collect(), "");
    let is_new = |&combination: &u32| {
        template
            .unlisted(combination)
            .is_some_and(|scene| !listed.contains(&scene) && outcome(&scene, None).is_ok_and(|alone| !alone.solved))
    };
    combinations.into_iter().filter(is_new).take(count).collect()
}

#[cfg(test)]
mod tests {
    use pathlight::puzzle::templates::TEMPLATES;

    use super::*;

    #[test]
    fn no_unlisted_task_is_a_task_of_the_benchmark() {
        for template in TEMPLATES {
            let listed: Vec<Scene> = Task::of(template).map(|task| task.scene).collect();
            let unlisted = unlisted_tasks(template, 30);
            assert!((20..=30).contains(&unlisted.len()), "{}: {}", template.name, unlisted.len());
            for combination in unlisted {
                let scene = template.unlisted(combination).expect("an unlisted task");
                assert!(!listed.contains(&scene), "{} {combination}", template.name);
            }
        }
    }
}
