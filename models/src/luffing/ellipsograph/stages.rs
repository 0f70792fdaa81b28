//! The boom as a component: what it is given, and in which stages its equations follow from each other.

use crate::balance::analysis::Analysis;
use crate::balance::residual::Residual;
use crate::balance::scene::Form;
use crate::balance::symbols as b;
use crate::component::outline::joined;
use crate::component::part::{Component, Port, ports};
use crate::component::scalar::Scalar;
use crate::component::stages::{Found, stages};
use crate::component::whole::{How, Whole};
use crate::drive::crank::{CrankRod, Cranked, cranked};
use crate::drive::gear::Gear;
use crate::drive::line::{self, Drive, Mounted, Reaction};
use crate::drive::mount::{Bore, DriveMount, DrivenBar};
use crate::drive::shaft::{Gearing, Shaft};
use crate::kernel::group::One;
use crate::kernel::symbol::{Symbol, listed};
use crate::kernel::variable::Variable;
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
use crate::luffing::moving::control::{self, ByAxis, HeldMoments};
use crate::luffing::moving::given::{Constants, CraneStates, Fitted, Inputs};
use crate::luffing::moving::hoisting::{HoistMotor, HoistRamp, RopeGive};
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
use crate::luffing::strength::given::{Nut, PinSize, Profile, Strut, Teeth};
use crate::luffing::strength::nut::{Core, Threaded};
use crate::luffing::strength::pins::Sheared;
use crate::luffing::strength::pull::pressed;
use crate::luffing::strength::strut::{Slender, buckled};
use crate::luffing::strength::teeth::{Mesh, Toothed};
use crate::luffing::with_balance::WithBalance;
use crate::parts::air::AirAround;
use crate::parts::control::{Latched, SpeedControl};
use crate::parts::four_bar::FourBar;
use crate::parts::ground::GroundBelow;
use crate::parts::plane::Point;

/// Quantities at rest and in motion, and of the drive.
mod s {
    pub use crate::balance::symbols::{F_KX, F_KY, F_MX, F_MY, N_1};
    pub use crate::drive::symbols::{F_D, L_D, Q_D, T_CR, V_D};
    pub use crate::luffing::ellipsograph::symbols::*;
    pub use crate::luffing::moving::symbols::{F_AIR, H_G, M_R, M_R_H, N_G, P_AIR, S_R, W_BLOW};
    pub use crate::luffing::resistances::symbols::F_R;
    pub use crate::luffing::strength::symbols::{P_C, U_K};
}

