//! Steering of a machine on many steered wheel groups. [Zhang2016, generalised]
//!
//! ```text
//!        y  left
//!        |
//!   4    3  |  2    1        1, 2, 3 … steered groups, each of one or more wheels
//!   o----o--|--o----o        on one turntable, anywhere in the plane
//!   |       +--------- x     theta_i  heading of group i from x, counter-clockwise
//!   o----o-----o----o
//!   8    7     6    5        O        turning centre: every axle line passes through it
//! ```
//!
//! Seen from above: x forward, y to the left, angles counter-clockwise, so that a
//! positive angle of a front group turns the machine to the left. The turning
//! centre may lie at infinity. A group's wheels roll in its heading (positive
//! speed) or against it (negative): heading and speed together tell the motion.
//! A positive cylinder force pushes.
//!
//! | id | function | source |
//! |---|---|---|
//! | `steering.machine` | [`machine::Machine::new`] | derived |
//! | `steering.mode.centre` | [`mode::Mode::centre`] | Zhang2016, 2; five of the nine modes derived |
//! | `steering.centre.rolling` | [`mode::Centre::rolling`] | rigid body |
//! | `steering.ackermann.angle` | [`wheels::roll`] | Zhang2016, eq. 1-9, generalised |
//! | `steering.ackermann.residual` | [`wheels::residual`] | derived |
//! | `steering.swept` | [`swept::moved`], [`swept::Swept::new`] | rigid body |
//! | `steering.reach` | [`reach::reach`], [`reach::nearest`] | derived |
//! | `steering.slip` | [`slip::Slip::new`], [`slip::worst`], [`slip::Accuracy::angle_error`] | least squares |
//! | `steering.transition` | [`transition::Crew::transition`], [`transition::Plan`] | derived |
//! | `steering.resistance` | [`load::resistance`] | Zhang2016, 3 |
//! | `steering.load_share` | [`load::share`] | equal springs |
//! | `steering.ring` | [`ring::Duty::new`], [`ring::Catalogue::choose`] | Zhang2016, 4 |
//! | `steering.cylinder.length` | [`cylinder::Linkage::at`] | Zhang2016, 5.1 |
//! | `steering.cylinder.stroke` | [`cylinder::Cylinder::stroke_margins`], [`cylinder::choose_stroke`] | Zhang2016, 5.1 |
//! | `steering.cylinder.range` | [`cylinder::Cylinder::range`], [`cylinder::Linkage::over`] | derived |
//! | `steering.cylinder.force` | [`sizing::force`] | Zhang2016, 5.2 |
//! | `steering.cylinder.bore` | [`sizing::bore`], [`sizing::next`] | Zhang2016, 5.3; ISO 3320 |
//! | `steering.flow` | [`sizing::rates`], [`sizing::flow`], [`sizing::greatest_demand`] | derived |
//! | `steering.pump` | [`sizing::pump`] | derived |
//! | `steering.buckling` | [`sizing::buckling`] | Euler |
//! | `steering.published` | [`published::Layout::angles`] | Zhang2016, eq. 1-9, misprints mended |

pub(crate) mod changes;
pub mod cylinder;
pub mod hydraulic;
pub mod load;
pub mod machine;
pub mod mode;
pub mod model;
pub mod moving;
pub mod outputs;
pub mod published;
pub mod reach;
pub mod ring;
pub mod scene;
pub mod searched;
pub mod set_points;
pub mod sheet;
pub mod sizing;
pub mod slip;
pub mod swept;
pub mod symbols;
pub mod transition;
pub mod wheels;
