//! What the book tells of a crane on a portal, in its order.

use crate::component::outline::Explained::Stage;
use crate::component::outline::{Greatest, Limit, Most, Outline, chapters};
use crate::kernel::symbol::listed;
use crate::supports::portal::symbols as s;

pub const OUTLINE: Outline = Outline {
    inputs: chapters!(
        portal_place "", portal_corners "corners", portal_bodies "portal", portal_upper "upper", load "Q", load "R",
        portal_wind "wind", portal_areas "wind.areas", motion, limits
    ),
    constants: &[
        ("portal_weights", &[Stage("still"), Stage("own")]),
        ("portal_slewing", &[Stage("slewing")]),
        ("portal_circle", &[Stage("circle")]),
    ],
    sections: &[
        ("portal_moments", &[Stage("moments")]),
        ("portal_four", &[Stage("four")]),
        ("portal_rigid", &[Stage("rigid")]),
        ("portal_hinged", &[Stage("hinged")]),
        ("portal_wheels", &[Stage("loads"), Stage("top")]),
        ("portal_tipping", &[Stage("edges")]),
    ],
    table: listed!(s: M_X, M_Y, N_TOP, N_LOW),
    curves: &[
        ("portal_rigid", None, &s::N_R),
        ("portal_hinged", None, &s::N_H),
        ("portal_difference", None, &s::D_N),
    ],
    extremes: &[
        Greatest::new(&s::N_R_MAX, Most::Greatest, &s::N_R),
        Greatest::new(&s::N_H_MAX, Most::Greatest, &s::N_H),
        Greatest::new(&s::D_N_MAX, Most::Amount, &s::D_N),
        Greatest::new(&s::F_W_MAX, Most::Greatest, &s::F_W),
        Greatest::new(&s::H_MAX, Most::Greatest, &s::H),
        Greatest::new(&s::N_4_MIN, Most::Least, &s::N_4),
        Greatest::new(&s::K_MIN, Most::Least, &s::K),
    ],
    summary: &[],
    sensitivity: listed!(s: F_W_MAX, N_4_MIN, K_MIN),
    limits: &[
        Limit::at_most("portal_wheel", &s::F_W_MAX),
        Limit::at_least("portal_lift", &s::N_4_MIN),
        Limit::at_least("portal_tipping", &s::K_MIN),
    ],
    uses: &[],
    forces: listed!(s: N_R, N_H, H),
    worst: &[("greatest_wheel_load", &s::F_W_MAX)],
};
