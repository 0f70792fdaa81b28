//! What the book of a mechanism tells of its drive, whose stages have the same names in each.

use crate::component::outline::Explained::Stage;
use crate::component::outline::{Greatest, Limit, Most, SectionOutline};
use crate::drive::symbols as s;

pub const CRANK_CONSTANTS: SectionOutline = ("crank_constants", &[Stage("crank")]);
pub const GEARING: SectionOutline = ("drive_constants", &[Stage("gearing")]);

pub const CRANK: SectionOutline = ("crank", &[Stage("cranked")]);
pub const LINE: SectionOutline = ("drive", &[Stage("drive"), Stage("stroke"), Stage("flow")]);
pub const SHAFT: SectionOutline = ("drive_shaft", &[Stage("shaft"), Stage("by_slider")]);

pub const FORCE_MAX: Greatest = Greatest::new(&s::F_D_MAX, Most::Amount, &s::F_D).with_pole(&s::H_D);
pub const TORQUE_OUT_MAX: Greatest = Greatest::new(&s::T_D_OUT_MAX, Most::Amount, &s::T_D_OUT).with_pole(&s::H_D);
pub const TORQUE_IN_MAX: Greatest = Greatest::new(&s::T_D_IN_MAX, Most::Amount, &s::T_D_IN).with_pole(&s::H_D);
pub const PULL_MIN: Greatest = Greatest::new(&s::S_L_MIN, Most::Least, &s::S_L).with_pole(&s::H_D);
pub const PULL_MAX: Greatest = Greatest::new(&s::S_L_MAX, Most::Greatest, &s::S_L_IN).with_pole(&s::H_D);

pub const LOCKS: Limit = Limit::at_least("drive_lock", &s::LOCK_D);
pub const TORQUE_OUT: Limit = Limit::at_most("drive_torque_out", &s::T_D_OUT_MAX);
pub const TORQUE_IN: Limit = Limit::at_most("drive_torque_in", &s::T_D_IN_MAX);
pub const PULLS: Limit = Limit::not_negative("drive_pulls", &s::S_L_MIN);
pub const PULL: Limit = Limit::at_most("drive_pull", &s::S_L_MAX);
