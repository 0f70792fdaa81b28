//! The boom as a component: what it is given, and in which stages its equations follow from each other.

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
use crate::luffing::balancing::{Balanced, Balancing};
use crate::luffing::criteria::Criteria;
use crate::luffing::ellipsograph::balancing::{analysed, balanced, balancing, criteria, residual};
use crate::luffing::ellipsograph::driving;
use crate::luffing::ellipsograph::forces_in_motion::{GuidedForces, forces};
use crate::luffing::ellipsograph::moving::{Guided, GuidedInertias, GuidedParts};
use crate::luffing::ellipsograph::pins::GuidedPins;
use crate::luffing::ellipsograph::position::{Bars, GuidedChoice, GuidedPosition, axes, pole};
use crate::luffing::ellipsograph::resisting::{self, GuidedPlaces};
use crate::luffing::ellipsograph::statics::{GuidedWeights, HeadLoad, WeightMoment, needed, power};
use crate::luffing::ellipsograph::symbols as g;
use crate::luffing::ellipsograph::velocity::{GuidedSpeeds, GuidedTravel};
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
    pub use crate::luffing::ellipsograph::symbols::*;
    pub use crate::luffing::moving::symbols::{F_AIR, F_C, H_G, M_R, M_R_H, N_G, P_AIR, S_R, W_BLOW};
    pub use crate::luffing::resistances::symbols::F_R;
    pub use crate::luffing::strength::symbols::{P_C, U_K};
}

composed! {
    /// A single boom on guide and link.
    EllipsographBoom over C from {
        ..coordinate(phi, omega),
        Parameter inertias: Option<GuidedInertias<C>>,
        ..plant(hoist_falls),
        ..by_oil(),
        ..remembered(),
        Load load: Option<One<C>>,
        Parameter bars: Bars<C>,
        Parameter weights: Option<GuidedWeights<C>>,
        ..driven(),
        Parameter balance: Option<Form<C>>,
        ..cases(),
        ..strong_parts(),
        ..chosen(),
        Fixed choice: GuidedChoice,
        Fixed fitted: Fitted,
    } find {
        axes: Point<C> = axes(bars) => [E_1, E_2];
        position: GuidedPosition<C> = GuidedPosition::new(bars, axes, phi);
        pole: Point<C> = pole(position) => [P_X, P_Y];
        travel: GuidedTravel<C> = GuidedTravel::new(axes, position) => _;
        speeds: GuidedSpeeds<C> = GuidedSpeeds::new(travel, omega);
        bar: DrivenBar<C> = driving::bar(position, bars) => _;
        crank: FourBar<C> = driving::crank(rod[!], mount[!], choice) => _, lifted;
        cranked: Cranked<C> = cranked(crank, rod[!], mount[!], bar);
        drive: Drive<C> = Drive::of(bar, mount[!], rod, cranked[?]);
        stroke: C = driving::stroke(drive, speeds) => V_D;
        flow: C = line::flow(cylinder[!], stroke) => Q_D;
        hanging: HeadLoad<C> = HeadLoad::new(position, pole, travel, load[!]);
        own: WeightMoment<C> = WeightMoment::new(bars, weights[!], phi);
        balancing: Balancing<C> = balancing(bars, weights[!], balance[!], choice) => _;
        residual: Residual<C> = residual(balancing, own, position);
        balanced: Balanced<C> = balanced(residual, hanging, own, drive[?]);
        needed: C = needed(hanging, own[?], residual[?]) => M_D;
        power: C = power(needed, omega) => P_D;
        push: Reaction<C> = driving::push(drive, needed);
        pins: GuidedPins<C> = GuidedPins::new(bars, load[!], weights, phi, position, residual[?], push[?]);
        ..shaft();
        analysed: Analysis = analysed(bars, weights[!], balance[!], choice) => _, plain;
        criteria: Criteria<C> = criteria(balancing, bars, weights[!], analysed, choice);
        way: DriveWay<C> = driving::way(mount[!], rod, crank[?], bars) => _;
        places: GuidedPlaces<C> = GuidedPlaces::new(bars, weights[!], balancing[?], way) => _;
        ..resisted(phi, drive, position, drive, residual[?]);
        ..strong();
        ..sheared();
        guided: GuidedParts<C> = GuidedParts::new(bars, weights[!], inertias[!], choice, mount) => _;
        hoist: HoistParts<C> = HoistParts::new(ramp, motor, give, hoist_falls) => _;
        ..single_boom(Guided, guided);
        ..geared(way);
        ..oiled();
        ..exposed(OfGuided);
        built[constants]: Vec<Level<C>> = single::driven(parts, boom, geared, oiled[?], exposed) => _;
        ..told(phi, omega);
        at: CraneAt<C> = acting::at(phi, omega, states[!], wound, past[!], commands, brake, second, fitted, control, regulating, regime) => _;
        ..boom_rates(phi, Guided);
        pushing: C = stages::cylinder(built, told, at, phi) => F_C;
        ..pulled(phi);
        acting: Acting<C> = single::acting(boom, built, told, at, phi);
        countered: BalanceInMotion<C> = single::countered(acting, balance[!]);
        forces: GuidedForces<C> = forces(bars, boom, phi, position, acting, drive[?]);
        hauling: Hauling<C> = hauling(gear[!], forces);
        ..regulated(phi, omega);
        ..surrounded(phi);
        ..oil_flows();
        events: CraneEvents<C> = stages::events(built, told, at, phi, fitted);
    }
}

