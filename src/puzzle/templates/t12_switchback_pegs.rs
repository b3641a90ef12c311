//! 00012 Switchback Pegs.

use std::f64::consts::PI;

use super::{Ints, Params, Template, evenly, task_numbers};
use crate::puzzle::layout::{Ball, Bar, BodyBuilder, dynamic_body, scene, static_body};
use crate::puzzle::numpy::RandomState;
use crate::puzzle::scene::{SIZE, Scene};

pub(crate) static TEMPLATE: Template = Template {
    number: 12,
    name: "Switchback Pegs",
    story: "A ball falls among rows of pegs that climb away from alternate sides; get it down to the floor.",
    grid: &[("seed", Ints(0, 999))],
    script,
    task_numbers: task_numbers(
        "2 4 8 9 12 18 23 27 28 30 32 34 37 41 44 50-52 54 59 61 63 66 67 71 74 76 77 79 80 85 \
         90-92 97 99 101 102 105-109 111 112 114 116 118-120 122 124-126 131 132 138 140 142 \
         144-152 157 158 161 164 165 172 173 175 176 179 181 182 187-192 195 197 198 201 202 208 \
         210 211 218 220-222 225 228",
    ),
    combinations: [
        610, 236, 899, 433, 134, 63, 595, 384, 498, 269, 158, 762, 60, 249, 713, 590, 597, 682, 59, 349, 696, 408, 413,
        285, 283, 531, 659, 410, 691, 512, 140, 224, 159, 376, 313, 441, 438, 6, 541, 292, 884, 564, 670, 43, 33, 746,
        400, 668, 863, 712, 251, 803, 131, 558, 930, 963, 927, 864, 172, 473, 895, 277, 883, 738, 485, 664, 852, 870,
        915, 432, 579, 470, 656, 799, 51, 981, 769, 394, 532, 859, 719, 145, 115, 515, 957, 523, 507, 672, 741, 493,
        943, 817, 320, 66, 41, 599, 591, 301, 399, 78,
    ],
};

fn script(p: &Params) -> Option<Scene> {
    let mut random = RandomState::new(p.int("seed"));
    let ball = dynamic_body(Ball(0.1)).at(SIZE * random.uniform(0.2, 0.5), 0.9 * SIZE);
    let top = (ball.bottom() - 2.0 * ball.height()) / SIZE;
    let rows = (0..4).flat_map(|k| row(&mut random, evenly(0.1, top, 4, 3 - k), k % 2 == 1)).collect();
    let floor = static_body(Bar(1.0)).at_bottom(0.0).at_left(0.0);
    Some(scene([ball.object()].into_iter().chain(pegs(rows, 0.04)).chain([floor.goal()])))
}

/// Returns the points of one row, in fractions of the scene, starting at its wall.
fn row(random: &mut RandomState, y: f64, mirrored: bool) -> Vec<[f64; 2]> {
    let mut point = [0.0, y];
    let mut points = vec![point];
    for _ in 0..random.randint(3, 8) {
        let step = random.uniform(0.05, 0.17);
        let angle = 5.0 * PI / 180.0 + random.normal() * 2.0 * PI / 40.0;
        point = [point[0] + step * libm::cos(angle), point[1] + step * libm::sin(angle)];
        points.push(point);
    }
    if mirrored {
        points.iter_mut().for_each(|point| point[0] = 1.0 - point[0]);
    }
    points
}

/// Returns a peg at each point inside the scene. Points are fractions of the scene.
pub(crate) fn pegs(points: Vec<[f64; 2]>, scale: f64) -> impl Iterator<Item = BodyBuilder> {
    let inside = points.into_iter().filter(|point| point.iter().all(|at| (0.0..=1.0).contains(at)));
    inside.map(move |[x, y]| static_body(Ball(scale)).at(SIZE * x, SIZE * y))
}
