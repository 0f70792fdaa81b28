//! The publication's own equations, misprints mended.
//!
//! Printed: θ1 = θ4, θ2 = θ3, θ5 = θ6, θ7 = θ8 (1-4); cos θ1 − cos θ5 = S/L1 (5),
//! cos θ2 − cos θ6 = S/L1 (6), cos θ1 = (S+R)/L2 (7), cos θ2 = (S+R)/L2 (8). The
//! "cos" is a misread "ctg", and the pairs do not meet in one point; (7) and (8)
//! contradict θ1 ≠ θ2. The consistent set, R from the inner side to the centre:
//! θ1 = θ4, θ2 = θ3, θ5 = θ8, θ6 = θ7 in amount, cot θ1 = R/L2, cot θ2 = R/L1,
//! cot θ5 = (R+S)/L2, cot θ6 = (R+S)/L1.

use crate::kernel::calc::Calc;
use crate::kernel::group::quantities;
use crate::parts::plane::Point;
use crate::steering::machine::Machine;
use crate::steering::mode::{Command, Mode};
use crate::steering::symbols as s;

quantities! {
    /// The paper's layout: track, half the distance between the inner and between the outer axles, in m.
    Layout { s_t: S, l_1: L_1, l_2: L_2 }
}

impl<C: Calc> Layout<C> {
    /// Groups 1 to 8 for a turn to the left: 1 to 4 on the inner, left side from
    /// the front to the rear, 5 to 8 on the outer side likewise. [Zhang2016, Fig. 3]
    pub fn groups(&self) -> [Point<C>; 8] {
        let half = self.s_t / C::constant(2.0);
        let at = |x: C, y: C| Point::new(x, y);
        [
            at(self.l_2, half),
            at(self.l_1, half),
            at(-self.l_1, half),
            at(-self.l_2, half),
            at(self.l_2, -half),
            at(self.l_1, -half),
            at(-self.l_1, -half),
            at(-self.l_2, -half),
        ]
    }

    /// Angles of groups 1, 2, 5 and 6, in rad, for the distance `r` (m) from the
    /// inner side to the turning centre. [Zhang2016, eq. 1-8, mended]
    pub fn angles(&self, r: C) -> [C; 4] {
        [
            C::direction(r, self.l_2).def(&s::THETA_1),
            C::direction(r, self.l_1).def(&s::THETA_2),
            C::direction(r + self.s_t, self.l_2).def(&s::THETA_5),
            C::direction(r + self.s_t, self.l_1).def(&s::THETA_6),
        ]
    }

    /// Amount of the angle of the outer groups turning on the spot, in rad. [Zhang2016, eq. 9]
    pub fn pivot(&self) -> C {
        C::direction(self.s_t, C::constant(2.0) * self.l_2).def(&s::THETA_P)
    }
}

/// Where the machine has the paper's layout, the greatest difference between its
/// mended equations and the general geometry, in rad.
#[must_use]
pub fn printed(machine: &Machine<f64>) -> Option<f64> {
    let groups = &machine.groups;
    let [one, two, ..] = groups.as_slice() else { return None };
    let layout = Layout {
        s_t: 2.0 * one.y,
        l_1: two.x,
        l_2: one.x,
    };
    if groups.as_slice() != layout.groups() {
        return None;
    }
    let mut worst = 0.0_f64;
    for radius in [1.0, 3.0, 10.0, 30.0, 100.0] {
        let command = Command::Radius(radius + layout.s_t / 2.0);
        let centre = Mode::AllWheel.centre(machine, command).ok()?;
        let general = [0, 1, 4, 5].map(|i| {
            let along = centre.rolling(groups[i]);
            f64::direction(along.x, along.y)
        });
        for (a, b) in layout.angles(radius).into_iter().zip(general) {
            worst = worst.max((a - b).abs());
        }
    }
    Some(worst)
}
