//! Load cases besides the one that `[hull]` itself describes, as a scene plans them.

use crate::afloat::cases::{CaseWind, LIMITS, PlannedCase, PlannedCases};
use crate::afloat::symbols as s;
use crate::kernel::diagnostic::Diagnostic;
use crate::kernel::group::One;
use crate::kernel::schema::{Key, Kind, Values};
use crate::kernel::symbol::Symbol;
use crate::kernel::text::Text;
use crate::luffing::kinds::CARRIED;

/// Key of the name of the case that `[hull]` itself describes, and of the further ones.
pub const OWN: &str = "load_case";
pub const CASES: &str = "load_cases";

/// Key of what is open or flooded in some cases alone, of so many at most.
pub const fn only_in(most: usize) -> Key {
    Key::new(
        "cases",
        Kind::Texts(most),
        "Names (in English) of the load cases in which it is so; without it in all.",
    )
    .optional()
}

/// What a further case takes from `[hull]` where it does not give it: its key, the table or key without which there is none, and
/// the quantity of `[hull]`.
const TAKEN: [(&Symbol, &str, &Symbol); 7] = [
    (&s::Q_K, "Q", &s::Q),
    (&s::R_K, "R", &s::R),
    (&s::THETA_1K, CARRIED.name, &s::THETA_1),
    (&s::P_WK, "wind", &s::P_W),
    (&s::CHI_WK, "wind", &s::CHI_W),
    (&s::P_GK, "gust", &s::P_G),
    (&s::F_PK, "tow", &s::F_P),
];

/// Without which each limit judges nothing, in their order.
const NEEDS: [&str; LIMITS.len()] = [
    "Q", "Q", "Q", "openings", "openings", "phi_f", "loss", "gust", "gust", "Q",
];

/// Names of all cases, that of `[hull]` first, and what each of the further ones has.
#[derive(Clone, Debug, Default)]
pub struct ReadCases {
    pub names: Vec<Text>,
    pub planned: PlannedCases,
    pub loads: Vec<One<f64>>,
    pub hangs: Vec<One<f64>>,
    pub winds: Vec<CaseWind<f64>>,
    pub gusts: Vec<One<f64>>,
    pub pulls: Vec<One<f64>>,
}

/// Names of all cases; mistakes go to `found`.
fn names(v: &Values, found: &mut Vec<Diagnostic>) -> Vec<Text> {
    let tables = v.tables(CASES);
    match (v.words(OWN), tables) {
        (Some(_), []) => {
            let help = "add [[hull.load_cases]], or remove the name";
            found.push(v.refuse(
                OWN,
                "a load case with a name beside no other",
                "there is one only",
                help,
            ));
        }
        (None, [_, ..]) => {
            let help = "add load_case = \"At work\" in [hull]";
            found.push(v.refuse(
                CASES,
                "the load case of [hull] itself has no name",
                "what is the first one?",
                help,
            ));
        }
        _ => {}
    }
    if let Some(fidelity) = v
        .text("fidelity")
        .filter(|&fidelity| fidelity != "static" && !tables.is_empty())
    {
        let what = format!("load cases of a hull at fidelity = \"{fidelity}\"");
        let help = "they stand still: describe them in a scene of fidelity = \"static\"";
        found.push(v.refuse(CASES, what, "not at this level", help));
    }
    let mut names: Vec<Text> = v.words(OWN).cloned().into_iter().collect();
    for table in tables {
        let name = table.words("name").cloned().unwrap_or_default();
        if names.iter().any(|known| known.english() == name.english()) {
            let what = format!("two load cases \"{}\"", name.english());
            found.push(table.refuse("name", what, "there is one already", "give it a name of its own"));
        }
        names.push(name);
    }
    names
}

