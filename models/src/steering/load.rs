//! Vertical load of the groups and their resistance to steering. [Zhang2016, 3]

use crate::component::sheet::{Section, Table};
use crate::component::stages::results;
use crate::kernel::calc::Calc;
use crate::kernel::group::quantities;
use crate::kernel::number::short;
use crate::kernel::record::{Rec, record};
use crate::kernel::symbol::Symbol;
use crate::parts::plane::Point;
use crate::parts::springs::{SpringNames, Springs};
use crate::steering::cylinder::Pose;
use crate::steering::machine::Machine;
use crate::steering::refusal::Refusal;
use crate::steering::ring::{Bearing, friction};
use crate::steering::symbols as s;

quantities! {
    /// Vertical load of a group, in N.
    GroupLoad { g: G }
}

quantities! {
    /// Sliding friction between tyre and ground, tyre pressure (Pa), and how many
    /// times smaller the resistance is while travelling. The paper takes 0.7 on
    /// asphalt or concrete, and 2.5 out of 2 to 3.
    Tyre { f_t: F_T, p_t: P_T, k_v: K_V }
}

/// Moment, in N·m, that the tyres of a group set against steering, at standstill and while travelling.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Resistance<C> {
    pub standing: C,
    pub travelling: C,
}

/// T_r = f/3 · √(G³/p) at a load (N), and T_r/2.5 while travelling. [Zhang2016, 3]
#[inline]
pub fn resistance<C: Calc>(tyre: &Tyre<C>, g: C) -> Resistance<C> {
    let standing = (tyre.f_t / C::constant(3.0) * (g * g.square() / tyre.p_t).sqrt()).def(&s::T_R);
    Resistance {
        standing,
        travelling: (standing / tyre.k_v).def(&s::T_RX),
    }
}

/// What a group's cylinder works against, in N·m.
#[derive(Clone, Copy, Debug)]
pub struct Drag<C> {
    pub tyres: Resistance<C>,
    /// Of the slewing ring, where there is one; it stays while travelling.
    friction: Option<C>,
    /// At standstill.
    pub moment: C,
}
results! { each Drag as d => {
    T_R: d.tyres.standing;
    T_RX: d.tyres.travelling;
    T_G: d.moment;
} }

impl<C: Calc> Drag<C> {
    #[inline]
    pub fn new(tyre: &Tyre<C>, bearing: &Option<Bearing<C>>, load: &GroupLoad<C>) -> Drag<C> {
        let tyres = resistance(tyre, load.g);
        let friction = bearing.as_ref().map(|bearing| friction(bearing, load.g));
        Drag {
            tyres,
            friction,
            moment: with(tyres.standing, friction).def(&s::T_G),
        }
    }
}

fn with<C: Calc>(tyres: C, friction: Option<C>) -> C {
    friction.map_or(tyres, |friction| tyres + friction)
}

/// Force of a cylinder, in N, against a moment (N·m) at a lever arm (m): f_g = T_g/od. [Zhang2016, 5.2]
/// The arm is not zero within a range that [`Linkage::over`](crate::steering::cylinder::Linkage::over) accepts.
#[inline]
pub fn force<C: Calc>(t_g: C, od: C) -> C {
    t_g / od.abs()
}

/// Force of a group's cylinder at standstill, in N.
#[inline]
pub fn standing<C: Calc>(drag: &Drag<C>, pose: &Pose<C>) -> C {
    force(drag.moment, pose.od).def(&s::F_G)
}

/// The same while travelling.
pub fn travelling<C: Calc>(drag: &Drag<C>, pose: &Pose<C>) -> C {
    let moment = with(drag.tyres.travelling, drag.friction).def(&s::T_GX);
    force(moment, pose.od).def(&s::F_GX)
}

/// What the groups' springs are called.
static NAMES: SpringNames = SpringNames {
    count: &s::N_G,
    mean: [&s::X_S, &s::Y_S],
    sums: [&s::S_XX, &s::S_YY, &s::S_XY],
    eccentric: [&s::E_SX, &s::E_SY],
    apart: [&s::D_SX, &s::D_SY],
    tilt: None,
};

/// All groups as equal springs under a rigid frame.
fn on_springs<C: Calc>(groups: &[Point<C>]) -> Springs<C> {
    Springs::new(groups.iter().copied(), &NAMES)
}

/// How the load of the most heavily loaded group follows from a weight (N) at `centre` (m), for the book.
pub fn told(machine: &Machine<f64>, weight: f64, centre: Point<f64>) -> Section {
    let springs = on_springs(&machine.groups);
    let loads = machine.groups.iter().map(|p| springs.carry(weight, centre, *p));
    let rows = (1..).zip(&machine.groups).zip(loads);
    let rows: Vec<Vec<f64>> = rows.map(|((i, p), load)| vec![f64::from(i), p.x, p.y, load]).collect();
    let heaviest = (0..rows.len()).max_by(|i, j| rows[*i][3].total_cmp(&rows[*j][3]));
    let at = |[x, y]: [&'static Symbol; 2], p: &Point<f64>| Point::new(Rec::given(x, p.x), Rec::given(y, p.y));
    let (trace, ()) = record(|| {
        let groups: Vec<Point<Rec>> = machine.groups.iter().map(|p| at([&s::X, &s::Y], p)).collect();
        let (springs, centre) = (on_springs(&groups), at([&s::X_G, &s::Y_G], &centre));
        if let Some(i) = heaviest {
            let _ = springs.carry(Rec::given(&s::W, weight), centre, groups[i]).def(&s::G);
        }
    });
    Section {
        id: "loads",
        trace,
        table: Some(Table {
            columns: vec![&s::NUMBER, &s::X, &s::Y, &s::G],
            rows,
        }),
        ..Section::default()
    }
}

/// Load of each group, in N, for a weight (N) whose centre of gravity is at
/// `centre` (m), on a rigid frame over equal springs.
pub fn share(machine: &Machine<f64>, weight: f64, centre: Point<f64>, loads: &mut [f64]) -> Result<(), Refusal> {
    let springs = on_springs(&machine.groups);
    if springs.are_in_line() {
        return Err(Refusal::new(
            "groups",
            "all groups stand on one line: their loads do not follow from the centre of gravity",
            "give the load of each group",
        ));
    }
    for (i, (p, load)) in machine.groups.iter().zip(loads.iter_mut()).enumerate() {
        *load = springs.carry(weight, centre, *p);
        if *load < 0.0 {
            return Err(Refusal::new(
                format!("G[{}]", i + 1),
                format!("group {} would carry {} kN", i + 1, short(*load / 1e3)),
                format!(
                    "the centre of gravity ({}, {}) m lies too far out: bring it nearer to ({}, {}) m",
                    short(centre.x),
                    short(centre.y),
                    short(springs.mean.x),
                    short(springs.mean.y)
                ),
            ));
        }
    }
    Ok(())
}
