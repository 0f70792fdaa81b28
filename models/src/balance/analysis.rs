//! What is left of the moment over the working range.

use std::sync::Arc;

use std::f64::consts::TAU;

use crate::balance::boom::Boom;
use crate::balance::grid::{Sampled, zero};
use crate::balance::residual::Residual;
use crate::balance::{Balance, symbols as s};
use crate::component::extreme::Extreme;
use crate::component::sheet::Summary;
use crate::kernel::allowed::OutOfRange;
use crate::kernel::symbol::Symbol;

/// Where nothing is left.
#[derive(Clone, Copy, Debug)]
pub struct Equilibrium {
    /// Coordinate of the working range, in rad: the boom angle, unless the rocker is driven.
    pub at: f64,
    /// Boom angle, in rad.
    pub phi: f64,
    /// The boom comes back when it is moved a little.
    pub stable: bool,
}

/// Results of the working range.
#[derive(Clone, Debug)]
pub struct Analysis {
    /// Greatest amount of the residual about the boom foot, in N·m.
    pub dm_max: Extreme,
    /// Greatest amount of the residual about the lever's pivot, in N·m; infinite where
    /// the lever comes to rest within the range.
    pub dm_5_max: Option<Extreme>,
    /// ∫ |dM| dφ, in J.
    pub e_abs: f64,
    /// ∫ max(dM, 0) dφ, in J.
    pub e_plus: f64,
    pub gamma_min: Option<Extreme>,
    /// Greatest amount of the force in rod or rope, in N.
    pub n_max: Option<Extreme>,
    /// Smallest and greatest height of the counterweight, in m.
    pub y_5: Option<[Extreme; 2]>,
    pub equilibria: Arc<[Equilibrium]>,
    /// Residual at the lowest and the highest boom angle, in N·m: stable ends have it positive, then negative. [Balance004, eq. 6-7]
    pub ends: [f64; 2],
}

impl Analysis {
    /// Over the boom angles `range`, in rad.
    ///
    /// # Errors
    /// A range that is empty, or where boom or balance do not close or would
    /// have to pass a dead point, with the angles where they do not.
    pub fn new(boom: &dyn Boom<f64>, balance: &Balance<f64>, range: [f64; 2]) -> Result<Analysis, OutOfRange> {
        let [from, to] = range;
        if !(from < to && from.is_finite() && to.is_finite()) {
            return Err(OutOfRange::new(
                &s::PHI,
                to,
                [from, f64::INFINITY],
                "the working range is empty",
            ));
        }
        let middle = f64::midpoint(from, to);
        let mut arcs = vec![(
            boom.arc(middle),
            "the boom system does not close over the whole working range",
        )];
        let what = "the balance linkage does not close over the whole working range without a dead point";
        match balance {
            Balance::Lever(lever) => arcs.push((lever.arc(middle), what)),
            Balance::Parallelogram(lever) => arcs.push((lever.arc(middle), what)),
            _ => {}
        }
        for (arc, what) in arcs {
            for phi in range {
                if !(arc[0]..=arc[1]).contains(&phi) {
                    return Err(OutOfRange::new(&s::PHI, phi, arc, what));
                }
            }
        }
        Analysis::over(range, &|phi| Residual::new(boom, balance, phi))
    }

