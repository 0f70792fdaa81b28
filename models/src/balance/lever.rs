//! Four-bar lever counterweight: boom O–K, coupling rod K–L, lever M–L with the
//! counterweight on its other arm.

use nalgebra::Scalar;

use crate::balance::action::{Action, LeverTurn, RodLine};
use crate::balance::symbols as s;
use crate::kernel::allowed::{FINITE, OutOfRange, POSITIVE, check};
use crate::kernel::calc::Calc;
use crate::kernel::group::{quantities, sound};
use crate::parts::arcs::Arc;
use crate::parts::closure::Closure;
use crate::parts::four_bar::{Branch, FourBar, Names};
use crate::parts::plane::{self, Point};

quantities! {
    /// Lengths (m), angles (rad) and the counterweight's moment (N·m).
    Dimensions { d_1: D_1, delta_1: DELTA_1, r_1: R_K, alpha_1: ALPHA_K, l_1: L_1, lever: R_L, chi_5: CHI_5, m_5: M_5 }
}

/// The linkage, at no particular position.
#[derive(Clone, Copy, Debug)]
pub struct Lever<C> {
    pub dimensions: Dimensions<C>,
    /// Arm of the counterweight (m); only its height, its weight and the
    /// pivot's force depend on it.
    pub s_5: Option<C>,
    pub branch: Branch,
    pivot: Point<C>,
    linkage: FourBar<C>,
}

impl<C: Copy + Scalar> Lever<C> {
    /// The same lever over another scalar.
    #[must_use]
    pub fn map<D: Scalar>(&self, f: fn(C) -> D) -> Lever<D> {
        Lever {
            dimensions: self.dimensions.map(&mut |_, value| f(value)),
            s_5: self.s_5.map(f),
            branch: self.branch,
            pivot: self.pivot.map(f),
            linkage: self.linkage.map(f),
        }
    }
}

impl<C: Calc> Lever<C> {
    /// `branch` is the side of the line from the lever's pivot to the joint on
    /// the boom on which the rod meets the lever; Balance004 has the left one.
    ///
    /// # Errors
    /// A length that is not positive, a negative moment, or lengths that close at no angle.
    pub fn new(dimensions: Dimensions<C>, s_5: Option<C>, branch: Branch) -> Result<Lever<C>, OutOfRange> {
        sound(&dimensions)?;
        if let Some(s_5) = s_5 {
            check(&s::S_5, s_5.value(), POSITIVE)?;
        }
        let d = dimensions;
        let (sin, cos) = d.delta_1.sin_cos();
        let pivot = plane::def(Point::new(d.d_1 * cos, d.d_1 * sin), [&s::D_1X, &s::D_1Y]);
        let linkage = FourBar::new([d.r_1, d.l_1, d.lever], pivot, branch, &NAMES).ok_or_else(|| {
            // The diagonal from pivot to joint lies between |d_1 - r_1| and d_1 + r_1.
            let [frame, crank, arm] = [d.d_1.value(), d.r_1.value(), d.lever.value()];
            let shortest = ((frame - crank).abs() - arm).max(arm - frame - crank).max(0.0);
            let allowed = [shortest, frame + crank + arm];
            OutOfRange::new(
                &s::L_1,
                d.l_1.value(),
                allowed,
                "the balance linkage closes at no angle of the boom",
            )
        })?;
        Ok(Lever {
            dimensions,
            s_5,
            branch,
            pivot,
            linkage,
        })
    }

    /// Boom angles between which the linkage closes without passing a dead
    /// point, in rad, around `phi` or else the first.
    #[must_use]
    pub fn arc(&self, phi: f64) -> [f64; 2] {
        if self.linkage.turns_fully() {
            return FINITE;
        }
        let alpha = self.dimensions.alpha_1.value();
        // Whole turns bring an arc to where phi is.
        let near = |arc: &Arc| {
            let turns = ((phi + alpha - f64::midpoint(arc.from, arc.to)) / std::f64::consts::TAU).round();
            let shift = turns * std::f64::consts::TAU - alpha;
            [arc.from + shift, arc.to + shift]
        };
        let arcs = self.linkage.arcs();
        let mut all = arcs.iter().map(near);
        all.find(|arc| (arc[0]..=arc[1]).contains(&phi))
            .unwrap_or_else(|| near(&arcs[0]))
    }

    fn psi(&self, follower: Point<C>) -> C {
        (C::direction(follower.x, follower.y) + self.dimensions.chi_5).def(&s::PSI)
    }

