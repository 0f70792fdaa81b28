//! The chapter of the cases, and their checks.

use crate::component::description::{Described, Description};
use crate::component::outline::Most;
use crate::component::part::Component;
use crate::component::peaks::Peaks;
use crate::component::probe::slots;
use crate::component::running::Running;
use crate::component::sheet::{CasesSheet, Summary, Table, WorkedCase};
use crate::component::stages::Found;
use crate::component::standing::Standing;
use crate::component::starting::start_curve;
use crate::component::telling::{explained, fine, lines, values};
use crate::kernel::diagnostic::Diagnostic;
use crate::kernel::group::Group;
use crate::kernel::schema::Values;
use crate::kernel::symbol::{Symbol, listed};
use crate::luffing::resistances::able::able;
use crate::luffing::resistances::friction::{OF_BALANCE, Pins};
use crate::luffing::resistances::given::{Case, CaseBody, CasePin, CasesChoice};
use crate::luffing::resistances::loads::Loads;
use crate::luffing::resistances::moments::Resisted;
use crate::luffing::resistances::outline::{COLUMNS, CURVES, MOVED, SHAFT_COLUMNS, WORKED};
use crate::luffing::resistances::placed::{BARS, MovedBars};
use crate::luffing::resistances::scene::{CaseParts, Cases};
use crate::luffing::resistances::sums::{BodySums, Sums, pointing, swept};
use crate::luffing::resistances::symbols as s;
use crate::luffing::strength::given::PinSize;
use crate::luffing::strength::outline::{COLUMNS as STRENGTH_COLUMNS, WorkedOutline};
use crate::luffing::strength::symbols as t;

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

    /// Moments in a publication's form with the exact ones, side by side.
    const BESIDE: &'static [&'static Symbol] = &[];

    /// How the former are worked out.
    const WORKED: &'static [WorkedOutline] = &[];

    /// # Errors
    /// A position that does not exist.
    fn felt(known: &mut Self::Known<f64>) -> Found<Felt>;
}

