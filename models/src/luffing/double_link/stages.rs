//! The mechanism as a component: what it is given, and in which stages its equations follow from each other.

use crate::balance::analysis::Analysis;
use crate::balance::residual::Residual;
use crate::balance::scene::Form;
use crate::balance::symbols as b;
use crate::component::fragments::composed;
use crate::component::outline::joined;
use crate::component::part::{Component, Port, ports};
use crate::component::stages::{Found, absent};
use crate::component::whole::{How, Whole};
use crate::drive::crank::{Cranked, cranked};
use crate::drive::fragments::{driven, shaft, taut_rope};
use crate::drive::hauling::{Hauling, PULLS, hauling};
use crate::drive::line::{self, Drive, Reaction};
use crate::drive::mount::{Bore, DriveMount, DrivenBar};
use crate::drive::symbols::Z_PULL;
use crate::drive::way::DriveWay;
use crate::kernel::calc::Calc;
use crate::kernel::group::One;
use crate::kernel::number::exact;
use crate::kernel::symbol::{Symbol, listed};
use crate::kernel::variable::Fault;
use crate::luffing::balancing::{Balanced, Balancing};
use crate::luffing::criteria::Criteria;
use crate::luffing::double_link::balancing::{self, analysis, balanced, residual};
use crate::luffing::double_link::driving;
use crate::luffing::double_link::feet::Feet;
use crate::luffing::double_link::forces_in_motion::RESULTS;
use crate::luffing::double_link::geometry::Geometry;
use crate::luffing::double_link::held::{Carried, Held, Passes};
use crate::luffing::double_link::leading::{beginning, leads};
use crate::luffing::double_link::linkage::HeavyLinkage;
use crate::luffing::double_link::moving::built::{CraneParts, Inertias};
use crate::luffing::double_link::moving::motion::{self, CraneForces, LinkRates, RATES};
use crate::luffing::double_link::outline;
use crate::luffing::double_link::parameters::{Choice, Driven, Jib, Lengths, Parameters, Weights};
use crate::luffing::double_link::pole::Pole;
use crate::luffing::double_link::position::Position;
use crate::luffing::double_link::published::PublishedFormulas;
use crate::luffing::double_link::resisting::{self, LinkPlaces};
use crate::luffing::double_link::statics::{LoadMoment, Own, by_pole};
use crate::luffing::double_link::symbols as g;
use crate::luffing::double_link::unbalanced::{Unbalanced, UnbalancedCase};
use crate::luffing::double_link::velocity::Velocity;
use crate::luffing::led::fragments::{hauled, leading, led};
use crate::luffing::led::pull::RESULTS as LED;
use crate::luffing::led::reeved::Reeved;
use crate::luffing::led::stretch::LedBars;
use crate::luffing::led::symbols as w;
use crate::luffing::moving::control::acting;
use crate::luffing::moving::fragments::{
    by_oil, coordinate, exposed, geared, oil_flows, oiled, plant, pulled, regulated, remembered, surrounded, told,
};
use crate::luffing::moving::given::Fitted;
use crate::luffing::moving::level::{CraneAt, Level};
use crate::luffing::moving::listed::{ALL_INDICATORS, Said, luffing_component, said};
use crate::luffing::moving::luffs::luffs;
use crate::luffing::moving::reduced::Renewed;
use crate::luffing::moving::stages::{self, CraneEvents, CraneMoves};
use crate::luffing::resistances::fragments::{cases, chosen, resisted, sheared};
use crate::luffing::resistances::outline::WHOLE;
use crate::luffing::resistances::symbols::M_R_OWN;
use crate::luffing::resistances::told::resists;
use crate::luffing::strength::fragments::{strong, strong_parts};
use crate::luffing::with_balance::with_balance;
use crate::parts::four_bar::FourBar;
use crate::parts::motion::{Motion, degrees};
use crate::parts::plane::Point;
use crate::parts::starts::way;

/// Quantities at rest and in motion.
mod s {
    pub use crate::drive::symbols::T_CR;
    pub use crate::luffing::double_link::moving::symbols::*;
    pub use crate::luffing::double_link::symbols::*;
    pub use crate::luffing::led::symbols::V_Q;
    pub use crate::luffing::resistances::symbols::F_R;
    pub use crate::luffing::strength::symbols::{P_C, U_K};
}

