//! The coupling between the slewing drive, with its brake, and all that slews: up to a moment it carries the drive along,
//! beyond it slips, as dry friction between the two. [`Joint`] is the rule of both sides and of what is between them.

use crate::component::stages::results;
use crate::kernel::calc::Calc;
use crate::kernel::group::quantities;
use crate::parts::joint::{Bar, Friction, Joint};
use crate::parts::turntable::Turning;
use crate::slewing::motion::{Led, Past, SlewingDrive, Stops, Turned, bar, drive, joint, needed};
use crate::slewing::symbols as s;

quantities! {
    /// The drive's side, and what the coupling carries.
    SlipCoupling { j_d: J_D, m_lim: M_LIM }
}

quantities! {
    /// How the drive's side turns, and how far the coupling has slipped.
    DriveSide { omega_d: OMEGA_D, psi_slip: PSI_SLIP }
}

quantities! {
    /// What happened before: whether the coupling sticks, and, where it slips, which way the drive's side turns.
    SlipPast { slip: SLIP, way_d: WAY_D }
}

/// Without stops and without friction but one moment (N·m).
pub(super) fn dry<C: Calc>(moment: C) -> Joint<C> {
    Joint {
        friction: Friction {
            viscous: C::constant(0.0),
            coulomb: moment,
        },
        stops: [f64::NEG_INFINITY, f64::INFINITY],
    }
}

impl DriveSide<f64> {
    /// Turning at a speed (rad/s) with all that slews, the coupling not having slipped.
    pub(super) fn along(omega: f64) -> DriveSide<f64> {
        DriveSide {
            omega_d: omega,
            psi_slip: 0.0,
        }
    }
}

impl<C: Calc> SlipPast<C> {
    /// Of the coupling, and of the drive's side where it slips.
    pub(super) fn bars(&self) -> [Bar; 2] {
        [self.slip, self.way_d].map(|way| bar(way.value()))
    }
}

/// M_lim with the sign of what slips, in N·m, which the coupling passes on to what slews; `None` where it sticks.
fn limited<C: Calc>(coupling: &SlipCoupling<C>, past: &SlipPast<C>) -> Option<C> {
    match past.bars()[0] {
        Bar::Held | Bar::Loose => None,
        Bar::Forward => Some(coupling.m_lim),
        Bar::Backward => Some(-coupling.m_lim),
    }
}

/// What acts on all that slews: drive and brake themselves, or what a coupling that slips passes on.
pub fn passed_on<C: Calc>(
    motor: &SlewingDrive<C>,
    coupling: &Option<SlipCoupling<C>>,
    past: &Option<SlipPast<C>>,
) -> SlewingDrive<C> {
    let Some((coupling, past)) = coupling.as_ref().zip(past.as_ref()) else {
        return *motor;
    };
    match limited(coupling, past) {
        None => SlewingDrive {
            m_sl: motor.m_sl.over(coupling.m_lim),
            m_b_sl: motor.m_b_sl,
        },
        Some(moment) => SlewingDrive {
            m_sl: moment,
            m_b_sl: C::constant(0.0),
        },
    }
}

/// J_d of a drive that turns with what slews, in kg·m²; `None` where nothing does.
fn along<C: Calc>(coupling: &Option<SlipCoupling<C>>, past: &Option<SlipPast<C>>) -> Option<C> {
    let (coupling, past) = coupling.as_ref().zip(past.as_ref())?;
    (past.bars()[0] == Bar::Held).then_some(coupling.j_d)
}

/// J_sl, with J_d while the coupling sticks. [Ports001, 6.5.4]
pub fn carried_along<C: Calc>(
    turning: &Turning<C>,
    coupling: &Option<SlipCoupling<C>>,
    past: &Option<SlipPast<C>>,
) -> Turning<C> {
    along(coupling, past).map_or(*turning, |j_d| Turning {
        j_sl: turning.j_sl + j_d,
        ..*turning
    })
}

