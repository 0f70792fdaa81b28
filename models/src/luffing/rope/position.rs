//! Where boom, tackle, hoist rope and load are.

use crate::component::stages::{Found, results};
use crate::kernel::calc::Calc;
use crate::kernel::group::{group, quantities};
use crate::kernel::symbol::Symbol;
use crate::kernel::variable::Fault;
use crate::parts::motion::{Motion, degrees};
use crate::parts::plane::{self, Point};

/// Quantities of boom and ropes, and of the tackle that carries the load.
mod s {
    pub use crate::luffing::moving::symbols::M_H;
    pub use crate::luffing::rope::symbols::*;
}

/// What the scene has chosen.
#[derive(Clone, Copy, Debug)]
pub struct BoomChoice {
    /// Working range of the boom.
    pub range: Motion,
}
group!(BoomChoice);

quantities! {
    /// Boom, luffing tackle and hoist rope.
    Rig {
        l: L, f_a: F_A, x_8: X_8,
        e_x: E_X, e_y: E_Y, s_k: S_K, chi_k: CHI_K, m_l: M_L, eta_l: ETA_L,
        b_x: B_X, b_y: B_Y, m_h: M_H, eta_h: ETA_H, h_q: H_Q
    }
}

quantities! {
    /// Hoist rope that runs several times between head and sheave.
    Compensation { m_k: M_K, eta_k: ETA_K }
}

/// The boom at one angle.
#[derive(Clone, Copy, Debug)]
pub struct BoomPosition<C> {
    /// Unit vector along its line.
    pub along: Point<C>,
    /// Its head, in m from O1.
    pub a: Point<C>,
    /// Reach, in m.
    pub r: C,
}
results! { BoomPosition as p => { A_X: p.a.x; A_Y: p.a.y; R: p.r; } }

impl<C: Calc> BoomPosition<C> {
    pub fn new(rig: &Rig<C>, phi: &C) -> BoomPosition<C> {
        let (sin, cos) = phi.sin_cos();
        let a = Point::new(rig.l * cos - rig.f_a * sin, rig.l * sin + rig.f_a * cos);
        let a = plane::def(a, [&s::A_X, &s::A_Y]);
        BoomPosition {
            along: Point::new(cos, sin),
            a,
            r: (a.x + rig.x_8).def(&s::R),
        }
    }
}

/// A taut rope from a point of the boom to one of the frame.
#[derive(Clone, Copy, Debug)]
pub struct TautRope<C> {
    /// From the boom to the frame, in m.
    pub line: Point<C>,
    pub length: C,
    /// Lever arm about O1, in m: what the length loses for one radian of the boom.
    pub arm: C,
}

