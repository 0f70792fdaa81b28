//! The boom as a component: what it is given, and in which stages its equations follow from each other.

use crate::balance::analysis::Analysis;
use crate::balance::boom::Plain;
use crate::balance::residual::Residual;
use crate::balance::scene::Form;
use crate::balance::symbols as b;
use crate::component::fragments::composed;
use crate::component::outline::joined;
use crate::component::part::{Component, Port, ports};
use crate::component::stages::Found;
use crate::component::whole::{How, Whole};
use crate::kernel::group::One;
use crate::kernel::symbol::{Symbol, listed};
use crate::luffing::balancing::{Balanced, Balancing};
use crate::luffing::criteria::Criteria;
use crate::luffing::moving::balance_in_motion::BalanceInMotion;
use crate::luffing::moving::built::HoistParts;
use crate::luffing::moving::control::acting;
use crate::luffing::moving::fragments::{
    boom_rates, coordinate, exposed, plant, regulated, remembered, single_boom, surrounded, told,
};
use crate::luffing::moving::given::{Fitted, Slack};
use crate::luffing::moving::level::{CraneAt, Level};
use crate::luffing::moving::listed::{ALL_INDICATORS, Said, luffing_component, rates_after, said};
use crate::luffing::moving::luffs::luffs;
use crate::luffing::moving::single::{self, Acting, SingleBoom};
use crate::luffing::moving::stages::{self, CraneEvents};
use crate::luffing::resistances::fragments::{cases, chosen, resisted, sheared};
use crate::luffing::resistances::outline::WHOLE;
use crate::luffing::resistances::told::resists;
use crate::luffing::rope::balancing::{analysed, balanced, balancing, criteria, residual};
use crate::luffing::rope::forces_in_motion::{self, RopeForces};
use crate::luffing::rope::losses::Losses;
use crate::luffing::rope::moving::{BoomInertia, Roped, RopedParts, hoist};
use crate::luffing::rope::position::{BoomChoice, BoomPosition, Compensation, Falls, LoadLevel, Path, Rig, Stretch};
use crate::luffing::rope::resisting::{self, BoomPlaces};
use crate::luffing::rope::statics::{Hanging, OwnMoment, Pull, RopePulls, hauled, power};
use crate::luffing::rope::symbols as r;
use crate::luffing::rope::velocity::{RopeTravel, Speeds};
use crate::luffing::strength::given::Wire;
use crate::luffing::strength::pull::{RopeRatios, Tensed};
use crate::luffing::with_balance::with_balance;
use crate::parts::starts::way;

/// Quantities at rest and in motion.
mod s {
    pub use crate::balance::symbols::{F_KX, F_KY, F_MX, F_MY, N_1};
    pub use crate::luffing::moving::symbols::{F_AIR, H_G, M_R, M_R_H, N_G, P_AIR, S_R, W_BLOW, Z_LOW};
    pub use crate::luffing::resistances::symbols::F_R;
    pub use crate::luffing::rope::symbols::*;
}

