//! Boom and trunk as a component: what it is given, and in which stages its equations follow from each other.

use crate::balance::analysis::Analysis;
use crate::balance::residual::Residual;
use crate::balance::scene::Form;
use crate::balance::symbols as b;
use crate::component::fragments::composed;
use crate::component::outline::joined;
use crate::component::part::{Component, Port, ports};
use crate::component::stages::Found;
use crate::component::whole::{How, Whole};
use crate::drive::crank::{Cranked, cranked};
use crate::drive::fragments::{driven, shaft, taut_rope};
use crate::drive::hauling::{Hauling, hauling};
use crate::drive::line::{self, Drive, Reaction};
use crate::drive::mount::DrivenBar;
use crate::drive::symbols::Z_PULL;
use crate::drive::way::DriveWay;
use crate::kernel::group::One;
use crate::kernel::symbol::{Symbol, listed};
use crate::kernel::variable::Fault;
use crate::luffing::balancing::{Balanced, Balancing};
use crate::luffing::criteria::Criteria;
use crate::luffing::curved_trunk::balancing::{analysed, balanced, balancing, criteria, residual};
use crate::luffing::curved_trunk::contact::Contact;
use crate::luffing::curved_trunk::driving;
use crate::luffing::curved_trunk::forces_in_motion::{self, TrunkForces, forces};
use crate::luffing::curved_trunk::leading::{beginning, hoist, leads};
use crate::luffing::curved_trunk::moving::{TrunkInertias, TrunkParts, Trunked};
use crate::luffing::curved_trunk::pins::{TrunkBearing, TrunkPins, power, pressure, slack};
use crate::luffing::curved_trunk::position::TrunkPosition;
use crate::luffing::curved_trunk::resisting::{self, TrunkPlaces};
use crate::luffing::curved_trunk::statics::{TrunkLoad, TrunkWeight, TrunkWeights};
use crate::luffing::curved_trunk::symbols as t;
use crate::luffing::curved_trunk::tail::{TailArc, Trunk, TrunkChoice, TrunkTail};
use crate::luffing::curved_trunk::velocity::{TrunkSpeeds, TrunkTravel, pole};
use crate::luffing::led::fragments::{hauled, leading, led};
use crate::luffing::led::pull::RESULTS as LED;
use crate::luffing::led::reeved::Reeved;
use crate::luffing::led::stretch::LedBars;
use crate::luffing::led::symbols as w;
use crate::luffing::moving::balance_in_motion::BalanceInMotion;
use crate::luffing::moving::built::HoistParts;
use crate::luffing::moving::control::acting;
use crate::luffing::moving::fragments::{
    boom_rates, by_oil, coordinate, exposed, geared, oil_flows, oiled, plant, pulled, regulated, remembered,
    single_boom, surrounded, told,
};
use crate::luffing::moving::given::Fitted;
use crate::luffing::moving::level::{CraneAt, Level};
use crate::luffing::moving::listed::{ALL_INDICATORS, Said, luffing_component, rates_after, said};
use crate::luffing::moving::luffs::luffs;
use crate::luffing::moving::single::{self, Acting, SingleBoom};
use crate::luffing::moving::stages::{self, CraneEvents};
use crate::luffing::resistances::fragments::{cases, chosen, resisted, sheared};
use crate::luffing::resistances::outline::WHOLE;
use crate::luffing::resistances::told::resists;
use crate::luffing::strength::fragments::{strong, strong_parts};
use crate::luffing::with_balance::with_balance;
use crate::parts::four_bar::FourBar;
use crate::parts::plane::Point;
use crate::parts::starts::way;

/// Quantities at rest and in motion, and of the drive.
mod s {
    pub use crate::balance::symbols::{F_KX, F_KY, F_MX, F_MY, N_1};
    pub use crate::drive::symbols::{F_D, L_D, Q_D, S_LM, S_LM_IN, S_LM_OUT, T_CR, V_D};
    pub use crate::luffing::curved_trunk::symbols::*;
    pub use crate::luffing::led::symbols::{F_R1X, F_R1Y, F_R2X, F_R2Y, M_R1, M_R2, S_H, V_Q};
    pub use crate::luffing::moving::symbols::{F_AIR, F_C, H_G, M_R, M_R_H, N_G, P_AIR, S_R, W_BLOW};
    pub use crate::luffing::resistances::symbols::F_R;
    pub use crate::luffing::strength::symbols::{P_C, U_K};
}

