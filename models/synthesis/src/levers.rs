//! The end of the search for a lever counterweight: every peak over the whole working range, with exact derivatives.

use lemnis_models::balance::action::Action;
use lemnis_models::balance::boom::Boom;
use lemnis_models::balance::lever::{Dimensions, Lever};
use lemnis_models::balance::task::{Bounds, Constraints, Criterion};
use lemnis_models::kernel::calc::Calc;
use lemnis_models::parts::four_bar::Branch;
use num_dual::Dual64;

use crate::finish::{Finished, Function, HEAVY, LIGHT, Program};
use crate::peaks::{Peak, Peaked, Peaks, Shape, place, tops};

/// What is searched for, over the boom angles `range` (rad).
#[derive(Clone, Copy)]
pub struct Wanted<'a> {
    pub boom: &'a (dyn Boom<f64> + Send + Sync),
    pub range: [f64; 2],
    pub branch: Branch,
    pub criterion: Criterion,
    pub constraints: &'a Constraints,
    pub bounds: &'a Bounds,
}

/// A lever that no step makes better.
#[derive(Clone, Copy, Debug)]
pub struct Best {
    pub dimensions: Dimensions<f64>,
    /// Value of the criterion over the whole range, in SI.
    pub value: f64,
    /// Of the conditions of an optimum, with the criterion over its amount, by parts of the bounds.
    pub residual: f64,
    /// Whether it keeps all constraints.
    pub keeps: bool,
}

/// Parts of the working range between the positions that are looked at before peaks are refined.
const GRID: usize = 100;
/// As much less than allowed is asked for, so that rounding breaks no constraint.
const MARGIN: f64 = 1e-11;

/// What there is at a boom angle.
#[derive(Clone, Copy, Debug)]
enum Of {
    Residual,
    RodForce,
    Transmission,
    /// Cosine of the angle of the counterweight's arm.
    Counterweight,
}

impl Of {
    fn value<C: Calc>(self, m_0: C, action: &Action<C>) -> C {
        let turn = || action.lever.as_ref().expect("a lever turns");
        match self {
            Of::Residual => m_0 + action.m_b,
            Of::RodForce => action.n_1.expect("a lever has a rod"),
            Of::Transmission => turn().gamma,
            Of::Counterweight => turn().psi.sin_cos().1,
        }
    }
}

/// A result of the range.
#[derive(Clone, Debug)]
enum Measured {
    /// The greatest of one or two, with their signs.
    Greatest(Of, &'static [f64]),
    Least(Of),
    /// The residual at an angle.
    At(f64),
    /// Integral of the residual's amount.
    Energy,
}

/// Levers over the range.
struct Levers<'a> {
    wanted: &'a Wanted<'a>,
    results: Vec<Measured>,
    /// Boom angle and moment.
    grid: Vec<[f64; 2]>,
    plain: Option<Lever<f64>>,
    /// By the boom angle, then by each dimension that is free.
    duals: Vec<Lever<Dual64>>,
}

