//! The trolley in motion with its load as a pendulum: it follows its command, the load sways behind it.

use crate::bridge::bodies::motion::SlungTurning;
use crate::bridge::bodies::posture::SlungLoad;
use crate::bridge::bodies::pulls::SlungPulls;
use crate::bridge::given::{BridgeTrolley, TrolleyCommand};
use crate::bridge::suspension::{FourRopes, RopesLength, Suspended};
use crate::bridge::symbols as s;
use crate::bridge::trolley::TravelForces;
use crate::component::stages::results;
use crate::kernel::calc::Calc;
use crate::kernel::group::One;
use crate::parts::travel::{at_motor, sense};
use crate::sway::pendulum::{Damped, Feedback, HungLoad, SwayingLoad, Swung};

/// Length of the ropes, in m: given, or a state.
pub fn length<C: Calc>(
    ropes: &Option<RopesLength<C>>,
    swaying: &Option<SwayingLoad<C>>,
    hung: &Option<SlungLoad<C>>,
) -> C {
    let given = ropes.map(|ropes| ropes.l).or(swaying.map(|load| load.l));
    let given = given.or(hung.map(|load| load.l));
    given.unwrap_or(C::constant(0.0))
}

/// The trolley follows its command: rates of its place and of its speed.
#[derive(Clone, Copy, Debug)]
pub struct Travelling<C>([C; 2]);
results! { Travelling as t => { D_X_T: t.0[0]; D_V_T: t.0[1]; } }

/// With its speed (m/s) and acceleration (m/s²), as it answers.
pub fn travelling<C: Calc>(_: &Feedback<C>, speed: &One<C>, answer: &C) -> Travelling<C> {
    Travelling([**speed, *answer])
}

/// What the trolley is told, and what it answers to the sway, of a spreader with slings to its own, in m/s².
pub fn answer<C: Calc>(
    feedback: &Feedback<C>,
    swaying: &Option<SwayingLoad<C>>,
    hung: &Option<SlungLoad<C>>,
    turning: Option<&SlungTurning<C>>,
    command: &TrolleyCommand<C>,
    gravity: &One<C>,
    hanging: &Suspended<C>,
) -> C {
    let reeling = -hanging.slope * command.v_h;
    let spreader = hung.zip(turning).map(|(load, turning)| SwayingLoad {
        phi: load.phi,
        omega: turning.omega[0],
        l: load.l,
    });
    let Some(load) = &swaying.or(spreader) else {
        return command.a;
    };
    feedback.answer(command.a, load, **gravity, [hanging.length, reeling])
}

/// Small sway on the four ropes under feedback, of spreader and load as one body.
pub fn damped<C: Calc>(feedback: &Feedback<C>, _: &SwayingLoad<C>, hanging: &Suspended<C>) -> Damped<C> {
    Damped::new(feedback, hanging.frequency, Some(hanging.felt))
}

/// The load as it sways on its four ropes.
#[expect(clippy::too_many_arguments, reason = "all that moves it")]
pub fn swung<C: Calc>(
    load: &SwayingLoad<C>,
    command: &TrolleyCommand<C>,
    gravity: &One<C>,
    place: &One<C>,
    weight: &C,
    ropes: &FourRopes<C>,
    hanging: &Suspended<C>,
    answer: &C,
) -> Swung<C> {
    let pendulum = HungLoad {
        length: hanging.length,
        slope: hanging.slope,
        felt: hanging.felt,
        deep: hanging.height + ropes.e_q,
    };
    Swung::new(load, [*answer, command.v_h], gravity, **place, *weight, &pendulum)
}

/// The travel drive in motion: its force (N) and its motor's power (W).
#[derive(Clone, Copy, Debug)]
pub struct DriveInMotion<C>([C; 2]);
results! { DriveInMotion as d => { F_DR: d.0[0]; P_DR: d.0[1]; } }

impl<C: Calc> DriveInMotion<C> {
    /// F_dr = ±(F_μ + F_w + F_s) + F_γ + G_t a/g − F_φ; P = F v/η where it drives, F v η where it brakes. [Newton and Euler]
    pub fn new(
        unit: &BridgeTrolley<C>,
        gravity: &One<C>,
        speed: &One<C>,
        forces: &TravelForces<C>,
        swung: Option<&Swung<C>>,
        pulls: Option<&SlungPulls<C>>,
        answer: &C,
    ) -> DriveInMotion<C> {
        let pull = swung
            .map(|swung| swung.pull_along)
            .or(pulls.map(|pulls| pulls.pull_along));
        let inertia = unit.g_t / **gravity * *answer - pull.unwrap_or(C::constant(0.0));
        let sense = sense(speed.value(), answer.value());
        let force = forces.with(inertia, sense).over(**speed).def(&s::F_DR);
        DriveInMotion([force, at_motor(force * **speed, unit.eta_d).def(&s::P_DR)])
    }
}