    /// Over any coordinate that turns the boom one way, `range` in rad.
    ///
    /// # Errors
    /// Those of `at`; a boom that turns back, a moment that is not finite.
    pub fn over(
        range: [f64; 2],
        at: &dyn Fn(f64) -> Result<Residual<f64>, OutOfRange>,
    ) -> Result<Analysis, OutOfRange> {
        let grid = Sampled::new(range, at)?;
        let first = grid.samples[0].phi;
        // Where it hangs straight down the boom's angle jumps by a turn.
        let turned = |pair: &[Residual<f64>]| {
            let angle = pair[1].phi - pair[0].phi;
            angle - TAU * (angle / TAU).round()
        };
        let upward = grid.samples.windows(2).map(turned).sum::<f64>() > 0.0;
        if let Some(pair) = grid.samples.windows(2).find(|pair| (turned(pair) > 0.0) != upward) {
            let allowed = if upward {
                [first, pair[0].phi]
            } else {
                [pair[0].phi, first]
            };
            let what = "the boom turns back within the working range: no moment about its foot moves it there";
            return Err(OutOfRange::new(&s::PHI, pair[1].phi, allowed, what));
        }
        let dm = |theta| at(theta).map(|r| r.dm);
        let dm_max = grid.greatest(&|r| Some(r.dm.abs()))?.expect("a residual exists");
        let ratio = |r: &Residual<f64>| r.action.lever.map_or(1.0, |turn| turn.i_5);
        let rest = grid
            .samples
            .windows(2)
            .position(|pair| ratio(&pair[0]) * ratio(&pair[1]) < 0.0);
        let dm_5_max = match rest {
            Some(i) => Some(Extreme {
                value: f64::INFINITY,
                at: zero(
                    [grid.angle(i), grid.angle(i + 1)],
                    ratio(&grid.samples[i]) > 0.0,
                    &|theta| at(theta).map(|r| ratio(&r)),
                )?,
            }),
            None => grid.greatest(&|r| r.dm_5.map(f64::abs))?,
        };
        // The integral of the residual is the fall of the potential energy, and
        // its zeros split the range.
        let forward = if upward { 1.0 } else { -1.0 };
        let energy = |r: &Residual<f64>| -forward * (r.boom.u_0 + r.action.u_5);
        let mut equilibria = Vec::new();
        let (mut e_abs, mut e_plus) = (0.0, 0.0);
        let mut last = energy(&grid.samples[0]);
        let mut gain = |here: f64, last: &mut f64| {
            let step = here - *last;
            e_abs += step.abs();
            e_plus += step.max(0.0);
            *last = here;
        };
        let scale = grid.samples.iter().map(|r| r.boom.m_0.abs()).fold(0.0, f64::max);
        for (i, pair) in grid.samples.windows(2).enumerate() {
            let (a, b) = (pair[0].dm, pair[1].dm);
            // Rounding of an exact balance is no equilibrium of its own.
            if a.abs().max(b.abs()) <= 1e-10 * scale || (a > 0.0) == (b > 0.0) {
                continue;
            }
            let theta = zero([grid.angle(i), grid.angle(i + 1)], a > 0.0, &dm)?;
            let there = at(theta)?;
            equilibria.push(Equilibrium {
                at: theta,
                phi: there.phi,
                stable: (a > 0.0) == upward,
            });
            gain(energy(&there), &mut last);
        }
        gain(energy(grid.samples.last().expect("samples")), &mut last);
        let highest = grid.greatest(&|r| r.action.y_5)?;
        let lowest = grid.greatest(&|r| r.action.y_5.map(|y| -y))?;
        let gamma = grid.greatest(&|r| r.action.lever.map(|turn| -turn.gamma))?;
        Ok(Analysis {
            dm_max,
            dm_5_max,
            e_abs,
            e_plus,
            gamma_min: gamma.map(Extreme::turned),
            n_max: grid.greatest(&|r| r.action.n_1.map(f64::abs))?,
            y_5: lowest.map(Extreme::turned).zip(highest).map(|(low, high)| [low, high]),
            equilibria: equilibria.into(),
            ends: {
                let [from, to] = [grid.samples[0].dm, grid.samples.last().expect("samples").dm];
                if upward { [from, to] } else { [to, from] }
            },
        })
    }
}

impl Analysis {
    /// Results with the place, a value of the coordinate, where each is greatest or least.
    #[must_use]
    pub fn extremes(&self, coordinate: &'static Symbol) -> Vec<Summary> {
        let all = [
            (&s::DM_MAX, &s::DM, Some(self.dm_max)),
            (&s::DM_5_MAX, &s::DM_5, self.dm_5_max),
            (&s::N_MAX, &s::N_1, self.n_max),
            (&s::GAMMA_MIN, &s::GAMMA, self.gamma_min),
        ];
        let found = all.map(|(symbol, of, extreme)| extreme.map(|found| Summary::at(symbol, found, coordinate).of(of)));
        found.into_iter().flatten().collect()
    }
}
