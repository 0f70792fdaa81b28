//! Teeth of the pinion with its rack, or with a sector that has its teeth outside.

use crate::component::stages::{Found, absent, results};
use crate::drive::gear::Gear;
use crate::drive::mount::DriveMount;
use crate::kernel::calc::Calc;
use crate::luffing::strength::given::{Teeth, under};
use crate::luffing::strength::symbols as s;
use crate::parts::teeth;

/// How the teeth touch at the pitch point.
#[derive(Clone, Copy, Debug)]
pub struct Mesh<C> {
    /// In m.
    radius: C,
}
results! { Mesh as m => { RHO_C: m.radius; } }

impl<C: Calc> Mesh<C> {
    /// 1/ρ = (1/r_z + 1/r_s) / sin α; a rack is flat. (Hertz)
    ///
    /// # Errors
    /// A drive without a pinion.
    pub fn new(teeth: &Teeth<C>, gear: &Gear<C>, mount: &DriveMount<C>) -> Found<Mesh<C>> {
        let Gear::Pinion(pinion) = gear else {
            return Err(absent());
        };
        let (r_z, sin) = (pinion.r_z, teeth.alpha.sin());
        let radius = match mount {
            DriveMount::Sector(sector) => r_z * sector.r_s / (r_z + sector.r_s) * sin,
            DriveMount::Anchors(_) => r_z * sin,
        };
        let radius = radius.def(&s::RHO_C);
        Ok(Mesh { radius })
    }
}

/// The teeth under the force of a case, in Pa.
#[derive(Clone, Copy, Debug)]
pub struct Toothed<C> {
    bending: C,
    contact: C,
}
results! { each Toothed as t => { SIGMA_F: t.bending; SIGMA_H: t.contact; } }

impl<C: Calc> Toothed<C> {
    /// One tooth carries the force (N): σ_F = K F Y / (b m) (Lewis), and by two cylinders, of which the force across the
    /// flank is F / cos α, σ_H² = K F E / (2π (1 − ν²) b ρ cos α) (Hertz). [Ports001, 5.8]
    pub fn new(teeth: &Teeth<C>, mesh: &Mesh<C>, force: &C) -> Toothed<C> {
        let bending = under(*force, |force| {
            teeth::bending(teeth.k, force, teeth.y, [teeth.b, teeth.m]).def(&s::SIGMA_F)
        });
        let contact = under(*force, |force| {
            let (steel, line) = ([teeth.e, teeth.nu], [teeth.b, mesh.radius]);
            teeth::contact(teeth.k, force, steel, line, teeth.alpha).def(&s::SIGMA_H)
        });
        Toothed { bending, contact }
    }
}
