//! Boom and trunk as a component: what it is given, and in which stages its equations follow from each other.

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
use crate::kernel::variable::{Fault, Variable};
use crate::luffing::balancing::{Balanced, Balancing};
use crate::luffing::criteria::Criteria;
use crate::luffing::curved_trunk::balancing::{analysed, balanced, balancing, criteria, residual};
use crate::luffing::curved_trunk::contact::Contact;
use crate::luffing::curved_trunk::driving;
use crate::luffing::curved_trunk::forces_in_motion::{self, TrunkForces, forces};
use crate::luffing::curved_trunk::moving::{TrunkInertias, TrunkParts, Trunked};
use crate::luffing::curved_trunk::pins::{TrunkBearing, TrunkPins, power, pressure, slack};
use crate::luffing::curved_trunk::position::TrunkPosition;
use crate::luffing::curved_trunk::resisting::{self, TrunkPlaces};
use crate::luffing::curved_trunk::statics::{TrunkLoad, TrunkWeight, TrunkWeights};
use crate::luffing::curved_trunk::symbols as t;
use crate::luffing::curved_trunk::tail::{TailArc, Trunk, TrunkChoice, TrunkTail};
use crate::luffing::curved_trunk::velocity::{TrunkSpeeds, TrunkTravel, pole};
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
    pub use crate::luffing::curved_trunk::symbols::*;
    pub use crate::luffing::moving::symbols::{F_AIR, H_G, M_R, M_R_H, N_G, P_AIR, S_R, W_BLOW};
    pub use crate::luffing::resistances::symbols::F_R;
    pub use crate::luffing::strength::symbols::{P_C, U_K};
}

stages! {
    /// A boom with a trunk whose curved tail a tie holds.
    CurvedTrunkBoom over C from {
        Coordinate phi: One<C>,
        Rate omega: One<C>,
        State states: Option<CraneStates<C>>,
        Input inputs: Option<Inputs<C>>,
        Parameter inertias: Option<TrunkInertias<C>>,
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
        Parameter trunk: Trunk<C>,
        Parameter arc: Option<TailArc<C>>,
        Parameter width: Option<One<C>>,
        Parameter weights: Option<TrunkWeights<C>>,
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
        hanging: TrunkLoad<C> = TrunkLoad::new(position, travel, pole, load[!]);
        own: TrunkWeight<C> = TrunkWeight::new(weights[!], phi, position, travel);
        balancing: Balancing<C> = balancing(tail, choice, weights[!], balance[!]) => _;
        residual: Residual<C> = residual(balancing, own, phi);
        balanced: Balanced<C> = balanced(residual, hanging, own, drive[?]);
        pins: TrunkPins<C> = TrunkPins::new(position, load[!], own[?], residual[?]);
        push: Reaction<C> = driving::push(drive, pins);
        bearing: TrunkBearing<C> = TrunkBearing::new(contact, pins, own[?], residual[?], push[?]);
        pressure: C = pressure(bearing, width[!]) => P_T;
        power: C = power(pins, omega) => P_D;
        gearing: Gearing<C> = Gearing::new(gear[!]);
        shaft: Shaft<C> = line::shaft(gearing, push, stroke, cranked[?]);
        by_slider: C = line::by_slider(cranked, rod[!], mount[!], push) => T_CR;
        analysed: Analysis = analysed(tail, choice, weights[!], balance[!]) => _, plain;
        criteria: Criteria<C> = criteria(balancing, tail, choice, weights[!], analysed);
        mounted: Mounted<C> = Mounted::new(mount[!], rod, crank[?]) => _;
        places: TrunkPlaces<C> = TrunkPlaces::new(tail, choice, weights[!], balancing[?], mounted) => _;
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
        trunked: TrunkParts<C> = TrunkParts::new(tail, weights[!], inertias[!], choice) => _;
        hoist: HoistParts<C> = HoistParts::new(ramp, motor, give) => _;
        parts[constants]: Vec<SingleParts<Trunked, C>> = single::parts(
            trunked, load[!], balance, hoist, around, ground, constants[!], fitted
        ) => _;
        boom[constants]: Vec<Renewed<Heavy<Trunked, C>>> = single::heavy(parts) => _;
        built[constants]: Vec<Level<C>> = single::built(parts, boom) => _;
        sampled: ByAxis<Latched<C>> = control::sampled(control[!], commanded[!], latched[!], phi, omega, states[!]) => _;
        controlled: HeldMoments<C> = HeldMoments::new(latched[!]);
        commands: Inputs<C> = control::acting(inputs[!], latched) => _;
        told[constants]: Vec<Level<C>> = stages::told(built, commands) => _;
        at: CraneAt<C> = stages::at(phi, omega, states[!], wound, past[!], commands, fitted) => _;
        moves: CraneMoves<C> = stages::moves(built, told, at, phi) => _;
        turning: BoomRates<Trunked, C> = BoomRates::new(moves);
        rates: CraneRates<C> = CraneRates::new(moves, fitted);
        resisting: C = stages::resisting(built, told, at, phi) => M_R;
        pull: C = stages::pull(built, told, at, phi) => S_R;
        drum: C = stages::drum(built, told, at, phi) => M_R_H;
        acting: Acting<C> = single::acting(boom, built, told, at, phi);
        countered: BalanceInMotion<C> = single::countered(acting, balance[!]);
        forces: TrunkForces<C> = forces(boom, phi, contact, position, travel, acting, drive[?]);
        pressing: C = forces_in_motion::pressure(forces, width[!]) => P_T;
        air_force: C = stages::air_force(built, told, at, phi, around[!]) => F_AIR;
        air_power: C = stages::air_power(built, told, at, phi, around[!]) => P_AIR;
        ground_force: C = stages::ground_force(built, told, at, phi, ground[!]) => N_G;
        height: C = stages::height(built, told, at, phi, ground[!]) => H_G;
        blown: C = stages::blown(at) => W_BLOW;
        events: CraneEvents<C> = stages::events(built, told, at, phi, fitted);
    }
}

