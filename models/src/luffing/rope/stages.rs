//! The boom as a component: what it is given, and in which stages its equations follow from each other.

use crate::balance::analysis::Analysis;
use crate::balance::boom::Plain;
use crate::balance::residual::Residual;
use crate::balance::scene::Form;
use crate::balance::symbols as b;
use crate::component::outline::joined;
use crate::component::part::{Component, Port, ports};
use crate::component::scalar::Scalar;
use crate::component::stages::{Found, stages};
use crate::component::whole::{How, Whole};
use crate::kernel::group::One;
use crate::kernel::symbol::{Symbol, listed};
use crate::kernel::variable::Variable;
use crate::luffing::balancing::{Balanced, Balancing};
use crate::luffing::criteria::Criteria;
use crate::luffing::moving::balance_in_motion::BalanceInMotion;
use crate::luffing::moving::built::HoistParts;
use crate::luffing::moving::control::{self, ByAxis, HeldMoments};
use crate::luffing::moving::given::{Constants, CraneStates, Fitted, Inputs, Slack};
use crate::luffing::moving::hoisting::{HoistRamp, RopeGive};
use crate::luffing::moving::hydraulic::Modes;
use crate::luffing::moving::level::{CraneAt, Level};
use crate::luffing::moving::listed::{Fittings, Said};
use crate::luffing::moving::luffs::{Luffs, luffs};
use crate::luffing::moving::reduced::Renewed;
use crate::luffing::moving::single::{self, Acting, BoomRates, Heavy, SingleBoom, SingleParts};
use crate::luffing::moving::stages::{self, CraneEvents, CraneMoves, CraneRates, INDICATORS, rates_after};
use crate::luffing::resistances::brakes::{Holding, Stopped};
use crate::luffing::resistances::friction::{Pins, Rubbed};
use crate::luffing::resistances::given::{
    Case, CaseBody, CaseBrake, CaseHold, CaseMotor, CasePin, CasesChoice, InverterStart, SecondBrake, SlipStart,
};
use crate::luffing::resistances::inverter::Ramped;
use crate::luffing::resistances::loads::Loads;
use crate::luffing::resistances::moments::Resisted;
use crate::luffing::resistances::motor::{Heating, Motored};
use crate::luffing::resistances::outline::WHOLE;
use crate::luffing::resistances::placed::{MovedBars, Weighty};
use crate::luffing::resistances::starts::Slipped;
use crate::luffing::resistances::sums::Sums;
use crate::luffing::resistances::told::resists;
use crate::luffing::rope::balancing::{analysed, balanced, balancing, criteria, residual};
use crate::luffing::rope::forces_in_motion::{self, RopeForces};
use crate::luffing::rope::losses::Losses;
use crate::luffing::rope::moving::{BoomInertia, Roped, RopedParts};
use crate::luffing::rope::position::{BoomChoice, BoomPosition, Compensation, Falls, LoadLevel, Path, Rig, Stretch};
use crate::luffing::rope::resisting::{self, BoomPlaces};
use crate::luffing::rope::statics::{Hanging, OwnMoment, Pull, RopePulls, hauled, power};
use crate::luffing::rope::symbols as r;
use crate::luffing::rope::velocity::{RopeTravel, Speeds};
use crate::luffing::strength::given::{PinSize, Wire};
use crate::luffing::strength::pins::Sheared;
use crate::luffing::strength::pull::{RopeRatios, Tensed};
use crate::luffing::with_balance::WithBalance;
use crate::parts::air::AirAround;
use crate::parts::control::{Latched, SpeedControl};
use crate::parts::ground::GroundBelow;
use crate::parts::plane::Point;

/// Quantities at rest and in motion.
mod s {
    pub use crate::balance::symbols::{F_KX, F_KY, F_MX, F_MY, N_1};
    pub use crate::luffing::moving::symbols::{F_AIR, H_G, M_R, N_G, P_AIR, S_R, W_BLOW, Z_LOW};
    pub use crate::luffing::resistances::symbols::F_R;
    pub use crate::luffing::rope::symbols::*;
}

