//! The rollouts of the simulator benchmark, the same for all implementations: 20 tasks of each template, each with a
//! random valid ball.

use pathlight::puzzle::action::{Ball, Obstacles};
use pathlight::puzzle::sampling::uniform_ball;
use pathlight::puzzle::scene::Scene;
use pathlight::puzzle::task::Task;
use pathlight::puzzle::templates::TEMPLATES;
use pathlight::simulator::{self, Simulation};
use rand::SeedableRng;
use rand_pcg::Pcg32;

/// Returns the scenes and their balls, the same on every machine.
pub fn rollouts() -> Vec<(Scene, Ball)> {
    let mut random = Pcg32::seed_from_u64(0);
    let tasks = TEMPLATES.iter().flat_map(|template| Task::of(template).step_by(5));
    tasks
        .map(|Task { scene, .. }| {
            let ball = uniform_ball(&Obstacles::new(&scene), &mut random).expect("the scene has room");
            (scene, ball)
        })
        .collect()
}

/// Returns the end of each rollout, for comparison: `[solved, steps, x and y of each dynamic body in px]`.
pub fn final_states(rollouts: &[(Scene, Ball)]) -> String {
    let final_state = |(scene, ball): &(Scene, Ball)| {
        let rollout = simulator::simulate(scene, Some(*ball)).expect("a valid ball");
        let positions = rollout.row(rollout.steps).iter().flat_map(|[x, y, _]| [*x, *y]);
        let numbers = [f32::from(u8::from(rollout.solved)), rollout.steps as f32].into_iter().chain(positions);
        numbers.collect::<Vec<_>>()
    };
    format!("{:?}", rollouts.iter().map(final_state).collect::<Vec<_>>())
}

/// Returns a rollout before its first step.
pub fn start((scene, ball): &(Scene, Ball)) -> Simulation {
    Simulation::new(scene, Some(*ball)).expect("a valid ball")
}
