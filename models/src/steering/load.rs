//! Vertical load of the groups and their resistance to steering. [Zhang2016, 3]

use crate::calc::Calc;
use crate::number::short;
use crate::plane::{self, Point};
use crate::steering::machine::{Machine, Refusal, within};
use crate::steering::symbols as s;
use crate::symbol::quantities;

quantities! {
    /// Sliding friction between tyre and ground, tyre pressure (Pa), and how many
    /// times smaller the resistance is while travelling. The paper takes 0.7 on
    /// asphalt or concrete, and 2.5 out of 2 to 3.
    Tyre { f_t: F_T, p_t: P_T, k_v: K_V }
}

impl<C: Calc> Tyre<C> {
    pub fn check(&self) -> Result<(), Refusal> {
        within(&s::F_T, self.f_t, 0.0, 2.0, false)?;
        within(&s::P_T, self.p_t, 0.0, 1e7, true)?;
        within(&s::K_V, self.k_v, 1.0, 10.0, false)?;
        Ok(())
    }
}

/// A group's vertical load, in N: not negative.
pub fn check_load<C: Calc>(group: usize, g: C) -> Result<C, Refusal> {
    within(&s::G, g, 0.0, f64::INFINITY, false).map_err(|found| Refusal {
        key: format!("G[{}]", group + 1),
        what: format!("load of group {}: {}", group + 1, found.what),
        help: format!("{}: no group can pull the ground", found.help),
    })
}

/// Moment, in N·m, that a group at load `g` (N) sets against steering, at standstill and while travelling.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Resistance<C> {
    pub standing: C,
    pub travelling: C,
}

/// T_r = f/3 · √(G³/p), and T_r/2.5 while travelling. [Zhang2016, 3]
#[inline]
pub fn resistance<C: Calc>(tyre: &Tyre<C>, g: C) -> Resistance<C> {
    let standing = (tyre.f_t / C::constant(3.0) * (g * g.square() / tyre.p_t).sqrt()).def(&s::T_R);
    Resistance {
        standing,
        travelling: (standing / tyre.k_v).def(&s::T_RX),
    }
}

/// Load of each group, in N, for a weight (N) whose centre of gravity is at
/// `centre` (m), on a rigid frame over equal springs.
pub fn share(machine: &Machine<f64>, weight: f64, centre: Point<f64>, loads: &mut [f64]) -> Result<(), Refusal> {
    within(&s::W, weight, 0.0, f64::INFINITY, false)?;
    let n = machine.groups.len() as f64;
    let mean = machine.groups.iter().sum::<Point<f64>>() / n;
    let (mut xx, mut xy, mut yy) = (0.0, 0.0, 0.0);
    for p in &machine.groups {
        let d = p - mean;
        xx += d.x * d.x;
        xy += d.x * d.y;
        yy += d.y * d.y;
    }
    let determinant = xx * yy - xy * xy;
    if determinant <= 1e-12 * (xx + yy) * (xx + yy) {
        return Err(Refusal::new(
            "groups",
            "all groups stand on one line: their loads do not follow from the centre of gravity",
            "give the load of each group",
        ));
    }
    let e = centre - mean;
    let (bx, by) = ((e.x * yy - e.y * xy) / determinant, (e.y * xx - e.x * xy) / determinant);
    for (i, (p, load)) in machine.groups.iter().zip(loads.iter_mut()).enumerate() {
        *load = weight * (1.0 / n + plane::dot(Point::new(bx, by), p - mean));
        if *load < 0.0 {
            return Err(Refusal::new(
                format!("G[{}]", i + 1),
                format!("group {} would carry {} kN", i + 1, short(*load / 1e3)),
                format!(
                    "the centre of gravity ({}, {}) m lies too far out: bring it nearer to ({}, {}) m",
                    short(centre.x),
                    short(centre.y),
                    short(mean.x),
                    short(mean.y)
                ),
            ));
        }
    }
    Ok(())
}
