//! Learning-rate schedules. The learning rate is a function of the step alone, so a run can be continued from any
//! checkpoint without extra state.

/// Warm-up steps of the success net, the dynamics net and DQN, over which the learning rate rises from zero.
pub const WARMUP_STEPS: usize = 200;

/// How the learning rate changes over a run.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Schedule {
    /// Constant, then falling linearly to zero over the last steps of the run.
    LinearDecay {
        /// Learning rate before the decay.
        peak: f64,
        /// Number of final steps over which it decays; 0 keeps it constant.
        decay_steps: usize,
    },
    /// Linear warm-up from zero over the first steps, times a linear decay to zero over the whole run.
    WarmupLinear {
        /// Learning rate that the two factors scale.
        peak: f64,
        /// Number of first steps over which it rises.
        warmup_steps: usize,
    },
}

impl Schedule {
    /// Returns the learning rate of a step, counted from 0, of a run of `total` steps.
    pub fn learning_rate(&self, step: usize, total: usize) -> f64 {
        match *self {
            Schedule::LinearDecay { peak, decay_steps } => {
                // Without decay, the quotient is infinite and is clamped to 1.
                let left = (total - step) as f64 / decay_steps as f64;
                peak * left.min(1.0)
            }
            Schedule::WarmupLinear { peak, warmup_steps } => {
                let warmup = ((step + 1) as f64 / warmup_steps as f64).min(1.0);
                peak * warmup * (1.0 - step as f64 / total as f64)
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn linear_decay_is_constant_until_its_last_steps() {
        let rates = |decay_steps| {
            let schedule = Schedule::LinearDecay { peak: 0.5, decay_steps };
            (0..6).map(|step| schedule.learning_rate(step, 6)).collect::<Vec<_>>()
        };
        assert_eq!(rates(2), [0.5, 0.5, 0.5, 0.5, 0.5, 0.25]);
        assert_eq!(rates(4), [0.5, 0.5, 0.5, 0.375, 0.25, 0.125]);
        assert_eq!(rates(0), [0.5; 6]);
    }

    #[test]
    fn warm_up_rises_to_the_decaying_line() {
        let schedule = Schedule::WarmupLinear { peak: 1.0, warmup_steps: 2 };
        let rates: Vec<f64> = (0..4).map(|step| schedule.learning_rate(step, 4)).collect();
        assert_eq!(rates, [0.5, 0.75, 0.5, 0.25]);
    }
}
