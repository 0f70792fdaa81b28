//! A mobile crane as a component: what it is given, and in which stages its equations follow from each other.

use crate::component::part::{Component, Port, ports};
use crate::component::stages::{Found, stages};
use crate::kernel::group::One;
use crate::kernel::symbol::{Symbol, listed};
use crate::parts::plane::Point;
use crate::parts::springs::Springs;
use crate::supports::mobile::bearing::{Bearable, Pad, SupportCapacity, SupportForce, bearing_springs, pressure};
use crate::supports::mobile::boom::{BoomPart, BoomShape, BoomWeight, HeadPose};
use crate::supports::mobile::chart::LoadChart;
use crate::supports::mobile::ground::GroundForce;
use crate::supports::mobile::limiter::Utilised;
use crate::supports::mobile::rating::{Permission, Rated, RatingBasis};
use crate::supports::mobile::strength::Strengths;
use crate::supports::mobile::symbols as s;
use crate::supports::mobile::tipping::{Sides, SupportPoint, Tipping, behind};
use crate::supports::mobile::weights::{
    CarrierBody, DeadWeight, Hook, Inclined, Leaning, Payload, UpperBody, WindOnLoad,
};
use crate::supports::plan::{LeftOpen, heading};

stages! {
    /// A mobile crane on its supports.
    MobileCrane over C from {
        Coordinate psi: One<C>,
        Rate omega: One<C>,
        Parameter angle: Option<One<C>>,
        Parameter reach: Option<One<C>>,
        Parameter length: One<C>,
        Parameter load: One<C>,
        Parameter hook: Hook<C>,
        Parameter points: Vec<SupportPoint<C>>,
        Parameter caps: Vec<SupportCapacity<C>>,
        Parameter pad: Option<Pad<C>>,
        Parameter carrier: Vec<CarrierBody<C>>,
        Parameter upper: Vec<UpperBody<C>>,
        Parameter shape: BoomShape<C>,
        Parameter parts: Vec<BoomPart<C>>,
        Parameter slope: Option<Inclined<C>>,
        Parameter wind: Option<WindOnLoad<C>>,
        Parameter basis: RatingBasis<C>,
        Parameter permission: Permission<C>,
        Fixed strengths: Strengths,
        Fixed chart: Option<LoadChart>,
        Fixed open: LeftOpen,
    } find {
        sides: Sides<C> = Sides::new(points) => _;
        pose: HeadPose<C> = HeadPose::new(shape, length, angle, reach);
        boom: BoomWeight<C> = BoomWeight::new(parts, length, pose);
        dead: DeadWeight<C> = DeadWeight::new(carrier, upper, shape, pose, boom);
        leaning: Leaning<C> = Leaning::new(slope, wind, pose, dead);
        heading: Point<C> = heading(psi) => _;
        tipping: Tipping<C> = Tipping::new(points, sides, heading, dead, leaning);
        behind: C = behind(points, sides, heading, dead, leaning) => S_BACK;
        payload: Payload<C> = Payload::new(load, hook);
        bearable: Bearable<C> = Bearable::new(points, caps, heading, dead, leaning);
        rated: Rated<C> =
            Rated::new(basis, permission, hook, strengths, tipping, behind, boom, pose, length, bearable);
        utilised: Utilised<C> = Utilised::new(permission, payload, rated, chart, pose, length);
        ground: GroundForce<C> = GroundForce::new(sides, heading, dead, leaning, payload);
        springs: Springs<C> = bearing_springs(psi, points, ground, tipping, payload) => _;
        forces[each points]: Vec<SupportForce<C>> = SupportForce::new(springs, ground, points[each]);
        pressures[each points]: Vec<C> = pressure(forces[each], pad[!]) => P_G;
    }
}

impl Component for MobileCrane {
    const INDICATORS: &'static [&'static Symbol] = listed!(s: Z_WARN, Z_STOP);

    const PORTS: &'static [Port] = ports! { s:
        axis "Slewing axis.": phi PSI, w OMEGA;
        head "Boom head, where the load hangs.": r R, z H_A, f Q;
        support "A support on the ground.": x X, y Y, f N;
    };

    /// What is given is no result, and what slope, wind and chart would change is none without them.
    fn has(given: &Given<f64>, symbol: &'static Symbol) -> bool {
        let there = |of: &[&'static Symbol]| of.contains(&symbol);
        let inclined = given.slope.is_some() || !there(listed!(s: M_E, M_R));
        let moved = given.slope.is_some() || given.wind.is_some() || !there(listed!(s: R_E));
        let charted = given.chart.is_some() || !there(listed!(s: Q_CH, ETA_CH));
        let capped = !given.caps.is_empty() || symbol != &s::Q_N;
        let strong = !given.strengths.0.is_empty() || !there(listed!(s: Q_S));
        let own = if given.angle.is_some() { &s::PHI } else { &s::R };
        inclined && moved && charted && capped && strong && symbol != own
    }

    fn is_input(given: &Given<f64>, symbol: &'static Symbol) -> bool {
        given.open.0.contains(&symbol)
    }

    fn update(known: &mut Known<f64>) -> Found<()> {
        known.rated().map(|_| ())
    }
}
