//! 00012 Switchback Pegs.

use std::f64::consts::PI;

use super::numpy::RandomState;
use super::{Ints, Params, Template, evenly, kept};
use crate::puzzle::layout::{Ball, Bar, Piece, dynamic, fixed, scene};
use crate::puzzle::scene::{SIZE, Scene};

pub static TEMPLATE: Template = Template {
    number: 12,
    name: "Switchback Pegs",
    story: "A ball falls among rows of pegs that climb away from alternate sides; get it down to the floor.",
    grid: &[("seed", Ints(0, 999))],
    script,
    selected: kept(
        "2 4 8 9 12 18 23 27 28 30 32 34 37 41 44 50-52 54 59 61 63 66 67 71 74 76 77 79 80 85 \
         90-92 97 99 101 102 105-109 111 112 114 116 118-120 122 124-126 131 132 138 140 142 \
         144-152 157 158 161 164 165 172 173 175 176 179 181 182 187-192 195 197 198 201 202 208 \
         210 211 218 220-222 225 228",
    ),
};

fn script(p: &Params) -> Option<Scene> {
    let mut random = RandomState::new(p.int("seed"));
    let ball = dynamic(Ball(0.1)).at(SIZE * random.uniform(0.2, 0.5), 0.9 * SIZE);
    let top = (ball.bottom() - 2.0 * ball.height()) / SIZE;
    let rows = (0..4).flat_map(|k| row(&mut random, evenly(0.1, top, 4, 3 - k), k % 2 == 1)).collect();
    let floor = fixed(Bar(1.0)).at_bottom(0.0).at_left(0.0);
    Some(scene([ball.object()].into_iter().chain(pegs(rows, 0.04)).chain([floor.goal()])))
}

/// The points of one row, in fractions of the scene, from its wall onwards.
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

/// A peg at each of the points that lie in the scene; the points are fractions of it.
pub fn pegs(points: Vec<[f64; 2]>, scale: f64) -> impl Iterator<Item = Piece> {
    let inside = points.into_iter().filter(|point| point.iter().all(|at| (0.0..=1.0).contains(at)));
    inside.map(move |[x, y]| fixed(Ball(scale)).at(SIZE * x, SIZE * y))
}
