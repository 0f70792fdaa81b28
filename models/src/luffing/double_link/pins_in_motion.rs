//! Forces in the pins and of the frame while the mechanism moves: equilibrium of jib, rocker and boom under their weights,
//! their inertia and the rope. [Newton and Euler]

use crate::kernel::calc::Calc;
use crate::luffing::double_link::moving::symbols as s;
use crate::luffing::double_link::parameters::Driven;
use crate::luffing::double_link::pin_forces::{JibLoad, MomentNames, PinForces};
use crate::luffing::double_link::pose::PosedLinkage;
use crate::luffing::double_link::symbols as g;
use crate::luffing::led::pull::Hauled;
use crate::luffing::moving::balance_in_motion::BalanceInMotion;
use crate::luffing::moving::inertia_forces::PosedBody;
use crate::luffing::moving::shares::Instant;
use crate::parts::plane::{self, Point, cross, dot};

/// What the pins and the frame carry.
#[derive(Clone, Copy, Debug)]
pub struct PinsInMotion<C> {
    /// On the jib; with the moment on the driving link that equilibrium asks for.
    pub on_jib: PinForces<C>,
    /// Of the frame on boom and rocker.
    pub o1: Point<C>,
    pub o3: Point<C>,
    /// Axial force in the rocker at C, tension positive.
    pub n_3: C,
    /// What cancels to the moment on the driving link, in N·m: its length times the force in its pin, or what the boom's
    /// own weight and inertia have about its foot, if that is more; the nearer to a dead point the more of it is lost.
    pub lift: f64,
}

const NAMES: MomentNames = MomentNames {
    about: [&s::M_IB, &s::M_IC],
    driven: &s::M_T,
};

impl<C: Calc> PinsInMotion<C> {
    /// Without what the balance carries, with the force of the drive along its line (N) and what a led rope does to the bars, where
    /// there are any.
    pub fn new(
        pose: &PosedLinkage<C>,
        at: &Instant<C>,
        gravity: C,
        balance: Option<&BalanceInMotion<C>>,
        f_d: Option<C>,
        rope: Option<&[Hauled<C>; 3]>,
    ) -> PinsInMotion<C> {
        let p = &pose.position;
        let [boom, jib, rocker] = &pose.bodies;
        let on = |body: &PosedBody<C>, names| body.force(at, gravity, names);
        let f_1 = on(boom, [&s::F_1X, &s::F_1Y]);
        let f_2 = on(jib, [&s::F_2X, &s::F_2Y]);
        let f_3 = on(rocker, [&s::F_3X, &s::F_3Y]);
        let about_b = jib.moment(at, f_2);
        let (on_jib, about_b) = match at.pull {
            Some(pull) => (f_2 + pull, about_b - cross(p.a - p.b, pull)),
            None => (f_2, about_b),
        };
        let own = boom.moment(at, f_1);
        let m_1 = balance.map_or(own, |balance| own - balance.moment).def(&s::M_I1);
        let m_3 = rocker.moment(at, f_3).def(&s::M_I3);
        let jib = JibLoad {
            down: -on_jib.y,
            forward: Some(on_jib.x),
            about_b,
        };
        let on_jib = match rope {
            None => PinForces::under(p, &jib, [Some(m_1), Some(m_3)], &NAMES),
            Some(rope) => PinForces::led(p, &jib, [Some(m_1), Some(m_3)], rope, &NAMES),
        };
        let by_rope = |force: Point<C>, bar: usize| rope.map_or(force, |rope| force - rope[bar].force);
        // Where no force gives the moment the drive is taken as a mere moment.
        let push = pose.drive.zip(f_d.filter(|f_d| f_d.value().is_finite()));
        let push = push.map(|((line, [length, _]), f_d)| line.map(|x| f_d * x / length));
        let by_drive = |force: Point<C>, driven| match push {
            Some(push) if p.driven == driven => force - push,
            _ => force,
        };
        let o1 = balance.map_or(on_jib.b - f_1, |balance| on_jib.b - f_1 - balance.on_boom);
        let o1 = plane::def(by_drive(by_rope(o1, 0), Driven::Boom), [&g::F_O1X, &g::F_O1Y]);
        let o3 = by_rope(on_jib.c - f_3, 2);
        let o3 = plane::def(by_drive(o3, Driven::Rocker), [&g::F_O3X, &g::F_O3Y]);
        let n_3 = (-(dot(on_jib.c, p.x_3) / pose.x_3)).def(&g::N_3);
        let (bar, pin) = match p.driven {
            Driven::Boom => (p.x_1, on_jib.b),
            Driven::Rocker => (p.x_3, on_jib.c),
        };
        let lift = plane::length(bar.map(C::value)) * plane::length(pin.map(C::value));
        let lift = lift.max(own.value().abs()) / p.sine();
        PinsInMotion {
            on_jib,
            o1,
            o3,
            n_3,
            lift,
        }
    }
}
