//! Solids bounded by triangles, cut by the plane of a liquid: exact at any level and slope.
//!
//! The liquid stands at `z = t + a x + b y`. Sheared along z by that plane the solid keeps its volumes, and each triangle below
//! the plane bounds a tetrahedron with a corner in it: the lid on the plane adds nothing, and no polygon is closed.

use std::convert::Infallible;
use std::sync::Arc;

use crate::kernel::calc::Calc;
use crate::parts::bracket::bracketed;
use crate::parts::cut::Cut;

/// A triangle by the places of its corners, counter-clockwise seen from outside.
pub type Triangle = [u16; 3];

/// Corners (m) and faces that a scene gives.
#[derive(Debug)]
pub struct TriangleMesh {
    pub points: Vec<[f64; 3]>,
    pub faces: Vec<Triangle>,
}

/// The faces of a box, whose corners are numbered by bits: 1 forward, 2 to the left, 4 at the top.
const BOX: [Triangle; 12] = [
    [0, 2, 3],
    [0, 3, 1],
    [4, 5, 7],
    [4, 7, 6],
    [0, 1, 5],
    [0, 5, 4],
    [2, 6, 7],
    [2, 7, 3],
    [0, 4, 6],
    [0, 6, 2],
    [1, 3, 7],
    [1, 7, 5],
];

/// The corner of a triangle that is alone on its side of the plane, by bits of those below it.
const ALONE: [usize; 8] = [0, 0, 1, 2, 2, 1, 0, 0];

/// The last step to a level leaves the square of this, as part of the solid's height: whoever needs more goes one step more of
/// Newton's method.
const NEAR: f64 = 1e-6;

/// A body that a plane cuts.
#[derive(Clone, Debug)]
pub enum Solid<C> {
    Box([[C; 3]; 8]),
    Mesh(Arc<TriangleMesh>),
}

/// Where the line from a point below the plane to one above it, or back, meets it.
#[inline]
fn met<C: Calc>(p: [C; 3], q: [C; 3]) -> [C; 3] {
    let part = p[2] / (p[2] - q[2]);
    [
        p[0] + (q[0] - p[0]) * part,
        p[1] + (q[1] - p[1]) * part,
        C::constant(0.0),
    ]
}

impl<C: Calc> Solid<C> {
    /// Of a length, a breadth and a height (m), around the middle of its bottom.
    pub fn cuboid([x, y, z]: [C; 3], [length, breadth, height]: [C; 3]) -> Solid<C> {
        let side = |middle: C, whole: C, more: bool| {
            let half = whole.scaled(0.5);
            if more { middle + half } else { middle - half }
        };
        Solid::Box(std::array::from_fn(|corner| {
            let top = if corner & 4 == 0 { z } else { z + height };
            [side(x, length, corner & 1 != 0), side(y, breadth, corner & 2 != 0), top]
        }))
    }

    /// The same over another scalar.
    #[inline(never)]
    pub fn map<D>(&self, f: &mut dyn FnMut(C) -> D) -> Solid<D> {
        match self {
            Solid::Box(points) => Solid::Box(points.map(|point| point.map(&mut *f))),
            Solid::Mesh(mesh) => Solid::Mesh(mesh.clone()),
        }
    }

    /// Its corners from the plane, sheared, and its faces, for as long as they are asked for.
    fn sheared<R>(&self, [t, a, b]: [C; 3], f: impl FnOnce(&[[C; 3]], &[Triangle]) -> R) -> R {
        let from = |[x, y, z]: [C; 3]| [x, y, z - t - a * x - b * y];
        let meshed: Vec<[C; 3]>;
        let boxed: [[C; 3]; 8];
        let (points, faces): (&[[C; 3]], &[Triangle]) = match self {
            Solid::Box(points) => {
                boxed = points.map(from);
                (&boxed, &BOX)
            }
            Solid::Mesh(mesh) => {
                meshed = (mesh.points.iter()).map(|point| from(point.map(C::constant))).collect();
                (&meshed, &mesh.faces)
            }
        };
        f(points, faces)
    }

    /// Least and greatest height of a corner over the plane of these slopes through the origin.
    #[must_use]
    #[inline(never)]
    pub fn heights(&self, [a, b]: [C; 2]) -> [f64; 2] {
        self.sheared([C::constant(0.0), a, b], |points, _| {
            let heights = points.iter().map(|point| point[2].value());
            heights.fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], z| {
                [low.min(z), high.max(z)]
            })
        })
    }

    /// What lies below the plane `z = t + a x + b y`.
    #[inline(never)]
    pub fn cut(&self, plane: [C; 3]) -> Cut<C> {
        self.sheared(plane, |points, faces| {
            let mut found = Cut::nothing();
            for face in faces {
                let wet = |i: usize| usize::from(points[usize::from(face[i])][2].value() < 0.0) << i;
                let wet = wet(0) | wet(1) | wet(2);
                let [p, q, r] = [0, 1, 2].map(|i| points[usize::from(face[(ALONE[wet] + i) % 3])]);
                match wet.count_ones() {
                    0 => {}
                    1 => {
                        let (u, v) = (met(p, q), met(p, r));
                        found.piece([p, u, v]);
                        found.side(v, u);
                    }
                    2 => {
                        let (u, v) = (met(q, p), met(r, p));
                        found.piece([u, q, r]);
                        found.piece([u, r, v]);
                        found.side(u, v);
                    }
                    _ => found.piece([p, q, r]),
                }
            }
            found.done(plane)
        })
    }
}

impl Solid<f64> {
    /// As [`level`], of a volume (m³) of this solid.
    #[must_use]
    #[inline(never)]
    pub fn level(&self, slopes: [f64; 2], volume: f64, from: f64) -> f64 {
        level(self.heights(slopes), slopes, volume, Some(from), |plane| {
            self.cut(plane)
        })
    }
}

/// Level (m) of the plane of slopes below which a volume (m³) lies, to a part of the heights (m) between which it is sought:
/// Newton's method from a level (m), or from the middle, between ends that close in. The whole, or nothing of it, where there is not as much.
pub fn level(
    [low, high]: [f64; 2],
    [a, b]: [f64; 2],
    volume: f64,
    from: Option<f64>,
    below: impl Fn([f64; 3]) -> Cut<f64>,
) -> f64 {
    let from = from.filter(|from| *from > low && *from < high);
    let from = from.unwrap_or(f64::midpoint(low, high));
    let short = |level: f64| {
        let cut = below([level, a, b]);
        Ok::<_, Infallible>([volume - cut.volume, -cut.area])
    };
    match bracketed([low, high], from, NEAR * (high - low), short) {
        Ok(level) => level,
    }
}
