//! What is a mechanism's own in what the book tells of it in motion.

use crate::component::description::{Described, Description};
use crate::component::moving::MovingComponent;
use crate::component::stages::Stages;
use crate::drive::mount::Bore;
use crate::kernel::symbol::Symbol;
use crate::kernel::variable::Fault;
use crate::luffing::moving::luffs::Luffs;
use crate::luffing::moving::scene::Moving;
use crate::luffing::moving::start::starting;
use crate::luffing::moving::symbols as m;

/// A quantity that is drawn over time, by the id of its curve.
pub type Drawn = (&'static str, &'static Symbol);

/// A bar that may be driven: its angle, its angular velocity, and how fast that changes.
pub struct ShownBar {
    pub angle: Drawn,
    pub speed: Drawn,
    pub acceleration: &'static Symbol,
}

/// What is a mechanism's own in a section of its equations: id of the section, the one by which its words know it, and what
/// it gives.
pub type OwnPart = (&'static str, &'static str, &'static [&'static Symbol]);

/// How far two ways to one moment are apart, and the greatest of what they are made of, in N·m; `None` where there are no
/// finite forces.
pub type Apart = fn(&mut MovingComponent) -> Option<[f64; 2]>;

/// A mechanism that may move by itself, and whose book tells how.
pub trait Shown: Described<Component: Luffs> {
    /// Those that scenes may drive.
    const BARS: &'static [ShownBar];

    /// Reach, from which manoeuvres know where they go.
    const REACH: &'static Symbol;

    /// What sections of the equations give besides what any mechanism has there, and what of it is found while the model is
    /// assembled, before it moves.
    const SECTIONS: &'static [OwnPart];
    const ASSEMBLED: &'static [&'static Symbol] = &[];

    /// Stages that its equations at an instant consist of, of those that the scene has.
    const STAGES: &'static [&'static str] = &[
        "moves",
        "pull",
        "standing",
        "acted",
        "acting",
        "countered",
        "forces",
        "hauling",
    ];

    /// What its drive gives, and what is drawn of it where there is no rope; while it hoists beside the rope.
    const DRIVE: Drawn = ("motion_drive", &m::M_A);
    const BODY: Drawn = ("motion_resisting", &m::M_R);

    /// Forces of the motion, which other parts are designed for.
    const FORCES: &'static [&'static Symbol];

    /// What two ways to one result differ by.
    const AGREEMENT: &'static Symbol;

    /// Of the moment on the driven bar by equilibrium of the moving bodies, and that of drive, friction and end stop.
    const APART: Option<Apart> = None;

    /// What it is made of, with what only motion asks for, and its motion; `None` where it does not move by itself.
    fn moves(this: &Description<Self>) -> Option<(<Self::Component as Stages>::Given<f64>, &Moving)>;

    /// Of a luffing cylinder.
    fn bore(_this: &Description<Self>) -> Option<Bore<f64>> {
        None
    }
}

/// The model in motion, at rest at the start of the working range; none of what does not move.
pub fn running<T: Shown>(this: &Description<T>) -> Option<Result<MovingComponent, Fault>> {
    let (given, moving) = T::moves(this)?;
    Some(starting::<T::Component>(&given, this.motion, moving, this.motion.from))
}
