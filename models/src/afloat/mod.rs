//! A crane on a hull that floats: how it lies under its load, its righting levers, and what a loss of load does.
//! [Ports001, 7.3]
//!
//! ```text
//!   seen from the bow:            seen from above:
//!                 o  load              left (y)
//!                /                  +-----------------\
//!        _______/________           |      o  psi      \  bow (x)
//!   ~~~~|        G       |~~~~      |                  /
//!       |________B_______|          +-----------------/
//! ```
//!
//! The origin lies at the keel; x forward, y to the left, z up. Heel is positive where the left side goes down, trim where the
//! bow does. A moment has the sign of the coordinate at which its weights stand: `M_T = Σ G y`, `M_L = Σ G x`.
//!
//! | id | function | source |
//! |---|---|---|
//! | `afloat.weights` | [`weights::DeadLoad::new`], [`loaded::Loaded::new`] | equilibrium; IS Code 2008, B 2.9 |
//! | `afloat.cut` | [`Solid::cut`](crate::parts::solid::Solid::cut) | Gauss' theorem |
//! | `afloat.upright` | [`upright::Upright::new`], [`small::SmallAngles::new`] | Ports001, 7.3 |
//! | `afloat.rest` | [`rest::rest`], [`posture::Posture::new`] | equilibrium |
//! | `afloat.levers` | [`levers::levers`] | potential energy; Ports001, 7.3: wall-sided form |
//! | `afloat.openings` | [`openings::flooding`], [`openings::AreaEnds::new`] | geometry; Ports001, 7.3 |
//! | `afloat.loss` | [`loss::residual`], [`loss::LoadLost::new`] | 46 CFR 173, 173.020 and 173.025 |
//! | `afloat.gust` | [`gust::Gust::new`] | Ports001, 7.3: dynamic lever |
//! | `afloat.cases` | [`cases::CaseOutcome::new`] | Ports001, 7.3: 3.2.6.1 to 3.2.6.4 |
//! | `afloat.riding` | [`riding::RidingHull::new`], [`riding::WaterForces::new`] | geometry; virtual work |
//! | `afloat.crane` | [`Luffed::at`](crate::luffing::luffed::Luffed::at), [`crane::CraneWeights::new`], [`holding::HeldAtRest::new`] | equilibrium; virtual work |
//! | `afloat.carrying` | [`carrying::CraneAfloat::moved`], [`yielding::yielding`], [`driving::DriveMoments::new`] | Lagrange; virtual work |
//! | `afloat.swaying` | [`head::HeadPlace::new`], [`swaying::Swaying::new`] | Lagrange, first kind |

pub mod carrying;
pub mod cases;
pub mod crane;
mod drawing;
pub mod driving;
pub mod gust;
pub mod head;
pub mod heeling;
pub mod holding;
pub mod hull;
mod judging;
pub mod levers;
pub mod loaded;
pub mod loss;
pub mod openings;
mod outline;
mod planning;
pub mod posture;
pub mod rest;
pub mod riding;
mod rig;
pub mod scene;
mod shape;
pub mod small;
pub mod stages;
mod start;
pub mod swaying;
pub mod symbols;
mod told;
pub mod upright;
pub mod weights;
pub mod yielding;
