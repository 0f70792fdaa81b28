//! The chapter of the load cases: what is given of each, what it comes to at most or at least, and what it uses of its limits.

use crate::afloat::cases::{LIMITS, NAMES};
use crate::afloat::outline::{CASES, OUTLINE};
use crate::afloat::stages::Given;
use crate::afloat::symbols as s;
use crate::component::description::Described;
use crate::component::extreme::{Extreme, greatest_value};
use crate::component::outline::{Greatest, Most};
use crate::component::peaks::Peaks;
use crate::component::probe::slots;
use crate::component::running::Running;
use crate::component::sheet::{CasesSheet, Check, JudgedCase, Sheet, Summary, Table, WorkedCase};
use crate::component::standing::Standing;
use crate::component::telling::{explained, sample};
use crate::kernel::symbol::{Symbol, listed};
use crate::kernel::text::Text;
use crate::parts::motion::Motion;

/// The hull in its load cases: names, that of `[hull]` itself first, whether a loss of load is judged by a ratio of areas, and the
/// working range of slewing.
pub struct HullCases<'a> {
    pub given: &'a Given<f64>,
    pub names: &'a [Text],
    pub ratio: bool,
    pub motion: &'a Motion,
}

/// The same of the case of `[hull]` itself, in the order of [`NAMES`], but for the last one, which is none of its results.
const OWN: [&Symbol; NAMES.len() - 1] = *listed!(s: PHI, THETA, F_LOW, F_O, PHI_O, A_RES, PHI_2, PHI_DYN, K_C, GM);

/// What of a result counts, by its place.
fn most(place: usize) -> Most {
    match LIMITS.get(place) {
        Some((_, true)) => Most::Amount,
        _ => Most::Least,
    }
}

/// Area that stops the roll over the one that the criterion asks for, where that is least of the case of `[hull]` itself.
fn own_ratio(told: &HullCases, model: &mut Standing) -> Option<Extreme> {
    let rule = told.given.rule?;
    let mut of = |at: f64| {
        let areas = sample(model, &[&s::A_I, &s::A_II], std::iter::once(at)).remove(0);
        let asked = rule.k_a * areas[0] + rule.c_a;
        (asked > 0.0).then(|| -areas[1] / asked)
    };
    greatest_value(told.motion, &mut of).map(|found| Extreme {
        value: -found.value,
        ..found
    })
}

/// A result by its place, in all cases.
fn row(told: &HullCases, model: &mut Standing, peaks: &mut Peaks, place: usize) -> Option<Vec<Summary>> {
    let (symbol, coordinate) = (NAMES[place], model.variables()[0].symbol);
    let own = match OWN.get(place) {
        Some(own) => peaks
            .most(model, &Greatest::new(own, most(place), own))
            .map(|found| found.extreme),
        None => own_ratio(told, model),
    };
    let further = slots(model, symbol).collect::<Vec<_>>();
    let further = further
        .iter()
        .map(|slot| Some(peaks.of(model, slot, most(place))?.extreme));
    let all: Vec<Extreme> = std::iter::once(own).chain(further).collect::<Option<_>>()?;
    let still = std::iter::once(None).chain(told.given.planned.further.iter().map(|case| case.psi));
    let cell = |(extreme, psi): (Extreme, Option<f64>)| {
        Summary::at(
            symbol,
            Extreme {
                at: psi.unwrap_or(extreme.at),
                ..extreme
            },
            coordinate,
        )
    };
    (all.len() > 1).then(|| all.into_iter().zip(still).map(cell).collect())
}

/// Where the scene says that a limit of a case comes from, numbered from 0.
fn criterion(sheet: &Sheet, symbol: &'static Symbol, case: usize) -> Option<Text> {
    let number = (case > 0).then_some(case as u16);
    let mut own = sheet
        .inputs
        .iter()
        .filter(|input| input.symbol == symbol && input.number == number);
    own.find_map(|input| input.given.as_ref()?.source.clone())
}