    /// The counterweight from the boom foot, in m, at boom angle `phi` (rad); `None` where the linkage
    /// does not close, and where the counterweight's arm is not known.
    pub fn place(&self, phi: C) -> Option<Point<C>> {
        let angle = (phi + self.dimensions.alpha_1).def(&s::PHI_K);
        let follower = Closure::new(&self.linkage, angle, &NAMES)?.follower;
        let ((sin, cos), s_5) = (self.psi(follower).sin_cos(), self.s_5?);
        Some(Point::new(self.pivot.x + s_5 * cos, self.pivot.y + s_5 * sin))
    }

    /// How its rod carries a force on the counterweight at `place` (m); `None` where the linkage does not close.
    pub fn line(&self, phi: C, place: Point<C>) -> Option<RodLine<C>> {
        let d = &self.dimensions;
        let closed = Closure::new(&self.linkage, phi + d.alpha_1, &NAMES)?;
        let (arm, h_5) = (place - self.pivot, closed.area / (C::constant(2.0) * d.l_1));
        Some(RodLine {
            per_force: Point::new(-arm.y, arm.x) / h_5,
            along: closed.coupler / d.l_1,
            rail: None,
        })
    }

    /// At boom angle `phi` (rad). [Balance004, eq. 2]
    ///
    /// # Errors
    /// An angle at which the linkage does not close or has a dead point.
    pub fn at(&self, phi: C) -> Result<Action<C>, OutOfRange> {
        let d = &self.dimensions;
        let outside = |what| OutOfRange::new(&s::PHI, phi.value(), self.arc(phi.value()), what);
        let angle = (phi + d.alpha_1).def(&s::PHI_K);
        let Closure {
            crank: k,
            coupler,
            follower,
            area,
            ..
        } = Closure::new(&self.linkage, angle, &NAMES)
            .ok_or_else(|| outside("the balance linkage does not close at this angle"))?;
        let two = C::constant(2.0);
        if area.value().abs() <= 8.0 * f64::EPSILON * (d.l_1 * d.lever).value() {
            return Err(outside("rod and lever lie in one line: a dead point"));
        }
        // Arms of the rod's force about foot and pivot.
        let h_1 = (plane::cross(k, coupler) / d.l_1).def(&s::H_1);
        let h_5 = (area / (two * d.l_1)).def(&s::H_5);
        let (i_5, i_1) = ((h_1 / h_5).def(&s::I_5), two * plane::cross(k, follower) / area);
        let psi = self.psi(follower);
        let (sin, cos) = psi.sin_cos();
        let about_pivot = d.m_5 * cos;
        let m_b = (-(about_pivot * i_5)).def(&s::M_UR);
        let n_1 = (-(about_pivot / h_5)).def(&s::N_1);
        let pull = Point::new(n_1 * coupler.x / d.l_1, n_1 * coupler.y / d.l_1);
        let on_boom = plane::def(pull, [&s::F_KX, &s::F_KY]);
        let on_pivot = self
            .s_5
            .map(|s_5| plane::def(Point::new(on_boom.x, on_boom.y + d.m_5 / s_5), [&s::F_MX, &s::F_MY]));
        let gamma = C::direction(plane::dot(coupler, follower).abs(), (area / two).abs()).def(&s::GAMMA);
        Ok(Action {
            m_b,
            u_5: (d.m_5 * sin).def(&s::U_5),
            y_5: self.s_5.map(|s_5| (self.pivot.y + s_5 * sin).def(&s::C_5Y)),
            on_boom,
            on_pivot,
            n_1: Some(n_1),
            lever: Some(LeverTurn { psi, i_5, i_1, gamma }),
        })
    }

    /// Arms of the rod about boom foot and lever's pivot, in m: R1 and R2 of [Ports001, eq. 5.2.3-5.2.4].
    ///
    /// # Errors
    /// As [`at`](Lever::at).
    pub fn arms(&self, phi: C) -> Result<[C; 2], OutOfRange> {
        let action = self.at(phi)?;
        let d = &self.dimensions;
        let turn = action.lever.expect("a lever turns");
        let h_5 = d.lever * turn.gamma.sin();
        Ok([(turn.i_5 * h_5).abs(), h_5])
    }
}

static NAMES: Names = Names {
    frame: &s::F_1,
    frame_angle: &s::DELTA_F,
    stretched: [&s::PHI_S, &s::PHI_S2],
    folded: [&s::PHI_F, &s::PHI_F2],
    crank: [&s::K_X, &s::K_Y],
    diagonal: [&s::A_1X, &s::A_1Y],
    diagonal_length: &s::A_1,
    stretched_margin: &s::SIGMA_S1,
    folded_margin: &s::SIGMA_F1,
    area: &s::K_1,
    follower: [&s::R_1X, &s::R_1Y],
    coupler: [&s::L_1X, &s::L_1Y],
};