composed! {
    /// A boom with a trunk whose curved tail a tie holds.
    CurvedTrunkBoom over C from {
        ..coordinate(phi, omega),
        Parameter inertias: Option<TrunkInertias<C>>,
        ..plant(hoist_falls),
        ..by_oil(),
        ..remembered(),
        Load load: Option<One<C>>,
        Parameter trunk: Trunk<C>,
        Parameter arc: Option<TailArc<C>>,
        Parameter width: Option<One<C>>,
        Parameter weights: Option<TrunkWeights<C>>,
        ..driven(),
        Parameter balance: Option<Form<C>>,
        ..led(),
        ..cases(),
        ..strong_parts(),
        ..chosen(),
        Fixed choice: TrunkChoice,
        Fixed fitted: Fitted,
    } find {
        tail: TrunkTail<C> = TrunkTail::new(trunk, arc, choice), lifted;
        contact: Contact<C> = Contact::new(tail, choice, phi);
        position: TrunkPosition<C> = TrunkPosition::new(tail, contact);
        travel: TrunkTravel<C> = TrunkTravel::new(position);
        pole: Point<C> = pole(position, travel) => [P_X, P_Y];
        speeds: TrunkSpeeds<C> = TrunkSpeeds::new(travel, omega);
        bar: DrivenBar<C> = driving::bar(position, trunk, phi) => _;
        crank: FourBar<C> = driving::crank(rod[!], mount[!], choice) => _, lifted;
        cranked: Cranked<C> = cranked(crank, rod[!], mount[!], bar);
        drive: Drive<C> = Drive::of(bar, mount[!], rod, cranked[?]);
        stroke: C = line::speed(drive, omega) => V_D;
        flow: C = line::flow(cylinder[!], stroke) => Q_D;
        reeved: Reeved<C> = Reeved::new(rope[!], sheaves, leading) => _;
        leads: LedBars<C> = leads(position, travel, phi) => _;
        beginning: LedBars<C> = beginning(tail, choice) => _;
        ..leading(omega);
        ..hauled();
        hanging: TrunkLoad<C> = TrunkLoad::new(position, travel, pole, load[!], led[?], pulled[?]);
        own: TrunkWeight<C> = TrunkWeight::new(weights[!], phi, position, travel);
        balancing: Balancing<C> = balancing(tail, choice, weights[!], balance[!]) => _;
        residual: Residual<C> = residual(balancing, own, phi);
        balanced: Balanced<C> = balanced(residual, hanging, own, drive[?]);
        pins: TrunkPins<C> = TrunkPins::new(position, load[!], own[?], residual[?], pulled[?]);
        push: Reaction<C> = driving::push(drive, pins);
        bearing: TrunkBearing<C> = TrunkBearing::new(contact, pins, own[?], residual[?], push[?], pulled[?]);
        pressure: C = pressure(bearing, width[!]) => P_T;
        power: C = power(pins, omega) => P_D;
        ..shaft();
        analysed: Analysis = analysed(tail, choice, weights[!], balance[!]) => _, plain;
        criteria: Criteria<C> = criteria(balancing, tail, choice, weights[!], analysed);
        way: DriveWay<C> = driving::way(mount[!], rod, crank[?], trunk) => _;
        places: TrunkPlaces<C> = TrunkPlaces::new(tail, choice, weights[!], balancing[?], reeved[?], way) => _;
        ..resisted(phi, drive, position, drive, residual[?], pulled[?]);
        ..strong();
        ..sheared();
        trunked: TrunkParts<C> = TrunkParts::new(tail, weights[!], inertias[!], choice, reeved[?], mount) => _;
        hoist: HoistParts<C> = hoist(ramp, motor, give, hoist_falls, reeved[?]) => _;
        ..single_boom(Trunked, trunked);
        ..geared(way);
        ..oiled();
        ..exposed(OfTrunk);
        built[constants]: Vec<Level<C>> = single::driven(parts, boom, geared, oiled[?], exposed) => _;
        ..told(phi, omega);
        at: CraneAt<C> = acting::at(phi, omega, states[!], wound, past[!], commands, brake, second, fitted, control, regulating, regime) => _;
        ..boom_rates(phi, Trunked);
        pushing: C = stages::cylinder(built, told, at, phi) => F_C;
        ..pulled(phi);
        acting: Acting<C> = single::acting(boom, built, told, at, phi);
        countered: BalanceInMotion<C> = single::countered(acting, balance[!]);
        forces: TrunkForces<C> = forces(boom, phi, contact, position, travel, acting, drive[?]);
        pressing: C = forces_in_motion::pressure(forces, width[!]) => P_T;
        hauling: Hauling<C> = hauling(gear[!], forces);
        ..regulated(phi, omega);
        ..surrounded(phi);
        ..oil_flows();
        events: CraneEvents<C> = stages::events(built, told, at, phi, fitted);
    }
}