/// All that is asked of all cases, that of `[hull]` first.
fn judged(told: &HullCases, sheet: &Sheet, rows: &[Vec<Summary>]) -> Vec<JudgedCase> {
    let of = |case: usize, check: Check| JudgedCase {
        case,
        criterion: match check.symbol == &s::RHO_K || check.symbol == &s::D_A_MIN {
            true => (!told.ratio).then(|| Text::from("46 CFR 173.025".to_owned())),
            false => criterion(sheet, check.symbol, case),
        },
        check,
    };
    let own = sheet.requirements.iter().filter(|check| check.symbol != &s::U_MAX);
    let mut all: Vec<JudgedCase> = own.map(|check| of(0, *check)).collect();
    let found = |place: usize, case: usize| {
        let row = rows.iter().find(|row| row[0].symbol == NAMES[place])?;
        row.get(case).copied()
    };
    for (case, planned) in (1..).zip(&told.given.planned.further) {
        for &(place, limit) in &planned.asked {
            let (symbol, at_most) = LIMITS[place];
            let known = OUTLINE.limits.iter().find(|limit| limit.symbol == symbol);
            let Some((known, result)) = known.zip(found(place, case)) else {
                continue;
            };
            let check = Check::of(known.id, &result, limit, at_most);
            let value = if at_most { check.value.abs() } else { check.value };
            all.push(of(case, Check { symbol, value, ..check }));
        }
        let ratio = found(NAMES.len() - 1, case).map(|result| Check::of("afloat_case_lost", &result, 1.0, false));
        all.extend(ratio.map(|check| of(case, check)));
    }
    all
}

/// What is given of each case.
fn given(told: &HullCases) -> Table {
    let it = &told.given;
    let values = |own: f64, of: &mut dyn Iterator<Item = f64>| std::iter::once(own).chain(of).collect::<Vec<f64>>();
    let mut all = vec![(&s::Q_K, values(it.load.1, &mut it.loads.iter().map(|one| one.1)))];
    for (symbol, own) in [(&s::R_K, it.reach), (&s::THETA_1K, it.held)] {
        let hangs = own.map(|own| (symbol, values(own.1, &mut it.hangs.iter().map(|one| one.1))));
        all.extend(hangs.filter(|_| it.hangs.iter().all(|one| one.0 == symbol)));
    }
    if let Some(wind) = it.wind {
        all.push((&s::P_WK, values(wind.p_w, &mut it.winds.iter().map(|one| one.p_wk))));
        all.push((
            &s::CHI_WK,
            values(wind.chi_w, &mut it.winds.iter().map(|one| one.chi_wk)),
        ));
    }
    let gust = it
        .gust
        .map(|gust| (&s::P_GK, values(gust.p_g, &mut it.gusts.iter().map(|one| one.1))));
    let pull = it
        .tow
        .map(|tow| (&s::F_PK, values(tow.f_p, &mut it.pulls.iter().map(|one| one.1))));
    all.extend(gust.into_iter().chain(pull));
    Table {
        columns: all.iter().map(|(symbol, _)| *symbol).collect(),
        rows: (0..=it.loads.len())
            .map(|case| all.iter().map(|(_, values)| values[case]).collect())
            .collect(),
    }
}

/// The chapter; `None` where the scene has one case only. The case that uses most is worked out.
pub fn chapter<T: Described>(told: &HullCases, model: &mut Standing, sheet: &Sheet) -> Option<CasesSheet> {
    if told.given.loads.is_empty() {
        return None;
    }
    let mut peaks = Peaks::new(model);
    peaks.look(model, OWN.into_iter().chain(NAMES).chain([&s::U_K]));
    let rows = (0..NAMES.len()).filter_map(|place| row(told, model, &mut peaks, place));
    let mut greatest: Vec<Vec<Summary>> = rows.collect();
    let judged = judged(told, sheet, &greatest);
    let used = |case: usize| {
        let own = judged.iter().filter(|one| one.case == case).map(|one| one.check);
        let finite = own.filter(|check| check.utilisation().is_finite());
        finite.max_by(|one, other| one.utilisation().total_cmp(&other.utilisation()))
    };
    let all: Vec<Option<Check>> = (0..told.names.len()).map(used).collect();
    let part = |check: &Option<Check>| Summary {
        at: check.and_then(|check| check.at),
        ..Summary::new(&s::U_K, check.map_or(0.0, |check| check.utilisation()))
    };
    greatest.push(all.iter().map(part).collect());
    let worked = all.iter().enumerate().skip(1).filter_map(|(case, check)| {
        let (coordinate, at) = (*check)?.at?;
        Some((case, coordinate, at, (*check)?.utilisation()))
    });
    let worked = worked.max_by(|one, other| one.3.total_cmp(&other.3));
    Some(CasesSheet {
        words: "afloat_cases",
        names: told.names.to_vec(),
        given: given(told),
        worked: (worked.into_iter())
            .map(|(case, coordinate, at, _)| WorkedCase {
                id: "worked_hull",
                case,
                coordinate,
                at,
                sections: explained::<T>(model, (at, Some(case)), &[], CASES),
                terms: Vec::new(),
                taken: Vec::new(),
            })
            .collect(),
        greatest,
        judged,
        ..CasesSheet::default()
    })
}
