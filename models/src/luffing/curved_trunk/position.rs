//! Where trunk, tie and head are.

use crate::component::stages::results;
use crate::kernel::calc::Calc;
use crate::luffing::curved_trunk::contact::Contact;
use crate::luffing::curved_trunk::symbols as s;
use crate::luffing::curved_trunk::tail::TrunkTail;
use crate::parts::plane::{self, Point};

/// The mechanism at one angle of the boom.
#[derive(Clone, Copy, Debug)]
pub struct TrunkPosition<C> {
    /// Unit vectors along the trunk's line and along the free tie towards O3.
    pub along: Point<C>,
    pub tie: Point<C>,
    /// From B to the trunk's head and to the point of contact, in m.
    pub front: Point<C>,
    pub touch: Point<C>,
    /// Both in m from O1, and the boom's head.
    pub a: Point<C>,
    pub t: Point<C>,
    pub b: Point<C>,
    /// Reach, in m.
    r: C,
    /// Lever arm of the tie about B, in m.
    pub h_t: C,
}
results! { TrunkPosition as p => {
    ALPHA: C::direction(p.along.x, p.along.y).def(&s::ALPHA);
    A_X: p.a.x;
    A_Y: p.a.y;
    T_X: p.t.x;
    T_Y: p.t.y;
    R: p.r;
    H_T: p.h_t;
    MU: C::direction(plane::dot(p.touch, p.tie).abs(), p.h_t.abs()).def(&s::MU);
} }

impl<C: Calc> TrunkPosition<C> {
    /// The trunk turns its end of the tie, v from B, onto O3, which is d from B. [Ports001, 5.2.3.3]
    pub fn new(tail: &TrunkTail<C>, contact: &Contact<C>) -> TrunkPosition<C> {
        let trunk = &tail.trunk;
        let Contact { b, d, d_2, p, u, f, .. } = *contact;
        let v = plane::def(p + u * f, [&s::V_X, &s::V_Y]);
        let along = Point::new(plane::dot(d, v) / d_2, plane::cross(v, d) / d_2);
        let along = plane::def(along, [&s::K_X, &s::K_Y]);
        let front = along * trunk.a;
        let a = plane::def(b + front, [&s::A_X, &s::A_Y]);
        let touch = plane::turned(p, along.x, along.y);
        TrunkPosition {
            along,
            tie: plane::def(plane::turned(u, along.x, along.y), [&s::E_TX, &s::E_TY]),
            front,
            touch,
            a,
            t: plane::def(b + touch, [&s::T_X, &s::T_Y]),
            b,
            r: (a.x + trunk.x_8).def(&s::R),
            h_t: plane::cross(p, u).def(&s::H_T),
        }
    }
}