luffs!(CurvedTrunkBoom by phi, omega with hoist_falls, oil, oil_parts holds taut);

taut_rope!(pulls by phi);

resists!(CurvedTrunkBoom with resisting::PARTS);

said! { CurvedTrunkBoom: Said {
    bar: [&[&b::PHI, &s::OMEGA], &rates_after::<30>(Trunked::RATES)],
    still: &[t::ALL, w::ALL, b::ALL, crate::drive::symbols::ALL],
    moving: listed!(s: M_D, P_D, N_T, Q_T, P_T, F_BX, F_BY, F_O1X, F_O1Y, F_D, N_1, F_KX, F_KY, F_MX, F_MY, S_LM, S_LM_OUT, S_LM_IN,
        S_H, F_R1X, F_R1Y, M_R1, F_R2X, F_R2Y, M_R2
    ),
    drive: Some(&s::M_D),
    remarks: &[],
} }

impl Component for CurvedTrunkBoom {
    luffing_component!(position);

    const INDICATORS: &'static [&'static Symbol] = &joined::<_, 38, 2, 40>(ALL_INDICATORS, [&s::Z_TIE, &Z_PULL]);

    const WHOLE: &'static [Whole] = &joined::<_, 7, 4, 11>(
        [
            Whole::new(&w::DELTA_YQ, How::Swing, &w::Y_Q),
            Whole::new(&w::EPSILON_YQ, How::Ratio(&s::R), &w::Y_Q),
            Whole::new(&s::R_MAX, How::Greatest, &s::R),
            Whole::new(&s::R_MIN, How::Least, &s::R),
            Whole::new(&s::DELTA_Y, How::Swing, &s::A_Y),
            Whole::new(&s::EPSILON_Y, How::Ratio(&s::R), &s::A_Y),
            Whole::new(&s::MU_MIN, How::Least, &s::MU),
        ],
        WHOLE,
    );

    const PORTS: &'static [Port] = ports! { s:
        head "Head A of the trunk, where the load hangs.": x A_X, y A_Y, v_x V_AX, v_y V_AY, f Q;
        tie "Tie on the tail.": w W, f N_T;
        drive "Cylinder, rack, screw, sector, crank or rope between frame and boom.": s L_D, v V_D, f F_D, q Q_D;
    };

    /// A balance has what its kind has, and so has a drive.
    fn has(given: &Given<f64>, symbol: &'static Symbol) -> bool {
        let third = [&w::F_R3X, &w::F_R3Y, &w::M_R3];
        (symbol != &b::F_D_0 || given.mount.is_some())
            && (given.rope.is_some() || !LED.contains(&symbol))
            && !third.contains(&symbol)
            && given.balance.as_ref().is_none_or(|form| form.has(symbol))
            && line::has(given.mount.as_ref(), given.rod.is_some(), given.gear.as_ref(), symbol)
            && fittings(given).is_none_or(|crane| crane.has(symbol))
            && way::has(given.starting.as_ref(), symbol)
    }
}

/// Whether the tie pulls, and a rope that drives the boom.
fn taut(known: &mut Known<f64>) -> Found<()> {
    pulls(known)?;
    let (phi, n_t) = (known.given.phi.1, known.forces()?.n_t);
    slack(phi, n_t).map_or(Ok(()), |what| {
        let help = "this motion ends there: drive, brake, stop and hoist more gently, or let more weigh on the trunk in front of B";
        Err(Box::new(Fault::outside(format!("{what}; {help}"))))
    })
}

// The head is that of the boom, which the balance raises.
with_balance!(CurvedTrunkBoom by [&b::PHI, &s::R, &s::M_D], head position b);
