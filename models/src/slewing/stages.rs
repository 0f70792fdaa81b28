//! Slewing as a component: what it is given, in which stages its equations follow from each other, how it moves.

use crate::component::part::{Component, Port, ports};
use crate::component::stages::{Found, stages};
use crate::kernel::group::{One, group};
use crate::kernel::symbol::{Symbol, listed};
use crate::kernel::variable::Variable;
use crate::parts::air::{AirAround, Stream, WindAround};
use crate::parts::control::continuous::{Regime, Regulating, Sensed};
use crate::parts::control::{Latched, SpeedControl};
use crate::parts::hanging::HangingLoad;
use crate::parts::joint::{Arrival, Bar, Joint};
use crate::parts::side_wind::SlewedArea;
use crate::parts::slope::SlopingGround;
use crate::parts::turntable::Turning;
use crate::slewing::air::{FeltAir, WindOnSlewed, outer, stream};
use crate::slewing::blows::SwungInstant;
use crate::slewing::control::{ControlEvents, Controlled, Regulated, Regulation, Winding, acting, sampled, seen};
use crate::slewing::coupled_sides::{CoupledSides, CouplingEvents, needs};
use crate::slewing::coupling::{
    DriveRates, DriveSide, SlipCoupling, SlipPast, all_along, carried_along, passed_on, passing,
};
use crate::slewing::motion::{self, Led, Past, SlewingDrive, SlewingEvents, Stops, Turned, joint, resisting, struck};
use crate::slewing::swinging::{
    RopeLength, Slackness, Swinging, SwingingLoad, SwingingRates, leaning, led, slackening,
};
use crate::slewing::symbols as s;
use crate::slewing::turning::{Circling, Hung, SlewedLoad, Steady, tilt, total};

stages! {
    /// A crane that slews.
    SlewingCrane over C from {
        Coordinate psi: One<C>,
        Rate omega: One<C>,
        Parameter hung: Hung<C>,
        Parameter turning: Turning<C>,
        Parameter slope: Option<SlopingGround<C>>,
        Parameter area: Option<SlewedArea<C>>,
        Input driven: Option<SlewingDrive<C>>,
        State swung: Option<SwingingLoad<C>>,
        Parameter rope: Option<RopeLength<C>>,
        Parameter around: Option<AirAround<C>>,
        Input blowing: Option<WindAround<C>>,
        Parameter control: Option<SpeedControl<C>>,
        Input commanded: Option<One<C>>,
        Parameter coupling: Option<SlipCoupling<C>>,
        State side: Option<DriveSide<C>>,
        State regulating: Option<Regulating<C>>,
        Memory slipping: Option<SlipPast<C>>,
        Memory past: Past<C>,
        Memory slackness: Option<Slackness<C>>,
        Memory regime: Option<Regime<C>>,
        Latch latched: Option<Latched<C>>,
        Fixed stops: Stops,
        Fixed open: Open,
    } find {
        carried: SlewedLoad<C> = SlewedLoad::new(hung);
        total: C = total(turning, carried) => J_TOT;
        tilt: C = tilt(slope[!], hung, psi) => M_GAMMA;
        wind: WindOnSlewed<C> = WindOnSlewed::new(area[!], blowing[!], around, psi);
        outer: Option<C> = outer(tilt[?], wind[?]) => _;
        steady: Steady<C> = Steady::new(turning, outer, omega);
        circling: Circling<C> = Circling::new(carried, hung, total, omega);
        bound: Turning<C> = carried_along(turning, coupling, slipping) => _;
        whole: C = all_along(total, coupling, slipping) => _;
        regulated: Regulated<C> = Regulated::new(control[!], bound, swung, whole);
        sampled: Latched<C> = sampled(
            control[!], commanded[!], latched[!], bound, swung, whole, coupling, side, psi, omega) => _;
        controlled: Controlled<C> = Controlled::new(latched[!]);
        regulation: Regulation<C> = Regulation::new(control[!], regulating[!], regime[!], side, omega), decided;
        motor: SlewingDrive<C> = acting(driven[!], latched, regulation[?]) => _;
        drive: SlewingDrive<C> = passed_on(motor, coupling, slipping) => _;
        leaning: C = leaning(slope[!], swung[!], psi) => M_GAMMA_U;
        pushed: Option<C> = outer(leaning[?], wind[?]) => _;
        stream: Stream<C> = stream(around[!], blowing[!], hung, psi) => _;
        swinging: Swinging<C> = Swinging::new(
            bound, drive, past, slackness[!], stops, slope, pushed, stream[?], swung[!], hung, carried, psi,
            omega);
        in_air: FeltAir<C> = FeltAir::new(stream, swinging, hung, carried, omega);
        led: Led<C> = led(swinging) => _;
        resisting: C = resisting(turning, drive, past, stops, outer, led[?], omega) => M_R_SL;
        turned: Turned<C> = Turned::new(drive, past, outer, resisting, led[?], whole, carried, hung, omega);
        rates: SwingingRates<C> = SwingingRates::new(swinging);
        passing: C = passing(
            motor, coupling[!], slipping[!], turning, past, stops, outer, led[?], turned, psi) => M_CD, decided;
        coupled: DriveRates<C> = DriveRates::new(
            motor, coupling[!], slipping[!], side[!], passing, turned, omega), decided;
        seen: Sensed<C> = seen(commanded[!], side, psi, omega, turned, coupled[?]) => _;
        winding: Winding<C> = Winding::new(control[!], regime[!], regulation, seen), decided;
        struck: C = struck(driven[!], past) => W_BLOW;
        events: SlewingEvents<C> = SlewingEvents::new(turning, drive, past, stops, outer, led[?], psi, omega);
        slackening: C = slackening(swinging, rope[!], slackness[!]) => Z_ROPE;
        parting: CouplingEvents<C> = CouplingEvents::new(
            motor, coupling[!], slipping[!], side[!], passing, omega), decided;
        regulated_until: ControlEvents<C> = ControlEvents::new(
            control[!], regulating[!], regime[!], regulation, seen), decided;
    }
}

