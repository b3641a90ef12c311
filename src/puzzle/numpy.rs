//! NumPy's legacy `RandomState`, from which PHYRE draws the pegs of templates 00012 and 00013, and its list of actions.
//!
//! NumPy wraps the 32-bit Mersenne Twister MT19937 and has its own conversion from words to numbers. Both must agree to
//! the bit, because the positions of pegs and balls depend on them. The expected values in the tests come from NumPy.

use rand_mt::Mt;

/// One stream of draws.
pub(crate) struct RandomState {
    words: Mt,
    /// The second of a pair of normal draws; other draws in between do not discard it.
    spare: Option<f64>,
}

impl RandomState {
    pub(crate) fn new(seed: usize) -> Self {
        RandomState { words: Mt::new(seed.try_into().expect("a seed has 32 bits")), spare: None }
    }

    /// Draws a number in [0, 1) from 53 bits of two words (`random_sample`).
    pub(crate) fn unit(&mut self) -> f64 {
        let high = f64::from(self.words.next_u32() >> 5);
        let low = f64::from(self.words.next_u32() >> 6);
        (high * 67_108_864.0 + low) / 9_007_199_254_740_992.0
    }

    /// Draws a number in [low, high).
    pub(crate) fn uniform(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * self.unit()
    }

    /// Draws from the standard normal distribution, by Marsaglia's polar method (`randn`).
    pub(crate) fn normal(&mut self) -> f64 {
        if let Some(spare) = self.spare.take() {
            return spare;
        }
        loop {
            let p = 2.0 * self.unit() - 1.0;
            let q = 2.0 * self.unit() - 1.0;
            let r = p * p + q * q;
            if 0.0 < r && r < 1.0 {
                let factor = libm::sqrt(-2.0 * libm::log(r) / r);
                self.spare = Some(factor * p);
                return factor * q;
            }
        }
    }

    /// Draws an integer in low..high by masked rejection sampling. A single choice draws nothing.
    pub(crate) fn randint(&mut self, low: usize, high: usize) -> usize {
        let range = (high - 1 - low) as u32;
        if range == 0 {
            return low;
        }
        let mask = u32::MAX >> range.leading_zeros();
        loop {
            let value = self.words.next_u32() & mask;
            if value <= range {
                return low + value as usize;
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::RandomState;

    /// Ten draws with seed 0.
    fn draws<T>(mut draw: impl FnMut(&mut RandomState) -> T) -> Vec<T> {
        let mut random = RandomState::new(0);
        (0..10).map(|_| draw(&mut random)).collect()
    }

    #[test]
    fn words_are_the_mersenne_twisters() {
        let words = draws(|random| random.words.next_u32());
        assert_eq!(words[..4], [2357136044, 2546248239, 3071714933, 3626093760]);
    }

    #[test]
    fn units_and_integers_are_numpys() {
        assert_eq!(draws(RandomState::unit)[..2], [0.5488135039273248, 0.7151893663724195]);
        assert_eq!(draws(|random| random.randint(3, 8)), [7, 3, 6, 6, 6, 4, 6, 5, 7, 3]);
        assert_eq!(draws(|random| random.randint(15, 30)), [27, 20, 15, 18, 26, 18, 22, 24, 18, 20]);
    }

    #[test]
    fn normal_numbers_are_numpys() {
        let expected = [1.764052345967664, 0.4001572083672233, 0.9787379841057392];
        for (drawn, expected) in draws(RandomState::normal).into_iter().zip(expected) {
            assert!((drawn - expected).abs() < 1e-15, "{drawn} for {expected}");
        }
    }

    #[test]
    fn a_single_choice_draws_nothing() {
        let mut random = RandomState::new(0);
        assert_eq!(random.randint(0, 1), 0);
        assert_eq!(random.unit(), 0.5488135039273248);
    }

    #[test]
    fn the_spare_normal_outlives_other_draws() {
        let mut random = RandomState::new(610);
        let drawn = [
            random.uniform(0.2, 0.5),
            random.randint(3, 8) as f64,
            random.uniform(0.05, 0.17),
            random.normal(),
            random.uniform(0.05, 0.17),
            random.normal(),
        ];
        let expected = [
            0.3016005458385089,
            7.0,
            0.10031058547450228,
            0.3772368191869689,
            0.11426490399774197,
            0.18260338395032835,
        ];
        for (drawn, expected) in drawn.into_iter().zip(expected) {
            assert!((drawn - expected).abs() < 1e-15, "{drawn} for {expected}");
        }
    }
}