/// J, with J_d while the coupling sticks, in kg·m². [Ports001, 6.5.4]
pub fn all_along<C: Calc>(total: &C, coupling: &Option<SlipCoupling<C>>, past: &Option<SlipPast<C>>) -> C {
    along(coupling, past).map_or(*total, |j_d| *total + j_d)
}

/// M_c = M_sl − M_B − J_d ω̇ while it sticks and turns to the left; at rest the least by which both sides stay; ±M_lim while it
/// slips, in N·m. [Ports001, 6.5.4]
#[expect(clippy::too_many_arguments, reason = "all that it stands between")]
pub fn passing<C: Calc>(
    motor: &SlewingDrive<C>,
    coupling: &SlipCoupling<C>,
    slipping: &SlipPast<C>,
    turning: &Turning<C>,
    past: &Past<C>,
    stops: &Stops,
    outer: &Option<C>,
    led: Option<&Led<C>>,
    turned: &Turned<C>,
    psi: &C,
) -> C {
    let (none, bar) = (C::constant(0.0), past.bar());
    let moment = match (limited(coupling, slipping), bar) {
        (Some(moment), _) => moment,
        (None, Bar::Held) => {
            let without = needed(motor, outer, led) + motor.m_sl;
            let alone = SlewingDrive { m_b_sl: none, ..*motor };
            let [least, most] = joint(turning, stops).holds(*psi, &drive(&alone));
            let low = (motor.m_sl - motor.m_b_sl).greater(without - most);
            let high = (motor.m_sl + motor.m_b_sl).smaller(without - least);
            none.greater(low).smaller(high)
        }
        (None, _) => dry(none).resisted(motor.m_sl, bar, none, &drive(motor)) - coupling.j_d * turned.acceleration,
    };
    moment.def(&s::M_CD)
}

/// The drive's side: its brake's moment where the coupling slips, rates of its states, energy and heat.
#[derive(Clone, Copy, Debug)]
pub struct DriveRates<C> {
    braking: C,
    pub(super) acceleration: C,
    slipping: C,
    power: C,
    energy: C,
    heat: C,
}
results! { DriveRates as d => {
    M_RD: d.braking;
    D_OMEGA_D: d.acceleration;
    D_PSI_SLIP: d.slipping;
    P_SLIP: d.power;
    E_D: d.energy;
    W_SLIP: d.heat;
} }

impl<C: Calc> DriveRates<C> {
    /// ω̇_d = (M_sl + M_Rd − M_c) / J_d while it slips, as all that slews while it sticks; P = M_c (ω_d − ω), W = M_lim ψ_slip,
    /// E = J_d ω_d² / 2. [Ports001, 6.5.4]
    pub fn new(
        motor: &SlewingDrive<C>,
        coupling: &SlipCoupling<C>,
        slipping: &SlipPast<C>,
        side: &DriveSide<C>,
        passing: &C,
        turned: &Turned<C>,
        omega: &C,
    ) -> DriveRates<C> {
        let (none, [slip, bar]) = (C::constant(0.0), slipping.bars());
        let stuck = DriveRates {
            braking: none,
            acceleration: turned.acceleration,
            slipping: none,
            power: none,
            energy: (C::constant(0.5) * coupling.j_d * side.omega_d.square()).def(&s::E_D),
            heat: (coupling.m_lim * side.psi_slip).def(&s::W_SLIP),
        };
        if slip == Bar::Held {
            return stuck;
        }
        let (against, apart) = (motor.m_sl - *passing, side.omega_d - *omega);
        let braking = match bar {
            Bar::Held => -against,
            _ => dry(none).resistance(bar, side.omega_d, &drive(motor)),
        };
        let acceleration = match bar {
            Bar::Held => none,
            _ => (against + braking) / coupling.j_d,
        };
        DriveRates {
            braking: braking.def(&s::M_RD),
            acceleration: acceleration.def(&s::D_OMEGA_D),
            slipping: if slip == Bar::Forward { apart } else { -apart }.def(&s::D_PSI_SLIP),
            power: (*passing * apart).def(&s::P_SLIP),
            ..stuck
        }
    }
}