luffs!(CurvedTrunkBoom by phi, omega with motor holds taut);

resists!(CurvedTrunkBoom with resisting::PARTS);

/// What is said of its variables in motion.
const SAID: Said = Said {
    bar: [&[&b::PHI, &s::OMEGA], &rates_after::<22>(Trunked::RATES)],
    still: &[t::ALL, b::ALL, crate::drive::symbols::ALL],
    moving: listed!(s: M_D, P_D, N_T, Q_T, P_T, F_BX, F_BY, F_O1X, F_O1Y, F_D, N_1, F_KX, F_KY, F_MX, F_MY),
    drive: Some(&s::M_D),
};

/// What it has in motion; `None` at rest.
fn fittings(given: &Given<f64>) -> Option<Fittings> {
    Fittings::of(&CurvedTrunkBoom::luffing(given).sources)
}

impl Component for CurvedTrunkBoom {
    const STATES: [&'static [&'static Symbol]; 2] = SAID.bar;

    const INDICATORS: &'static [&'static Symbol] = &joined::<_, 26, 1, 27>(INDICATORS, [&s::Z_TIE]);

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
            Whole::new(&s::MU_MIN, How::Least, &s::MU),
        ],
        WHOLE,
    );

    const PORTS: &'static [Port] = ports! { s:
        head "Head A of the trunk, where the load hangs.": x A_X, y A_Y, v_x V_AX, v_y V_AY, f Q;
        tie "Tie on the tail.": w W, f N_T;
        drive "Cylinder, rack, screw, sector or crank between frame and boom.": s L_D, v V_D, f F_D, q Q_D;
    };

    /// A balance has what its kind has, and so has a drive.
    fn has(given: &Given<f64>, symbol: &'static Symbol) -> bool {
        (symbol != &b::F_D_0 || given.mount.is_some())
            && given.balance.as_ref().is_none_or(|form| form.has(symbol))
            && line::has(given.mount.as_ref(), given.rod.is_some(), given.gear.as_ref(), symbol)
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

/// Whether the tie pulls.
fn taut(known: &mut Known<f64>) -> Found<()> {
    let (phi, n_t) = (known.given.phi.1, known.forces()?.n_t);
    slack(phi, n_t).map_or(Ok(()), |what| {
        let help = "this motion ends there: drive, brake, stop and hoist more gently, or let more weigh on the trunk in front of B";
        Err(Box::new(Fault::outside(format!("{what}; {help}"))))
    })
}

impl WithBalance for CurvedTrunkBoom {
    const SYMBOLS: [&'static Symbol; 3] = [&b::PHI, &s::R, &s::M_D];

    fn form(given: &Given<f64>) -> Option<Form<f64>> {
        given.balance
    }

    fn balance(known: &mut Known<f64>) -> Found<(Balancing<f64>, Analysis)> {
        Ok((*known.balancing()?, known.analysed()?.clone()))
    }

    /// That of the boom, which the balance raises.
    fn head(known: &mut Known<f64>) -> Found<Point<f64>> {
        Ok(known.position()?.b)
    }

    fn residual<C: Scalar>(known: &mut Known<C>) -> Found<Residual<C>> {
        known.residual().copied()
    }
}
