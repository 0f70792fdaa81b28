//! Two aims of a search at once: what can be had of one for the other.
//!
//! The ends are what is best for each aim by itself; between them the first aim is sought under a limit of the second, in
//! equal steps of it. [Miettinen, Nonlinear Multiobjective Optimization, 1999, 3.2, 4.2]

use lemnis_models::component::mechanism::Mechanism;
use lemnis_models::kernel::shared::Watch;
use lemnis_models::request::{Aim, RangeLimit, Request};

use crate::asked::{Answer, Nothing, calls, seek};

/// Steps of the second aim between the ends.
const STEPS: usize = 8;

/// By which part of its amount an aim that is best by itself may be worse for the other's sake; the next where nothing is
/// found with the one before.
const SLACK: [f64; 3] = [1e-8, 1e-6, 1e-4];

/// A design than which none is better in both aims.
#[derive(Clone, Debug)]
pub struct Compromise {
    /// Of each quantity that varies, in SI, and the same rounded to what a scene writes.
    pub values: Vec<f64>,
    pub written: Vec<f64>,
    /// Both aims, in SI.
    pub aims: [f64; 2],
    /// Each limited result, in the order of [`limits`](crate::asked::limits).
    pub results: Vec<f64>,
    /// Of the conditions of an optimum.
    pub residual: f64,
}

/// Designs from the best for the first aim to the best for the second.
#[derive(Clone, Debug)]
pub struct Compromises {
    pub points: Vec<Compromise>,
    /// The point nearest to the best of both, each aim as a part of what the front covers of it.
    pub chosen: usize,
    pub complete: bool,
}

/// How often [`front`] calls [`Watch::run`] at most.
#[must_use]
pub fn runs(asked: &Request) -> usize {
    calls(asked) * (STEPS + 3)
}

/// A search for one of two aims.
struct Sides<'a> {
    mechanism: &'a dyn Mechanism,
    asked: &'a Request,
    aims: [Aim; 2],
    seed: u64,
    threads: usize,
    watch: Watch<'a>,
}

impl Sides<'_> {
    /// The best for one aim, with the other within a limit.
    fn best(&self, own: usize, limit: Option<f64>, near: &[Vec<f64>]) -> Result<Answer, Nothing> {
        let other = self.aims[1 - own];
        let mut asked = self.asked.clone();
        asked.demands.extend(limit.map(|limit| RangeLimit {
            result: other.result,
            least: other.greatest.then_some(limit),
            most: (!other.greatest).then_some(limit),
            place: self.asked.place.clone(),
        }));
        seek(
            self.mechanism,
            (&asked, self.aims[own]),
            near,
            self.seed,
            self.threads,
            self.watch,
        )
    }

    fn point(&self, own: usize, mut answer: Answer) -> Compromise {
        let other = answer.results.pop().expect("the other aim has a limit");
        Compromise {
            values: answer.values,
            written: answer.written,
            aims: if own == 0 {
                [answer.value, other]
            } else {
                [other, answer.value]
            },
            results: answer.results,
            residual: answer.residual,
        }
    }

    /// The best for one aim, and of all such the best for the other.
    fn end(&self, own: usize) -> Result<(Compromise, bool), Nothing> {
        let alone = self.best(own, None, &[])?;
        let near = [alone.values];
        let found = SLACK.iter().find_map(|slack| {
            let worse = alone.value + self.aims[own].sign() * slack * alone.value.abs();
            self.best(1 - own, Some(worse), &near).ok()
        });
        let both = found.ok_or(Nothing::Impossible)?;
        let complete = alone.complete && both.complete;
        Ok((self.point(1 - own, both), complete))
    }
}

/// The front of a request for two aims, or what there is of it where it was broken off.
///
/// # Errors
/// Limits that no values within the bounds keep.
pub fn front(
    mechanism: &dyn Mechanism,
    (asked, aims): (&Request, [Aim; 2]),
    seed: u64,
    threads: usize,
    watch: Watch<'_>,
) -> Result<Compromises, Nothing> {
    let sides = Sides {
        mechanism,
        asked,
        aims,
        seed,
        threads,
        watch,
    };
    let ((first, whole), (last, too)) = (sides.end(0)?, sides.end(1)?);
    let [from, to] = [&first, &last].map(|end| end.aims[1]);
    let mut complete = whole && too;
    let mut points = vec![first];
    // Where one design is best for both, that is all.
    let apart = aims[1].sign() * (from - to) > 10.0 * SLACK[0] * from.abs().max(to.abs());
    for step in 1..STEPS {
        if !apart || !watch.goes_on() {
            break;
        }
        let limit = from + (to - from) * step as f64 / STEPS as f64;
        let near = points[points.len() - 1].values.clone();
        // Where nothing is found the front has a gap.
        if let Ok(between) = sides.best(0, Some(limit), &[near, last.values.clone()]) {
            complete &= between.complete;
            further(&mut points, sides.point(0, between));
        }
    }
    if apart {
        further(&mut points, last);
    }
    Ok(Compromises {
        chosen: nearest(&points),
        points,
        complete: complete && watch.goes_on(),
    })
}

/// A point behind the last one, if it is another: two limits may lead to the same.
fn further(points: &mut Vec<Compromise>, point: Compromise) {
    let same = |(a, b): (&f64, &f64)| (a - b).abs() <= 10.0 * SLACK[0] * a.abs().max(b.abs());
    if !points[points.len() - 1].aims.iter().zip(&point.aims).all(same) {
        points.push(point);
    }
}

/// Which point is nearest to the best of both aims.
fn nearest(points: &[Compromise]) -> usize {
    let [first, last] = [&points[0], &points[points.len() - 1]];
    let away = |point: &Compromise| {
        let part = |aim: usize, best: &Compromise, worst: &Compromise| {
            let covered = worst.aims[aim] - best.aims[aim];
            if covered == 0.0 {
                0.0
            } else {
                (point.aims[aim] - best.aims[aim]) / covered
            }
        };
        part(0, first, last).powi(2) + part(1, last, first).powi(2)
    };
    (0..points.len())
        .min_by(|&a, &b| away(&points[a]).total_cmp(&away(&points[b])))
        .unwrap_or_default()
}
