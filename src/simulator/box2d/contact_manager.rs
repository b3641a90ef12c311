//! The contacts of the world, created by the broad phase and updated by the narrow phase: b2ContactManager and
//! b2BroadPhase.
//!
//! Scenes have a few dozen fixtures, so all pairs are compared, without a dynamic tree. Contacts are in Box2D's order,
//! which determines the order in which they are solved.

use rapier2d::parry::bounding_volume::BoundingVolume;

use super::body::Body;
use super::contact::Contact;
use super::fixture::Fixture;

/// Polygons whose AABBs, which include the skins, are farther apart than this have no manifold, m. At a corner, the
/// skins of two polygons meet up to sqrt(2) times as far out as their radii, 0.0083 m beyond the AABBs.
const MANIFOLD_MARGIN: f32 = 0.01;

#[derive(Default)]
pub(super) struct ContactManager {
    /// The contacts by their ids; the ids of ended contacts are reused.
    slots: Vec<Contact>,
    free: Vec<usize>,
    /// The ids of the contacts, oldest first. Box2D's list has the newest first.
    pub(super) order: Vec<usize>,
    /// Whether any fat AABB has changed since the last search for new pairs.
    pub(super) any_moved: bool,
    // Kept from step to step only to save allocations.
    pairs: Vec<[usize; 2]>,
}

impl std::ops::Index<usize> for ContactManager {
    type Output = Contact;

    fn index(&self, id: usize) -> &Contact {
        &self.slots[id]
    }
}

impl std::ops::IndexMut<usize> for ContactManager {
    fn index_mut(&mut self, id: usize) -> &mut Contact {
        &mut self.slots[id]
    }
}

impl ContactManager {
    /// Returns all contacts, and some ended ones, in an unspecified order that does not affect the result.
    pub(super) fn contacts_mut(&mut self) -> impl Iterator<Item = &mut Contact> {
        self.slots.iter_mut()
    }

    /// The broad phase: adds a contact for every new pair of fixtures whose fat AABBs overlap, in the order of the
    /// fixtures (FindNewContacts and b2BroadPhase::UpdatePairs).
    pub(super) fn find_new_contacts(&mut self, bodies: &mut [Body], fixtures: &mut [Fixture]) {
        if !std::mem::take(&mut self.any_moved) {
            return;
        }
        let mut pairs = std::mem::take(&mut self.pairs);
        for (a, moved) in fixtures.iter().enumerate().filter(|(_, fixture)| fixture.moved) {
            for (b, other) in fixtures.iter().enumerate() {
                // A pair whose fixtures have both moved is found twice.
                let is_found = other.moved && b < a;
                if moved.fat_aabb.intersects(&other.fat_aabb) && moved.body != other.body && !is_found {
                    pairs.push([a.min(b), a.max(b)]);
                }
            }
        }
        fixtures.iter_mut().for_each(|fixture| fixture.moved = false);
        pairs.sort_unstable();
        pairs.drain(..).for_each(|pair| self.add_pair(pair, bodies, fixtures));
        self.pairs = pairs;
    }

    /// Adds the contact of two fixtures, unless it exists or both bodies are static (AddPair).
    fn add_pair(&mut self, pair: [usize; 2], bodies: &mut [Body], fixtures: &[Fixture]) {
        let [a, b] = pair.map(|fixture| fixtures[fixture].body);
        let is_same = |&id: &usize| {
            let [first, second] = self.slots[id].fixtures;
            [first, second] == pair || [second, first] == pair
        };
        if !(bodies[a].dynamic || bodies[b].dynamic) || bodies[b].contacts.iter().any(is_same) {
            return;
        }
        let contact = Contact::new(pair, fixtures);
        let id = match self.free.pop() {
            Some(id) => {
                self.slots[id] = contact;
                id
            }
            None => {
                self.slots.push(contact);
                self.slots.len() - 1
            }
        };
        self.order.push(id);
        for body in [a, b] {
            bodies[body].contacts.push(id);
            bodies[body].wake();
        }
    }

    /// The narrow phase: removes contacts whose fat AABBs no longer overlap, and updates the remaining contacts of
    /// awake bodies (Collide).
    pub(super) fn collide(&mut self, bodies: &mut [Body], fixtures: &[Fixture]) {
        for index in (0..self.order.len()).rev() {
            let id = self.order[index];
            let contact = &mut self.slots[id];
            if !contact.bodies.iter().any(|&body| bodies[body].is_active()) {
                continue;
            }
            let [a, b] = contact.fixtures.map(|fixture| &fixtures[fixture]);
            if !a.fat_aabb.intersects(&b.fat_aabb) {
                self.order.remove(index);
                self.destroy(id, bodies);
            } else if contact.manifold.is_empty() && !a.aabb.loosened(MANIFOLD_MARGIN).intersects(&b.aabb) {
                // The manifold would be empty again.
                contact.enabled = true;
            } else {
                contact.update(bodies, fixtures);
            }
        }
    }

    /// b2ContactManager::Destroy.
    fn destroy(&mut self, id: usize, bodies: &mut [Body]) {
        let contact = &self.slots[id];
        for &body in &contact.bodies {
            bodies[body].contacts.retain(|&other| other != id);
            if !contact.manifold.is_empty() {
                bodies[body].wake();
            }
        }
        self.free.push(id);
    }
}

#[cfg(all(test, not(target_arch = "wasm32")))]
mod tests {
    use proptest::prelude::*;
    use rapier2d::math::Vector;

    use super::*;
    use crate::simulator::box2d::manifold::Manifold;
    use crate::simulator::box2d::math::{Rotation, Transform};
    use crate::simulator::box2d::shape::Shape;

    fn bar((w, h): (f32, f32)) -> Shape {
        Shape::polygon(&[[w, h], [-w, h], [-w, -h], [w, -h]].map(Vector::from))
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(4000))]

        /// The skins of corners meet farthest out where both bars stand on a corner.
        #[test]
        fn beyond_the_margin_there_is_no_manifold(
            a in (0.3..10.0f32, 0.3..2.0f32).prop_map(bar),
            b in (0.3..10.0f32, 0.3..2.0f32).prop_map(bar),
            angles in prop_oneof![(-3.2..3.2f32, -3.2..3.2f32), Just((0.785, 0.785)), Just((0.785, 0.0))],
            gap in MANIFOLD_MARGIN..0.1f32,
            across in -4.0..4.0f32,
        ) {
            let transform_a = Transform { position: Vector::ZERO, rotation: Rotation::new(angles.0) };
            let turned = Transform { position: Vector::ZERO, rotation: Rotation::new(angles.1) };
            let left = a.aabb(&transform_a).maxs.x - b.aabb(&turned).mins.x;
            let transform_b = Transform { position: Vector::new(left + gap + 1e-5, across), ..turned };
            prop_assert!(!a.aabb(&transform_a).loosened(MANIFOLD_MARGIN).intersects(&b.aabb(&transform_b)));
            prop_assert!(Manifold::new(&a, &transform_a, &b, &transform_b).is_empty());
        }
    }
}
