//! What the rows of a study say together.

use std::collections::BTreeMap;

use lemnis_models::alone::alone;
use lemnis_models::component::places::stand;
use lemnis_models::component::running::Running;
use lemnis_models::component::standing::Standing;
use lemnis_models::kernel::variable::Quantity;
use lemnis_models::registry::judged;
use lemnis_models::study::Output;

use crate::designs::deviation;
use crate::rows::{Plan, Row};

/// Rows as they come, with what is kept of each: its outputs.
#[derive(Clone, Debug)]
pub struct Gathered {
    /// Of each output every row's value, NaN where the design is refused.
    pub outputs: Vec<Vec<f64>>,
    /// Of each requirement how many rows fail it, and how many fail any.
    pub fails: Vec<usize>,
    pub failed: usize,
    /// Why designs are refused: how often, and how the first one was. Messages that differ by numbers alone are one.
    reasons: BTreeMap<String, (usize, String)>,
}

/// What an output comes to in all designs.
#[derive(Clone, Copy, Debug)]
pub struct Spread {
    pub least: f64,
    pub p5: f64,
    pub p50: f64,
    pub p95: f64,
    pub greatest: f64,
}

/// How a quantity that varies moves an output: by so much for its standard deviation.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Effect {
    /// From the exact derivative in the scene; `None` where there is none.
    pub exact: Option<f64>,
    /// From the straight line nearest to all designs; `None` where there are too few.
    pub sampled: Option<f64>,
}

impl Gathered {
    #[must_use]
    pub fn new(plan: &Plan<'_>) -> Gathered {
        Gathered {
            outputs: vec![Vec::new(); plan.study.outputs.len()],
            fails: vec![0; plan.requirements.len()],
            failed: 0,
            reasons: BTreeMap::new(),
        }
    }

    /// Takes in the next row.
    pub fn take(&mut self, row: &Row) {
        match &row.found {
            Ok(found) => {
                let all = self.outputs.iter_mut().zip(&found.outputs);
                all.for_each(|(column, value)| column.push(*value));
                let fails = self.fails.iter_mut().zip(&found.fails);
                fails.for_each(|(count, fails)| *count += usize::from(*fails));
                self.failed += usize::from(found.fails.contains(&true));
            }
            Err(reason) => {
                self.outputs.iter_mut().for_each(|column| column.push(f64::NAN));
                let first = || (0, reason.clone());
                self.reasons.entry(shape(reason)).or_insert_with(first).0 += 1;
            }
        }
    }

    /// How many rows there are.
    #[must_use]
    pub fn rows(&self) -> usize {
        self.outputs.first().map_or(0, Vec::len)
    }

    /// How many designs are refused.
    #[must_use]
    pub fn refused(&self) -> usize {
        self.reasons.values().map(|(count, _)| count).sum()
    }

    /// The most frequent reason, how often it is so, and how it was first.
    #[must_use]
    pub fn reason(&self) -> Option<(usize, &str)> {
        let most = self.reasons.values().rev().max_by_key(|(count, _)| *count);
        most.map(|(count, first)| (*count, first.as_str()))
    }

    /// An output's values in order, without the designs that are refused.
    #[must_use]
    pub fn sorted(&self, output: usize) -> Vec<f64> {
        let mut all: Vec<f64> = self.outputs[output]
            .iter()
            .copied()
            .filter(|value| !value.is_nan())
            .collect();
        all.sort_unstable_by(f64::total_cmp);
        all
    }

    /// `None` where all designs are refused.
    #[must_use]
    pub fn spread(&self, output: usize) -> Option<Spread> {
        let all = self.sorted(output);
        Some(Spread {
            least: *all.first()?,
            p5: percentile(&all, 0.05),
            p50: percentile(&all, 0.5),
            p95: percentile(&all, 0.95),
            greatest: *all.last()?,
        })
    }

    /// Of each quantity that varies how it moves each output.
    #[must_use]
    pub fn effects(&self, plan: &Plan<'_>) -> Vec<Vec<Effect>> {
        let lines = self.lines(plan);
        let each = plan.study.varied.iter().zip(lines).map(|(varied, slopes)| {
            let size = deviation(&varied.law);
            let quantity = alone(plan.scene, &varied.key).ok();
            let effects = plan.study.outputs.iter().zip(slopes).map(|(output, sampled)| Effect {
                exact: quantity.and_then(|quantity| Some(derivative(plan, output, quantity)? * size)),
                sampled: sampled.map(|slope| slope * size),
            });
            effects.collect()
        });
        each.collect()
    }