/// Quantities that are inputs although they are given.
#[derive(Clone, Debug)]
pub struct Open(pub Vec<&'static Symbol>);
group!(Open);

/// Changes at one instant.
const MOST_CHANGES: u32 = 8;

impl Component for SlewingCrane {
    const STATES: [&'static [&'static Symbol]; 2] = [
        &[&s::PSI_SL, &s::OMEGA_SL],
        &[
            &s::D_PSI_SL,
            &s::D_OMEGA_SL,
            &s::D_X_Q,
            &s::D_Y_Q,
            &s::D_Z_Q,
            &s::D_V_QX,
            &s::D_V_QY,
            &s::D_V_QZ,
            &s::D_OMEGA_D,
            &s::D_PSI_SLIP,
            &s::D_OMEGA_R_SL,
            &s::D_EPSILON_SL,
        ],
    ];

    const INDICATORS: &'static [&'static Symbol] = listed!(s: Z_SL_REST, Z_SL_LOOSE, Z_SL_LOW, Z_SL_HIGH, Z_ROPE, Z_D_REST, Z_D_LOOSE, Z_C_REST, Z_C_LOOSE, Z_SL_RAMP,
        Z_SL_LIMIT, Z_SL_WIND);

    const PORTS: &'static [Port] = ports! { s:
        shaft "Slewing axis." [tau]: phi PSI_SL, w OMEGA_SL, tau M_SL;
    };

    /// A load that swings is not carried along its circle.
    fn has(given: &Given<f64>, symbol: &'static Symbol) -> bool {
        symbol != &s::F_T || given.swung.is_none()
    }

    /// The moment of the drive is given where no controller holds it.
    fn gives(given: &Given<f64>, symbol: &'static Symbol) -> bool {
        symbol != &s::M_SL || given.control.is_none()
    }

    fn list(given: &Given<f64>, variable: &mut Variable) -> u8 {
        let held = [&s::M_SL, &s::OMEGA_S_SL, &s::M_I_SL];
        variable.at_events = if given.regulating.is_some() {
            [&s::OMEGA_C_SL, &s::PSI_C_SL].contains(&variable.symbol)
        } else {
            given.control.is_some() && held.contains(&variable.symbol)
        };
        0
    }

    fn cycle(given: &Given<f64>) -> Option<f64> {
        given.control.and_then(|control| control.cycle())
    }

    fn latch(known: &mut Known<f64>) -> Found<()> {
        let held = *known.sampled()?;
        *known.latched() = Some(held);
        Ok(())
    }

    fn is_input(given: &Given<f64>, symbol: &'static Symbol) -> bool {
        given.open.0.contains(&symbol)
    }

    fn update(known: &mut Known<f64>) -> Found<()> {
        known.total().map(|_| ())
    }

    /// At rest it is decided again which way it goes, as drive and brake may have changed; an end stop takes all speed.
    fn decide(known: &mut Known<f64>) -> Found<bool> {
        if known.given.driven.is_none() {
            return Ok(false);
        }
        let joint = joint(&known.given.turning, &known.given.stops);
        let (start, mut blown, mut put_there) = (instant(known)?, 0.0, false);
        let mut now = start;
        if let Some(coupled) = &mut now.coupled {
            coupled.begin(start.omega);
            put(known, &now);
        }
        if start.omega == 0.0 {
            known.past().way = 0.0;
        }
        for _ in 0..MOST_CHANGES {
            put_there |= regulate(known)?;
            let before = instant(known)?;
            let mut now = before;
            match joint.arrival(now.bar, [*known.given.psi, now.omega]) {
                Arrival::None => {}
                Arrival::SetOff(way) => now.bar = way,
                Arrival::Rest { at_stop } => {
                    if at_stop {
                        let [low, high] = joint.stops;
                        known.psi().1 = known.given.psi.clamp(low, high);
                        blown += now.struck(SwungInstant::stop);
                    } else if let Some(coupled) = &mut now.coupled {
                        coupled.begin(0.0);
                    }
                    (now.bar, now.omega) = (Bar::Held, 0.0);
                }
            }
            if known.given.swung.is_some() {
                blown += now.struck(SwungInstant::catch);
                put(known, &now);
                now.taut = now.taut && known.swinging()?.found.slackening >= 0.0;
            }
            if let Some(coupled) = &mut now.coupled {
                coupled.arrive(now.omega);
            }
            put(known, &now);
            loosen(known, &joint, &mut now)?;
            if instant(known)? == before {
                break;
            }
        }
        if blown != 0.0 {
            known.past().blown += blown;
        }
        let end = instant(known)?;
        let speed = |at: &SwungInstant| at.coupled.map(|coupled| coupled.omega);
        Ok(put_there || end.omega != start.omega || end.load != start.load || speed(&end) != speed(&start))
    }
}

