//! Finds a valid place for an invalid ball.

use super::action::{Ball, Obstacles};

/// Returns the nearest valid ball of the same radius whose centre is at whole px and at most `reach` px away. This is
/// the ball itself if it qualifies, and `None` if no ball does.
pub fn nearest_place(ball: Ball, obstacles: &Obstacles, reach: f64) -> Option<Ball> {
    let span = |centre: f64| (centre - reach).ceil() as i64..=(centre + reach).floor() as i64;
    let squared_distance = |place: &Ball| {
        let [dx, dy] = [place.x - ball.x, place.y - ball.y];
        dx * dx + dy * dy
    };
    let mut places: Vec<Ball> = span(ball.x)
        .flat_map(|x| span(ball.y).map(move |y| Ball { x: x as f64, y: y as f64, r: ball.r }))
        .filter(|place| squared_distance(place) <= reach * reach)
        .collect();
    places.sort_by(|a, b| squared_distance(a).total_cmp(&squared_distance(b)));
    places.into_iter().find(|place| obstacles.check(place).is_ok())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::puzzle::task::Task;

    #[test]
    fn the_nearest_valid_place_is_as_near_as_any() {
        let scene = Task::load("00007:008".parse().expect("an id")).expect("a task").scene;
        let obstacles = Obstacles::new(&scene);
        let mut moved = 0;
        for (x, y, r) in [(3.0, 3.0, 8.0), (128.0, 20.0, 12.0), (60.0, 200.0, 30.0), (250.0, 128.0, 16.0)] {
            let ball = Ball { x, y, r };
            let place = nearest_place(ball, &obstacles, 64.0).expect("a place");
            let distance = |other: &Ball| libm::hypot(other.x - x, other.y - y);
            assert_eq!(place.check(&scene), Ok(()));
            assert_eq!(place == ball, ball.check(&scene).is_ok());
            let all = (0..256).flat_map(|x| (0..256).map(move |y| Ball { x: f64::from(x), y: f64::from(y), r }));
            let nearest = all.filter(|other| other.check(&scene).is_ok()).map(|other| distance(&other));
            assert_eq!(nearest.fold(f64::INFINITY, f64::min), distance(&place));
            moved += usize::from(place != ball);
        }
        assert!(moved > 0);
    }

    #[test]
    fn nothing_beyond_reach_is_a_place() {
        let scene = Task::load("00007:008".parse().expect("an id")).expect("a task").scene;
        let corner = Ball { x: 0.0, y: 0.0, r: 32.0 };
        assert_eq!(nearest_place(corner, &Obstacles::new(&scene), 20.0), None);
    }
}
