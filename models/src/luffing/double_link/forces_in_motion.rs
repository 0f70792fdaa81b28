//! The forces in the pins, of the frame, of drive and balance while the mechanism moves: equilibrium of each body under
//! its weight, its inertia and the rope as it hangs. [Newton and Euler]
//!
//! In the plane of the mechanism, also where it slews: what acts across that plane is not told.

use crate::balance::symbols as b;
use crate::component::outline::joined;
use crate::drive::hauling::Pushes;
use crate::drive::line::force;
use crate::kernel::calc::Calc;
use crate::kernel::symbol::Symbol;
use crate::luffing::double_link::linkage::HeavyLinkage;
use crate::luffing::double_link::moving::symbols as s;
use crate::luffing::double_link::pins_in_motion::PinsInMotion;
use crate::luffing::double_link::pose::{PosedLinkage, Posing};
use crate::luffing::double_link::symbols as g;
use crate::luffing::led::pull::{self, Hauled, named};
use crate::luffing::led::symbols as w;
use crate::luffing::moving::balance_in_motion::BalanceInMotion;
use crate::luffing::moving::dynamics::Coordinate;
use crate::luffing::moving::inertia_forces::hanging;
use crate::luffing::moving::level::{CraneAt, Level};
use crate::luffing::moving::shares::Instant;
use crate::parts::plane::Point;

/// Forces in motion, in N; moments in N·m.
#[derive(Clone, Copy, Debug)]
pub struct ForcesInMotion<C> {
    /// `None` where bars lie in one line.
    pub pins: Option<PinsInMotion<C>>,
    /// Force of the drive, push positive; where there is one.
    pub f_d: Option<C>,
    pub balance: Option<BalanceInMotion<C>>,
    /// Pull of a led hoist rope (N), and what it does to boom, jib and rocker.
    pub rope: Option<(C, [Hauled<C>; 3])>,
    pub at: Instant<C>,
}

/// Results in motion in the place of those at rest, and those that only motion has.
pub const RESULTS: [&Symbol; 31] = joined(OWN, pull::RESULTS);

const OWN: [&Symbol; 21] = [
    &g::F_BX,
    &g::F_BY,
    &g::F_CX,
    &g::F_CY,
    &g::F_O1X,
    &g::F_O1Y,
    &g::F_O3X,
    &g::F_O3Y,
    &g::N_3,
    &g::M_D,
    &g::F_D,
    &b::N_1,
    &b::F_KX,
    &b::F_KY,
    &b::F_MX,
    &b::F_MY,
    &s::F_AX,
    &s::F_AY,
    &s::M_RC,
    &s::M_RV,
    &s::M_RS,
];

impl<C: Copy> Pushes<C> for ForcesInMotion<C> {
    fn f_d(&self) -> Option<C> {
        self.f_d
    }
}

impl<C: Posing<C> + Coordinate<C>> ForcesInMotion<C> {
    /// Of a crane at an instant; `None` where linkage or balance do not close.
    pub fn of(level: &Level<C>, linkage: &HeavyLinkage<C>, at: &CraneAt<C>) -> Option<ForcesInMotion<C>> {
        let pose = C::pose(linkage, at.y[0], level.dynamics().turns())?;
        let arm = pose.drive.map_or(C::constant(0.0), |(_, [_, arm])| arm);
        let instant = level.instant(at, arm)?;
        let instant = match pose.load.filter(|_| instant.pull.is_none()) {
            Some((mass, places)) => {
                let axis = level.dynamics().turns().map(|table| table.axis);
                let reach = axis.map_or(C::constant(0.0), |axis| places[0].x - axis);
                hanging(instant, (mass, places), reach, linkage.bodies.gravity)
            }
            None => instant,
        };
        Some(ForcesInMotion::new(&pose, &instant, linkage.bodies.gravity))
    }
}

impl<C: Calc> ForcesInMotion<C> {
    /// With gravity in m/s².
    pub fn new(pose: &PosedLinkage<C>, at: &Instant<C>, gravity: C) -> ForcesInMotion<C> {
        let balance = pose.counterweight.map(|it| BalanceInMotion::new(&it, at, gravity));
        let m_d = at.shares.drive.def(&g::M_D);
        let f_d = pose
            .drive
            .map(|(_, sizes)| at.shares.push.unwrap_or_else(|| force(m_d, sizes, &g::F_D)));
        let rope = pose.rope.as_ref().map(|rope| {
            let s_h = (at.tension.unwrap_or(C::constant(0.0)) / rope.falls).def(&w::S_H);
            (s_h, named(rope.each.map(|bar| bar.under(s_h))))
        });
        let on_bars = rope.as_ref().map(|(_, on)| on);
        let pins = !pose.position.is_in_line();
        let pins = pins.then(|| PinsInMotion::new(pose, at, gravity, balance.as_ref(), f_d, on_bars));
        ForcesInMotion {
            pins,
            f_d,
            balance,
            rope,
            at: *at,
        }
    }

    /// How far the moment on the driving link by equilibrium is from that of drive, friction and end stop, and the
    /// greatest of what they are made of; `None` where bars lie in one line.
    pub fn apart(&self) -> Option<[f64; 2]> {
        let PinsInMotion { on_jib, lift, .. } = self.pins.as_ref()?;
        let (acting, greatest) = self.at.shares.acting();
        let greatest = greatest.max(*lift).max(on_jib.m_d.value().abs());
        Some([(on_jib.m_d - acting).value().abs(), greatest])
    }

    /// The [results](RESULTS), as far as there are any.
    pub fn results(&self) -> [Option<C>; RESULTS.len()] {
        let rope = self.rope.map(|(s_h, on)| pull::results(s_h, &on).map(Some));
        joined(self.own(), rope.unwrap_or_default())
    }

    fn own(&self) -> [Option<C>; OWN.len()] {
        let parts = |point: Option<Point<C>>| [point.map(|p| p.x), point.map(|p| p.y)];
        let pins = self.pins.as_ref();
        let [b, c] = [parts(pins.map(|it| it.on_jib.b)), parts(pins.map(|it| it.on_jib.c))];
        let [o1, o3] = [parts(pins.map(|it| it.o1)), parts(pins.map(|it| it.o3))];
        let rod = self.balance.and_then(|it| it.rod);
        let [k, m] = [parts(self.balance.map(|it| it.on_boom)), parts(rod.map(|rod| rod.1))];
        let (pull, shares) = (parts(self.at.pull), &self.at.shares);
        [
            b[0],
            b[1],
            c[0],
            c[1],
            o1[0],
            o1[1],
            o3[0],
            o3[1],
            pins.map(|it| it.n_3),
            Some(shares.drive),
            self.f_d,
            rod.map(|rod| rod.0),
            k[0],
            k[1],
            m[0],
            m[1],
            pull[0],
            pull[1],
            Some(shares.dry),
            Some(shares.viscous),
            Some(shares.stop),
        ]
    }
}