/// Of each table of a list: in which cases it counts.
fn counts(v: &Values, list: &str, names: &[Text], found: &mut Vec<Diagnostic>) -> Vec<Vec<bool>> {
    let mut of = |table: &Values| {
        let chosen = table.texts("cases");
        for (name, place) in chosen {
            if names.iter().all(|known| known.english() != name) {
                let known: Vec<&str> = names.iter().map(Text::english).collect();
                let help = match known.as_slice() {
                    [] => "give the scene [[hull.load_cases]], or remove the list".to_owned(),
                    _ => format!("there are \"{}\"", known.join("\", \"")),
                };
                let what = format!("no load case \"{name}\"");
                found.push(Diagnostic::new(place.clone(), what, "not known").help(help));
            }
        }
        let within = |name: &Text| chosen.is_empty() || chosen.iter().any(|(chosen, _)| chosen == name.english());
        let all: Vec<bool> = names.iter().map(within).collect();
        if list == "openings" && all.first() == Some(&false) {
            let what = format!("an opening that is closed in \"{}\"", names[0].english());
            let help = "what [hull] itself describes has all openings: name that case too";
            found.push(table.refuse("cases", what, "open in no case but others", help));
        }
        all
    };
    v.tables(list).iter().map(&mut of).collect()
}

/// Refuses what a case has and the hull has not, and a case of which nothing is asked.
fn suits(v: &Values, case: &Values, found: &mut Vec<Diagnostic>) {
    let mut refuse = |symbol: &Symbol, needs: &str| {
        let what = format!("`{}` in a load case, and [hull] has no `{needs}`", symbol.id);
        let help = format!("remove it, or give [hull] `{needs}`");
        found.push(case.refuse(symbol.id, what, "not used", help));
    };
    let taken = TAKEN.iter().map(|(symbol, needs, _)| (*symbol, *needs));
    let limits = LIMITS.iter().zip(NEEDS).map(|((symbol, _), needs)| (*symbol, needs));
    for (symbol, needs) in taken.chain(limits) {
        if case.has(symbol.id) && !v.has(needs) {
            refuse(symbol, needs);
        }
    }
    if !v.has("loss") && LIMITS.iter().all(|(symbol, _)| !case.has(symbol.id)) {
        let help = "give what it must keep, such as phi_max = \"5 deg\" or f_min = \"0.5 m\"";
        found.push(case.refuse(
            "name",
            "a load case of which nothing is asked",
            "which criterion?",
            help,
        ));
    }
}

impl ReadCases {
    /// With the luffing angle at rest (rad), if there is one; mistakes go to `found`.
    pub fn read(v: &Values, held: Option<f64>, found: &mut Vec<Diagnostic>) -> ReadCases {
        let names = names(v, found);
        let [open, flooded] = ["openings", "flooded"].map(|list| counts(v, list, &names, found));
        let of = |all: &[Vec<bool>], case: usize| all.iter().map(|acts| acts.get(case) != Some(&false)).collect();
        let mut read = ReadCases {
            planned: PlannedCases {
                flooded: of(&flooded, 0),
                further: Vec::new(),
            },
            ..ReadCases::default()
        };
        for (i, case) in (1..).zip(v.tables(CASES)) {
            suits(v, case, found);
            let [q, r, theta, p, chi, gust, pull] = TAKEN.map(|(symbol, _, own)| {
                let own = if own == &s::THETA_1 { held } else { v.of(own) };
                case.number(symbol.id).or(own)
            });
            read.loads.extend(q.map(|q| One(&s::Q_K, q)));
            let hangs = match held {
                Some(_) => theta.map(|theta| One(&s::THETA_1K, theta)),
                None => r.map(|r| One(&s::R_K, r)),
            };
            read.hangs.extend(hangs);
            let wind = p.zip(chi).filter(|_| v.has("wind"));
            read.winds.extend(wind.map(|(p_wk, chi_wk)| CaseWind { p_wk, chi_wk }));
            read.gusts
                .extend(gust.filter(|_| v.has("gust")).map(|gust| One(&s::P_GK, gust)));
            read.pulls
                .extend(pull.filter(|_| v.has("tow")).map(|pull| One(&s::F_PK, pull)));
            let limits = (0..).zip(&LIMITS);
            read.planned.further.push(PlannedCase {
                psi: case.number(s::PSI_K.id),
                open: of(&open, i),
                flooded: of(&flooded, i),
                asked: limits
                    .filter_map(|(place, (limit, _))| Some((place, case.number(limit.id)?)))
                    .collect(),
            });
        }
        ReadCases { names, ..read }
    }
}
