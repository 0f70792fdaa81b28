//! The chapter of the cases, and their checks.

use crate::component::description::{Described, Description};
use crate::component::governing::most_of;
use crate::component::outline::Most;
use crate::component::part::Component;
use crate::component::probe::slots;
use crate::component::running::Running;
use crate::component::sheet::{CasesSheet, Summary, Table};
use crate::component::stages::Found;
use crate::component::standing::Standing;
use crate::component::telling::{explained, fine, lines, values};
use crate::kernel::diagnostic::Diagnostic;
use crate::kernel::group::Group;
use crate::kernel::schema::Values;
use crate::kernel::symbol::{Symbol, listed};
use crate::luffing::resistances::friction::{OF_BALANCE, Pins};
use crate::luffing::resistances::given::{Case, CaseBody, CasePin, CasesChoice};
use crate::luffing::resistances::loads::Loads;
use crate::luffing::resistances::moments::Resisted;
use crate::luffing::resistances::outline::{COLUMNS, CURVES, SECTIONS};
use crate::luffing::resistances::placed::{BARS, MovedBars};
use crate::luffing::resistances::scene::{CaseParts, Cases};
use crate::luffing::resistances::sums::{BodySums, pointing, swept};
use crate::luffing::resistances::symbols as s;

/// What is found of all cases at one position.
pub struct Felt {
    pub moved: MovedBars<f64>,
    pub loads: Vec<Loads<f64>>,
    pub resisted: Vec<Resisted<f64>>,
    pub pins: Vec<Pins<f64>>,
}

/// A mechanism whose drive overcomes what cases ask for.
pub trait Resists: Component {
    const PARTS: CaseParts;

    /// # Errors
    /// A position that does not exist.
    fn felt(known: &mut Self::Known<f64>) -> Found<Felt>;
}

/// Implements [`Resists`] for a component with the stages of that name.
macro_rules! resists {
    ($component:ident with $parts:expr) => {
        impl $crate::luffing::resistances::told::Resists for $component {
            const PARTS: $crate::luffing::resistances::scene::CaseParts = $parts;
            fn felt(known: &mut Known<f64>) -> Found<$crate::luffing::resistances::told::Felt> {
                Ok($crate::luffing::resistances::told::Felt {
                    moved: *known.moved()?,
                    loads: known.loads()?.clone(),
                    resisted: known.resisted()?.clone(),
                    pins: known.pinned()?.clone(),
                })
            }
        }
    };
}
pub(crate) use resists;

pub(super) fn felt<T: Resists>(model: &Standing, at: f64) -> Found<Felt> {
    let mut known = T::new(model.of::<T>().given().clone());
    T::put(&mut known, model.coordinate(), at);
    T::felt(&mut known)
}

/// Checks that the cases are possible all over the working range, and that none moves the drive through a place where it points
/// at the foot of its bar.
pub fn check<T: Resists>(model: &Standing, cases: &Cases, v: &Values, found: &mut Vec<Diagnostic>) {
    let (mut before, moves) = (None, cases.cases.iter().any(|case| case.v != 0.0 || case.a != 0.0));
    for at in fine(model.motion()).filter(|_| cases.are_there()) {
        let fault = match felt::<T>(model, at) {
            Ok(felt) => {
                let way = felt.moved.at[1].way;
                let turned = moves && before.replace(way).is_some_and(|before: f64| before * way <= 0.0);
                turned.then(pointing)
            }
            Err(fault) => Some(*fault),
        };
        if let Some(fault) = fault {
            let help = "move the drive's anchors, or keep the working range away from there";
            found.push(v.refuse("cases", fault.message, "not possible all over the working range", help));
            return;
        }
    }
}

/// The chapter; `None` where the scene has no cases.
pub fn chapter<T: Described<Component: Resists>>(
    told: &Description<T>,
    model: &mut Standing,
    cases: &Cases,
) -> Option<CasesSheet> {
    let coordinate = model.variables()[0].symbol;
    let greatest = |symbol: &'static Symbol| -> Vec<Summary> {
        let each = slots(model, symbol).filter_map(|slot| most_of(model, &slot, Most::Amount));
        each.map(|found| Summary::at(symbol, found, coordinate)).collect()
    };
    let greatest: Vec<Vec<Summary>> = COLUMNS.iter().map(|symbol| greatest(symbol)).collect();
    let sums = &greatest[COLUMNS.iter().position(|symbol| *symbol == &s::M_R_SUM)?];
    let most = |a: &usize, b: &usize| sums[*a].value.abs().total_cmp(&sums[*b].value.abs());
    let case = (0..sums.len()).rev().max_by(most)?;
    let at = sums[case].at?.1;
    let felt = felt::<T::Component>(model, at).ok()?;
    Some(CasesSheet {
        names: cases.names.clone(),
        given: given(cases),
        unconfirmed: (cases.unconfirmed.iter())
            .map(|it| (it.symbol, it.number, it.value, it.standard))
            .collect(),
        governing: (case, coordinate, at),
        sections: explained::<T>(model, (at, Some(case + 1)), SECTIONS),
        terms: terms(&T::Component::PARTS, cases, &felt, case),
        greatest,
        ranges: (1..)
            .zip(&cases.names)
            .map(|(number, _)| range(model, number))
            .collect(),
        curves: lines(told, model, CURVES),
    })
}

