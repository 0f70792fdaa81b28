//! What weighs on the water, and the wind.

use crate::afloat::symbols as s;
use crate::component::stages::{absent, results};
use crate::kernel::calc::{Calc, sum};
use crate::kernel::group::{One, quantities};
use crate::kernel::variable::Fault;

quantities! {
    /// The hull, or a mass on it.
    HullMass { g_m: G_M, x_m: X_M, y_m: Y_M, z_m: Z_M }
}

quantities! {
    /// A rectangular tank and its liquid.
    TankGiven { rho_t: RHO_T, l_t: L_T, b_t: B_T, d_t: D_T, h_t: H_T, x_t: X_T, y_t: Y_T, z_t: Z_T }
}

quantities! {
    /// Where the crane stands.
    CranePlace { x_s: X_S, y_s: Y_S }
}

quantities! {
    /// The wind on the hull.
    HullWind { p_w: P_W, chi_w: CHI_W, z_l: Z_L }
}

quantities! {
    /// An area on which it acts.
    WindageArea { a_w: A_W, z_w: Z_W }
}

quantities! {
    /// A rope that pulls the hull.
    HullTow { f_p: F_P, chi_p: CHI_P, z_p: Z_P, z_lp: Z_LP }
}

impl<C: Calc> TankGiven<C> {
    /// Weight of the liquid, in N: ρ g l b h.
    pub fn weight(&self, gravity: &One<C>) -> C {
        self.rho_t * **gravity * self.l_t * self.b_t * self.h_t
    }

    /// Second moments of its surface about the axes along and across the hull, in m⁴: l b³/12, b l³/12.
    pub fn seconds(&self) -> [C; 2] {
        let (l, b, twelve) = (self.l_t, self.b_t, C::constant(12.0));
        [l * (b.square() * b) / twelve, b * (l.square() * l) / twelve]
    }
}

/// Weight (N) with its moments (N·m) about the axes across and along the hull, and the keel.
#[derive(Clone, Copy, Debug)]
pub struct Weighed<C> {
    pub weight: C,
    pub along: C,
    pub across: C,
    pub up: C,
}

impl<C: Calc> Weighed<C> {
    /// With what weighs besides.
    pub fn and(&self, other: &Weighed<C>) -> Weighed<C> {
        Weighed {
            weight: self.weight + other.weight,
            along: self.along + other.along,
            across: self.across + other.across,
            up: self.up + other.up,
        }
    }

    /// The same over another scalar.
    pub fn map<D>(&self, f: &mut dyn FnMut(C) -> D) -> Weighed<D> {
        let [weight, along, across, up] = [self.weight, self.along, self.across, self.up].map(f);
        Weighed {
            weight,
            along,
            across,
            up,
        }
    }
}

/// What floats without the load: weight (N), moments (N·m), those of the wind among them.
#[derive(Clone, Copy, Debug)]
pub struct DeadLoad<C> {
    pub all: Weighed<C>,
    /// Those of the weights alone.
    pub own: [C; 2],
    wind: Option<C>,
    tow: Option<C>,
}
results! { DeadLoad as d => {
    W_0: d.all.weight;
    M_W: d.wind.ok_or_else(absent)?;
    M_P: d.tow.ok_or_else(absent)?;
    M_L0: d.all.along;
    M_T0: d.all.across;
    M_V0: d.all.up;
} }

impl<C: Calc> DeadLoad<C> {
    /// W_0 = Σ G, M_L0 = Σ G x + M_w cos χ, M_T0 = Σ G y + M_w sin χ, M_V0 = Σ G z, M_w = p Σ A (z_w − z_l); a rope that
    /// tows adds to both likewise, M_p = F_p (z_p − z_lp).
    ///
    /// # Errors
    /// Nothing weighs anything.
    pub fn new(
        masses: &[HullMass<C>],
        tanks: &[TankGiven<C>],
        gravity: &One<C>,
        wind: &Option<HullWind<C>>,
        areas: &[WindageArea<C>],
        tow: &Option<HullTow<C>>,
    ) -> Result<DeadLoad<C>, Fault> {
        let with = |own: C, each: &dyn Fn(&TankGiven<C>) -> C| match tanks {
            [] => own,
            _ => own + sum(tanks.iter().map(|tank| tank.weight(gravity) * each(tank))),
        };
        let one = C::constant(1.0);
        let weight = with(sum(masses.iter().map(|m| m.g_m)), &|_| one).def(&s::W_0);
        if weight.value() <= 0.0 {
            let what = "W_0 = 0: what weighs nothing does not float; give the weight of the hull among the masses";
            return Err(Fault::outside(what));
        }
        let along = with(sum(masses.iter().map(|m| m.g_m * m.x_m)), &|tank| tank.x_t);
        let across = with(sum(masses.iter().map(|m| m.g_m * m.y_m)), &|tank| tank.y_t);
        let half = |tank: &TankGiven<C>| tank.z_t + tank.h_t / C::constant(2.0);
        let up = with(sum(masses.iter().map(|m| m.g_m * m.z_m)), &half).def(&s::M_V0);
        let blown = wind.as_ref().map(|wind| {
            let arms = sum(areas.iter().map(|area| area.a_w * (area.z_w - wind.z_l)));
            ((wind.p_w * arms).def(&s::M_W), wind.chi_w.sin_cos())
        });
        let towed = tow.as_ref().map(|tow| {
            let moment = (tow.f_p * (tow.z_p - tow.z_lp)).def(&s::M_P);
            (moment, tow.chi_p.sin_cos())
        });
        let own = [along, across];
        let pushed = blown.iter().chain(&towed);
        let [along, across] = pushed.fold(own, |[along, across], &(moment, (sin, cos))| {
            [along + moment * cos, across + moment * sin]
        });
        let all = Weighed {
            weight,
            along: along.def(&s::M_L0),
            across: across.def(&s::M_T0),
            up,
        };
        Ok(DeadLoad {
            all,
            own,
            wind: blown.map(|(moment, _)| moment),
            tow: towed.map(|(moment, _)| moment),
        })
    }
}