stages! {
    /// A single boom on guide and link.
    EllipsographBoom over C from {
        Coordinate phi: One<C>,
        Rate omega: One<C>,
        State states: Option<CraneStates<C>>,
        Input inputs: Option<Inputs<C>>,
        Parameter inertias: Option<GuidedInertias<C>>,
        Parameter constants: Option<Constants<C>>,
        Parameter ramp: Option<HoistRamp<C>>,
        Parameter motor: Option<HoistMotor<C>>,
        Parameter give: Option<RopeGive<C>>,
        Parameter around: Option<AirAround<C>>,
        Parameter ground: Option<GroundBelow<C>>,
        Parameter control: Option<ByAxis<SpeedControl<C>>>,
        Input commanded: Option<ByAxis<One<C>>>,
        Latch latched: Option<ByAxis<Latched<C>>>,
        Memory wound: Option<One<C>>,
        Memory past: Option<Modes>,
        Load load: Option<One<C>>,
        Parameter bars: Bars<C>,
        Parameter weights: Option<GuidedWeights<C>>,
        Parameter mount: Option<DriveMount<C>>,
        Parameter rod: Option<CrankRod<C>>,
        Parameter cylinder: Option<Bore<C>>,
        Parameter gear: Option<Gear<C>>,
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
        Parameter strut: Option<Strut<C>>,
        Parameter profile: Option<Profile<C>>,
        Parameter teeth: Option<Teeth<C>>,
        Parameter nut: Option<Nut<C>>,
        Parameter sizes: Option<Vec<PinSize<C>>>,
        Fixed chosen: Option<CasesChoice>,
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
        gearing: Gearing<C> = Gearing::new(gear[!]);
        shaft: Shaft<C> = line::shaft(gearing, push, stroke, cranked[?]);
        by_slider: C = line::by_slider(cranked, rod[!], mount[!], push) => T_CR;
        analysed: Analysis = analysed(bars, weights[!], balance[!], choice) => _, plain;
        criteria: Criteria<C> = criteria(balancing, bars, weights[!], analysed, choice);
        mounted: Mounted<C> = Mounted::new(mount[!], rod, crank[?]) => _;
        places: GuidedPlaces<C> = GuidedPlaces::new(bars, weights[!], balancing[?], mounted) => _;
        weighty: Weighty<C> = resisting::weighty(places, bodies, chosen[!]) => _;
        moved: MovedBars<C> = resisting::moved(places, weighty, residual[?], phi) => _;
        sums: Sums<C> = Sums::new(moved, bodies, cases, chosen[!]);
        resisted[each cases]: Vec<Resisted<C>> = Resisted::new(sums, load[!], air[!], cases[each]);
        loads[each cases]: Vec<Loads<C>> = Loads::new(moved, bodies, chosen[!], load[!], cases[each], resisted[each]) => _;
        pinned[each cases]: Vec<Pins<C>> = resisting::pins(position, drive, residual[?], moved, loads[each], resisted[each]) => _;
        rubbed[each cases]: Vec<Rubbed<C>> = Rubbed::new(resisted[each], pinned[each], rubbing, chosen[!]);
        force[each cases]: Vec<C> = resisting::force(drive, rubbed[each]) => F_R;
        motored[each cases]: Vec<Motored<C>> = Motored::new(
            driver[!], sums, cases[each], resisted[each], rubbed[each], force[each]
        );
        heating: Heating<C> = Heating::new(driver[!], sums, resisted, motored, chosen[!]);
        holding[each holds]: Vec<Holding<C>> = Holding::new(driver[!], brake[!], second, sums, holds[each], resisted[each]);
        stopped[each holds]: Vec<Stopped<C>> = Stopped::new(driver[!], brake[!], second, sums, cases[each], motored[each]);
        slipped[each cases]: Vec<Slipped<C>> = Slipped::new(driver[!], slip[!], sums, cases[each], motored[each]);
        ramped[each cases]: Vec<Ramped<C>> = Ramped::new(driver[!], inverter[!], sums, cases[each], motored[each]);
        slender: Slender<C> = Slender::new(strut[!], profile, nut, cylinder, drive);
        buckled[each cases]: Vec<C> = buckled(strut[!], slender, force[each]) => U_K;
        mesh: Mesh<C> = Mesh::new(teeth[!], gear[!], mount[!]);
        toothed[each cases]: Vec<Toothed<C>> = Toothed::new(teeth[!], mesh, force[each]);
        core: Core<C> = Core::new(nut[!], gear[!], gearing);
        threaded[each cases]: Vec<Threaded<C>> = Threaded::new(nut[!], core, force[each]);
        pressed[each cases]: Vec<C> = pressed(cylinder[!], force[each]) => P_C;
        sheared[each cases]: Vec<Sheared<C>> = Sheared::new(sizes[!], chosen[!], pinned[each]);
        guided: GuidedParts<C> = GuidedParts::new(bars, weights[!], inertias[!], choice) => _;
        hoist: HoistParts<C> = HoistParts::new(ramp, motor, give) => _;
        parts[constants]: Vec<SingleParts<Guided, C>> = single::parts(
            guided, load[!], balance, hoist, around, ground, constants[!], fitted
        ) => _;
        boom[constants]: Vec<Renewed<Heavy<Guided, C>>> = single::heavy(parts) => _;
        built[constants]: Vec<Level<C>> = single::built(parts, boom) => _;
        sampled: ByAxis<Latched<C>> = control::sampled(control[!], commanded[!], latched[!], phi, omega, states[!]) => _;
        controlled: HeldMoments<C> = HeldMoments::new(latched[!]);
        commands: Inputs<C> = control::acting(inputs[!], latched) => _;
        told[constants]: Vec<Level<C>> = stages::told(built, commands) => _;
        at: CraneAt<C> = stages::at(phi, omega, states[!], wound, past[!], commands, fitted) => _;
        moves: CraneMoves<C> = stages::moves(built, told, at, phi) => _;
        turning: BoomRates<Guided, C> = BoomRates::new(moves);
        rates: CraneRates<C> = CraneRates::new(moves, fitted);
        resisting: C = stages::resisting(built, told, at, phi) => M_R;
        pull: C = stages::pull(built, told, at, phi) => S_R;
        drum: C = stages::drum(built, told, at, phi) => M_R_H;
        acting: Acting<C> = single::acting(boom, built, told, at, phi);
        countered: BalanceInMotion<C> = single::countered(acting, balance[!]);
        forces: GuidedForces<C> = forces(bars, boom, phi, position, acting, drive[?]);
        air_force: C = stages::air_force(built, told, at, phi, around[!]) => F_AIR;
        air_power: C = stages::air_power(built, told, at, phi, around[!]) => P_AIR;
        ground_force: C = stages::ground_force(built, told, at, phi, ground[!]) => N_G;
        height: C = stages::height(built, told, at, phi, ground[!]) => H_G;
        blown: C = stages::blown(at) => W_BLOW;
        events: CraneEvents<C> = stages::events(built, told, at, phi, fitted);
    }
}

