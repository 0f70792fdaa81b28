//! What several mechanisms are made of: plane geometry, air, ground, a four-bar, a speed controller, solids cut by a plane, joints, buckling, slewing, teeth, a load curve, a load on its rope, a hoist, a body on springs, motors with brakes, motion over a range, travel of a trolley, oil, solvers.

pub mod air;
pub mod arcs;
pub mod buckling;
pub mod closure;
pub mod control;
pub mod cut;
mod dead_points;
pub mod four_bar;
pub mod ground;
pub mod hanging;
pub mod hoist;
pub mod hull;
pub mod hydraulics;
pub mod joint;
pub mod load_curve;
pub mod motion;
pub mod motor;
pub mod plane;
pub mod shaping;
pub mod smooth_curve;
pub mod solid;
pub mod solver;
pub mod springs;
pub mod teeth;
pub mod travel;
pub mod turntable;
pub mod turntable_control;
