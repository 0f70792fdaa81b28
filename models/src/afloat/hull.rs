//! The shape of the hull and of its tanks.

use std::sync::Arc;

use crate::afloat::cases::{PlannedCases, acting};
use crate::afloat::symbols as s;
use crate::afloat::weights::TankGiven;
use crate::kernel::calc::Calc;
use crate::kernel::group::{One, group, quantities};
use crate::kernel::variable::Fault;
use crate::parts::cut::Cut;
use crate::parts::solid::{Solid, TriangleMesh, level};

quantities! {
    /// A hull that is a box, around the origin.
    BoxHull { l: L, b: B, d: D }
}

quantities! {
    /// A rectangular compartment within the hull that is open to the water.
    FloodedSpace { mu_f: MU_F, l_f: L_F, b_f: B_F, d_f: D_F, x_f: X_F, y_f: Y_F, z_f: Z_F }
}

/// Its walls, and the share of it that water fills.
#[derive(Clone, Debug)]
pub struct OpenSpace<C> {
    walls: Solid<C>,
    share: C,
}

/// The sections of a hull: corners and faces, and the deck's edge on the left by its corners, from the stern to the bow.
#[derive(Clone, Debug)]
pub struct Offsets {
    pub mesh: Arc<TriangleMesh>,
    /// Points of a section on one side.
    pub half: usize,
}
group!(Offsets);

/// A tank: its walls, weight of its liquid for a volume (N/m³), volume of the liquid (m³), its centre and the middle of its
/// surface, the hull upright, and its length, breadth and depth (m).
#[derive(Clone, Debug)]
pub struct BallastTank<C> {
    pub walls: Solid<C>,
    pub weight: C,
    pub volume: C,
    pub centre: [C; 3],
    surface: [C; 3],
    size: [C; 3],
}

impl<C: Calc> BallastTank<C> {
    /// With its surface at slopes along and across: how far the moments of its volume have gone from those of the upright hull
    /// (m⁴), and the second moments of the surface about its own centre (m⁴).
    pub fn leaning(&self, [a, b]: [C; 2]) -> ([C; 3], [C; 3]) {
        let slopes = [a.value(), b.value()];
        let [length, breadth, depth] = self.size;
        let rises = [slopes[0] * length.value(), slopes[1] * breadth.value()].map(f64::abs);
        let depth = depth.value();
        let filled = 2.0 * (self.surface[2] - self.centre[2]).value();
        let (low, full) = (filled.min(depth - filled), 2.0 * filled > depth);
        if rises[0] + rises[1] < 2.0 * low {
            // It meets walls alone, and turns about its middle.
            let area = (length * breadth).scaled(1.0 / 12.0);
            let (along, across) = (area * length.square(), area * breadth.square());
            let up = (a.square() * along + b.square() * across).scaled(0.5);
            return ([a * along, b * across, up], [along, C::constant(0.0), across]);
        }
        // Looked for from that of a tank that leans to one side alone: a trapezium, a triangle or a parallelogram below it.
        let rise = rises[0].max(rises[1]);
        let over = if rise < 2.0 * low {
            low
        } else if 2.0 * rise * low < depth * depth {
            f64::sqrt(2.0 * rise * low) - 0.5 * rise
        } else {
            0.5 * depth + rise * (low / depth - 0.5)
        };
        let [x, y, z] = self.surface.map(|x| x.value());
        let over = if full { depth - over } else { over };
        let near = z - filled + over - slopes[0] * x - slopes[1] * y;
        let walls = self.walls.map(&mut |x| x.value());
        let level = C::constant(walls.level(slopes, self.volume.value(), near));
        let found = self.walls.cut([level, a, b]);
        // What is missing lies at the surface: a last step of Newton's method, which brings the derivatives.
        let short = self.volume - found.volume;
        let [x, y] = found.first.map(|first| first / found.area);
        let at = [x, y, level + a * x + b * y];
        let moved = [0, 1, 2].map(|i| found.moment[i] + short * at[i] - self.volume * self.centre[i]);
        (moved, found.central())
    }
}

/// Hull and tanks, and the weight of the water for a volume, in N/m³.
#[derive(Clone, Debug)]
pub struct Floating<C> {
    pub hull: Solid<C>,
    pub tanks: Vec<BallastTank<C>>,
    pub water: C,
    open: Vec<OpenSpace<C>>,
    /// Points of a section on one side, where it has sections.
    half: usize,
}