composed! {
    /// The double-link luffing mechanism.
    DoubleLink over C from {
        ..coordinate(theta, omega),
        Parameter inertias: Option<Inertias<C>>,
        ..plant(hoist_falls),
        ..by_oil(),
        ..remembered(),
        Load load: Option<One<C>>,
        Parameter lengths: Lengths<C>,
        Parameter jib: One<C>,
        Parameter weights: Option<Weights<C>>,
        ..driven(),
        Parameter balance: Option<Form<C>>,
        ..led(),
        ..cases(),
        ..strong_parts(),
        ..chosen(),
        Fixed choice: Choice,
        Fixed fitted: Fitted,
    } find {
        geometry: Geometry<C> = geometry(lengths, jib, choice) => _, lifted;
        position: Position<C> = position(geometry, theta);
        velocity: Velocity<C> = Velocity::new(position);
        head: Point<C> = Velocity::v_a(velocity, omega) => [V_AX, V_AY];
        pole: Pole<C> = Pole::new(geometry, position, velocity);
        bar: DrivenBar<C> = driving::bar(position, lengths, theta) => _;
        crank: FourBar<C> = driving::crank(rod[!], mount[!], lengths, choice) => _, lifted;
        cranked: Cranked<C> = cranked(crank, rod[!], mount[!], bar);
        drive: Drive<C> = Drive::of(bar, mount[!], rod, cranked[?]);
        stroke: C = line::speed(drive, omega) => V_D;
        flow: C = line::flow(cylinder[!], stroke) => Q_D;
        reeved: Reeved<C> = Reeved::new(rope[!], sheaves, leading) => _;
        leads: LedBars<C> = leads(geometry, position, velocity) => _;
        beginning: LedBars<C> = beginning(geometry, choice) => _;
        ..leading(omega);
        ..hauled();
        load_moment: LoadMoment<C> = LoadMoment::new(velocity, led[?], load[!]);
        by_pole: C = by_pole(pole, geometry, position, velocity, load[!], pulled[?]) => M_Q_P;
        own: Own<C> = Own::new(position, velocity, lengths, weights[!]);
        balancing: Balancing<C> = balancing(lengths, jib, weights, balance[!], choice) => _;
        residual: Residual<C> = balancing::at(balancing, geometry, position, velocity, weights[!], own, theta);
        balanced: Balanced<C> = balanced(residual, position, velocity, load_moment, own, drive[?]);
        passes: Passes = Passes::new(geometry, choice) => _, plain;
        carried: Carried<C> = Carried::new(velocity, load_moment, load[!], weights, own[?], residual[?]) => _;
        held: Held<C> = Held::new(position, theta, carried, own[?], residual[?], passes, pulled[?]);
        push: Reaction<C> = driving::push(drive, held);
        ..shaft();
        feet: Feet<C> = Feet::new(position, lengths, weights, residual[?], held, push[?], pulled[?]);
        analysed: Analysis = analysed(lengths, jib, weights[!], balance[!], choice) => _, plain;
        criteria: Criteria<C> = criteria(balancing, geometry, weights[!], analysed, choice);
        published: PublishedFormulas<C> = published(geometry, jib, theta) => _;
        way: DriveWay<C> = driving::way(mount[!], rod, crank[?], lengths, choice) => _;
        places: LinkPlaces<C> = LinkPlaces::new(geometry, weights[!], balancing[?], reeved[?], way) => _;
        ..resisted(theta, drive, position, drive, residual[?], pulled[?]);
        unbalanced: Unbalanced<C> = Unbalanced::new(position, velocity, weights[!], own, moved, bodies, chosen[!]);
        unbalanced_case[each cases]: Vec<UnbalancedCase<C>> = UnbalancedCase::new(unbalanced, load[!], cases[each], resisted[each]);
        ..strong();
        ..sheared();
        parameters: Parameters<C> = parameters(lengths, jib, weights, mount, cylinder, balance, choice) => _;
        parts[constants]: Vec<CraneParts<C>> = motion::parts(
            parameters, reeved[?], load[!], inertias[!], constants[!], ramp, motor, hoist_falls, give, around, ground, slewed, fitted, choice
        ) => _;
        linkage[constants]: Vec<Renewed<HeavyLinkage<C>>> = motion::linkage(parts) => _;
        ..geared(way);
        ..oiled();
        ..exposed(OfLink);
        built[constants]: Vec<Level<C>> = motion::built(parts, linkage, geared, oiled[?], exposed) => _;
        ..told(theta, omega);
        at: CraneAt<C> = acting::at(theta, omega, states[!], wound, past[!], commands, brake, second, fitted, control, regulating, regime) => _;
        moves: CraneMoves<C> = stages::moves(built, told, at, theta) => _;
        rates: LinkRates<C> = LinkRates::new(moves, fitted);
        pushing: C = stages::cylinder(built, told, at, theta) => F_C;
        ..pulled(theta);
        forces: CraneForces<C> = motion::forces(linkage, built, told, at, theta);
        hauling: Hauling<C> = hauling(gear[!], forces);
        ..regulated(theta, omega);
        ..surrounded(theta);
        ..oil_flows();
        events: CraneEvents<C> = stages::events(built, told, at, theta, fitted);
    }
}

luffs!(DoubleLink by theta, omega with hoist_falls, oil, oil_parts holds pulls);

