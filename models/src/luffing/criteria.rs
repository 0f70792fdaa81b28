//! What a balance comes to over the working range, with exact derivatives.

use crate::balance::analysis::Analysis;
use crate::balance::residual::Residual;
use crate::balance::symbols as s;
use crate::component::extreme::Extreme;
use crate::component::stages::{absent, results};
use crate::kernel::allowed::OutOfRange;
use crate::kernel::calc::Calc;
use crate::parts::motion::Motion;

/// Results of the working range over any scalar: found with `f64`, and then computed
/// where they occur, so that their derivatives are exact too (at an extreme, and
/// at a zero of the residual, the place's own change has no effect).
#[derive(Clone, Copy, Debug)]
pub struct Criteria<C> {
    pub dm_max: C,
    pub dm_5_max: Option<C>,
    pub e_abs: C,
    pub e_plus: C,
    pub gamma_min: Option<C>,
    pub n_max: Option<C>,
    pub travel: Option<C>,
}
results! { Criteria as c => {
    DM_MAX: c.dm_max;
    DM_5_MAX: c.dm_5_max.ok_or_else(absent)?;
    E: c.e_abs;
    E_PLUS: c.e_plus;
    GAMMA_MIN: c.gamma_min.ok_or_else(absent)?;
    N_MAX: c.n_max.ok_or_else(absent)?;
    DELTA_Y_5: c.travel.ok_or_else(absent)?;
} }

impl<C: Calc> Criteria<C> {
    /// # Errors
    /// As [`crate::luffing::balancing::Balancing::at`].
    pub fn new(
        found: &Analysis,
        motion: &Motion,
        at: &dyn Fn(C) -> Result<Residual<C>, OutOfRange>,
    ) -> Result<Criteria<C>, OutOfRange> {
        let at = |theta: f64| at(C::constant(theta));
        let ends = [motion.from, motion.to];
        let places = std::iter::once(ends[0])
            .chain(found.equilibria.iter().map(|e| e.at))
            .chain(std::iter::once(ends[1]));
        let mut energies = places.map(|place| at(place).map(|r| (r.phi, r.boom.u_0 + r.action.u_5)));
        let mut last = energies.next().expect("a range has a start")?;
        let nothing = C::constant(0.0) * last.1;
        let (mut e_abs, mut e_plus) = (nothing, nothing);
        for next in energies {
            let next = next?;
            let fall = last.1 - next.1;
            e_abs += fall.abs();
            // The residual raises the boom where the energy falls with a growing boom angle.
            if (fall.value() > 0.0) == (next.0.value() > last.0.value()) {
                e_plus += fall.abs();
            }
            last = next;
        }
        let of = |extreme: Option<Extreme>, pick: fn(&Residual<C>) -> Option<C>| match extreme {
            Some(extreme) if extreme.value.is_infinite() => Ok(Some(C::constant(extreme.value))),
            Some(extreme) => at(extreme.at).map(|r| pick(&r)),
            None => Ok(None),
        };
        let y_5 = |end: usize| of(found.y_5.map(|ends| ends[end]), |r| r.action.y_5);
        Ok(Criteria {
            dm_max: at(found.dm_max.at)?.dm.abs(),
            dm_5_max: of(found.dm_5_max, |r| r.dm_5.map(C::abs))?,
            e_abs,
            e_plus,
            gamma_min: of(found.gamma_min, |r| r.action.lever.map(|turn| turn.gamma))?,
            n_max: of(found.n_max, |r| r.action.n_1.map(C::abs))?,
            travel: y_5(1)?.zip(y_5(0)?).map(|(high, low)| high - low),
        })
    }
}