impl<C: Calc> Floating<C> {
    pub fn new(
        built: &Option<BoxHull<C>>,
        offsets: &Option<Offsets>,
        tanks: &[TankGiven<C>],
        flooded: &[FloodedSpace<C>],
        planned: &PlannedCases,
        density: &One<C>,
        gravity: &One<C>,
    ) -> Result<Floating<C>, Fault> {
        let zero = C::constant(0.0);
        let hull = match (built, offsets) {
            (Some(hull), _) => Solid::cuboid([zero; 3], [hull.l, hull.b, hull.d]),
            (_, Some(offsets)) => Solid::Mesh(offsets.mesh.clone()),
            _ => return Err(Fault::new("a hull is a box or has sections")),
        };
        let tank = |tank: &TankGiven<C>| {
            let half = tank.h_t / C::constant(2.0);
            let volume = tank.l_t * tank.b_t * tank.h_t;
            BallastTank {
                walls: Solid::cuboid([tank.x_t, tank.y_t, tank.z_t], [tank.l_t, tank.b_t, tank.d_t]),
                weight: tank.rho_t * **gravity,
                volume,
                centre: [tank.x_t, tank.y_t, tank.z_t + half],
                surface: [tank.x_t, tank.y_t, tank.z_t + tank.h_t],
                size: [tank.l_t, tank.b_t, tank.d_t],
            }
        };
        Ok(Floating {
            hull,
            tanks: tanks.iter().map(tank).collect(),
            water: **density * **gravity,
            open: acting(flooded, &planned.flooded)
                .map(|space| OpenSpace {
                    walls: Solid::cuboid([space.x_f, space.y_f, space.z_f], [space.l_f, space.b_f, space.d_f]),
                    share: space.mu_f,
                })
                .collect(),
            half: offsets.as_ref().map_or(0, |offsets| offsets.half),
        })
    }

    /// Whether compartments are open to the water.
    pub fn is_open(&self) -> bool {
        !self.open.is_empty()
    }

    /// The same over another scalar.
    #[inline(never)]
    pub fn map<D>(&self, f: &mut dyn FnMut(C) -> D) -> Floating<D> {
        Floating {
            hull: self.hull.map(f),
            tanks: (self.tanks.iter())
                .map(|tank| BallastTank {
                    walls: tank.walls.map(f),
                    weight: f(tank.weight),
                    volume: f(tank.volume),
                    centre: tank.centre.map(&mut *f),
                    surface: tank.surface.map(&mut *f),
                    size: tank.size.map(&mut *f),
                })
                .collect(),
            water: f(self.water),
            open: (self.open.iter())
                .map(|space| OpenSpace {
                    walls: space.walls.map(f),
                    share: f(space.share),
                })
                .collect(),
            half: self.half,
        }
    }

    /// What bears below the plane `z = t + a x + b y`: the hull without what is open to the water (lost buoyancy).
    #[inline(never)]
    pub fn cut(&self, plane: [C; 3]) -> Cut<C> {
        let mut cut = self.hull.cut(plane);
        self.open
            .iter()
            .for_each(|space| cut.less(&space.walls.cut(plane), space.share));
        cut
    }

    /// Points of the deck's edge on the left, from stern to bow, in m.
    #[inline(never)]
    pub fn deck(&self) -> Vec<[C; 3]> {
        match &self.hull {
            Solid::Box(points) => vec![points[6], points[7]],
            Solid::Mesh(mesh) => (mesh.points.chunks(2 * self.half))
                .map(|section| section[self.half - 1].map(C::constant))
                .collect(),
        }
    }

    /// Of each section the upright part of its side at a draft (m): half breadth, lower and upper end; where the side is not
    /// upright both ends are the draft.
    #[inline(never)]
    pub fn sides(&self, draft: C) -> Vec<[C; 3]> {
        match &self.hull {
            Solid::Box(points) => vec![[points[7][1], points[3][2], points[7][2]]],
            Solid::Mesh(mesh) => {
                let side = |section: &[[f64; 3]]| {
                    let side = &section[..self.half];
                    let above = side.partition_point(|point| point[2] < draft.value());
                    let y = side.get(above)?[1];
                    if above == 0 {
                        return None;
                    }
                    let upright = |point: &&[f64; 3]| point[1] == y;
                    let below = side[..above].iter().rev().take_while(upright).last();
                    let top = side[above..].iter().take_while(upright).last();
                    let ends = below.zip(top).map(|(below, top)| [below[2], top[2]].map(C::constant));
                    let [low, high] = ends.unwrap_or([draft; 2]);
                    Some([C::constant(y), low, high])
                };
                mesh.points.chunks(2 * self.half).filter_map(side).collect()
            }
        }
    }
}

impl Floating<f64> {
    /// As [`level`], of a volume (m³) that bears.
    #[must_use]
    pub fn level(&self, slopes: [f64; 2], volume: f64, from: Option<f64>) -> f64 {
        level(self.hull.heights(slopes), slopes, volume, from, |plane| self.cut(plane))
    }
}