impl<C: Calc> TautRope<C> {
    /// With the names of its components, its length and its arm.
    ///
    /// # Errors
    /// Both ends in one place: no line to pull along.
    fn new(from: Point<C>, to: Point<C>, [x, y, length, arm]: [&'static Symbol; 4]) -> Found<TautRope<C>> {
        let reach = |point: Point<C>| point.x.value().abs() + point.y.value().abs();
        let line = plane::def(to - from, [x, y]);
        let long = plane::length(line).def(length);
        if long.value() <= 4.0 * f64::EPSILON * (reach(from) + reach(to)) {
            let message = format!("{} = 0 m: its ends meet, there is no line to pull along", length.id);
            return Err(Box::new(Fault::outside(message)));
        }
        Ok(TautRope {
            line,
            length: long,
            arm: (plane::cross(from, line) / long).def(arm),
        })
    }

    /// Force on the boom, in N, of a pull along it.
    pub fn force(&self, pull: C) -> Point<C> {
        Point::new(pull * self.line.x / self.length, pull * self.line.y / self.length)
    }
}

/// The luffing rig.
#[derive(Clone, Copy, Debug)]
pub struct Falls<C> {
    pub line: TautRope<C>,
    /// Rope in all falls, in m.
    l_l: C,
}
results! { Falls as t => { L_T: t.line.length; H_T: t.line.arm; L_L: t.l_l; } }

impl<C: Calc> Falls<C> {
    /// [Ports001, 5.1]
    ///
    /// # Errors
    /// A tackle of no length, one that would have to push.
    pub fn new(rig: &Rig<C>, position: &BoomPosition<C>, phi: &C) -> Found<Falls<C>> {
        let (sin, cos) = rig.chi_k.sin_cos();
        let k = plane::turned(position.along, rig.s_k * cos, rig.s_k * sin);
        let k = plane::def(k, [&s::K_LX, &s::K_LY]);
        let names = [&s::L_TX, &s::L_TY, &s::L_T, &s::H_T];
        let line = TautRope::new(k, Point::new(rig.e_x, rig.e_y), names)?;
        if line.arm.value() <= 4.0 * f64::EPSILON * line.length.value() {
            return Err(Box::new(Fault::outside(format!(
                "phi = {}: the luffing tackle passes below the boom's foot, it would have to push to raise the boom; \
                 set E higher or farther back, or lower the boom less",
                degrees(phi.value())
            ))));
        }
        let l_l = (rig.m_l * line.length).def(&s::L_L);
        Ok(Falls { line, l_l })
    }
}

/// The hoist rope between head and sheave: once, or in several parts.
#[derive(Clone, Copy, Debug)]
pub struct Stretch<C> {
    pub line: TautRope<C>,
    pub parts: Option<Compensation<C>>,
}
results! { Stretch as r => { L_S: r.line.length; H_S: r.line.arm; } }

impl<C: Calc> Stretch<C> {
    /// # Errors
    /// The head in the sheave.
    pub fn new(rig: &Rig<C>, parts: &Option<Compensation<C>>, position: &BoomPosition<C>) -> Found<Stretch<C>> {
        let names = [&s::L_SX, &s::L_SY, &s::L_S, &s::H_S];
        let line = TautRope::new(position.a, Point::new(rig.b_x, rig.b_y), names)?;
        Ok(Stretch { line, parts: *parts })
    }

    /// In all parts, what one has: length, lever arm or pull.
    pub fn all(&self, one: C) -> C {
        self.parts.map_or(one, |parts| parts.m_k * one)
    }
}

/// Where the load hangs at the start of the working range.
#[derive(Clone, Copy, Debug)]
pub struct LoadLevel<C> {
    /// Height of the load less that of the head, in m, were there no rope between head and sheave.
    c_q: C,
    /// Height of the load at the start, in m.
    start: C,
}
results! { LoadLevel as l => { C_Q: l.c_q; } }

impl<C: Calc> LoadLevel<C> {
    /// h_Q below the head. [Ports001, 5.2.3]
    ///
    /// # Errors
    /// As [`Stretch::new`].
    pub fn new(rig: &Rig<C>, parts: &Option<Compensation<C>>, choice: &BoomChoice) -> Found<LoadLevel<C>> {
        let there = BoomPosition::new(rig, &C::known(&s::FROM, choice.range.from));
        let stretch = Stretch::new(rig, parts, &there)?;
        Ok(LoadLevel {
            c_q: (-rig.h_q - stretch.all(stretch.line.length) / rig.m_h).def(&s::C_Q),
            start: (there.a.y - rig.h_q).def(&s::Y_QA),
        })
    }
}

/// The load with the hoist drum at rest: what the stretch between head and sheave loses goes into the falls below the
/// head.
#[derive(Clone, Copy, Debug)]
pub struct Path<C> {
    /// Height of the load, in m.
    pub y_q: C,
    l_h: C,
}
results! { Path as p => { Y_Q: p.y_q; L_H: p.l_h; } }

impl<C: Calc> Path<C> {
    /// y_Q = y_A + |A − B| m_k / m_h + const. [Ports001, 5.2.3.1]
    pub fn new(rig: &Rig<C>, level: &LoadLevel<C>, position: &BoomPosition<C>, stretch: &Stretch<C>) -> Path<C> {
        let y_q = (position.a.y + stretch.all(stretch.line.length) / rig.m_h + level.c_q).def(&s::Y_Q);
        Path {
            y_q,
            l_h: (rig.m_h * (level.start - y_q)).def(&s::L_H),
        }
    }
}
