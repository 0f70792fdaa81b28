//! Where the steered groups stand.

use crate::kernel::calc::{Among, Calc};
use crate::kernel::group::{group, quantities};
use crate::kernel::number::short;
use crate::parts::plane::{self, Point};
use crate::steering::refusal::Refusal;
use crate::steering::symbols as s;

/// Smallest and greatest number of steered groups.
pub const GROUPS: [usize; 2] = [4, 64];

/// Groups nearer than this coincide, in m.
pub const NEAREST: f64 = 1e-3;

quantities! {
    /// Axis of a steered group, in m.
    Axis { x: X, y: Y }
}

impl<C: Calc> Axis<C> {
    #[inline]
    pub fn point(&self) -> Point<C> {
        Point::new(self.x, self.y)
    }
}

/// Front, rear, left and right of the machine, in m; `None` as far as the groups reach.
#[derive(Clone, Copy, Debug)]
pub struct Footprint(pub Option<[f64; 4]>);
group!(Footprint);

/// A machine with its steered groups, the first of which commands front-axle, all-wheel and crab steering; lengths in m.
#[derive(Clone, Debug)]
pub struct Machine<C> {
    pub groups: Vec<Point<C>>,
    /// Corners of the outline from the front left, in order around it.
    pub corners: [Point<C>; 4],
    /// Group whose angle commands rear-axle steering: the rearmost one that is nearest in line with the first.
    pub rear_base: usize,
    /// Foremost and rearmost axle line's x.
    pub front: C,
    pub rear: C,
    /// Outermost groups' y.
    pub left: C,
    pub right: C,
    /// Midway between the outermost groups.
    pub middle: Point<C>,
}

impl<C: Calc> Machine<C> {
    /// Any layout of 4 to 64 groups no two of which coincide.
    pub fn new(axes: &[Axis<C>], outline: &Footprint) -> Result<Machine<C>, Refusal> {
        let groups: Vec<Point<C>> = axes.iter().map(Axis::point).collect();
        apart(&groups)?;
        let outermost = |pick: fn(&Point<C>) -> C, end: Among, symbol| {
            let of_two = if end == Among::Greatest { C::greater } else { C::smaller };
            let all = groups.iter().map(pick).reduce(of_two);
            all.expect("at least four").among(end, pick(&groups[0])).def(symbol)
        };
        let front = outermost(|p| p.x, Among::Greatest, &s::X_F);
        let rear = outermost(|p| p.x, Among::Least, &s::X_R);
        let left = outermost(|p| p.y, Among::Greatest, &s::Y_L);
        let right = outermost(|p| p.y, Among::Least, &s::Y_R);
        let two = C::constant(2.0);
        let middle = Point::new(((front + rear) / two).def(&s::M_X), ((left + right) / two).def(&s::M_Y));
        let [e_f, e_r, e_left, e_right] = match outline.0 {
            Some([front, rear, left, right]) => [
                C::known(&s::E_F, front),
                C::known(&s::E_R, rear),
                C::known(&s::E_LEFT, left),
                C::known(&s::E_RIGHT, right),
            ],
            None => [front, rear, left, right],
        };
        let corners = [(e_f, e_left), (e_r, e_left), (e_r, e_right), (e_f, e_right)];
        Ok(Machine {
            corners: corners.map(|(x, y)| Point::new(x, y)),
            rear_base: rear_base(&groups),
            groups,
            front,
            rear,
            left,
            right,
            middle,
        })
    }
}

impl Machine<f64> {
    /// Greatest length or width between the groups, in m.
    #[must_use]
    pub fn extent(&self) -> f64 {
        (self.front - self.rear).max(self.left - self.right)
    }

    /// Greatest distance of a group from the middle, in m.
    #[must_use]
    pub fn size(&self) -> f64 {
        let arms = self.groups.iter().map(|p| plane::length(p - self.middle));
        arms.fold(0.0, f64::max)
    }
}

/// That there are as many groups as there may be, and no two in one place.
fn apart<C: Calc>(groups: &[Point<C>]) -> Result<(), Refusal> {
    let [least, most] = GROUPS;
    if !(least..=most).contains(&groups.len()) {
        return Err(Refusal::new(
            "groups",
            format!("{} steered groups", groups.len()),
            format!("there must be {least} to {most}"),
        ));
    }
    let plain = |p: &Point<C>| Point::new(p.x.value(), p.y.value());
    for (i, a) in groups.iter().map(plain).enumerate() {
        for (j, b) in groups[..i].iter().map(plain).enumerate() {
            let apart = plane::length(a - b);
            if apart < NEAREST {
                return Err(Refusal::new(
                    format!("group[{}]", i + 1),
                    format!(
                        "groups {} and {} coincide at ({}, {}) m: they are {} m apart",
                        j + 1,
                        i + 1,
                        short(a.x),
                        short(a.y),
                        short(apart)
                    ),
                    format!("groups must be at least {NEAREST} m apart"),
                ));
            }
        }
    }
    Ok(())
}

/// Part of the machine's length by which groups of one axle line may differ: the unit in which a place was given must not
/// decide which of them commands.
const ALIKE: f64 = 1e-9;

fn rear_base<C: Calc>(groups: &[Point<C>]) -> usize {
    let x = |i: usize| groups[i].x.value();
    let all = || (0..groups.len()).map(x);
    let (front, rear) = (all().fold(f64::MIN, f64::max), all().fold(f64::MAX, f64::min));
    let last = (0..groups.len()).filter(|i| x(*i) <= rear + ALIKE * (front - rear));
    let aside = |i: &usize| (groups[*i].y - groups[0].y).value().abs();
    last.min_by(|a, b| aside(a).total_cmp(&aside(b))).unwrap_or(0)
}
