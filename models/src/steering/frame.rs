//! How the groups are built in, and how far they turn by it.

use std::f64::consts::PI;

use crate::kernel::calc::Calc;
use crate::kernel::group::group;
use crate::steering::cylinder::Mounting;
use crate::steering::limits::Limits;
use crate::steering::refusal::Refusal;

/// How a group is built in.
#[derive(Clone, Debug)]
pub struct Mount {
    /// Whether its cylinder shortens where the others lengthen.
    pub mirrored: bool,
    /// How far it turns, in rad; `None` as far as its cylinder turns it.
    pub range: Option<[f64; 2]>,
    /// Ranges through which it must not turn, in rad.
    pub forbidden: Vec<[f64; 2]>,
}
group!(Mount);

/// The range of each group: its own, else that of its cylinder.
pub fn limits<C: Calc>(
    mounts: &[Mount],
    cylinder: &Option<Mounting<C>>,
    limits: &mut Vec<Limits>,
) -> Result<(), Refusal> {
    let cylinder = cylinder.map(|cylinder| cylinder.map(&mut |_, x| x.value()));
    limits.clear();
    for (number, mount) in (1..).zip(mounts) {
        let whole = match (mount.range, &cylinder) {
            (Some([min, max]), _) => Limits::new(min, max, Vec::new())?,
            (None, Some(cylinder)) => Limits::between(cylinder.ends(mount.mirrored)),
            (None, None) => Limits::new(-PI, PI, Vec::new())?,
        };
        limits.push(whole.forbid(mount.forbidden.clone()).map_err(|found| Refusal {
            key: format!("forbidden[{number}]"),
            what: format!("group {number}: {}", found.what),
            ..found
        })?);
    }
    Ok(())
}

/// The ends of a group's range again, in rad, with the derivatives of what they follow from.
#[derive(Clone, Copy, Debug)]
pub struct Ends<C>(pub [C; 2]);

impl<C: Calc> Ends<C> {
    pub fn new(mount: &Mount, cylinder: &Option<Mounting<C>>, limits: &Limits) -> Ends<C> {
        match (mount.range, cylinder) {
            (None, Some(cylinder)) => Ends(cylinder.ends(mount.mirrored)),
            _ => Ends([limits.min, limits.max].map(C::constant)),
        }
    }
}
