//! What each corner bears: of a rigid portal on four legs or three, and of a hinged one.

use crate::component::stages::results;
use crate::kernel::calc::Calc;
use crate::kernel::group::One;
use crate::kernel::variable::Fault;
use crate::supports::portal::load::{Base, PortalMoments, SlewingLoad};
use crate::supports::portal::symbols as s;

/// A corner: whether it stands in front, and whether on the left rail.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct PortalCorner {
    pub front: bool,
    pub left: bool,
}

const fn corner(front: bool, left: bool) -> PortalCorner {
    PortalCorner { front, left }
}

/// By their numbers, counter-clockwise.
pub const CORNERS: [PortalCorner; 4] = [
    corner(true, false),
    corner(true, true),
    corner(false, true),
    corner(false, false),
];

/// The sum, or the difference where it is not on the positive side.
pub fn signed<C: Calc>(middle: C, aside: C, positive: bool) -> C {
    if positive { middle + aside } else { middle - aside }
}

/// What is found of each corner, in the order of their numbers.
pub fn all<C: Calc, T>(room: &mut Vec<T>, of: impl Fn(usize, PortalCorner) -> T) {
    room.clear();
    room.extend(
        CORNERS
            .iter()
            .enumerate()
            .map(|(at, corner)| C::body(at, || of(at, *corner))),
    );
}

/// N = V/4 ± M_y/(2a) ± M_x/(2b), in N, whatever its sign. [Ports001, 7.2]
pub fn four_legs<C: Calc>(base: &Base<C>, slewing: &SlewingLoad<C>, moments: &PortalMoments<C>, room: &mut Vec<C>) {
    all::<C, C>(room, |_, corner| {
        let quarter = slewing.force / C::constant(4.0);
        let along = moments.y / base.a.scaled(2.0);
        let across = moments.x / base.b.scaled(2.0);
        signed(signed(quarter, along, corner.front), across, corner.left).def(&s::N_4)
    });
}

/// The corner that bears least on four legs.
#[derive(Clone, Copy, Debug)]
pub struct Lowest<C> {
    load: C,
    part: C,
}
results! { Lowest as l => { N_LOW: l.load; Z_LIFT: l.part; } }

impl<C: Calc> Lowest<C> {
    /// min N_4, and its part of V.
    pub fn new(slewing: &SlewingLoad<C>, four: &[C]) -> Lowest<C> {
        let load = four.iter().copied().reduce(C::smaller).expect("four corners");
        Lowest {
            load: load.def(&s::N_LOW),
            part: load / slewing.force,
        }
    }
}

/// The leg that is lifted, by its place among the corners.
#[derive(Clone, Copy, Debug)]
pub struct LiftedLeg<C> {
    pub lifted: Option<usize>,
    least: C,
}
results! { LiftedLeg as b => {
    LIFTS: C::constant(f64::from(u8::from(b.lifted.is_some()))).over(b.least);
    LEG: C::constant(b.lifted.map_or(1, |leg| leg + 2) as f64).over(b.least);
} }

impl<C: Calc> LiftedLeg<C> {
    /// The leg that would have to pull is lifted: of a crane that stands it is one at most.
    ///
    /// # Errors
    /// Two would have to: the crane tips.
    pub fn new(
        base: &Base<C>,
        psi: &One<C>,
        load: &One<C>,
        slewing: &SlewingLoad<C>,
        moments: &PortalMoments<C>,
        four: &[C],
        lowest: &Lowest<C>,
    ) -> Result<LiftedLeg<C>, Fault> {
        let ends = [
            (
                moments.y,
                base.a,
                ["over its edge in front", "over its edge behind"],
                &s::M_Y,
                &s::A,
            ),
            (
                moments.x,
                base.b,
                ["over the left rail", "over the right rail"],
                &s::M_X,
                &s::B,
            ),
        ];
        for (moment, width, over, symbol, of) in ends {
            let (moment, holds) = (moment.value(), slewing.force.value() * width.value() / 2.0);
            if moment.abs() > holds {
                return Err(Fault::outside(format!(
                    "psi = {}: with Q = {} the crane tips {}: {} = {}, where V {}/2 = {} holds it; give less load, \
                     reach, counterweight or wind, or a greater {}",
                    s::PSI.written(psi.value()),
                    s::Q.written(load.value()),
                    over[usize::from(moment < 0.0)],
                    symbol.id,
                    symbol.written(moment),
                    of.id,
                    symbol.written(holds),
                    of.id,
                )));
            }
        }
        let pulls = (0..four.len()).filter(|&leg| four[leg].value() < 0.0);
        Ok(LiftedLeg {
            lifted: pulls.min_by(|&i, &j| four[i].value().total_cmp(&four[j].value())),
            least: lowest.load,
        })
    }
}

/// What the corners of the rigid portal bear, in N: of three legs by their equilibrium. [Ports001, 7.2]
pub fn rigid<C: Calc>(
    base: &Base<C>,
    slewing: &SlewingLoad<C>,
    moments: &PortalMoments<C>,
    four: &[C],
    bearing: &LiftedLeg<C>,
    room: &mut Vec<C>,
) {
    all::<C, C>(room, |at, own| {
        let Some(lifted) = bearing.lifted.map(|leg| CORNERS[leg]) else {
            return four[at].def(&s::N_R);
        };
        let half = slewing.force / C::constant(2.0);
        let (along, across) = (moments.y / base.a, moments.x / base.b);
        let found = match (own.front == lifted.front, own.left == lifted.left) {
            (true, true) => return C::constant(0.0).over(four[at]),
            // On the same rail, on the same end, and across from it.
            (false, true) => signed(half, across, own.left),
            (true, false) => signed(half, along, own.front),
            (false, false) => signed(signed(C::constant(0.0), along, own.front), across, own.left),
        };
        found.over(four[at]).greater(C::constant(0.0)).def(&s::N_R)
    });
}

/// N = V (1/2 ± M_y/(V a)) (1/2 ± M_x/(V b)), in N. [Ports001, 7.2]
pub fn hinged<C: Calc>(
    base: &Base<C>,
    slewing: &SlewingLoad<C>,
    moments: &PortalMoments<C>,
    _: &LiftedLeg<C>,
    room: &mut Vec<C>,
) {
    all::<C, C>(room, |_, corner| {
        let v = slewing.force;
        let half = C::constant(1.0) / C::constant(2.0);
        let along = signed(half, moments.y / (v * base.a), corner.front);
        let across = signed(half, moments.x / (v * base.b), corner.left);
        (v * along * across).def(&s::N_H)
    });
}
