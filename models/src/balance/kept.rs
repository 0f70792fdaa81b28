//! What the constraints of a synthesis ask of the scene's own lever.

use crate::balance::Balance;
use crate::balance::analysis::Analysis;
use crate::balance::lever::Lever;
use crate::balance::symbols as s;
use crate::balance::task::Search;
use crate::component::extreme::{Extreme, greatest};
use crate::component::sheet::{Check, Summary};
use crate::kernel::calc::Calc;
use crate::parts::motion::Motion;

/// The constraints, each with what the scene's own lever has; none where there is no lever that closes.
#[must_use]
pub fn kept(search: &Search) -> Vec<Check> {
    let constraints = &search.task.constraints;
    let Some(own) = &search.own else { return Vec::new() };
    let Ok(whole) = Analysis::new(&*search.boom, &Balance::Lever(*own), search.range) else {
        return Vec::new();
    };
    let at = |symbol, of, extreme: Extreme| Summary::at(symbol, extreme, &s::PHI).of(of);
    let least = constraints.gamma_min;
    let mut checks: Vec<Check> = whole
        .gamma_min
        .filter(|_| least > 0.0)
        .map(|found| {
            Check::of(
                "synthesis_transmission",
                &at(&s::GAMMA_MIN, &s::GAMMA, found),
                least,
                false,
            )
        })
        .into_iter()
        .collect();
    if let Some(least) = constraints.m_plus {
        let [low, high] = search.range;
        let (place, value) = match whole.ends {
            [first, last] if first <= -last => (low, first),
            [_, last] => (high, -last),
        };
        let found = Extreme { value, at: place };
        checks.push(Check::of(
            "synthesis_ends",
            &Summary::at(&s::M_PLUS, found, &s::PHI),
            least,
            false,
        ));
    }
    if let Some((most, found)) = constraints.n_max.zip(whole.n_max) {
        checks.push(Check::of("synthesis_rod", &at(&s::N_MAX, &s::N_1, found), most, true));
    }
    if let Some(most) = constraints.dm_max {
        checks.push(Check::of(
            "synthesis_residual",
            &at(&s::DM_MAX, &s::DM, whole.dm_max),
            most,
            true,
        ));
    }
    if let Some(found) = rearward(own, search.range).filter(|_| constraints.rearward) {
        let angle = at(&s::PSI, &s::PSI, found);
        checks.push(Check::of(
            "synthesis_rearward",
            &angle,
            std::f64::consts::FRAC_PI_2,
            false,
        ));
    }
    checks
}

/// The smallest angle between the counterweight's arm and the horizontal in front, whichever way round, in rad.
fn rearward(own: &Lever<f64>, [from, to]: [f64; 2]) -> Option<Extreme> {
    let motion = Motion {
        from,
        to,
        step: to - from,
        speed: 1.0,
        by_part: false,
        period: std::f64::consts::TAU,
    };
    let dual = own.map(Calc::constant);
    let foremost = greatest(&motion, &mut |phi| Some(dual.at(phi).ok()?.lever?.psi.sin_cos().1))?;
    Some(Extreme {
        value: Calc::acos(foremost.value.clamp(-1.0, 1.0)),
        ..foremost
    })
}
