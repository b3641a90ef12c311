//! Touches of bodies in a rollout, as events. The Python package returns them.

use std::collections::{BTreeMap, BTreeSet};

/// The time for which two bodies touch (from BeginContact to EndContact of Box2D).
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct ContactEvent {
    /// The first step in which they touch; steps count from 1.
    pub begin: usize,
    /// The first later step in which they do not; one more than the steps of the rollout if they touch to its end.
    pub end: usize,
    /// The two bodies, ascending: the scene's bodies by their indices, then the ball, if there is one, then the walls
    /// in the order of `puzzle::scene::walls`.
    pub bodies: [usize; 2],
}

/// Collects the events of a rollout, step by step.
#[derive(Default)]
pub(super) struct ContactLog {
    /// The pairs that touch, and the step in which they began to.
    open: BTreeMap<[usize; 2], usize>,
    events: Vec<ContactEvent>,
}

impl ContactLog {
    /// Records the pairs that touch in a step.
    pub(super) fn add_step(&mut self, step: usize, touching: &BTreeSet<[usize; 2]>) {
        let ended = self.open.extract_if(.., |pair, _| !touching.contains(pair));
        self.events.extend(ended.map(|(bodies, begin)| ContactEvent { begin, end: step, bodies }));
        for &pair in touching {
            self.open.entry(pair).or_insert(step);
        }
    }

    /// Returns all events in the order of their beginnings; `end` is the step after the last.
    pub(super) fn into_events(mut self, end: usize) -> Vec<ContactEvent> {
        self.add_step(end, &BTreeSet::new());
        self.events.sort_unstable();
        self.events
    }
}
