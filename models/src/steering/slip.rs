//! Tyre slip from angles that are not quite right.

use nalgebra::{Matrix3, Vector3};

use crate::kernel::calc::Calc;
use crate::parts::plane::{self, Point};
use crate::steering::centre::Centre;
use crate::steering::machine::{GROUPS, Machine};

/// How the machine moves when its groups err, and what the tyres make of it.
#[derive(Clone, Copy, Debug)]
pub struct Slip {
    /// What the machine's motion gains: velocity of its middle (m/s) and angular velocity (rad/s).
    pub drift: Point<f64>,
    pub turn: f64,
    /// Root mean square of the sideways speed of the groups, in m/s.
    pub rms: f64,
}

impl Slip {
    /// The machine moves so that the squares of the groups' sideways speeds are
    /// least, with its mean rolling speed kept. `errors` (rad) are added to the
    /// right angles, `v` (m/s) is the speed of the fastest group; the sideways
    /// speed of each group (m/s, to the left of its heading positive) goes to
    /// `sideways`. Where the layout leaves the drift open (all groups on one axle
    /// line), the machine is taken to follow its command.
    ///
    /// # Panics
    /// Where the slices differ in length.
    #[must_use]
    pub fn new(machine: &Machine<f64>, centre: &Centre<f64>, v: f64, errors: &[f64], sideways: &mut [f64]) -> Slip {
        let groups = &machine.groups;
        assert!(
            errors.len() == groups.len() && sideways.len() == groups.len(),
            "one of each for every group"
        );
        let (scale, size) = (v / centre.fastest(machine), machine.size());
        // Each group's velocity, the normal of its heading, and its arm over the machine's size.
        let each = |i: usize| {
            let (along, arm) = (centre.rolling(groups[i]), (groups[i] - machine.middle) / size);
            let (sin, cos) = Calc::sin_cos(errors[i]);
            let length = plane::length(along);
            let unit = if length == 0.0 {
                Point::new(1.0, 0.0)
            } else {
                along / length
            };
            let normal = plane::turned(Point::new(-unit.y, unit.x), cos, sin);
            (along * scale, normal, arm)
        };
        // What an amount of drift x, drift y and turn times size does along a direction.
        let by = |direction: Point<f64>, arm: Point<f64>| {
            Vector3::new(direction.x, direction.y, plane::cross(arm, direction))
        };
        let (mut square, mut right, mut travel) = (Matrix3::zeros(), Vector3::zeros(), Vector3::zeros());
        for i in 0..groups.len() {
            let (velocity, normal, arm) = each(i);
            let row = by(normal, arm);
            square += row * row.transpose();
            right -= row * plane::dot(velocity, normal);
            travel += by(velocity, arm);
        }
        // Drift only across the travel: two directions that leave the mean rolling speed as it is.
        let found = basis(travel).and_then(|[a, b]| {
            let (aa, ab, bb) = (a.dot(&(square * a)), a.dot(&(square * b)), b.dot(&(square * b)));
            let determinant = aa * bb - ab * ab;
            let (ra, rb) = (a.dot(&right), b.dot(&right));
            (determinant > 1e-9 * (aa * bb).max(f64::MIN_POSITIVE))
                .then(|| (a * (ra * bb - rb * ab) + b * (rb * aa - ra * ab)) / determinant)
        });
        let gained = found.unwrap_or_else(Vector3::zeros);
        let mut sum = 0.0;
        for (i, slot) in sideways.iter_mut().enumerate() {
            let (velocity, normal, arm) = each(i);
            *slot = plane::dot(velocity, normal) + by(normal, arm).dot(&gained);
            sum += *slot * *slot;
        }
        Slip {
            drift: Point::new(gained.x, gained.y),
            turn: gained.z / size,
            rms: (sum / groups.len() as f64).sqrt(),
        }
    }
}

/// The greatest sideways speed of each group at a travel speed of one, of all signs of the angle errors (rad). Which
/// signs add up in a group is told by each error alone, one way and the other: errors that have no part in its slip
/// but by their square may stand with either sign.
///
/// # Panics
/// Where the slices differ in length, or for more groups than a machine may have.
pub fn worst(machine: &Machine<f64>, centre: &Centre<f64>, errors: &[f64], slips: &mut [f64]) {
    let n = slips.len();
    let (mut signed, mut sideways) = ([0.0; GROUPS[1]], [[0.0; GROUPS[1]]; 2]);
    let slip = |signed: &[f64], sideways: &mut [f64]| {
        let _ = Slip::new(machine, centre, 1.0, signed, sideways);
    };
    // Bit j of group i: whether a positive error of group j lets it slip to the right.
    let mut right = [0_u64; GROUPS[1]];
    for j in 0..n {
        for (sign, sideways) in [1.0, -1.0].into_iter().zip(&mut sideways) {
            signed[j] = sign * errors[j];
            slip(&signed[..n], &mut sideways[..n]);
        }
        signed[j] = 0.0;
        for i in 0..n {
            right[i] |= u64::from(sideways[0][i] < sideways[1][i]) << j;
        }
    }
    for (i, slot) in slips.iter_mut().enumerate() {
        *slot = 0.0;
        for sign in [1.0, -1.0] {
            for j in 0..n {
                let towards = if right[i] >> j & 1 == 1 { -sign } else { sign };
                signed[j] = towards * errors[j];
            }
            slip(&signed[..n], &mut sideways[0][..n]);
            *slot = slot.max(sideways[0][i].abs());
        }
    }
}

/// Two unit vectors at right angles to `to` and to each other; `None` where it is zero.
fn basis(to: Vector3<f64>) -> Option<[Vector3<f64>; 2]> {
    let along = to / to.dot(&to).sqrt();
    if !along.iter().all(|x| x.is_finite()) {
        return None;
    }
    let axis = along.iamin();
    let mut other = Vector3::zeros();
    other[axis] = 1.0;
    let a = along.cross(&other);
    let a = a / a.dot(&a).sqrt();
    Some([a, along.cross(&a)])
}