    /// Slopes of the straight lines nearest to all designs: of each output over each quantity.
    fn lines(&self, plan: &Plan<'_>) -> Vec<Vec<Option<f64>>> {
        let (inputs, outputs) = (plan.study.varied.len(), self.outputs.len());
        let finite = |row: &usize| self.outputs.iter().all(|column| column[*row].is_finite());
        let rows = || {
            (0..self.rows())
                .filter(finite)
                .map(|row| (row, plan.designs.values(row)))
        };
        let count = rows().count() as f64;
        let (mut x_mean, mut y_mean) = (vec![0.0; inputs], vec![0.0; outputs]);
        for (row, values) in rows() {
            x_mean
                .iter_mut()
                .zip(&values)
                .for_each(|(sum, value)| *sum += value / count);
            let own = self.outputs.iter().map(|column| column[row]);
            y_mean
                .iter_mut()
                .zip(own)
                .for_each(|(sum, value)| *sum += value / count);
        }
        let (mut squares, mut products) = (vec![0.0; inputs], vec![vec![0.0; outputs]; inputs]);
        for (row, values) in rows() {
            for (input, value) in values.iter().enumerate() {
                let off = value - x_mean[input];
                squares[input] += off * off;
                for (output, column) in self.outputs.iter().enumerate() {
                    products[input][output] += off * (column[row] - y_mean[output]);
                }
            }
        }
        let slopes = squares.into_iter().zip(products).map(|(square, products)| {
            let slope = |product: f64| (square > 0.0 && count > 2.0).then(|| product / square);
            products.into_iter().map(slope).collect()
        });
        slopes.collect()
    }
}

/// The value below which a part of all lies, straight between two of them.
///
/// # Panics
/// Of no values.
#[must_use]
pub fn percentile(sorted: &[f64], part: f64) -> f64 {
    let place = part * (sorted.len() - 1) as f64;
    let below = (place.floor() as usize).min(sorted.len() - 1);
    let (a, b) = (sorted[below], sorted[(below + 1).min(sorted.len() - 1)]);
    let t = place - below as f64;
    if t == 0.0 || !b.is_finite() {
        return if t == 0.0 { a } else { b };
    }
    match t < 0.5 {
        true => a + (b - a) * t,
        false => b - (b - a) * (1.0 - t),
    }
}

/// A message without its numbers.
fn shape(message: &str) -> String {
    let number = |c: char| c.is_ascii_digit() || ".+-".contains(c);
    message.split(number).filter(|part| !part.is_empty()).collect()
}

/// Exact derivative of an output by a quantity in the scene, at the held position.
fn derivative(plan: &Plan<'_>, output: &Output, by: Quantity) -> Option<f64> {
    let mut model: Standing = plan.scene.mechanism.standing();
    let (of, at, aside) = match output.at {
        Some(at) => (output.of, Some(at), None),
        None => {
            let symbol = output.of.0;
            let all = judged(&*plan.scene.mechanism, &mut model, &|known| known == symbol);
            let found = all.results().find(|result| result.symbol == symbol)?;
            let of = found.at.and(found.of).unwrap_or(symbol);
            ((of, None), found.at.map(|(_, at)| at), found.aside)
        }
    };
    let index = model
        .variables()
        .iter()
        .position(|variable| variable.quantity() == of)?;
    if let Some(at) = at {
        model.set(0, at).ok()?;
    }
    stand(&mut model, aside);
    let tangent = &mut model.tangent(&|quantity| f64::from(quantity == by));
    model
        .derivative(tangent, index)
        .ok()
        .filter(|derivative| derivative.is_finite())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn messages_that_differ_by_numbers_are_one() {
        assert_eq!(shape("at theta = 71.3 deg"), shape("at theta = -8 deg"));
        assert_ne!(shape("at 1 deg"), shape("at 1 m"));
    }

    #[test]
    fn percentiles_lie_straight_between_values() {
        let all = [1.0, 2.0, 4.0, 8.0, f64::INFINITY];
        assert_eq!(percentile(&all, 0.5), 4.0);
        assert_eq!(percentile(&all, 0.125), 1.5);
        assert_eq!(percentile(&all, 0.95), f64::INFINITY);
        assert_eq!(percentile(&all[..1], 0.95), 1.0);
    }
}