/// Implements [`Resists`] for a component with the stages of that name.
macro_rules! resists {
    ($component:ident with $parts:expr $(, beside $beside:expr, worked $worked:expr)?) => {
        impl $crate::luffing::resistances::told::Resists for $component {
            const PARTS: $crate::luffing::resistances::scene::CaseParts = $parts;
            $(
                const BESIDE: &'static [&'static $crate::kernel::symbol::Symbol] = $beside;
                const WORKED: &'static [$crate::luffing::strength::outline::WorkedOutline] = $worked;
            )?
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

/// What is found at one place after the other: what no place changes, once.
pub(super) fn felt<T: Resists>(model: &Standing) -> impl FnMut(f64) -> Found<Felt> + use<T> {
    let mut known = T::new(model.of::<T>().given().clone());
    let coordinate = model.coordinate();
    move |at| {
        T::put(&mut known, coordinate, at);
        T::felt(&mut known)
    }
}

/// Checks that the cases are possible all over the working range, and that none moves the drive through a place where it points
/// at the foot of its bar.
pub fn check<T: Resists>(model: &Standing, cases: &Cases, v: &Values, found: &mut Vec<Diagnostic>) {
    let (mut before, moves) = (None, cases.cases.iter().any(|case| case.v != 0.0 || case.a != 0.0));
    let mut felt = felt::<T>(model);
    for at in fine(model.motion()).filter(|_| cases.are_there()) {
        let fault = match felt(at) {
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
    free(model, v, found);
    able(model, cases, v, found);
}

/// Checks that the drive's bar has a free length all over the working range.
fn free(model: &Standing, v: &Values, found: &mut Vec<Diagnostic>) {
    let Some(slot) = slots(model, &t::L_K).next() else {
        return;
    };
    let mut part = model.part().duplicate();
    let length = |at: f64| {
        let mut value = 0.0;
        part.put(model.coordinate(), at);
        part.result(&slot, &mut value).ok().map(|()| (value, at))
    };
    let short = fine(model.motion())
        .filter_map(length)
        .find(|(length, _)| *length <= 0.0);
    if let Some((length, at)) = short {
        let coordinate = model.variables()[0].symbol;
        let what = format!(
            "no free length at {} = {}: l_k = {}",
            coordinate.id,
            coordinate.written(at),
            t::L_K.written(length)
        );
        let table = v.table("cases").unwrap_or(v);
        let help = "l_0 must be shorter than the drive is anywhere in the working range";
        found.push(table.refuse("buckling", what, "nothing to buckle", help));
    }
}

/// The chapter; `None` where the scene has no cases.
pub fn chapter<T: Described<Component: Resists>>(
    told: &Description<T>,
    model: &mut Standing,
    cases: &Cases,
) -> Option<CasesSheet> {
    if !cases.are_there() {
        return None;
    }
    let coordinate = model.variables()[0].symbol;
    const ALL: [&[&Symbol]; 3] = [COLUMNS, SHAFT_COLUMNS, STRENGTH_COLUMNS];
    let columns = ALL.into_iter().flatten().chain(T::Component::BESIDE);
    let mut peaks = Peaks::new(model);
    peaks.look(model, columns.copied());
    let mut greatest = |symbol: &&'static Symbol| -> Vec<Summary> {
        let each = slots(model, symbol).filter_map(|slot| peaks.of(model, &slot, Most::Amount));
        each.map(|found| Summary::at(symbol, found.extreme, coordinate))
            .collect()
    };
    let all: Vec<Vec<Summary>> = ALL.into_iter().flatten().map(&mut greatest).collect();
    let beside: Vec<Vec<Summary>> = T::Component::BESIDE.iter().map(&mut greatest).collect();
    // The case and the place where one of them is greatest.
    let most = |symbol: &'static Symbol| {
        let all = all
            .iter()
            .find(|all| all.first().is_some_and(|one| one.symbol == symbol))?;
        let (case, most) = (all.iter().enumerate().rev()).max_by(|a, b| a.1.value.abs().total_cmp(&b.1.value.abs()))?;
        (most.value != 0.0).then_some((case, most.at?.1))
    };
    let mut worked = Vec::new();
    let mut told_before = Vec::new();
    for (id, symbol, outline, takes) in WORKED.iter().chain(T::Component::WORKED).copied() {
        let Some((case, at)) = most(symbol) else { continue };
        let felt = felt::<T::Component>(model)(at).ok()?;
        let mut taken = bodies_taken(cases, &felt, case);
        let terms = if told_before.is_empty() {
            terms(&T::Component::PARTS, cases, &felt, case)
        } else {
            taken.retain(|(symbol, _)| takes.contains(symbol));
            let other = takes.iter().filter(|symbol| !MOVED.contains(symbol));
            taken.extend(other.filter_map(|symbol| Some((*symbol, result(model, symbol, case, at)?))));
            let pins = (id == "worked_pins").then(|| sizes(&T::Component::PARTS, cases, &felt.pins[case]));
            pins.into_iter().collect()
        };
        worked.push(WorkedCase {
            id,
            case,
            coordinate,
            at,
            sections: explained::<T>(model, (at, Some(case + 1)), &told_before, outline),
            terms,
            taken,
        });
        told_before.extend_from_slice(outline);
    }
    let mut curves = lines(told, model, &mut peaks, &CURVES);
    let hardest = slots(model, &s::T_0).filter_map(|slot| peaks.of(model, &slot, Most::Greatest));
    let hardest = hardest.max_by(|one, other| one.extreme.value.total_cmp(&other.extreme.value));
    let motor = cases.motor.map(|motor| motor.point());
    if let Some((hardest, rated)) = hardest.zip(motor) {
        let at = Summary::at(&s::T_0, hardest.extreme, coordinate).at;
        curves.extend(at.and_then(|(_, at)| start_curve(cases.start.as_ref(), &rated, model, at)));
    }
    let mut ranges = Vec::new();
    for (id, columns) in [
        ("case_range", COLUMNS),
        ("shaft_range", SHAFT_COLUMNS),
        ("strength_range", STRENGTH_COLUMNS),
    ] {
        let all = (0..cases.names.len()).map(|case| (id, case, range(model, case, columns)));
        ranges.extend(all.filter(|(.., table)| table.columns.len() > 1));
    }
    Some(CasesSheet {
        words: "cases",
        names: cases.names.clone(),
        given: given(cases),
        unconfirmed: (cases.unconfirmed.iter())
            .map(|it| (it.symbol, it.number, it.value, it.standard))
            .collect(),
        worked,
        greatest: all.into_iter().filter(|all| !all.is_empty()).collect(),
        beside: beside.into_iter().filter(|all| !all.is_empty()).collect(),
        ranges,
        curves,
        judged: Vec::new(),
    })
}

/// A result of a case, from 0, or of all of them, at a place.
fn result(model: &Standing, symbol: &'static Symbol, case: usize, at: f64) -> Option<f64> {
    let (slot, mut part, mut value) = (
        slots(model, symbol).nth(case).or(slots(model, symbol).next())?,
        model.part().duplicate(),
        0.0,
    );
    part.put(model.coordinate(), at);
    part.result(&slot, &mut value).ok().map(|()| value)
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

/// What the formulas take from tables and derivatives at a position, in a case.
fn bodies_taken(cases: &Cases, felt: &Felt, case: usize) -> Vec<(&'static Symbol, f64)> {
    let Some(choice) = &cases.choice else { return Vec::new() };
    let Ok(sums) = Sums::new(&felt.moved, &cases.bodies, &cases.cases, choice) else {
        return Vec::new();
    };
    let rubs = |(pin, at): (&CasePin<f64>, &usize)| {
        let on = felt.pins[case].at(*at);
        pin.mu * on.force() * on.way(pin.r)
    };
    let friction = cases.pins.iter().zip(&choice.pins).map(rubs).sum();
    let all = [
        (&s::DS_S, sums.way[0]),
        (&s::DDS_S, sums.way[1]),
        (&s::DX_H, sums.head.x),
        (&s::DY_H, sums.head.y),
        (&s::DY_L, sums.load),
        (&s::W_GX, sums.weighed.x),
        (&s::W_GY, sums.weighed.y),
        (&s::V_CA, sums.swept),
        (&s::J_R, sums.inertia[0]),
        (&s::DJ_R, sums.inertia[1]),
        (&s::DI_Z, sums.about_axis),
        (&s::D_P, sums.points),
        (&s::M_MU, friction),
    ];
    all.to_vec()
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
    let row = |(pin, at): (&CasePin<f64>, &usize)| {
        let on = carried.at(*at);
        let (force, way) = (on.force(), on.way(pin.r));
        vec![pin.mu, force, way, pin.mu * force * way]
    };
    let table = Table {
        columns: listed!(s: MU_P, F_PK, L_PK, M_MUK).to_vec(),
        rows: all.clone().map(row).collect(),
    };
    (all.map(|(_, at)| pin(parts, *at)).collect(), table)
}

/// A pin by its place.
fn pin(parts: &CaseParts, at: usize) -> &'static str {
    let all = parts.pins.iter().chain(&OF_BALANCE);
    all.copied().nth(at).unwrap_or_default()
}

/// Stresses of the pins whose sizes are given.
fn sizes(parts: &CaseParts, cases: &Cases, carried: &Pins<f64>) -> (&'static str, Vec<&'static str>, Table) {
    let all = cases.sizes.pins.iter().flatten().zip(&cases.sizes.at);
    let row = |(size, at): (&PinSize<f64>, &usize)| {
        let force = carried.at(*at).force();
        vec![force, size.d, size.b, size.pressure(force), size.shear(force)]
    };
    let table = Table {
        columns: vec![&s::F_PK, &t::D_P, &t::B_P, &t::P_BK, &t::TAU_PK],
        rows: all.clone().map(row).collect(),
    };
    ("strength_pins", all.map(|(_, at)| pin(parts, *at)).collect(), table)
}

/// Results of a case, from 0, over the working range.
fn range(model: &mut Standing, case: usize, results: &[&'static Symbol]) -> Table {
    let variables = model.variables();
    let of = |symbol: &Symbol, number| variables.iter().position(|v| v.symbol == symbol && v.number == number);
    let number = Some(case as u16 + 1);
    let index = |symbol: &'static Symbol| Some((symbol, of(symbol, number).or_else(|| of(symbol, None))?));
    let symbols = std::iter::once(variables[0].symbol).chain(results.iter().copied());
    let (columns, indices): (Vec<&'static Symbol>, Vec<usize>) = symbols.filter_map(index).unzip();
    let rows = values(model, &indices, model.motion().angles().into_iter());
    Table { columns, rows }
}
