//! What a balance does at one boom angle.

use crate::parts::plane::Point;

/// What a balance does at one boom angle.
#[derive(Clone, Copy, Debug)]
pub struct Action<C> {
    /// Moment about the boom foot, in N·m; positive raises the boom.
    pub m_b: C,
    /// Potential energy of the counterweight, in J, up to a constant.
    pub u_5: C,
    /// Height of the counterweight, in m, up to a constant; where its arm is known.
    pub y_5: Option<C>,
    /// Force on the boom, in N.
    pub on_boom: Point<C>,
    /// Force of the frame on the lever's pivot, the guide pulley or the rail, in N.
    pub on_pivot: Option<Point<C>>,
    /// Force in rod or rope, in N, tension positive.
    pub n_1: Option<C>,
    pub lever: Option<LeverTurn<C>>,
}

/// The lever of a balance at one boom angle.
#[derive(Clone, Copy, Debug)]
pub struct LeverTurn<C> {
    /// Angle of the counterweight's arm, in rad.
    pub psi: C,
    /// Angular velocity over the boom's, and that of the rod.
    pub i_5: C,
    pub i_1: C,
    /// Transmission angle, 0 to π/2 rad.
    pub gamma: C,
}

/// How a balance carries any force on its counterweight to the boom, by its rod or rope.
#[derive(Clone, Copy, Debug)]
pub struct RodLine<C> {
    /// Force in the rod or rope, tension positive, for one newton on the counterweight, forward and upward.
    pub per_force: Point<C>,
    /// Direction of the force on the boom where the rod or rope pulls.
    pub along: Point<C>,
    /// Direction up the straight rail that its guide pulley pulls along; elsewhere the pivot or rail carries the force on
    /// the counterweight itself.
    pub rail: Option<Point<C>>,
}
