//! How slewing moves under its drive: friction and brake that truly stick, end stops.

use crate::component::stages::{absent, results};
use crate::kernel::calc::Calc;
use crate::kernel::group::{group, quantities};
use crate::parts::joint::{Bar, Friction, Joint, JointDrive, above_zero};
use crate::parts::turntable::Turning;
use crate::slewing::symbols as s;
use crate::slewing::turning::{Hung, SlewedLoad};

quantities! {
    /// Drive and brake.
    SlewingDrive { m_sl: M_SL, m_b_sl: M_B_SL }
}

quantities! {
    /// What happened before: which way it turns, and the energy that blows have taken.
    Past { way: WAY, blown: W_BLOW }
}

impl<C: Calc> Past<C> {
    /// At rest (0), turning to the left (1) or to the right (−1).
    pub fn bar(&self) -> Bar {
        bar(self.way.value())
    }
}

/// Which way something turns, by a number that is zero where it is held.
pub(super) fn bar(way: f64) -> Bar {
    match way {
        0.0 => Bar::Held,
        way if way > 0.0 => Bar::Forward,
        _ => Bar::Backward,
    }
}

/// The same as such a number: 0, 1 or −1.
pub(super) fn way(bar: Bar) -> f64 {
    match bar {
        Bar::Forward => 1.0,
        Bar::Backward => -1.0,
        Bar::Held | Bar::Loose => 0.0,
    }
}

/// Least and greatest slewing angle, in rad; infinite where there is no stop.
#[derive(Clone, Copy, Debug)]
pub struct Stops(pub [f64; 2]);
group!(Stops);

/// The joint with its friction and stops.
pub fn joint<C: Calc>(turning: &Turning<C>, stops: &Stops) -> Joint<C> {
    Joint {
        friction: Friction {
            viscous: turning.c_sl,
            coulomb: turning.m_f_sl,
        },
        stops: stops.0,
    }
}

/// What the drive, slope and wind give together, in N·m.
pub(super) fn driving<C: Calc>(driven: &SlewingDrive<C>, outer: &Option<C>) -> C {
    outer.map_or(driven.m_sl, |outer| driven.m_sl + outer)
}

pub(super) fn drive<C: Calc>(driven: &SlewingDrive<C>) -> JointDrive<C> {
    JointDrive {
        moment: driven.m_sl,
        brake: driven.m_b_sl,
    }
}

/// What a load that swings makes of slewing.
#[derive(Clone, Copy, Debug)]
pub struct Led<C> {
    /// Moment that friction, brake and stops must give to hold it at rest, in N·m.
    pub needs: C,
    /// Moment of friction and brake while it turns, in N·m.
    pub rubbing: C,
    /// In rad/s².
    pub acceleration: C,
}

/// Moment that friction, brake and stops must give at rest, with the least and the greatest that they can, in N·m.
pub fn held<C: Calc>(
    joint: &Joint<C>,
    driven: &SlewingDrive<C>,
    outer: &Option<C>,
    led: Option<&Led<C>>,
    psi: &C,
) -> [C; 3] {
    let [least, most] = joint.holds(*psi, &drive(driven));
    [needed(driven, outer, led), least, most]
}

pub(super) fn needed<C: Calc>(driven: &SlewingDrive<C>, outer: &Option<C>, led: Option<&Led<C>>) -> C {
    led.map_or_else(|| -driving(driven, outer), |led| led.needs)
}

/// M_R: −c ω − (M_F + M_B) while it turns to the left, what it needs at rest, in N·m. [Ports001, 6.5]
pub fn resisting<C: Calc>(
    turning: &Turning<C>,
    driven: &SlewingDrive<C>,
    past: &Past<C>,
    stops: &Stops,
    outer: &Option<C>,
    led: Option<&Led<C>>,
    omega: &C,
) -> C {
    let moment = match (past.bar(), led) {
        (Bar::Held, _) => needed(driven, outer, led),
        (_, Some(led)) => return led.rubbing,
        (bar, None) => joint(turning, stops).resistance(bar, *omega, &drive(driven)),
    };
    moment.def(&s::M_R_SL)
}

/// Rates of angle and speed, and what they ask of the load.
#[derive(Clone, Copy, Debug)]
pub struct Turned<C> {
    rate: C,
    pub(super) acceleration: C,
    /// Of a load that keeps its place.
    along: Option<C>,
}
results! { Turned as t => { D_PSI_SL: t.rate; D_OMEGA_SL: t.acceleration; F_T: t.along.ok_or_else(absent)?; } }

impl<C: Calc> Turned<C> {
    /// ω̇ = (M_sl + M_γ + M_ws + M_R) / J, F_t = m_Q R ω̇. [Ports001, 6.5]
    #[expect(clippy::too_many_arguments, reason = "all that turns it")]
    pub fn new(
        driven: &SlewingDrive<C>,
        past: &Past<C>,
        outer: &Option<C>,
        resisting: &C,
        led: Option<&Led<C>>,
        total: &C,
        carried: &SlewedLoad<C>,
        hung: &Hung<C>,
        omega: &C,
    ) -> Turned<C> {
        let acceleration = match (past.bar(), led) {
            (Bar::Held, _) => C::constant(0.0),
            (_, Some(led)) => led.acceleration,
            _ => ((driving(driven, outer) + *resisting) / *total).def(&s::D_OMEGA_SL),
        };
        Turned {
            rate: *omega,
            acceleration,
            along: led
                .is_none()
                .then(|| (carried.mass * hung.r * acceleration).def(&s::F_T)),
        }
    }
}

/// Energy that blows at the stops have taken, in J: all that moved.
pub fn struck<C: Calc>(_: &SlewingDrive<C>, past: &Past<C>) -> C {
    past.blown
}

/// What falls below zero where a smooth piece of the motion ends.
#[derive(Clone, Copy, Debug)]
pub struct SlewingEvents<C>([C; 4]);
results! { SlewingEvents as e => { Z_SL_REST: e.0[0]; Z_SL_LOOSE: e.0[1]; Z_SL_LOW: e.0[2]; Z_SL_HIGH: e.0[3]; } }

impl<C: Calc> SlewingEvents<C> {
    #[expect(clippy::too_many_arguments, reason = "all that may end it")]
    pub fn new(
        turning: &Turning<C>,
        driven: &SlewingDrive<C>,
        past: &Past<C>,
        stops: &Stops,
        outer: &Option<C>,
        led: Option<&Led<C>>,
        psi: &C,
        omega: &C,
    ) -> SlewingEvents<C> {
        let joint = joint(turning, stops);
        let needs = || held(&joint, driven, outer, led, psi);
        SlewingEvents(joint.indicators(past.bar(), [*psi, *omega], needs).map(above_zero))
    }
}
