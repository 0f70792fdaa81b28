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
//! | `steering.centre.rolling` | [`centre::Centre::rolling`] | rigid body |
//! | `steering.ackermann.angle` | [`wheels::Rolling::new`], [`wheels::Wheel::new`], [`wheels::speed`] | Zhang2016, eq. 1-9, generalised |
//! | `steering.ackermann.residual` | [`centre::residual`] | derived |
//! | `steering.swept` | [`swept::moved`], [`swept::Swept::new`] | rigid body |
//! | `steering.reach` | [`reach::reach`], [`nearest::nearest`] | derived |
//! | `steering.slip` | [`slip::Slip::new`], [`slip::worst`], [`accuracy::Accuracy::angle_error`] | least squares |
//! | `steering.transition` | [`plan::Crew::transition`], [`plan::Plan`], [`progress::Moment`], [`transition::GreatCircle`] | derived |
//! | `steering.resistance` | [`load::resistance`] | Zhang2016, 3 |
//! | `steering.load_share` | [`load::share`] | equal springs |
//! | `steering.ring` | [`ring::Duty::new`], [`ring::Catalogue::choose`] | Zhang2016, 4 |
//! | `steering.cylinder.length` | [`cylinder::Linkage::at`] | Zhang2016, 5.1 |
//! | `steering.cylinder.stroke` | [`cylinder::Mounting::stroke_margins`], [`sizing::choose_stroke`] | Zhang2016, 5.1 |
//! | `steering.cylinder.range` | [`cylinder::Mounting::ends`], [`cylinder::Linkage::over`] | derived |
//! | `steering.cylinder.force` | [`load::force`] | Zhang2016, 5.2 |
//! | `steering.cylinder.bore` | [`sizing::bore`], [`sizing::next`] | Zhang2016, 5.3; ISO 3320 |
//! | `steering.flow` | [`travel::steering`], [`flow::flow`], [`demand::greatest_demand`] | derived |
//! | `steering.pump` | [`sizing::power`], [`sizing::pump`] | derived |
//! | `steering.buckling` | [`sizing::slenderness`], [`sizing::buckling`] | Euler |
//! | `steering.published` | [`published::Layout::angles`] | Zhang2016, eq. 1-9, misprints mended |

pub mod accuracy;
pub mod built;
pub mod centre;
pub mod change;
pub mod changes;
pub(crate) mod checks;
pub mod commanding;
pub mod cylinder;
pub mod demand;
pub(crate) mod drawing;
pub mod flow;
pub mod followed;
pub mod frame;
pub mod hydraulic;
pub(crate) mod keys;
pub mod limits;
pub mod load;
pub mod machine;
pub mod margin;
pub mod mode;
pub mod moving;
pub mod nearest;
pub(crate) mod parts;
pub mod plan;
pub mod progress;
pub mod published;
pub mod reach;
pub mod refusal;
pub mod ring;
pub mod scene;
pub mod set_points;
pub mod sheet;
pub mod sizing;
pub mod slip;
pub mod slope;
pub mod stages;
pub mod stand;
pub mod swept;
pub mod symbols;
pub mod transition;
pub mod travel;
pub(crate) mod views;
pub mod wheels;