taut_rope!(pulls by theta);

resists!(DoubleLink with resisting::PARTS, beside outline::SIDE_BY_SIDE, worked outline::UNBALANCED);

said! { DoubleLink: Said {
    bar: [&[&s::THETA_1, &s::OMEGA_1, &s::THETA_3, &s::OMEGA_3], &RATES],
    still: &[g::ALL, w::ALL, b::ALL, crate::drive::symbols::ALL],
    moving: &joined::<_, 31, 3, 34>(RESULTS, PULLS),
    drive: Some(&s::M_D),
    remarks: &[],
} }

impl Component for DoubleLink {
    luffing_component!(position);

    const WHOLE: &'static [Whole] = &joined::<_, 9, 4, 13>(
        [
            Whole::new(&s::DELTA_Y, How::Swing, &s::A_Y),
            Whole::new(&s::EPSILON_Y, How::Ratio(&s::R), &s::A_Y),
            Whole::new(&w::DELTA_YQ, How::Swing, &w::Y_Q),
            Whole::new(&w::EPSILON_YQ, How::Ratio(&s::R), &w::Y_Q),
            Whole::new(&s::R_MAX, How::Greatest, &s::R),
            Whole::new(&s::R_MIN, How::Least, &s::R),
            Whole::new(&s::MU_MIN, How::Least, &s::MU),
            Whole::new(&s::C_Q, How::Share(&s::R), &s::E_Q),
            Whole::new(&s::C_G, How::Share(&s::M_G), &M_R_OWN),
        ],
        WHOLE,
    );

    const PORTS: &'static [Port] = ports! { s:
        head "Head A of the jib, where the load hangs.": x A_X, y A_Y, v_x V_AX, v_y V_AY, f Q;
        shaft "Foot of the driving link, where a moment drives it." [phi w]:
            phi THETA_1, w OMEGA_1, phi THETA_3, w OMEGA_3, tau M_D;
        drive "Cylinder, rack, screw, sector, crank or rope between frame and driving link.": s L_D, v V_D, f F_D, q Q_D;
    };

    const INDICATORS: &'static [&'static Symbol] = &joined::<_, 38, 1, 39>(ALL_INDICATORS, [&Z_PULL]);

    fn has(given: &Given<f64>, symbol: &'static Symbol) -> bool {
        let own = match given.choice.driven {
            Driven::Boom => [&s::THETA_1, &s::I_1, &s::D_THETA_3, &s::D_OMEGA_3],
            Driven::Rocker => [&s::THETA_3, &s::I_3, &s::D_THETA_1, &s::D_OMEGA_1],
        };
        // The coordinate is no result, and a balance has what its kind has.
        let of_balance = listed!(b: N_1, F_KX, F_KY, F_MX, F_MY);
        let forces = listed!(s: F_BX, F_BY, F_CX, F_CY, F_O1X, F_O1Y, F_O3X, F_O3Y, N_3);
        !own.contains(&symbol)
            && (given.choice.pins || !forces.contains(&symbol))
            && given.balance.as_ref().is_none_or(|form| form.has(symbol))
            && fittings(given).is_none_or(|crane| crane.has(symbol))
            && way::has(given.starting.as_ref(), symbol)
            && (!of_balance.contains(&symbol) || given.balance.is_some())
            && line::has(given.mount.as_ref(), given.rod.is_some(), given.gear.as_ref(), symbol)
            && (given.rope.is_some() || !LED.contains(&symbol))
            && (symbol != &b::F_D_0 || given.mount.is_some())
            && (symbol != &s::C_G || given.balance.is_some())
    }

    /// With its change points go the branches of a linkage.
    fn undoes(given: &Given<f64>, symbol: &'static Symbol) -> bool {
        let bars = [&s::X_1, &s::X_2, &s::X_3, &s::X_5, &s::X_6];
        bars.contains(&symbol)
            && geometry(&given.lengths, &given.jib, &given.choice).is_ok_and(|g| g.linkage.keeps_branch())
    }

    /// Where the linkage closes around the working range, if that has ends.
    fn reach(known: &mut Known<f64>) -> Option<[f64; 2]> {
        let Motion { from, to, .. } = known.given.choice.range;
        let linkage = known.geometry().ok()?.linkage;
        let mut arcs = linkage.arcs().into_iter().filter(|_| !linkage.turns_fully());
        let arc = arcs.find(|arc| arc.from <= from && to <= arc.to)?;
        Some([arc.from, arc.to])
    }
}

with_balance!(DoubleLink by [&s::THETA_1, &s::R, &s::M_D], head position b);

