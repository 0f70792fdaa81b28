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
    /// Angular velocity over the boom's.
    pub i_5: C,
    /// Transmission angle, 0 to π/2 rad.
    pub gamma: C,
}
