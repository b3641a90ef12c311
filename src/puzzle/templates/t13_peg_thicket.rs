//! 00013 Peg Thicket.

use std::f64::consts::PI;

use super::t12_switchback_pegs::pegs;
use super::{Ints, Params, Template, task_numbers};
use crate::puzzle::layout::{Ball, Bar, dynamic_body, scene, static_body};
use crate::puzzle::numpy::RandomState;
use crate::puzzle::scene::{SIZE, Scene};

pub(crate) static TEMPLATE: Template = Template {
    number: 13,
    name: "Peg Thicket",
    story: "A ball falls into two wandering, branching chains of pegs; get it through to the floor.",
    grid: &[("seed", Ints(0, 299))],
    script,
    task_numbers: task_numbers(
        "11 15 19-21 25 27 36 45 49-52 59 64 65 67 70 74 75 78 81-84 90 91 95-97 101 104-108 112 \
         116 118 121 122 125 127 128 139 141 142 144 146 149 152 159 162 164 165 169 172 177-179 \
         181-184 193 194 197 206-208 210-212 215 218 220-222 226 231 234 235 240 243 244 247 249 \
         252 259 263 270-272 281 283 285 286 291 294 299",
    ),
    combinations: [
        269, 163, 196, 208, 59, 198, 283, 286, 154, 123, 277, 96, 298, 155, 72, 240, 41, 169, 152, 176, 270, 21, 247,
        125, 85, 284, 273, 121, 182, 26, 91, 229, 167, 192, 118, 110, 275, 105, 58, 84, 103, 282, 45, 250, 228, 89,
        128, 70, 206, 135, 95, 90, 25, 7, 179, 244, 86, 186, 93, 20, 231, 130, 15, 291, 108, 68, 38, 14, 238, 99, 261,
        209, 153, 160, 193, 174, 50, 219, 116, 87, 104, 8, 0, 225, 129, 73, 10, 264, 139, 97, 64, 205, 117, 299, 106,
        241, 49, 173, 164, 83,
    ],
};

fn script(p: &Params) -> Option<Scene> {
    let mut random = RandomState::new(p.int("seed"));
    let ball = dynamic_body(Ball(0.1)).at(SIZE * random.uniform(0.4, 0.6), 0.9 * SIZE);
    let top = (ball.bottom() - 2.0 * ball.height()) / SIZE;
    let chains = [[0.7, 0.5], [0.2, 0.5]].into_iter().flat_map(|start| chain(&mut random, start, top)).collect();
    let floor = static_body(Bar(1.0)).at_bottom(0.0).at_left(0.0);
    Some(scene([ball.object()].into_iter().chain(pegs(chains, 0.05)).chain([floor.goal()])))
}

/// Returns a spiral random walk below `top`. It sometimes branches from one of its own points, which is then listed
/// twice. It ends when enough points are inside the scene. Points are fractions of the scene.
fn chain(random: &mut RandomState, start: [f64; 2], top: f64) -> Vec<[f64; 2]> {
    let (mut angle, mut angle_step) = heading(random);
    let required = random.randint(15, 30);
    let mut points = vec![start];
    let (mut run, mut inside) = (1, 0);
    while inside < required {
        let next = if run >= 3 && random.unit() < 0.2 {
            let branch = points[random.randint(0, points.len())];
            run = 1;
            (angle, angle_step) = heading(random);
            branch
        } else {
            run += 1;
            let step = random.uniform(0.05, 0.2);
            angle += angle_step;
            let [x, y] = points[points.len() - 1];
            [x + step * libm::cos(angle), y + step * libm::sin(angle)]
        };
        if next[1] < top {
            points.push(next);
            inside += usize::from(next.iter().all(|&at| 0.0 < at && at < 1.0));
        }
    }
    points
}

/// Draws a direction and its change at each step, radians.
fn heading(random: &mut RandomState) -> (f64, f64) {
    let angle = random.unit() * 2.0 * PI;
    let angle_step = random.unit() * 2.0 * PI / 10.0;
    (angle, angle_step)
}