composed! {
    /// A plain boom on a luffing rope.
    RopeBoom over C from {
        ..coordinate(phi, omega),
        Parameter inertia: Option<BoomInertia<C>>,
        ..plant(),
        ..remembered(),
        Memory slack: Option<Slack>,
        Load load: Option<One<C>>,
        Parameter rig: Rig<C>,
        Parameter compensation: Option<Compensation<C>>,
        Parameter weights: Option<Plain<C>>,
        Parameter balance: Option<Form<C>>,
        ..cases(),
        Parameter wire: Option<Wire<C>>,
        ..chosen(),
        Fixed choice: BoomChoice,
        Fixed fitted: Fitted,
    } find {
        level: LoadLevel<C> = LoadLevel::new(rig, compensation, choice);
        position: BoomPosition<C> = BoomPosition::new(rig, phi);
        falls: Falls<C> = Falls::new(rig, position, phi);
        stretch: Stretch<C> = Stretch::new(rig, compensation, position);
        path: Path<C> = Path::new(rig, level, position, stretch);
        travel: RopeTravel<C> = RopeTravel::new(rig, position, stretch) => _;
        speeds: Speeds<C> = Speeds::new(rig, travel, falls, omega);
        hanging: Hanging<C> = Hanging::new(rig, position, load[!], stretch, travel);
        own: OwnMoment<C> = OwnMoment::new(weights[!], phi);
        balancing: Balancing<C> = balancing(weights[!], balance[!], choice) => _;
        residual: Residual<C> = residual(balancing, own, phi);
        balanced: Balanced<C> = balanced(residual, hanging, own);
        carried: RopePulls<C> = RopePulls::new(position, load[!], own[?], residual[?]) => _;
        pull: Pull<C> = Pull::new(carried, hanging, position, falls, stretch);
        power: C = power(rig, pull, speeds) => P_L;
        losses: Losses<C> = Losses::new(rig, load[!], carried, falls, stretch);
        analysed: Analysis = analysed(weights[!], balance[!], choice) => _, plain;
        criteria: Criteria<C> = criteria(balancing, weights[!], analysed, choice);
        places: BoomPlaces<C> = BoomPlaces::new(rig, compensation, weights[!], balancing[?]) => _;
        ..resisted(phi, falls, rig, falls, stretch, residual[?]);
        ratios: RopeRatios<C> = RopeRatios::new(wire[!]);
        tensed[each cases]: Vec<Tensed<C>> = resisting::tensed(wire[!], rig, force[each]);
        ..sheared();
        roped: RopedParts<C> = RopedParts::new(rig, compensation, weights[!], inertia[!], choice) => _;
        hoist: HoistParts<C> = hoist(ramp, motor, give, rig) => _;
        ..single_boom(Roped, roped);
        ..exposed(OfBoom);
        built[constants]: Vec<Level<C>> = single::built(parts, boom, exposed) => _;
        ..told(phi, omega);
        still: CraneAt<C> = acting::at(phi, omega, states[!], wound, past[!], commands, brake, second, fitted, control, regulating, regime) => _;
        at: CraneAt<C> = stages::hanging(still, slack[!]) => _;
        ..boom_rates(phi, Roped);
        resisting: C = stages::resisting(built, told, at, phi) => M_R;
        driving: C = stages::driving(built, told, at, phi) => _;
        tackle: C = forces_in_motion::pull(driving, falls) => T_DYN;
        hauled: C = hauled(rig, tackle, speeds) => P_L;
        led: C = stages::pull(built, told, at, phi) => S_R;
        drum: C = stages::drum(built, told, at, phi) => M_R_H;
        acting: Acting<C> = single::acting(boom, built, told, at, phi);
        countered: BalanceInMotion<C> = single::countered(acting, balance[!]);
        forces: RopeForces<C> = RopeForces::new(
            rig, position, falls, stretch, weights[!], inertia[!], constants[!], acting, tackle
        );
        ..regulated(phi, omega);
        ..surrounded(phi);
        events: CraneEvents<C> = stages::events(built, told, at, phi, fitted);
    }
}

luffs!(RopeBoom by phi, omega on slack);

resists!(RopeBoom with resisting::PARTS);

said! { RopeBoom: Said {
    bar: [&[&b::PHI, &s::OMEGA], &rates_after::<30>(Roped::RATES)],
    still: &[r::ALL, b::ALL],
    moving: listed!(s: T_DYN, S_H, F_K, F_O1X, F_O1Y, N_B, P_L, N_1, F_KX, F_KY, F_MX, F_MY),
    drive: None,
    remarks: &[(&s::Z_LOW, "Or where the slack tackle is taut again.")],
} }

impl Component for RopeBoom {
    luffing_component!(falls);

    const INDICATORS: &'static [&'static Symbol] = &ALL_INDICATORS;

    const WHOLE: &'static [Whole] = &joined::<_, 8, 4, 12>(
        [
            Whole::new(&s::R_MAX, How::Greatest, &s::R),
            Whole::new(&s::R_MIN, How::Least, &s::R),
            Whole::new(&s::DELTA_Y, How::Swing, &s::Y_Q),
            Whole::new(&s::EPSILON_Y, How::Ratio(&s::R), &s::Y_Q),
            Whole::new(&s::DELTA_L_T, How::Swing, &s::L_T),
            Whole::new(&s::L_L_MAX, How::Swing, &s::L_L),
            Whole::new(&s::PHI_T, How::Vanishes(None), &s::M_D),
            Whole::new(&s::PHI_T0, How::Vanishes(Some((&s::Q, 0.0))), &s::M_D),
        ],
        WHOLE,
    );

    const PORTS: &'static [Port] = ports! { s:
        head "Head A of the boom, where the load hangs.": x A_X, y A_Y, v_x V_AX, v_y V_AY, f Q;
        drum "Drum of the luffing rope.": v V_L, f S_L_UP, p P_L;
    };

    /// A balance has what its kind has, the tackle's force is told otherwise, and one part of a rope has its pull.
    fn has(given: &Given<f64>, symbol: &'static Symbol) -> bool {
        let in_parts = [&s::F_K, &s::F_K_UP, &s::F_K_DOWN].contains(&symbol);
        (!in_parts || given.compensation.is_some())
            && symbol != &b::F_D_0
            && given.balance.as_ref().is_none_or(|form| form.has(symbol))
            && fittings(given).is_none_or(|crane| crane.has(symbol))
            && way::has(given.starting.as_ref(), symbol)
    }
}

with_balance!(RopeBoom by [&b::PHI, &s::R, &s::M_D], head position a);