stages! {
    /// A plain boom on a luffing rope.
    RopeBoom over C from {
        Coordinate phi: One<C>,
        Rate omega: One<C>,
        State states: Option<CraneStates<C>>,
        Input inputs: Option<Inputs<C>>,
        Parameter inertia: Option<BoomInertia<C>>,
        Parameter constants: Option<Constants<C>>,
        Parameter ramp: Option<HoistRamp<C>>,
        Parameter give: Option<RopeGive<C>>,
        Parameter around: Option<AirAround<C>>,
        Parameter ground: Option<GroundBelow<C>>,
        Parameter control: Option<ByAxis<SpeedControl<C>>>,
        Input commanded: Option<ByAxis<One<C>>>,
        Latch latched: Option<ByAxis<Latched<C>>>,
        Memory wound: Option<One<C>>,
        Memory past: Option<Modes>,
        Memory slack: Option<Slack>,
        Load load: Option<One<C>>,
        Parameter rig: Rig<C>,
        Parameter compensation: Option<Compensation<C>>,
        Parameter weights: Option<Plain<C>>,
        Parameter balance: Option<Form<C>>,
        Parameter cases: Vec<Case<C>>,
        Parameter bodies: Vec<CaseBody<C>>,
        Parameter rubbing: Vec<CasePin<C>>,
        Parameter air: Option<One<C>>,
        Parameter driver: Option<CaseMotor<C>>,
        Parameter slip: Option<SlipStart<C>>,
        Parameter inverter: Option<InverterStart<C>>,
        Parameter brake: Option<CaseBrake<C>>,
        Parameter second: Option<SecondBrake<C>>,
        Parameter holds: Vec<CaseHold<C>>,
        Parameter wire: Option<Wire<C>>,
        Parameter sizes: Option<Vec<PinSize<C>>>,
        Fixed chosen: Option<CasesChoice>,
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
        hanging: Hanging<C> = Hanging::new(rig, load[!], stretch, travel);
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
        weighty: Weighty<C> = resisting::weighty(places, bodies, chosen[!]) => _;
        moved: MovedBars<C> = resisting::moved(places, weighty, residual[?], phi) => _;
        sums: Sums<C> = Sums::new(moved, bodies, cases, chosen[!]);
        resisted[each cases]: Vec<Resisted<C>> = Resisted::new(sums, load[!], air[!], cases[each]);
        loads[each cases]: Vec<Loads<C>> = Loads::new(moved, bodies, chosen[!], load[!], cases[each], resisted[each]) => _;
        pinned[each cases]: Vec<Pins<C>> = resisting::pins(rig, falls, stretch, residual[?], moved, loads[each], resisted[each]) => _;
        rubbed[each cases]: Vec<Rubbed<C>> = Rubbed::new(resisted[each], pinned[each], rubbing, chosen[!]);
        force[each cases]: Vec<C> = resisting::force(falls, rubbed[each]) => F_R;
        motored[each cases]: Vec<Motored<C>> = Motored::new(
            driver[!], sums, cases[each], resisted[each], rubbed[each], force[each]
        );
        heating: Heating<C> = Heating::new(driver[!], sums, resisted, motored, chosen[!]);
        holding[each holds]: Vec<Holding<C>> = Holding::new(driver[!], brake[!], second, sums, holds[each], resisted[each]);
        stopped[each holds]: Vec<Stopped<C>> = Stopped::new(driver[!], brake[!], second, sums, cases[each], motored[each]);
        slipped[each cases]: Vec<Slipped<C>> = Slipped::new(driver[!], slip[!], sums, cases[each], motored[each]);
        ramped[each cases]: Vec<Ramped<C>> = Ramped::new(driver[!], inverter[!], sums, cases[each], motored[each]);
        ratios: RopeRatios<C> = RopeRatios::new(wire[!]);
        tensed[each cases]: Vec<Tensed<C>> = resisting::tensed(wire[!], rig, force[each]);
        sheared[each cases]: Vec<Sheared<C>> = Sheared::new(sizes[!], chosen[!], pinned[each]);
        roped: RopedParts<C> = RopedParts::new(rig, compensation, weights[!], inertia[!], choice) => _;
        hoist: HoistParts<C> = HoistParts::by_speed(ramp, give) => _;
        parts[constants]: Vec<SingleParts<Roped, C>> = single::parts(
            roped, load[!], balance, hoist, around, ground, constants[!], fitted
        ) => _;
        boom[constants]: Vec<Renewed<Heavy<Roped, C>>> = single::heavy(parts) => _;
        built[constants]: Vec<Level<C>> = single::built(parts, boom) => _;
        sampled: ByAxis<Latched<C>> = control::sampled(control[!], commanded[!], latched[!], phi, omega, states[!]) => _;
        controlled: HeldMoments<C> = HeldMoments::new(latched[!]);
        commands: Inputs<C> = control::acting(inputs[!], latched) => _;
        told[constants]: Vec<Level<C>> = stages::told(built, commands) => _;
        still: CraneAt<C> = stages::at(phi, omega, states[!], wound, past[!], commands, fitted) => _;
        at: CraneAt<C> = stages::hanging(still, slack[!]) => _;
        moves: CraneMoves<C> = stages::moves(built, told, at, phi) => _;
        turning: BoomRates<Roped, C> = BoomRates::new(moves);
        rates: CraneRates<C> = CraneRates::new(moves, fitted);
        resisting: C = stages::resisting(built, told, at, phi) => M_R;
        driving: C = stages::driving(built, told, at, phi) => _;
        tackle: C = forces_in_motion::pull(driving, falls) => T_DYN;
        hauled: C = hauled(rig, tackle, speeds) => P_L;
        led: C = stages::pull(built, told, at, phi) => S_R;
        acting: Acting<C> = single::acting(boom, built, told, at, phi);
        countered: BalanceInMotion<C> = single::countered(acting, balance[!]);
        forces: RopeForces<C> = RopeForces::new(
            rig, position, falls, stretch, weights[!], inertia[!], constants[!], acting, tackle
        );
        air_force: C = stages::air_force(built, told, at, phi, around[!]) => F_AIR;
        air_power: C = stages::air_power(built, told, at, phi, around[!]) => P_AIR;
        ground_force: C = stages::ground_force(built, told, at, phi, ground[!]) => N_G;
        height: C = stages::height(built, told, at, phi, ground[!]) => H_G;
        blown: C = stages::blown(at) => W_BLOW;
        events: CraneEvents<C> = stages::events(built, told, at, phi, fitted);
    }
}

