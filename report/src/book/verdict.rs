//! What is judged, and what must be known before any of it is believed.

use lemnis_models::balance::symbols::DM_MAX;
use lemnis_models::component::sheet::{self, Sheet};
use lemnis_models::kernel::number::Number;
use lemnis_models::scene::Scene;
use serde::Serialize;

use crate::book::blocks::{Summary, summary};
use crate::book::synthesis::{Spread, unsearched};
use crate::book::tables::fixed;
use crate::print::number::Numbers;

#[derive(Serialize)]
pub(super) struct Verdict {
    requirements: Vec<Check>,
    /// How many of them are kept.
    kept: usize,
    /// Of the cases the one that uses most of a limit.
    governs: Option<Governs>,
    /// Symbols of results that nothing is asked of.
    unjudged: Vec<&'static str>,
    identities: Vec<Check>,
    /// How many of them do not hold.
    apart: usize,
    /// `open` or `broken` where the synthesis that the scene asks for has not come to its end.
    unsearched: Option<&'static str>,
    warnings: Vec<Warning>,
    /// What the residual moment is with the scene's tolerances.
    spread: Option<Spread>,
}

#[derive(Serialize)]
pub(super) struct Check {
    id: &'static str,
    symbol: &'static str,
    value: String,
    limit: String,
    at_most: bool,
    passed: bool,
    /// Id of the word.
    verdict: &'static str,
    /// Part of what is allowed that is used, in percent; none of a limit of zero, and none where what is asked to come
    /// late never comes.
    utilisation: Option<String>,
    /// Where or when it governs.
    at: Option<String>,
    /// How far the value is known, to both sides.
    band: Option<String>,
    /// Whether it keeps to its limit, and not all over its band.
    doubtful: bool,
    /// Names the words that say when the value is infinite, where it is.
    infinite: Option<&'static str>,
    /// Whether what builds within the tolerances come to belongs to it, and does not keep to the limit where it does.
    spread: bool,
    exceeded: bool,
}

/// Name of the case, what of it is judged, and the part of what is allowed that is used, in percent.
#[derive(Serialize)]
struct Governs {
    case: String,
    id: &'static str,
    utilisation: Option<String>,
}

/// What must be known before any result is believed.
#[derive(Serialize)]
struct Warning {
    warning: &'static str,
    manoeuvre: Option<&'static str>,
    count: usize,
    #[serde(flatten)]
    summary: Summary,
}

impl Verdict {
    pub(super) fn new(numbers: &Numbers, scene: &Scene, sheet: &Sheet, spread: Option<Spread>) -> Verdict {
        let Sheet {
            requirements,
            unjudged,
            identities,
            ..
        } = sheet;
        let count = |list: &[sheet::Check], passed: bool| list.iter().filter(|check| check.passed() == passed).count();
        let dm_95 = spread.as_ref().map(|spread| spread.dm_95);
        let shown = |list: &[sheet::Check]| list.iter().map(|found| check(numbers, found, dm_95)).collect();
        Verdict {
            kept: count(requirements, true),
            requirements: shown(requirements),
            governs: governs(numbers, sheet),
            unjudged: unjudged.iter().map(|symbol| symbol.print).collect(),
            apart: count(identities, false),
            identities: shown(identities),
            unsearched: scene.search().and_then(|search| unsearched(search.task)),
            warnings: warnings(numbers, sheet),
            spread,
        }
    }
}

fn governs(numbers: &Numbers, sheet: &Sheet) -> Option<Governs> {
    let cases = sheet.cases.as_ref()?;
    let most = cases.governs()?;
    Some(Governs {
        case: cases.names[most.case].of(numbers.language.code).to_owned(),
        id: most.check.id,
        utilisation: utilisation(&most.check).map(|part| numbers.language.text(&part)),
    })
}

/// Id of the word for whether a requirement is met.
pub(crate) fn verdict(check: &sheet::Check) -> &'static str {
    match check.passed() {
        false => "failed",
        true if check.is_doubtful() => "doubtful",
        true => "passed",
    }
}

/// A check as it is printed, beside what builds within the tolerances come to.
pub(super) fn check(numbers: &Numbers, check: &sheet::Check, dm_95: Option<f64>) -> Check {
    let spread = dm_95.filter(|_| check.symbol == &DM_MAX);
    let exceeded = check.passed() && spread.is_some_and(|spread| spread > check.limit);
    Check {
        verdict: if exceeded { "doubtful" } else { verdict(check) },
        spread: spread.is_some(),
        exceeded,
        id: check.id,
        symbol: check.symbol.print,
        value: numbers.judged(check.symbol, check.value, check.limit),
        limit: numbers.limit(check.symbol, check.limit),
        at_most: check.at_most,
        passed: check.passed(),
        utilisation: utilisation(check).map(|part| numbers.language.text(&part)),
        at: numbers.place(check.at, check.aside),
        band: check.band.map(|band| numbers.rough(check.symbol, band)),
        doubtful: check.is_doubtful(),
        infinite: (!check.value.is_finite()).then_some(check.symbol.id),
    }
}

/// In percent; of a limit that is not kept above 100, however little. `None` where the limit is zero, where the value is
/// infinitely far from it, and where both point different ways.
pub(crate) fn utilisation(check: &sheet::Check) -> Option<Number> {
    let part = 100.0 * check.utilisation();
    if check.limit == 0.0 || part < 0.0 || !check.at_most && !check.value.is_finite() {
        return None;
    }
    let beyond = |decimals: &u32| {
        let unit = f64::from(10_u32.pow(*decimals));
        check.passed() || (part * unit).round() > 100.0 * unit
    };
    Some(fixed(part, (1..6).find(beyond).unwrap_or(6) as usize))
}

fn warnings(numbers: &Numbers, sheet: &Sheet) -> Vec<Warning> {
    let warning = |warning: &sheet::Warning| Warning {
        warning: warning.id,
        manoeuvre: warning.manoeuvre,
        count: warning.count,
        summary: summary(numbers, &warning.summary),
    };
    sheet.warnings.iter().map(warning).collect()
}
