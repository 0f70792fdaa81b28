//! The four-bar linkage: crank O–J (driving), coupler J–K, follower N–K, frame
//! O–N; any lengths, both branches of assembly.

use std::f64::consts::{PI, TAU};

use nalgebra::Scalar;
use twofloat::TwoFloat;

use crate::kernel::calc::Calc;
use crate::kernel::schema::Values;
use crate::kernel::symbol::Symbol;
use crate::parts::dead_points::{Limit, dead_angle_tail};
use crate::parts::plane::{self, Point};

/// Names under which a mechanism's book prints the steps of the closure.
#[derive(Debug)]
pub struct Names {
    pub frame: &'static Symbol,
    pub frame_angle: &'static Symbol,
    pub stretched: [&'static Symbol; 2],
    pub folded: [&'static Symbol; 2],
    pub crank: [&'static Symbol; 2],
    pub diagonal: [&'static Symbol; 2],
    pub diagonal_length: &'static Symbol,
    pub stretched_margin: &'static Symbol,
    pub folded_margin: &'static Symbol,
    pub area: &'static Symbol,
    pub follower: [&'static Symbol; 2],
    pub coupler: [&'static Symbol; 2],
}

/// On which side of the line from the follower's pivot N to the crank's joint J
/// the joint K of coupler and follower lies; with change points, where it lies
/// up to half a turn clockwise of the frame: there a parallelogram is `Left`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Branch {
    Left,
    Right,
}

impl Branch {
    /// By its name in a scene.
    #[must_use]
    pub fn named(text: &str) -> Branch {
        if text == "right" { Branch::Right } else { Branch::Left }
    }

    /// Of a checked table, where it has the key `branch`.
    #[must_use]
    pub fn read(v: &Values) -> Option<Branch> {
        v.text("branch").map(Branch::named)
    }
}

/// Lengths of a linkage with what follows from them alone.
#[derive(Clone, Copy, Debug)]
pub struct FourBar<C> {
    pub(super) crank: C,
    pub(super) coupler: C,
    pub(super) follower: C,
    /// From the crank's pivot O to the follower's pivot N.
    pub(super) frame: Point<C>,
    pub(super) frame_length: C,
    pub(super) frame_direction: Point<C>,
    pub(super) branch: Branch,
    pub(super) stretched: Limit<C>,
    pub(super) folded: Limit<C>,
    /// Middle of the crank angles in use, in rad.
    pub(super) middle: f64,
    /// Whether both margins vanish.
    pub(super) changes: bool,
}

impl<C: Copy + Scalar> FourBar<C> {
    /// The same linkage over another scalar.
    #[must_use]
    pub fn map<D: Scalar>(&self, f: fn(C) -> D) -> FourBar<D> {
        FourBar {
            crank: f(self.crank),
            coupler: f(self.coupler),
            follower: f(self.follower),
            frame: self.frame.map(f),
            frame_length: f(self.frame_length),
            frame_direction: self.frame_direction.map(f),
            branch: self.branch,
            stretched: self.stretched.map(f),
            folded: self.folded.map(f),
            middle: self.middle,
            changes: self.changes,
        }
    }
}

impl<C: Calc> FourBar<C> {
    /// `None` where these lengths close at no crank angle.
    pub fn new(
        [crank, coupler, follower]: [C; 3],
        frame: Point<C>,
        branch: Branch,
        names: &Names,
    ) -> Option<FourBar<C>> {
        let frame_length = plane::length(frame).def(names.frame);
        let frame_angle = C::direction(frame.x, frame.y).def(names.frame_angle);
        let (a, f) = (crank, frame_length);
        let (sum, difference) = (coupler + follower, coupler - follower);
        // The diagonal runs from |a − f| to a + f and must stay within
        // |b − c| .. b + c.
        if sum.value() <= (a - f).value().abs() || difference.value().abs() >= (a + f).value() {
            return None;
        }
        // Dead angles lie this far on both sides of the frame.
        let away = |diagonal: C| {
            let half = C::direction(
                ((a + f - diagonal) * (a + f + diagonal)).sqrt(),
                ((diagonal - a + f) * (diagonal + a - f)).sqrt(),
            );
            C::constant(2.0) * half
        };
        let exact = |sign: f64| TwoFloat::new_add(coupler.value(), sign * follower.value());
        let end = |angle: C, name, diagonal: TwoFloat| {
            let angle = angle.def(name);
            (
                angle,
                dead_angle_tail(angle.value(), crank.value(), frame.map(C::value), diagonal),
            )
        };
        let reaches_stretched = sum.value() < (a + f).value();
        let reaches_folded = difference.value().abs() > (a - f).value().abs();
        let stretched = if reaches_stretched {
            let (away, names, exact) = (away(sum), names.stretched, exact(1.0));
            Limit::Between([
                end(frame_angle - away, names[0], exact),
                end(frame_angle + away, names[1], exact),
            ])
        } else {
            Limit::Free((sum - a - f) * (sum + a + f))
        };
        let folded = if !reaches_folded {
            Limit::Free((a - f - difference) * (a - f + difference))
        } else {
            let (away, names, exact) = (away(difference), names.folded, exact(-1.0));
            if reaches_stretched {
                Limit::Outside([
                    end(frame_angle - away, names[0], exact),
                    end(frame_angle + away, names[1], exact),
                ])
            } else {
                let turn = C::constant(TAU);
                Limit::Between([
                    end(frame_angle + away, names[0], exact),
                    end(frame_angle + turn - away, names[1], exact),
                ])
            }
        };
        let middle = frame_angle.value() + if reaches_folded && !reaches_stretched { PI } else { 0.0 };
        let frame_direction = frame / frame_length;
        let vanishes = |limit: &Limit<C>| matches!(limit, Limit::Free(margin) if margin.value() == 0.0);
        let changes = vanishes(&stretched) && vanishes(&folded);
        Some(FourBar {
            crank,
            coupler,
            follower,
            frame,
            frame_length,
            frame_direction,
            branch,
            stretched,
            folded,
            middle,
            changes,
        })
    }
}