luffs!(EllipsographBoom by phi, omega with hoist_falls, oil, oil_parts holds pulls);

taut_rope!(pulls by phi);

resists!(EllipsographBoom with resisting::PARTS);

said! { EllipsographBoom: Said {
    bar: [&[&b::PHI, &s::OMEGA], &rates_after::<30>(Guided::RATES)],
    still: &[g::ALL, b::ALL, crate::drive::symbols::ALL],
    moving: listed!(s: M_D, P_D, F_BX, F_CX, F_CY, N_L, F_O1X, F_O1Y, F_D, N_1, F_KX, F_KY, F_MX, F_MY, S_LM, S_LM_OUT, S_LM_IN),
    drive: Some(&s::M_D),
    remarks: &[],
} }

impl Component for EllipsographBoom {
    luffing_component!(position);

    const INDICATORS: &'static [&'static Symbol] = &joined::<_, 38, 1, 39>(ALL_INDICATORS, [&Z_PULL]);

    const WHOLE: &'static [Whole] = &joined::<_, 5, 4, 9>(
        [
            Whole::new(&s::R_MAX, How::Greatest, &s::R),
            Whole::new(&s::R_MIN, How::Least, &s::R),
            Whole::new(&s::DELTA_Y, How::Swing, &s::A_Y),
            Whole::new(&s::EPSILON_Y, How::Ratio(&s::R), &s::A_Y),
            Whole::new(&s::DELTA_B, How::Swing, &s::B_Y),
        ],
        WHOLE,
    );

    const PORTS: &'static [Port] = ports! { s:
        head "Head A of the boom, where the load hangs.": x A_X, y A_Y, v_x V_AX, v_y V_AY, f Q;
        foot "Foot B of the boom in its guide.": y B_Y, v_y V_B, f F_BX;
        drive "Cylinder, rack, screw, sector, crank or rope between frame and link.": s L_D, v V_D, f F_D, q Q_D;
    };

    /// A balance has what its kind has, and so has a drive.
    fn has(given: &Given<f64>, symbol: &'static Symbol) -> bool {
        (symbol != &b::F_D_0 || given.mount.is_some())
            && line::has(given.mount.as_ref(), given.rod.is_some(), given.gear.as_ref(), symbol)
            && given.balance.as_ref().is_none_or(|form| form.has(symbol))
            && fittings(given).is_none_or(|crane| crane.has(symbol))
            && way::has(given.starting.as_ref(), symbol)
    }
}

// The head is that of the link, which is what the balance sees.
with_balance!(EllipsographBoom by [&s::THETA_L, &s::R, &s::M_D], head position c);