luffs!(EllipsographBoom by phi, omega with motor);

resists!(EllipsographBoom with resisting::PARTS);

/// What is said of its variables in motion.
const SAID: Said = Said {
    bar: [&[&b::PHI, &s::OMEGA], &rates_after::<22>(Guided::RATES)],
    still: &[g::ALL, b::ALL, crate::drive::symbols::ALL],
    moving: listed!(s: M_D, P_D, F_BX, F_CX, F_CY, N_L, F_O1X, F_O1Y, F_D, N_1, F_KX, F_KY, F_MX, F_MY),
    drive: Some(&s::M_D),
};

/// What it has in motion; `None` at rest.
fn fittings(given: &Given<f64>) -> Option<Fittings> {
    Fittings::of(&EllipsographBoom::luffing(given).sources)
}

impl Component for EllipsographBoom {
    const STATES: [&'static [&'static Symbol]; 2] = SAID.bar;

    const INDICATORS: &'static [&'static Symbol] = &INDICATORS;

    fn gives(given: &Given<f64>, symbol: &'static Symbol) -> bool {
        fittings(given).is_none_or(|crane| crane.gives(symbol))
    }

    fn list(given: &Given<f64>, variable: &mut Variable) -> u8 {
        fittings(given).map_or(0, |_| SAID.list(variable))
    }

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
        drive "Cylinder, rack, screw, sector or crank between frame and link.": s L_D, v V_D, f F_D, q Q_D;
    };

    /// A balance has what its kind has, and so has a drive.
    fn has(given: &Given<f64>, symbol: &'static Symbol) -> bool {
        (symbol != &b::F_D_0 || given.mount.is_some())
            && line::has(given.mount.as_ref(), given.rod.is_some(), given.gear.as_ref(), symbol)
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
        known.position().map(|_| ())
    }
}

impl WithBalance for EllipsographBoom {
    const SYMBOLS: [&'static Symbol; 3] = [&s::THETA_L, &s::R, &s::M_D];

    fn form(given: &Given<f64>) -> Option<Form<f64>> {
        given.balance
    }

    fn balance(known: &mut Known<f64>) -> Found<(Balancing<f64>, Analysis)> {
        Ok((*known.balancing()?, known.analysed()?.clone()))
    }

    /// That of the link, which is what the balance sees.
    fn head(known: &mut Known<f64>) -> Found<Point<f64>> {
        Ok(known.position()?.c)
    }

    fn residual<C: Scalar>(known: &mut Known<C>) -> Found<Residual<C>> {
        known.residual().copied()
    }
}
