//! Velocities: ratios of angular velocities, and travel of the head.
//!
//! The ratios come from the loop O1–B–C–O3, x_1 ω_1 + x_2 ω_2 = x_3 ω_3 turned
//! by 90°, whose only singularity is the dead point; of a linkage with change points
//! they come from its branch, which has none. The instantaneous centre plays no part
//! in them: it lies at infinity where boom and rocker are parallel, while all
//! velocities stay finite.

use crate::component::stages::results;
use crate::kernel::calc::Calc;
use crate::luffing::double_link::parameters::Driven;
use crate::luffing::double_link::position::Position;
use crate::luffing::double_link::symbols as s;
use crate::parts::closure::Passing;
use crate::parts::four_bar::Branch;
use crate::parts::plane::{self, Point};

/// Velocities for one radian per second of the driving link.
#[derive(Clone, Copy, Debug)]
pub struct Velocity<C> {
    /// Jib's angular velocity over the driving link's. [Li2022, eq. 9]
    pub i_2: C,
    /// Angular velocity of the bar that is not driven over the driving link's.
    pub i_follower: C,
    /// Boom's angular velocity over the driving link's.
    pub of_boom: C,
    /// Travel of A for one radian of the driving link, in m. [Li2022, eq. 10]
    pub da: Point<C>,
    /// Travel of the driving link's head, B or C, for one radian, in m.
    pub head: Point<C>,
}

results! { Velocity as v => {
    I_2: v.i_2;
    I_1: v.i_follower;
    I_3: v.i_follower;
    BETA: v.beta();
} }

impl<C: Calc> Velocity<C> {
    #[inline]
    pub fn new(p: &Position<C>) -> Velocity<C> {
        let half = p.k / C::constant(2.0);
        let passed = p.passing.map(|passing| passed(p, passing));
        let ratio = |i: usize, a: Point<C>, b: Point<C>| match passed {
            Some(ratios) => ratios[i],
            None => plane::cross(a, b) / half,
        };
        let (i_2, i_follower, bar, beyond) = match p.driven {
            Driven::Boom => {
                let i_2 = ratio(0, p.x_1, p.x_3).def(&s::I_2);
                (i_2, ratio(1, p.x_1, p.x_2).def(&s::I_3), p.x_1, p.x_4)
            }
            Driven::Rocker => {
                let i_2 = ratio(0, p.x_3, p.x_1).def(&s::I_2);
                (i_2, ratio(1, p.x_2, p.x_3).def(&s::I_1), p.x_3, p.x_4 - p.x_2)
            }
        };
        let da = plane::def(
            Point::new(-(bar.y + i_2 * beyond.y), bar.x + i_2 * beyond.x),
            [&s::DA_X, &s::DA_Y],
        );
        Velocity {
            i_2,
            i_follower,
            of_boom: match p.driven {
                Driven::Boom => C::constant(1.0),
                Driven::Rocker => i_follower,
            },
            da,
            head: Point::new(-bar.y, bar.x),
        }
    }

    /// Angular velocities of boom and rocker over the driving link's.
    pub fn of_feet(&self, p: &Position<C>) -> (C, C) {
        let rocker = match p.driven {
            Driven::Boom => self.i_follower,
            Driven::Rocker => C::constant(1.0),
        };
        (self.of_boom, rocker)
    }

    /// Velocity of A, in m/s, at the driving link's angular velocity (rad/s). [Li2022, eq. 10]
    #[inline]
    pub fn v_a(&self, omega: &C) -> Point<C> {
        plane::def(Point::new(self.da.x * *omega, self.da.y * *omega), [&s::V_AX, &s::V_AY])
    }

    /// Direction of A's velocity when the driving link turns positively, in rad. [Li2022, eq. 10]
    pub fn beta(&self) -> C {
        C::direction(self.da.x, self.da.y).def(&s::BETA)
    }
}

/// Angular velocities of jib and driven link over the driving link's on the branch of a linkage with change points.
///
/// Cross and dot product of the two bars both tell how fast one turns from the other: the first one nothing where they
/// lie in one line, the second nothing where they stand at a right angle.
#[cold]
fn passed<C: Calc>(p: &Position<C>, passing: Passing) -> [C; 2] {
    let two = C::constant(2.0);
    let branch = match passing {
        Passing::Parallel => return [0.0, 1.0].map(C::constant),
        Passing::Folded => return [1.0, 0.0].map(C::constant),
        Passing::Swept(branch) => branch,
    };
    // Crank, coupler and follower of the linkage; its frame and its diagonal.
    let o3 = p.c - p.x_3;
    let (crank, coupler, follower, frame, relative) = match p.driven {
        Driven::Boom => (p.x_1, p.x_2, p.x_3, o3, &s::I_23),
        Driven::Rocker => (p.x_3, -p.x_2, p.x_1, -o3, &s::I_21),
    };
    let diagonal = crank - frame;
    let slope = two * plane::dot(crank, frame);
    let slope = match branch {
        Branch::Left => -slope,
        Branch::Right => slope,
    }
    .def(&s::DK);
    let squares = plane::squared(coupler) * plane::squared(follower);
    let turned = plane::dot(follower, coupler) * slope + p.k * plane::cross(crank, diagonal);
    let relative = (turned / (two * squares)).def(relative);
    let along = plane::dot(crank, diagonal) + relative * plane::dot(coupler, diagonal);
    let follower = along / plane::squared(diagonal);
    [follower + relative, follower]
}