impl Wanted<'_> {
    fn free(&self) -> Vec<[f64; 2]> {
        let mut all = Vec::new();
        self.bounds.map(&mut |_, bounds: [f64; 2]| all.push(bounds));
        all.retain(|[low, high]| low < high);
        all
    }

    fn dimensions(&self, values: &[f64]) -> Dimensions<f64> {
        let mut free = values.iter();
        self.bounds.map(&mut |_, [low, high]| {
            if low < high {
                *free.next().expect("one per free dimension")
            } else {
                low
            }
        })
    }

    fn values(&self, d: &Dimensions<f64>) -> Vec<f64> {
        let (mut all, mut of_bounds) = (Vec::new(), Vec::new());
        d.map(&mut |_, value| all.push(value));
        self.bounds
            .map(&mut |_, [low, high]: [f64; 2]| of_bounds.push(low < high));
        let free = all.into_iter().zip(of_bounds).filter(|(_, free)| *free);
        free.map(|(value, _)| value).collect()
    }

    /// All results with what is asked of them; the criterion first. Of its amount are moments at the ends.
    fn functions(&self, amounts: [f64; 3]) -> (Vec<Measured>, Vec<Function>) {
        let (own, unit) = match self.criterion {
            Criterion::Residual => (Measured::Greatest(Of::Residual, &[1.0, -1.0]), amounts[0]),
            Criterion::Energy => (Measured::Energy, amounts[1]),
            Criterion::RodForce => (Measured::Greatest(Of::RodForce, &[1.0, -1.0]), amounts[2]),
        };
        let (mut results, mut functions) = (vec![own], Vec::new());
        functions.push(Function {
            of: 0,
            sign: 1.0,
            limit: 0.0,
            unit,
        });
        let mut demand = |result, sign: f64, limit: f64, unit: f64| {
            functions.push(Function {
                of: results.len(),
                sign,
                limit: sign * limit - MARGIN * unit,
                unit,
            });
            results.push(result);
        };
        let k = self.constraints;
        demand(Measured::Least(Of::Transmission), -1.0, k.gamma_min, 1.0);
        if let Some(least) = k.m_plus {
            demand(Measured::At(self.range[0]), -1.0, least, amounts[0]);
            demand(Measured::At(self.range[1]), 1.0, -least, amounts[0]);
        }
        if let Some(most) = k.n_max {
            demand(Measured::Greatest(Of::RodForce, &[1.0, -1.0]), 1.0, most, most);
        }
        if let Some(most) = k.dm_max {
            demand(Measured::Greatest(Of::Residual, &[1.0, -1.0]), 1.0, most, most);
        }
        if k.rearward {
            demand(Measured::Greatest(Of::Counterweight, &[1.0]), 1.0, 0.0, 1.0);
        }
        (results, functions)
    }

    /// Programs over the range, from the amounts of residual, energy and rod force at a start.
    fn with<T>(&self, amounts: [f64; 3], f: impl FnOnce(&mut Program<'_>) -> Option<T>) -> Option<T> {
        let (results, functions) = self.functions(amounts);
        let [from, to] = self.range;
        let angles = (0..=GRID).map(|i| match i {
            GRID => to,
            _ => from + (to - from) * (i as f64 / GRID as f64),
        });
        let grid = angles.map(|phi| Some([phi, self.boom.at(phi).ok()?.m_0]));
        let mut levers = Levers {
            wanted: self,
            results,
            grid: grid.collect::<Option<_>>()?,
            plain: None,
            duals: Vec::new(),
        };
        f(&mut Program {
            equations: &mut levers,
            functions: &functions,
            bounds: &self.free(),
            penalty: LIGHT,
        })
    }

    /// From a lever, with its amounts of residual, energy and rod force, to the nearest that no step makes better;
    /// `None` where the start does not close.
    #[must_use]
    pub fn finish(&self, start: &Dimensions<f64>, amounts: [f64; 3]) -> Option<Best> {
        self.with(amounts, |program| {
            let mut end = program.finish(program.parts(&self.values(start)))?;
            if !keeps(&end) {
                program.penalty = HEAVY;
                end = program.finish(end.parts)?;
            }
            Some(Best {
                dimensions: self.dimensions(&program.values(&end.parts)),
                value: end.functions[0] * program.functions[0].unit,
                residual: end.residual,
                keeps: keeps(&end),
            })
        })
    }

    /// As [`finish`](Wanted::finish), then rounded so that every constraint is kept.
    #[must_use]
    pub fn rounded(
        &self,
        start: &Dimensions<f64>,
        amounts: [f64; 3],
        rounding: &dyn Fn(&Dimensions<f64>) -> Dimensions<f64>,
    ) -> Option<Dimensions<f64>> {
        let rounded = |values: &[f64]| self.values(&rounding(&self.dimensions(values)));
        let values = self.with(amounts, |program| {
            let parts = program.parts(&self.values(start));
            Some(program.settled(parts, MARGIN, &rounded))
        });
        Some(rounding(&self.dimensions(&values?)))
    }
}

fn keeps(end: &Finished) -> bool {
    end.functions[1..].iter().all(|over| *over <= MARGIN)
}

