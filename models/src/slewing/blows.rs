//! Blows at end stops and of the rope, for slewing with a load that swings.

use nalgebra::Vector3;

use crate::parts::hanging::{HangingLoad, HeadRope, turned};
use crate::parts::joint::Bar;
use crate::slewing::coupled_sides::CoupledSides;
use crate::slewing::swinging::head;

/// Slewing with its load at one instant, as an event changes it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SwungInstant {
    pub bar: Bar,
    /// In rad/s.
    pub omega: f64,
    pub load: HangingLoad<f64>,
    pub taut: bool,
    /// Reach (m), inertia of what slews without the load (kg·m²), the load's mass (kg), the rope's length (m).
    pub reach: f64,
    pub inertia: f64,
    pub mass: f64,
    pub length: f64,
    /// A coupling between it and its drive, through which no blow passes.
    pub coupled: Option<CoupledSides>,
}

impl SwungInstant {
    /// Kinetic energy, in J.
    #[must_use]
    pub fn energy(&self) -> f64 {
        let place = self.load.place + Vector3::new(self.reach, 0.0, 0.0);
        let velocity = self.load.rate + turned(place) * self.omega;
        0.5 * (self.inertia * self.omega.powi(2) + self.mass * velocity.norm_squared())
    }

    /// What a blow takes, in J.
    pub fn struck(&mut self, blow: fn(&mut SwungInstant)) -> f64 {
        let before = *self;
        blow(self);
        // To bring a taut rope's load to its end is no blow.
        if (before.taut, before.omega) == (self.taut, self.omega) {
            return 0.0;
        }
        before.energy() - self.energy()
    }

    /// Slewing stops at once and the load goes on: a taut rope that the head would run away from pulls the load along, one
    /// that it would push lets go.
    pub fn stop(&mut self) {
        let (head, lost) = (head(self.reach), [-self.omega]);
        let mut own = Vector3::zeros();
        if self.taut {
            let rope = HeadRope::new(self.load.place, &head);
            let pull = -(rope.arms[0] * lost[0]);
            self.taut = pull >= 0.0;
            own = rope.direction * -pull.max(0.0);
        }
        self.load = self.load.shifted(&head, lost, own);
        (self.bar, self.omega) = (Bar::Held, 0.0);
    }

    /// A load that leaves a slack rope's reach is caught by a plastic blow along it; a taut one is brought to its end.
    pub fn catch(&mut self) {
        if !self.taut {
            let head = head(self.reach);
            let rope = HeadRope::new(self.load.place, &head);
            let excess = rope.direction.dot(&self.load.rate);
            if rope.length < self.length || excess <= 0.0 {
                return;
            }
            let ease = if self.bar == Bar::Held { 0.0 } else { 1.0 / self.inertia };
            let pull = excess / rope.giving([ease], self.mass, 0.0);
            let change = self.mass * pull * rope.arms[0] * ease;
            self.omega += change;
            self.bar = self.bar.struck(self.omega);
            self.load = self.load.shifted(&head, [change], -rope.direction * pull);
            self.taut = true;
        }
        self.load = self.load.straightened(self.length, 0.0);
    }
}