luffs!(RopeBoom by phi, omega on slack);

resists!(RopeBoom with resisting::PARTS);

/// What is said of its variables in motion.
const SAID: Said = Said {
    bar: [&[&b::PHI, &s::OMEGA], &rates_after::<22>(Roped::RATES)],
    still: &[r::ALL, b::ALL],
    moving: listed!(s: T_DYN, S_H, F_K, F_O1X, F_O1Y, N_B, P_L, N_1, F_KX, F_KY, F_MX, F_MY),
    drive: None,
};

/// What it has in motion; `None` at rest.
fn fittings(given: &Given<f64>) -> Option<Fittings> {
    Fittings::of(&RopeBoom::luffing(given).sources)
}

impl Component for RopeBoom {
    const STATES: [&'static [&'static Symbol]; 2] = SAID.bar;

    const INDICATORS: &'static [&'static Symbol] = &INDICATORS;

    fn gives(given: &Given<f64>, symbol: &'static Symbol) -> bool {
        fittings(given).is_none_or(|crane| crane.gives(symbol))
    }

    fn list(given: &Given<f64>, variable: &mut Variable) -> u8 {
        if variable.symbol == &s::Z_LOW {
            variable.remark = Some("Or where the slack tackle is taut again.");
        }
        fittings(given).map_or(0, |_| SAID.list(variable))
    }

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
    }

    fn cycle(given: &Given<f64>) -> Option<f64> {
        given.control.as_ref().and_then(control::cycle)
    }

    fn latch(known: &mut Known<f64>) -> Found<()> {
        let held = *known.sampled()?;
        *known.latched() = Some(held);
        Ok(())
    }

    fn update(known: &mut Known<f64>) -> Found<()> {
        known.falls().map(|_| ())
    }
}

impl WithBalance for RopeBoom {
    const SYMBOLS: [&'static Symbol; 3] = [&b::PHI, &s::R, &s::M_D];

    fn form(given: &Given<f64>) -> Option<Form<f64>> {
        given.balance
    }

    fn balance(known: &mut Known<f64>) -> Found<(Balancing<f64>, Analysis)> {
        Ok((*known.balancing()?, known.analysed()?.clone()))
    }

    fn head(known: &mut Known<f64>) -> Found<Point<f64>> {
        Ok(known.position()?.a)
    }

    fn residual<C: Scalar>(known: &mut Known<C>) -> Found<Residual<C>> {
        known.residual().copied()
    }
}
