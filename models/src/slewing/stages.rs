//! Slewing as a component: what it is given, in which stages its equations follow from each other, how it moves.

use crate::component::part::{Component, Port, ports};
use crate::component::stages::{Found, stages};
use crate::kernel::group::{One, group};
use crate::kernel::symbol::Symbol;
use crate::parts::joint::{Arrival, Bar};
use crate::parts::turntable::Turning;
use crate::slewing::motion::{Past, SlewingDrive, SlewingEvents, Stops, Turned, held, joint, resisting, struck};
use crate::slewing::symbols as s;
use crate::slewing::turning::{Circling, Ground, Hung, SlewedLoad, Steady, tilt, total};

stages! {
    /// A crane that slews.
    SlewingCrane over C from {
        Coordinate psi: One<C>,
        Rate omega: One<C>,
        Parameter hung: Hung<C>,
        Parameter turning: Turning<C>,
        Parameter slope: Option<Ground<C>>,
        Input driven: Option<SlewingDrive<C>>,
        Memory past: Past<C>,
        Fixed stops: Stops,
        Fixed open: Open,
    } find {
        carried: SlewedLoad<C> = SlewedLoad::new(hung);
        total: C = total(turning, carried) => J_TOT;
        tilt: C = tilt(slope[!], hung, psi) => M_GAMMA;
        steady: Steady<C> = Steady::new(turning, tilt[?], omega);
        circling: Circling<C> = Circling::new(carried, hung, total, omega);
        resisting: C = resisting(turning, driven[!], past, stops, tilt[?], omega) => M_R_SL;
        turned: Turned<C> = Turned::new(driven[!], past, tilt[?], resisting, total, carried, hung, omega);
        struck: C = struck(driven[!], past) => W_BLOW;
        events: SlewingEvents<C> = SlewingEvents::new(turning, driven[!], past, stops, tilt[?], psi, omega);
    }
}

/// Quantities that are inputs although they are given.
#[derive(Clone, Debug)]
pub struct Open(pub Vec<&'static Symbol>);
group!(Open);

/// Changes at one instant.
const MOST_CHANGES: u32 = 4;

impl Component for SlewingCrane {
    const STATES: [&'static [&'static Symbol]; 2] = [&[&s::PSI_SL, &s::OMEGA_SL], &[&s::D_PSI_SL, &s::D_OMEGA_SL]];

    const INDICATORS: &'static [&'static Symbol] = &[&s::Z_SL_REST, &s::Z_SL_LOOSE, &s::Z_SL_LOW, &s::Z_SL_HIGH];

    const PORTS: &'static [Port] = ports! { s:
        shaft "Slewing axis." [tau]: phi PSI_SL, w OMEGA_SL, tau M_SL;
    };

    fn is_input(given: &Given<f64>, symbol: &'static Symbol) -> bool {
        given.open.0.contains(&symbol)
    }

    fn update(known: &mut Known<f64>) -> Found<()> {
        known.total().map(|_| ())
    }

    /// At rest it is decided again which way it goes, as drive and brake may have changed; an end stop takes all speed.
    fn decide(known: &mut Known<f64>) -> Found<bool> {
        let Some(driven) = known.given.driven else {
            return Ok(false);
        };
        let inertia = *known.total()?;
        let joint = joint(&known.given.turning, &known.given.stops);
        let (omega, mut blown) = (*known.given.omega, known.given.past.blown);
        let mut bar = known.given.past.bar();
        let mut at = [*known.given.psi, omega];
        if omega == 0.0 {
            bar = Bar::Held;
        }
        for _ in 0..MOST_CHANGES {
            let before = (bar, at);
            match joint.arrival(bar, at) {
                Arrival::None => {}
                Arrival::SetOff(way) => bar = way,
                Arrival::Rest { at_stop } => {
                    blown += if at_stop { 0.5 * inertia * at[1].powi(2) } else { 0.0 };
                    let [low, high] = joint.stops;
                    (bar, at) = (Bar::Held, [at[0].clamp(low, high), 0.0]);
                    known.psi().1 = at[0];
                    known.omega().1 = 0.0;
                }
            }
            if bar == Bar::Held {
                let tilt = known.given.slope.is_some().then(|| known.tilt().copied()).transpose()?;
                bar = Bar::loosened(held(&joint, &driven, tilt.as_ref(), &at[0]));
            }
            if (bar, at) == before {
                break;
            }
        }
        let way = match bar {
            Bar::Forward => 1.0,
            Bar::Backward => -1.0,
            Bar::Held | Bar::Loose => 0.0,
        };
        if (way, blown) != (known.given.past.way, known.given.past.blown) {
            *known.past() = Past { way, blown };
        }
        Ok(at[1] != omega)
    }
}