impl Levers<'_> {
    /// Takes values of what is free; `None` where there is no such lever.
    fn set(&mut self, values: &[f64]) -> Option<()> {
        let (d, branch) = (self.wanted.dimensions(values), self.wanted.branch);
        self.plain = Some(Lever::new(d, None, branch).ok()?);
        // Of each dimension its place among those that are free, from one.
        let (mut free, mut places) = (0, Vec::new());
        self.wanted.bounds.map(&mut |_, [low, high]: [f64; 2]| {
            free += usize::from(low < high);
            places.push((low < high).then_some(free));
        });
        let seeded = |own: usize| {
            let mut all = places.iter();
            let mut is_own = || all.next().is_some_and(|place| *place == Some(own));
            let dual = d.map(&mut |_, value| Dual64::new(value, f64::from(is_own())));
            Lever::new(dual, None, branch).ok()
        };
        self.duals = (0..=values.len()).map(seeded).collect::<Option<_>>()?;
        Some(())
    }

    fn plain(&self, of: Of, [phi, m_0]: [f64; 2]) -> Option<f64> {
        let action = self.plain.as_ref()?.at(phi).ok()?;
        Some(of.value(m_0, &action))
    }

    /// The derivative by the boom angle.
    fn slope(&self, of: Of, phi: f64) -> Option<f64> {
        let [m_0, by] = self.wanted.boom.slope(phi).ok()?;
        let action = self.duals[0].at(Dual64::new(phi, 1.0)).ok()?;
        Some(of.value(Dual64::new(m_0, by), &action).eps)
    }

    /// With derivatives by what is free.
    fn slopes(&self, phi: f64, value: &dyn Fn(Dual64, &Action<Dual64>) -> Dual64) -> Option<(f64, Vec<f64>)> {
        let m_0 = Dual64::from_re(self.wanted.boom.at(phi).ok()?.m_0);
        let each = self.duals[1..].iter();
        let each = each.map(|dual| Some(value(m_0, &dual.at(Dual64::from_re(phi)).ok()?).eps));
        let own = value(m_0, &self.duals[0].at(Dual64::from_re(phi)).ok()?).re;
        Some((own, each.collect::<Option<_>>()?))
    }

    fn peak(&self, of: Of, signs: &[f64], which: usize, between: [f64; 2]) -> Option<Peak> {
        let sign = signs[which];
        let at = place(between, &mut |phi| Some(sign * self.slope(of, phi)?))?;
        let (value, slope) = self.slopes(at, &|m_0, action| of.value(m_0, action) * sign)?;
        Some(Peak {
            of: which,
            between,
            value,
            slope,
        })
    }

    fn greatest(&self, of: Of, signs: &[f64]) -> Option<Vec<Peak>> {
        let grid = self.grid.iter().map(|&at| self.plain(of, at));
        let grid = grid.collect::<Option<Vec<f64>>>()?;
        let mut all = Vec::new();
        for (which, sign) in signs.iter().enumerate() {
            let values: Vec<f64> = grid.iter().map(|value| sign * value).collect();
            for ends in tops(&values) {
                all.push(self.peak(of, signs, which, ends.map(|at| self.grid[at][0]))?);
            }
        }
        Some(all)
    }

    /// A result that has no peaks.
    fn direct(&self, (value, slope): (f64, Vec<f64>)) -> Peak {
        Peak {
            of: 0,
            between: self.wanted.range,
            value,
            slope,
        }
    }

    /// The moment's integral is the fall of the potential energy between its zeros, which move without effect.
    fn energy(&self) -> Option<(f64, Vec<f64>)> {
        let mut ends = vec![self.grid[0][0]];
        let residual = |at: [f64; 2]| self.plain(Of::Residual, at);
        for pair in self.grid.windows(2) {
            let [before, after] = [residual(pair[0])?, residual(pair[1])?];
            if (before > 0.0) != (after > 0.0) {
                let sign = if before > 0.0 { 1.0 } else { -1.0 };
                let zero = place([pair[0][0], pair[1][0]], &mut |phi| {
                    Some(sign * residual([phi, self.wanted.boom.at(phi).ok()?.m_0])?)
                });
                ends.push(zero?);
            }
        }
        ends.push(self.grid[GRID][0]);
        let energies = ends.iter().map(|&phi| {
            let (u_5, by) = self.slopes(phi, &|_, action| action.u_5)?;
            Some((u_5 + self.wanted.boom.at(phi).ok()?.u_0, by))
        });
        let energies = energies.collect::<Option<Vec<_>>>()?;
        let mut sum = (0.0, vec![0.0; self.duals.len() - 1]);
        for pair in energies.windows(2) {
            let fall = pair[0].0 - pair[1].0;
            sum.0 += fall.abs();
            for ((sum, before), after) in sum.1.iter_mut().zip(&pair[0].1).zip(&pair[1].1) {
                *sum += (before - after) * 1.0_f64.copysign(fall);
            }
        }
        Some(sum)
    }

    fn result(&self, of: &Measured, before: Option<&[Peak]>) -> Option<Vec<Peak>> {
        let (of, signs): (Of, &[f64]) = match *of {
            Measured::Greatest(of, signs) => (of, signs),
            Measured::Least(of) => (of, &[-1.0]),
            Measured::At(phi) => {
                let own = self.slopes(phi, &|m_0, action| Of::Residual.value(m_0, action));
                return Some(vec![self.direct(own?)]);
            }
            Measured::Energy => return Some(vec![self.direct(self.energy()?)]),
        };
        match before {
            None => self.greatest(of, signs),
            Some(peaks) => {
                let each = peaks.iter();
                each.map(|peak| self.peak(of, signs, peak.of, peak.between)).collect()
            }
        }
    }
}

impl Peaked for Levers<'_> {
    fn shape(&self, of: usize) -> Shape {
        match self.results[of] {
            Measured::Greatest(..) => Shape::Greatest,
            Measured::Least(_) => Shape::Least,
            Measured::At(_) | Measured::Energy => Shape::Direct,
        }
    }

    fn peaks(&mut self, values: &[f64]) -> Option<Peaks> {
        self.set(values)?;
        let each = self.results.iter().map(|of| Some(vec![self.result(of, None)?]));
        each.collect()
    }

    fn moved(&mut self, values: &[f64], before: &Peaks) -> Option<Peaks> {
        self.set(values)?;
        let each = self.results.iter().zip(before);
        each.map(|(of, before)| Some(vec![self.result(of, Some(&before[0]))?]))
            .collect()
    }
}
