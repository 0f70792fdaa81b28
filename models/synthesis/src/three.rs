//! Three positions of equal energy: the drawing-board construction of
//! [Ports001, 2.2.1], done analytically.
//!
//! Equal energy at three positions does not make the moment zero there; it
//! makes it pass zero inside each of the two intervals. (The book says otherwise.)

use lemnis_models::balance::boom::{Boom, joint};
use lemnis_models::balance::lever::{Dimensions, Lever};
use lemnis_models::balance::symbols as s;
use lemnis_models::kernel::allowed::{FINITE, OutOfRange, POSITIVE, check};
use lemnis_models::kernel::calc::Calc;
use lemnis_models::parts::four_bar::Branch;
use lemnis_models::parts::plane::{self, Point};

/// What is chosen before the construction.
#[derive(Clone, Copy, Debug)]
pub struct Given {
    /// Boom angles, in rad, rising.
    pub phi: [f64; 3],
    /// Lever's pivot from the boom foot, in m and rad.
    pub d_1: f64,
    pub delta_1: f64,
    /// Joint on the boom, in m and rad.
    pub r_1: f64,
    pub alpha_1: f64,
    /// Counterweight's arm at the first boom angle, in rad, behind the pivot.
    pub psi_1: f64,
    /// Weight of the counterweight times its arm, in N·m.
    pub m_5: f64,
}

/// Angle of the counterweight's arm (rad) behind the pivot that keeps the
/// potential energy `u_0` (J) that it has at `psi_1` with `u_1`. [Balance004, eq. 4]
///
/// # Errors
/// A counterweight too light to take up the energy.
pub(crate) fn ordinate(m_5: f64, psi_1: f64, u_1: f64, u_0: f64) -> Result<f64, OutOfRange> {
    let (sin, cos) = Calc::sin_cos(psi_1);
    if cos >= 0.0 {
        let what = "the counterweight must start behind the lever's pivot";
        return Err(OutOfRange::new(
            &s::PSI,
            psi_1,
            [0.5 * std::f64::consts::PI, 1.5 * std::f64::consts::PI],
            what,
        ));
    }
    let sine = sin - (u_0 - u_1) / m_5;
    if sine.abs() >= 1.0 {
        let rise = (u_0 - u_1).abs();
        let room = if sine < 0.0 { 1.0 + sin } else { 1.0 - sin };
        let what = "the counterweight is too light: its lever would turn past the vertical";
        return Err(OutOfRange::new(&s::M_5, m_5, [rise / room, f64::INFINITY], what));
    }
    let turns = ((psi_1 - std::f64::consts::PI) / std::f64::consts::TAU).round();
    Ok(std::f64::consts::PI - Calc::asin(sine) + turns * std::f64::consts::TAU)
}

/// Twice the area of a triangle relative to its longest side below which its
/// corners count as lying in one line: the rod would be a thousand times longer.
const COLLINEAR: f64 = 1e-3;

/// The lever whose counterweight gives back the boom's energy at three positions.
///
/// # Errors
/// Angles that do not rise, a counterweight too light, positions that need an
/// infinite rod, or that a linkage reaches only in two branches.
pub fn lever(boom: &(dyn Boom<f64> + Sync), given: &Given) -> Result<Lever<f64>, OutOfRange> {
    let g = given;
    check(&s::D_1, g.d_1, POSITIVE)?;
    check(&s::R_K, g.r_1, POSITIVE)?;
    check(&s::M_5, g.m_5, POSITIVE)?;
    for (symbol, value) in [(&s::DELTA_1, g.delta_1), (&s::ALPHA_K, g.alpha_1), (&s::PSI, g.psi_1)] {
        check(symbol, value, FINITE)?;
    }
    for pair in g.phi.windows(2) {
        check(&s::PHI, pair[1], [pair[0], f64::MAX])?;
    }
    let u = g.phi.map(|phi| boom.at(phi).map(|load| load.u_0));
    let [u_1, u_2, u_3] = [u[0].clone()?, u[1].clone()?, u[2].clone()?];
    let psi = [
        g.psi_1,
        ordinate(g.m_5, g.psi_1, u_1, u_2)?,
        ordinate(g.m_5, g.psi_1, u_1, u_3)?,
    ];
    let (sin, cos) = Calc::sin_cos(g.delta_1);
    let pivot = Point::new(g.d_1 * cos, g.d_1 * sin);
    // Joints seen from the lever, as if it stayed in its first position.
    let seen = [0, 1, 2].map(|i| {
        let (sin, cos) = Calc::sin_cos(psi[0] - psi[i]);
        plane::turned(joint(g.phi[i], g.r_1, g.alpha_1) - pivot, cos, sin)
    });
    let [a, b] = [seen[1] - seen[0], seen[2] - seen[0]];
    let double_area = plane::cross(a, b);
    let longest = plane::length(a).max(plane::length(b)).max(plane::length(b - a));
    let height = double_area.abs() / longest;
    if height.is_nan() || height <= COLLINEAR * longest {
        let what = "the three positions of the joint seen from the lever lie in one line: the rod would be infinitely long; choose other positions or another joint";
        return Err(OutOfRange::new(&s::R_K, g.r_1, FINITE, what));
    }
    let (aa, bb) = (plane::dot(a, a), plane::dot(b, b));
    let centre = Point::new(b.y * aa - a.y * bb, a.x * bb - b.x * aa) / (2.0 * double_area);
    let arm = seen[0] + centre;
    let sides = seen.map(|k| plane::cross(k, arm) > 0.0);
    if sides != [sides[0]; 3] {
        let what = "the linkage reaches the three positions only by passing a dead point";
        return Err(OutOfRange::new(&s::ALPHA_K, g.alpha_1, FINITE, what));
    }
    let branch = if sides[0] { Branch::Left } else { Branch::Right };
    let dimensions = Dimensions {
        d_1: g.d_1,
        delta_1: g.delta_1,
        r_1: g.r_1,
        alpha_1: g.alpha_1,
        l_1: plane::length(centre),
        lever: plane::length(arm),
        chi_5: near_zero(psi[0] - f64::direction(arm.x, arm.y)),
        m_5: g.m_5,
    };
    Lever::new(dimensions, None, branch)
}

/// The angle less whole turns, in [−π, π].
pub(crate) fn near_zero(angle: f64) -> f64 {
    angle - (angle / std::f64::consts::TAU).round() * std::f64::consts::TAU
}
