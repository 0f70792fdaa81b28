//! What manufacturing leaves of an optimum: the same lever built many times.
//!
//! Every dimension is spread evenly within its tolerance, independently; so are
//! the weights of boom, jib, rocker and counterweight. The boom's own lengths stay.

use crate::candidate::Positions;
use lemnis_models::balance::lever::Dimensions;
use lemnis_models::balance::symbols as s;
use lemnis_models::balance::task::Tolerances;
use lemnis_models::kernel::allowed::{NOT_NEGATIVE, OutOfRange, POSITIVE, check};
use lemnis_models::parts::four_bar::Branch;

/// Deviations of many builds, drawn once: what is compared is built alike.
#[derive(Clone, Debug)]
pub struct Builds {
    deviations: Vec<Dimensions<f64>>,
    booms: Vec<Positions>,
}

/// Residuals of many builds.
#[derive(Clone, Copy, Debug)]
pub struct Spread {
    /// Greatest amount of the residual as designed, in N·m.
    pub nominal: f64,
    /// Half of all builds stay below, in N·m.
    pub median: f64,
    /// 95 % of all builds stay below, in N·m.
    pub dm_95: f64,
    /// Part of all builds that cannot be assembled over the whole range.
    pub scrap: f64,
}

impl Builds {
    /// # Errors
    /// A tolerance that is negative or no number, weights that could vanish.
    ///
    /// # Panics
    /// Fewer than 20 builds.
    pub fn new(positions: &Positions, t: Tolerances, count: usize, seed: u64) -> Result<Builds, OutOfRange> {
        check(&s::T_L, t.length, NOT_NEGATIVE)?;
        check(&s::T_A, t.angle, NOT_NEGATIVE)?;
        check(&s::T_W, t.weight, [0.0, 0.5])?;
        assert!(count >= 20, "too few builds to say what 95 % of them keep");
        let mut random = fastrand::Rng::with_seed(seed);
        let mut within = |limit: f64| limit * (2.0 * random.f64() - 1.0);
        let mut builds = Builds {
            deviations: Vec::new(),
            booms: Vec::new(),
        };
        for _ in 0..count {
            builds.deviations.push(Dimensions {
                d_1: within(t.length),
                delta_1: within(t.angle),
                r_1: within(t.length),
                alpha_1: within(t.angle),
                l_1: within(t.length),
                lever: within(t.length),
                chi_5: within(t.angle),
                m_5: within(t.weight),
            });
            let factors = [(); 3].map(|()| 1.0 + within(t.weight));
            builds.booms.push(positions.weighted(factors));
        }
        Ok(builds)
    }

    /// Greatest residuals of all builds, sorted, in N·m; infinite where one does not close.
    fn residuals(&self, d: &Dimensions<f64>, branch: Branch) -> Vec<f64> {
        let each = self.deviations.iter().zip(&self.booms).map(|(e, boom)| {
            let built = Dimensions {
                d_1: d.d_1 + e.d_1,
                delta_1: d.delta_1 + e.delta_1,
                r_1: d.r_1 + e.r_1,
                alpha_1: d.alpha_1 + e.alpha_1,
                l_1: d.l_1 + e.l_1,
                lever: d.lever + e.lever,
                chi_5: d.chi_5 + e.chi_5,
                m_5: d.m_5 * (1.0 + e.m_5),
            };
            boom.evaluate(&built, branch).map_or(f64::INFINITY, |c| c.dm_max)
        });
        let mut all: Vec<f64> = each.collect();
        all.sort_by(f64::total_cmp);
        all
    }

    /// What 95 % of all builds stay below, in N·m; a large number where too many do not close.
    pub(crate) fn dm_95(&self, positions: &Positions, d: &Dimensions<f64>, branch: Branch) -> f64 {
        quantile(&self.residuals(d, branch), 0.95).min(positions.scale)
    }
}

impl Spread {
    /// # Errors
    /// A lever that does not close as designed, or of which 95 % cannot be built.
    pub fn new(
        builds: &Builds,
        positions: &Positions,
        d: &Dimensions<f64>,
        branch: Branch,
    ) -> Result<Spread, OutOfRange> {
        let fault = |what| OutOfRange::new(&s::L_1, d.l_1, POSITIVE, what);
        let what = "the balance linkage does not close over the whole working range";
        let nominal = positions.evaluate(d, branch).map_err(|_| fault(what))?.dm_max;
        let all = builds.residuals(d, branch);
        let scrap = all.iter().filter(|value| value.is_infinite()).count();
        let dm_95 = quantile(&all, 0.95);
        if dm_95.is_infinite() {
            return Err(fault(
                "more than 5 % of all builds do not close over the whole working range",
            ));
        }
        Ok(Spread {
            nominal,
            median: quantile(&all, 0.5),
            dm_95,
            scrap: scrap as f64 / all.len() as f64,
        })
    }
}

/// The value that a part of the sorted numbers does not exceed.
fn quantile(sorted: &[f64], part: f64) -> f64 {
    let rank = (part * sorted.len() as f64).ceil() as usize;
    sorted[rank.clamp(1, sorted.len()) - 1]
}
