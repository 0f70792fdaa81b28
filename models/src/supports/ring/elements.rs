//! Forces on the rolling elements in each load case, and under a moment alone.

use crate::component::stages::results;
use crate::kernel::calc::Calc;
use crate::kernel::group::{One, quantities};
use crate::kernel::number::short;
use crate::kernel::variable::Fault;
use crate::supports::ring::law::RollingElements;
use crate::supports::ring::symbols as s;
use crate::supports::upper::load::{SupportLoad, most};

quantities! {
    /// Raceway: diameter and contact angle.
    Raceway { d: D, alpha: ALPHA }
}

/// Forces on the rolling elements, in N; falls and means without dimension.
#[derive(Clone, Copy, Debug)]
pub struct RollingForces<C> {
    pub whole: C,
    kappa: C,
    lambda: C,
    means: [C; 2],
    greatest: C,
    pub far: C,
    least: C,
    pub sum: C,
    pub normal: C,
}
results! { each RollingForces as p => {
    P_MAX: p.greatest;
    P_MIN: p.least;
    N_MAX: p.normal;
    S_N: p.sum;
    V_M: p.whole;
    KAPPA: p.kappa;
    LAMBDA_A: p.lambda;
    J_S: p.means[0];
    J_N: p.means[1];
    Q_FAR: p.far;
} }

impl<C: Calc> RollingForces<C> {
    /// V_M = V + 2M/D = z J_s P_max and κ = 2M/(D V_M) = Σ P c / Σ P (1 + c). Where λ is found with plain numbers a last
    /// step of Newton's method over any scalar gives the derivatives, by the theorem of the implicit function.
    /// [Ports001, 6.3.1.1]
    fn new(raceway: &Raceway<C>, rolling: &RollingElements, load: &SupportLoad<C>) -> RollingForces<C> {
        let (one, zero) = (C::constant(1.0), C::constant(0.0));
        let couple = load.moment.scaled(2.0) / raceway.d;
        let whole = (load.vertical + couple).def(&s::V_M);
        let kappa = (couple / whole).def(&s::KAPPA);
        let [place, met, slope] = rolling.solved(kappa.value());
        let found = [(place, &s::LAMBDA_0), (met, &s::KAPPA_0), (slope, &s::D_KAPPA)];
        let [place, met, slope] = found.map(|(value, symbol)| C::constant(value).def(symbol));
        let lambda = (place + (kappa - met) / slope).def(&s::LAMBDA_A);
        let approach = |cosine: C| one - lambda * (one - cosine);
        let amount = |force: C| if rolling.held_down { force.abs() } else { force };
        let [arms, amounts] = rolling.means(approach, |cosine, force| [(one + cosine) * force, amount(force)]);
        let (arms, amounts) = (arms.def(&s::J_S), amounts.def(&s::J_N));
        let count = C::known(&s::Z, rolling.cosines.len() as f64);
        let greatest = (whole / (count * arms)).def(&s::P_MAX);
        let far = (one - lambda.scaled(1.0 - rolling.far())).def(&s::Q_FAR);
        let least = if far.value() < 0.0 && !rolling.held_down {
            zero.over(far).over(greatest)
        } else {
            (greatest * rolling.force(far)).def(&s::P_MIN)
        };
        let steep = raceway.alpha.sin();
        RollingForces {
            whole,
            kappa,
            lambda,
            means: [arms, amounts],
            greatest,
            far,
            least,
            sum: (count * greatest * amounts / steep).def(&s::S_N),
            normal: (greatest / steep).def(&s::N_MAX),
        }
    }
}

/// Forces on the rolling elements of each case.
///
/// # Errors
/// Rolling elements that bear pressure alone, under a force beyond the raceway: the crane tips off the ring.
pub fn spreads<C: Calc>(
    psi: &One<C>,
    raceway: &Raceway<C>,
    rolling: &RollingElements,
    loads: &[SupportLoad<C>],
    room: &mut Vec<RollingForces<C>>,
) -> Result<(), Fault> {
    room.clear();
    for (at, load) in loads.iter().enumerate() {
        let ratio = 2.0 * load.moment.value() / (load.vertical.value() * raceway.d.value());
        // Beside the nearest element others must bear, else nothing holds the ring.
        if !rolling.held_down && ratio > 1.0 - 1e-6 * (1.0 - rolling.cosines[1]) {
            return Err(Fault::outside(format!(
                "psi = {}: in case {} the ring would tip over its edge, its force acts at M/V = {} from the axis and the \
                 raceway ends at D/2 = {}; give rows = \"hold_down\", a greater D, or less load, reach, counterweight or wind",
                s::PSI.written(psi.value()),
                at + 1,
                s::R.written(load.moment.value() / load.vertical.value()),
                s::D.written(raceway.d.value() / 2.0),
            )));
        }
        if !ratio.is_finite() {
            let what = format!("2M/(V D) = {} in case {}: give more weight", short(ratio), at + 1);
            return Err(Fault::outside(what));
        }
        room.push(C::body(at, || RollingForces::new(raceway, rolling, load)));
    }
    Ok(())
}

/// Of all cases the greatest force on a rolling element (N), and the least approach on the far side.
#[derive(Clone, Copy, Debug)]
pub struct AllCases<C> {
    greatest: C,
    far: C,
}
results! { AllCases as a => {
    P_ALL: a.greatest;
    LIFTS: C::constant(f64::from(u8::from(a.far.value() < 0.0))).over(a.far);
    Z_LIFT: a.far;
} }

impl<C: Calc> AllCases<C> {
    /// max P_max, min q_f.
    pub fn new(spreads: &[RollingForces<C>]) -> AllCases<C> {
        let far = spreads.iter().map(|spread| spread.far);
        AllCases {
            greatest: most(spreads.iter().map(|spread| spread.greatest)).tabled(&s::P_ALL),
            far: far.reduce(C::smaller).expect("one case at least"),
        }
    }
}

/// Coefficients of a moment alone, on two rows.
#[derive(Clone, Copy, Debug)]
pub struct MomentAlone<C> {
    means: [C; 2],
    pub force: C,
    pub sum: C,
}
results! { MomentAlone as m => { C_P: m.force; C_SIGMA: m.sum; ZETA_1: m.means[0]; ZETA_2: m.means[1]; } }

impl<C: Calc> MomentAlone<C> {
    /// P_max z D/M = 2/ζ_1 and Σ|P| D/M = 2 ζ_2/ζ_1, where ζ_1 = (1/z) Σ |c|ⁿ⁺¹ and ζ_2 = (1/z) Σ |c|ⁿ.
    pub fn new(rolling: &RollingElements) -> MomentAlone<C> {
        let two = C::constant(2.0);
        // That of the first element, which sums over all of them name.
        let _ = C::constant(rolling.cosines[0]).def(&s::C_J);
        let of = |cosine: C, force: C| [cosine * force, force.abs()];
        let [turns, amounts] = rolling.means_on(true, |cosine: C| cosine, of);
        let (turns, amounts) = (turns.def(&s::ZETA_1), amounts.def(&s::ZETA_2));
        MomentAlone {
            means: [turns, amounts],
            force: (two / turns).def(&s::C_P),
            sum: (two * amounts / turns).def(&s::C_SIGMA),
        }
    }
}
