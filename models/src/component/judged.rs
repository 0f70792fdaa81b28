//! Results of the whole range, and what the scene asks of them.

use crate::component::description::{Described, Description};
use crate::component::outline::{Bound, Greatest, Most};
use crate::component::peaks::Peaks;
use crate::component::running::Running;
use crate::component::sheet::{Check, Summary};
use crate::component::standing::Standing;
use crate::kernel::symbol::Symbol;

/// What a scene comes to, without its formulas.
#[derive(Default)]
pub struct Judged {
    /// Results with the position where each is greatest, or least, in the whole range.
    pub governing: Vec<Summary>,
    /// Other results of the whole range.
    pub summary: Vec<Summary>,
    pub requirements: Vec<Check>,
    /// Results of which the scene could ask something and does not.
    pub unjudged: Vec<&'static Symbol>,
}

impl Judged {
    /// What the whole range comes to.
    pub fn results(&self) -> impl Iterator<Item = &Summary> {
        self.governing.iter().chain(&self.summary)
    }
}

/// Whether a result is wanted.
pub type Sought<'a> = dyn Fn(&'static Symbol) -> bool + 'a;

/// Those results that are wanted, and all of which the scene asks something.
#[must_use]
pub fn judged<T: Described>(
    told: &Description<T>,
    model: &mut Standing,
    peaks: &mut Peaks,
    wanted: &Sought<'_>,
) -> Judged {
    let outline = T::OUTLINE;
    let asked = |symbol: &'static Symbol| {
        let mut own = outline.limits.iter().filter(|limit| limit.symbol == symbol);
        wanted(symbol) || own.any(|limit| bound(told, limit.bound, symbol).is_some())
    };
    let mut governing = peaks.governing(model, outline, &asked);
    governing.extend(T::searched(told, model));
    let symbols = outline.summary.iter().filter(|symbol| asked(symbol));
    let mut summary = symbols.filter_map(|symbol| whole(model, symbol)).collect::<Vec<_>>();
    let (requirements, unjudged) = limits(told, governing.iter().chain(&summary));
    summary.extend(T::totals(told));
    Judged {
        governing,
        summary,
        requirements,
        unjudged,
    }
}

/// What the scene allows of a result.
fn bound<T: Described>(told: &Description<T>, bound: Bound, symbol: &'static Symbol) -> Option<f64> {
    match bound {
        Bound::Scene => told.limit(symbol),
        Bound::End => Some(told.motion.to),
        Bound::Fixed(value) => Some(value),
    }
}

/// A result of the whole range, where the scene has it.
fn whole(model: &mut Standing, symbol: &'static Symbol) -> Option<Summary> {
    let index = model
        .variables()
        .iter()
        .position(|variable| variable.symbol == symbol)?;
    Some(Summary::new(symbol, model.get(index).ok()?))
}

/// Results against what the scene allows, and those of which it allows anything.
fn limits<'a, T: Described>(
    told: &Description<T>,
    results: impl Iterator<Item = &'a Summary> + Clone,
) -> (Vec<Check>, Vec<&'static Symbol>) {
    let (mut asked, mut unjudged) = (Vec::new(), Vec::new());
    for limit in T::OUTLINE.limits {
        let Some(result) = results.clone().find(|result| result.symbol == limit.symbol) else {
            continue;
        };
        match bound(told, limit.bound, limit.symbol) {
            Some(bound) => {
                let mut check = Check::of(limit.id, result, bound, limit.at_most);
                // What is greatest by amount has a sign, which a limit is none of.
                let amount = |most: &Greatest| most.symbol == limit.symbol && most.most == Most::Amount;
                if limit.at_most && T::OUTLINE.extremes.iter().any(amount) {
                    check.value = check.value.abs();
                }
                asked.push(check);
            }
            None => unjudged.push(limit.symbol),
        }
    }
    (asked, unjudged)
}
