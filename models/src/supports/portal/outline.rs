//! What the book tells of a crane on a portal, in its order.

use crate::component::outline::Explained::Stage;
use crate::component::outline::{Greatest, Limit, Most, Outline, chapters};
use crate::kernel::symbol::listed;
use crate::luffing::aboard::{OMEGA_1, THETA_1, THETA_A, THETA_E};
use crate::luffing::kinds::GIVEN;
use crate::supports::portal::symbols as s;

pub const OUTLINE: Outline = Outline {
    inputs: chapters!(
        portal_place "", portal_corners "corners", portal_bodies "portal", portal_upper "upper", portal_hopper "hopper",
        carried_luffing "luffing", carried_weights "luffing.weights", carried_balance "luffing.balance", carried_inertias "luffing.dynamics", carried_range "luffing.motion",
        load "Q", load "R",
        portal_wind "wind", portal_areas "wind.areas", portal_travel "travel", portal_storm "travel.storm", motion, limits
    ),
    constants: &[
        ("carried_luffing", &[Stage("luffed")]),
        ("portal_hopper", &[Stage("filled")]),
        ("portal_weights", &[Stage("still"), Stage("own")]),
        ("portal_slewing", &[Stage("slewing")]),
        ("portal_circle", &[Stage("circle")]),
        ("portal_travel", &[Stage("rolling"), Stage("blown"), Stage("resisting")]),
        ("portal_motors", &[Stage("driving")]),
        ("portal_stop", &[Stage("stopping")]),
        ("portal_storm", &[Stage("storming")]),
    ],
    sections: &[
        ("portal_moments", &[Stage("moments")]),
        ("portal_four", &[Stage("four")]),
        ("portal_rigid", &[Stage("rigid")]),
        ("portal_hinged", &[Stage("hinged")]),
        ("portal_wheels", &[Stage("loads"), Stage("top")]),
        ("portal_tipping", &[Stage("edges")]),
        ("portal_grip", &[Stage("pushing"), Stage("grips")]),
        ("portal_tied", &[Stage("tied")]),
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
        Greatest::new(&s::K_ST_MIN, Most::Least, &s::K_ST),
        Greatest::new(&s::K_BR_MIN, Most::Least, &s::K_BR),
        Greatest::new(&s::K_S_MIN, Most::Least, &s::K_S),
        Greatest::new(&s::U_MAX, Most::Greatest, &s::U),
    ],
    summary: listed!(s: P_T, U_T, P_A, U_A, A_BR, S_BR, F_HD, U_HD, F_CL, F_C1, U_C),
    sensitivity: listed!(s: F_W_MAX, N_4_MIN, K_MIN, K_ST_MIN),
    limits: &[
        Limit::at_most("portal_wheel", &s::F_W_MAX),
        Limit::at_least("portal_lift", &s::N_4_MIN),
        Limit::at_least("portal_tipping", &s::K_MIN),
        Limit::within("portal_power", &s::U_T, 1.0),
        Limit::within("portal_start", &s::U_A, 1.0),
        Limit::within("portal_hold", &s::U_HD, 1.0),
        Limit::at_most("portal_stop", &s::S_BR),
        Limit::at_least("portal_grip", &s::K_ST_MIN),
        Limit::at_least("portal_sliding", &s::K_BR_MIN),
        Limit::within("portal_clamps", &s::U_C, 1.0),
        Limit::at_least("portal_storm", &s::K_S_MIN),
        Limit::at_most("portal_anchors", &s::U_MAX),
    ],
    uses: &[
        ("carried_range", &[&THETA_A, &THETA_E, &OMEGA_1]),
        ("carried_angle", &[&THETA_1]),
        ("carried_bars", GIVEN),
    ],
    forces: listed!(s: N_R, N_H, H),
    worst: &[("greatest_wheel_load", &s::F_W_MAX)],
};
