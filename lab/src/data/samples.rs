//! Training samples of the four nets, from known solutions.

use pathlight::nets::training::Sample;
use pathlight::puzzle::action::{Ball, Invalid};
use pathlight::puzzle::scene::Scene;
use pathlight::raster::{ball_image, path_image, scene_channels};
use pathlight::simulator::simulate;

/// Returns the sample of a ball that solves a scene, from two rollouts: one without the ball and one with it.
///
/// # Errors
/// If the ball may not be placed in the scene.
pub fn sample(scene: &Scene, ball: Ball) -> Result<Sample, Invalid> {
    let (without, with) = (simulate(scene, None)?, simulate(scene, Some(ball))?);
    let without = if pathlight::suspects::on("ball") {
        use rand::SeedableRng;
        let seed = (ball.x * 1e6 + ball.y * 1e3 + ball.r) as u64;
        let mut rng = rand_pcg::Pcg64Mcg::seed_from_u64(seed);
        let small = pathlight::puzzle::sampling::uniform_ball(
            &pathlight::puzzle::action::Obstacles::new(scene),
            &mut rng,
        );
        let placed = small.map(|small| Ball { r: 2.0, ..small });
        simulate(scene, placed)?
    } else {
        without
    };
    let object = &scene.bodies[scene.body1];
    let targets = [
        path_image(object, &without, scene.body1),
        path_image(object, &with, scene.body1),
        path_image(&ball.body(), &with, scene.bodies.len()),
        ball_image(ball),
    ];
    Ok(Sample { scene: scene_channels(scene), targets })
}