/// What is given of the cases and is not nothing in all of them.
fn given(cases: &Cases) -> Table {
    let mut rows = vec![Vec::new(); cases.cases.len()];
    let mut columns = Vec::new();
    for (place, symbol) in Case::<f64>::SYMBOLS.iter().enumerate() {
        let values: Vec<f64> = cases.cases.iter().map(|case| case.take(place)).collect();
        if values.iter().any(|value| *value != 0.0) {
            columns.push(*symbol);
            rows.iter_mut().zip(values).for_each(|(row, value)| row.push(value));
        }
    }
    Table { columns, rows }
}

/// The terms of the sums at a position: of the bodies, and of the pins in a case.
fn terms(parts: &CaseParts, cases: &Cases, felt: &Felt, case: usize) -> Vec<(&'static str, Vec<&'static str>, Table)> {
    let Some(choice) = &cases.choice else { return Vec::new() };
    let bodies = bodies(parts, (&cases.bodies, choice), &felt.moved);
    let pins = pins(parts, (&cases.pins, choice), &felt.pins[case]);
    let all = [("resistance_bodies", bodies), ("resistance_pins", pins)];
    let there = all.into_iter().filter(|(_, (names, _))| !names.is_empty());
    there.map(|(id, (names, table))| (id, names, table)).collect()
}

type Terms = (Vec<&'static str>, Table);

fn bodies(parts: &CaseParts, (given, choice): (&[CaseBody<f64>], &CasesChoice), moved: &MovedBars<f64>) -> Terms {
    let behind = (moved.of.counterweight != 0.0).then_some((BARS, "counterweight"));
    let all: Vec<(usize, &str)> = parts.bodies.iter().copied().enumerate().chain(behind).collect();
    let row = |(body, _): &(usize, &str)| {
        let it = BodySums::new(moved, *body);
        let area = swept(moved, given, choice, *body);
        let [inertia, change] = it.inertia;
        vec![
            it.mass,
            it.x,
            it.travel.x,
            it.travel.y,
            it.turn,
            inertia,
            change,
            it.about_axis,
            area,
        ]
    };
    let table = Table {
        columns: listed!(s: MASS_K, X_K, DX_K, DY_K, I_K, J_RK, DJ_RK, DI_ZK, V_CAK).to_vec(),
        rows: all.iter().map(row).collect(),
    };
    (all.into_iter().map(|(_, name)| name).collect(), table)
}

fn pins(parts: &CaseParts, (given, choice): (&[CasePin<f64>], &CasesChoice), carried: &Pins<f64>) -> Terms {
    let all = given.iter().zip(&choice.pins);
    let name = |at: usize| {
        parts
            .pins
            .iter()
            .chain(&OF_BALANCE)
            .nth(at)
            .copied()
            .unwrap_or_default()
    };
    let row = |(pin, at): (&CasePin<f64>, &usize)| {
        let on = carried.at(*at);
        let (force, way) = (on.force(), on.way(pin.r));
        vec![pin.mu, force, way, pin.mu * force * way]
    };
    let table = Table {
        columns: listed!(s: MU_P, F_PK, L_PK, M_MUK).to_vec(),
        rows: all.clone().map(row).collect(),
    };
    (all.map(|(_, at)| name(*at)).collect(), table)
}

/// The results of a case, numbered from 1, over the working range.
fn range(model: &mut Standing, number: u16) -> Table {
    let variables = model.variables();
    let of = |symbol: &Symbol, number| variables.iter().position(|v| v.symbol == symbol && v.number == number);
    let index = |symbol: &'static Symbol| Some((symbol, of(symbol, Some(number)).or_else(|| of(symbol, None))?));
    let symbols = std::iter::once(variables[0].symbol).chain(COLUMNS.iter().copied());
    let (columns, indices): (Vec<&'static Symbol>, Vec<usize>) = symbols.filter_map(index).unzip();
    let rows = values(model, &indices, model.motion().angles().into_iter());
    Table { columns, rows }
}
