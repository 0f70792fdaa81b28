//! What load is permitted, and by what.

use crate::component::stages::results;
use crate::kernel::calc::Calc;
use crate::kernel::group::{either, quantities};
use crate::supports::mobile::bearing::Bearable;
use crate::supports::mobile::boom::{BoomWeight, HeadPose};
use crate::supports::mobile::strength::Strengths;
use crate::supports::mobile::symbols as s;
use crate::supports::mobile::tipping::Tipping;
use crate::supports::mobile::weights::Hook;

quantities! {
    /// Factors of load and boom against tipping.
    Factored { k_p: K_P, k_f: K_F }
}

quantities! {
    /// A part of the tipping load.
    Fraction { nu: NU }
}

quantities! {
    /// A safety factor of the load.
    Divided { k_t: K_T }
}

/// How much of the tipping load is permitted.
#[derive(Clone, Copy, Debug)]
pub enum RatingBasis<C> {
    Factored(Factored<C>),
    Fraction(Fraction<C>),
    Divided(Divided<C>),
}
either!(RatingBasis {
    Factored,
    Fraction,
    Divided
});

quantities! {
    /// What is asked without load, and when the load indicator warns.
    Permission { s_lim: S_LIM, k_w: K_W }
}

/// What is permitted.
#[derive(Clone, Copy, Debug)]
pub struct Rated<C> {
    by_stability: C,
    by_strength: C,
    /// In N, with hook block or grab; infinite where nothing limits it.
    pub load: C,
    pub net: C,
    /// Place among [`GOVERNING`](s::GOVERNING).
    pub governs: usize,
}
results! { Rated as r => {
    Q_ST: r.by_stability;
    Q_S: r.by_strength;
    Q_RAT: r.load;
    Q_NET: r.net;
    GOVERNS: C::constant((r.governs + 1) as f64);
} }

/// Places among [`GOVERNING`](s::GOVERNING).
const SUPPORT: usize = 1;
pub const FORBIDDEN: usize = 6;

impl<C: Calc> RatingBasis<C> {
    /// (P − k_F F) / k_P [ISO 4305], ν P, or P / K [Ports001, 7.1.4].
    fn permits(&self, tips: C, boom: &BoomWeight<C>) -> C {
        match self {
            RatingBasis::Factored(by) => (tips - by.k_f * boom.at_head) / by.k_p,
            RatingBasis::Fraction(by) => by.nu * tips,
            RatingBasis::Divided(by) => tips / by.k_t,
        }
    }
}

impl<C: Calc> Rated<C> {
    /// The least of stability, supports and strengths; nothing where the crane without load may tip backward.
    #[expect(clippy::too_many_arguments, reason = "all that limits it")]
    pub fn new(
        basis: &RatingBasis<C>,
        permission: &Permission<C>,
        hook: &Hook<C>,
        strengths: &Strengths,
        tipping: &Tipping<C>,
        behind: &C,
        boom: &BoomWeight<C>,
        pose: &HeadPose<C>,
        length: &C,
        bearable: &Bearable<C>,
    ) -> Rated<C> {
        let none = |symbol| C::known(symbol, f64::INFINITY);
        let by_stability = match tipping.load {
            Some(tips) => basis.permits(tips, boom).def(&s::Q_ST),
            None => none(&s::Q_ST),
        };
        let strength = strengths.at(length.value(), pose.reach.value());
        let by_strength = strength.map_or(none(&s::Q_S), |(_, load)| C::known(&s::Q_S, load));
        let by_strength = by_strength.over(pose.reach).over(*length);
        let each = [
            Some((0, by_stability)),
            bearable.0.map(|load| (SUPPORT, load)),
            strength.map(|(of, _)| (of, by_strength)),
        ];
        let first = |one: (usize, C), other: (usize, C)| {
            if other.1.value() < one.1.value() {
                (other.0, other.1.over(one.1))
            } else {
                (one.0, one.1.over(other.1))
            }
        };
        let (governs, load) = each.into_iter().flatten().reduce(first).expect("stability");
        let allowed = behind.value() >= permission.s_lim.value() && load.value() > 0.0;
        let (governs, load) = match allowed {
            true => (governs, load),
            false => (
                FORBIDDEN,
                C::constant(0.0).over(load).over(*behind).over(permission.s_lim),
            ),
        };
        let load = if load.value().is_finite() {
            load.def(&s::Q_RAT)
        } else {
            load
        };
        let net = if load.value().is_finite() && allowed {
            (load / hook.phi_q - hook.g_h).def(&s::Q_NET)
        } else {
            load
        };
        Rated {
            by_stability,
            by_strength,
            load,
            net,
            governs,
        }
    }
}