/// What follows for the continuous controller; whether a state of it jumped.
fn regulate(known: &mut Known<f64>) -> Found<bool> {
    let (Some(control), Some(before)) = (known.given.control, known.given.regulating.zip(known.given.regime)) else {
        return Ok(false);
    };
    let (state, past) = control.decided(before, known.seen()?);
    let jumped = state != before.0;
    if jumped {
        *known.regulating() = Some(state);
    }
    if past != before.1 {
        *known.regime() = Some(past);
    }
    Ok(jumped)
}

/// What is held, and whether it breaks loose: all that slews, then its coupling and its drive.
fn loosen(known: &mut Known<f64>, joint: &Joint<f64>, now: &mut SwungInstant) -> Found<()> {
    if now.bar == Bar::Held {
        let driven = *known.drive()?;
        let outer = *known.outer()?;
        let led = known.given.swung.is_some().then(|| known.led().copied()).transpose()?;
        now.bar = Bar::loosened(motion::held(joint, &driven, &outer, led.as_ref(), &known.given.psi));
        put(known, now);
    }
    if let (Some(coupled), Some(coupling)) = (&mut now.coupled, known.given.coupling) {
        let (stuck, motor) = (coupled.slip == Bar::Held, *known.motor()?);
        coupled.loosened(needs(&motor, &coupling, *known.passing()?));
        // At rest each side is asked for itself what it does now.
        if stuck && coupled.slip != Bar::Held && now.omega == 0.0 {
            now.bar = Bar::Held;
        }
        put(known, now);
    }
    Ok(())
}

/// Where it is; a load that keeps its place is a part of what slews.
fn instant(known: &mut Known<f64>) -> Found<SwungInstant> {
    let (total, mass) = (*known.total()?, known.carried()?.mass);
    let given = &known.given;
    let own = given.swung.map(|load| (given.turning.j_sl, mass, load.load()));
    let (inertia, mass, load) = own.unwrap_or((total, 0.0, HangingLoad::of(&[0.0; 6])));
    let coupled = given.side.as_ref().zip(given.slipping.as_ref());
    Ok(SwungInstant {
        bar: given.past.bar(),
        omega: *given.omega,
        load,
        taut: given.slackness.is_some_and(|rope| rope.slack == 0.0),
        reach: given.hung.r,
        inertia,
        mass,
        length: given.rope.map_or(0.0, |rope| rope.l_r),
        coupled: coupled.map(|(side, past)| CoupledSides::of(side, past)),
    })
}

/// What has changed; the rest is as it was, and so is what follows from it.
fn put(known: &mut Known<f64>, now: &SwungInstant) {
    let way = motion::way(now.bar);
    if way != known.given.past.way {
        known.past().way = way;
    }
    if now.omega != *known.given.omega {
        known.omega().1 = now.omega;
    }
    if known.given.swung.is_some_and(|load| load.load() != now.load) {
        *known.swung() = Some(now.load.into());
    }
    let slack = f64::from(!now.taut);
    if known.given.slackness.is_some_and(|rope| rope.slack != slack) {
        *known.slackness() = Some(Slackness { slack });
    }
    let Some((coupled, side)) = now.coupled.zip(known.given.side) else {
        return;
    };
    if coupled.omega != side.omega_d {
        *known.side() = Some(DriveSide {
            omega_d: coupled.omega,
            ..side
        });
    }
    if known.given.slipping != Some(coupled.past()) {
        *known.slipping() = Some(coupled.past());
    }
}