fn parameters<C: Calc>(
    lengths: &Lengths<C>,
    jib: &One<C>,
    weights: &Option<Weights<C>>,
    mount: &Option<DriveMount<C>>,
    cylinder: &Option<Bore<C>>,
    balance: &Option<Form<C>>,
    choice: &Choice,
) -> Parameters<C> {
    Parameters {
        anchors: match mount {
            Some(DriveMount::Anchors(anchors)) => Some(*anchors),
            _ => None,
        },
        cylinder: *cylinder,
        ..undriven(lengths, jib, weights, balance, choice)
    }
}

fn undriven<C: Calc>(
    lengths: &Lengths<C>,
    jib: &One<C>,
    weights: &Option<Weights<C>>,
    balance: &Option<Form<C>>,
    choice: &Choice,
) -> Parameters<C> {
    let jib = match jib.0 {
        known if known == &s::X_7 => Jib::Sag(jib.1),
        known if known == &s::AC => Jib::Axis(jib.1),
        _ => Jib::Angle(jib.1),
    };
    Parameters {
        lengths: *lengths,
        jib,
        weights: *weights,
        anchors: None,
        cylinder: None,
        balance: *balance,
        driven: choice.driven,
        branch: choice.branch,
    }
}

fn geometry<C: Calc>(lengths: &Lengths<C>, jib: &One<C>, choice: &Choice) -> Result<Geometry<C>, Fault> {
    let parameters = undriven(lengths, jib, &None, &None, choice);
    Geometry::new(&parameters).map_err(|misfit| {
        let words = parameters.values().describe(misfit);
        Fault::outside(format!("{}: {}", words.what, words.help))
    })
}

#[inline(always)]
fn position<C: Calc>(g: &Geometry<C>, theta: &One<C>) -> Found<Position<C>> {
    match Position::new(g, theta.1) {
        Some(position) => Ok(position),
        None => Err(unreachable_angle(g, theta)),
    }
}

fn balancing<C: Calc>(
    lengths: &Lengths<C>,
    jib: &One<C>,
    weights: &Option<Weights<C>>,
    balance: &Form<C>,
    choice: &Choice,
) -> Found<Balancing<C>> {
    let parameters = undriven(lengths, jib, weights, &Some(*balance), choice);
    let found = balancing::new(&parameters, &choice.range).map_err(Fault::from)?;
    found.ok_or_else(absent)
}

fn analysed<C: Calc>(
    lengths: &Lengths<C>,
    jib: &One<C>,
    weights: &Weights<C>,
    balance: &Form<C>,
    choice: &Choice,
) -> Found<Analysis> {
    let parameters = undriven(lengths, jib, &Some(*weights), &Some(*balance), choice);
    let found = analysis(&parameters.values(), &choice.range).map_err(Fault::from)?;
    found.ok_or_else(absent)
}

fn criteria<C: Calc>(
    balancing: &Balancing<C>,
    g: &Geometry<C>,
    weights: &Weights<C>,
    found: &Analysis,
    choice: &Choice,
) -> Result<Criteria<C>, Fault> {
    let at = |theta| residual(balancing, g, weights, theta);
    Ok(Criteria::new(found, &choice.range, &at)?)
}

/// The publication has one shape of the jib, and drives the boom.
fn published<C: Calc>(g: &Geometry<C>, jib: &One<C>, theta: &C) -> Found<PublishedFormulas<C>> {
    if g.driven == Driven::Boom && jib.0 == &s::X_7 {
        Ok(PublishedFormulas::new(g, jib.1, *theta))
    } else {
        Err(absent())
    }
}

/// The angles at which the linkage closes, in words.
pub(super) fn closes<C: Calc>(g: &Geometry<C>) -> String {
    let arcs = g.linkage.arcs();
    let words: Vec<String> = arcs
        .iter()
        .map(|arc| format!("{} to {}", degrees(arc.from), degrees(arc.to)))
        .collect();
    words.join(" and for ")
}

#[cold]
fn unreachable_angle<C: Calc>(g: &Geometry<C>, theta: &One<C>) -> Box<Fault> {
    let (symbol, theta) = (theta.0, theta.1.value());
    let turn = std::f64::consts::TAU;
    // The nearest end, rounded to a side where the linkage closes.
    const DIGITS: f64 = 1e6;
    let mut nearest = (f64::INFINITY, theta);
    for arc in g.linkage.arcs() {
        for end in [arc.from, arc.to] {
            let inward = if end == arc.from { f64::ceil } else { f64::floor };
            let away = (theta - end) - turn * ((theta - end) / turn).round();
            if away.abs() < nearest.0 {
                let degrees = (theta - away).to_degrees();
                nearest = (away.abs(), inward(degrees * DIGITS) / DIGITS);
            }
        }
    }
    Box::new(Fault::outside(format!(
        "{} = {}: the linkage does not close there; it closes for {}; the nearest angle is {} deg",
        symbol.id,
        degrees(theta),
        closes(g),
        exact(nearest.1)
    )))
}
