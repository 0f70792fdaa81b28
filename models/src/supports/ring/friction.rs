//! Friction moment of the ring: by the forces on all rolling elements, and by makers' forms. Each form has its coefficient,
//! and none may be put into another.

use crate::kernel::calc::Calc;
use crate::kernel::group::{group, quantities};
use crate::supports::drive::given::GivenDrive;
use crate::supports::drive::symbols::M_FS;
use crate::supports::ring::elements::{Raceway, RollingForces};
use crate::supports::ring::symbols as s;
use crate::supports::upper::load::{SupportLoad, most};

/// Makers' forms, as scenes name them: Rothe Erde's of ball and of roller rings, and another maker's of ball rings.
pub const FORMS: [&str; 3] = ["ball", "roller", "ball_2.2"];
/// What moment and horizontal force with the diameter count in each. 2.2 · 1.73 of a ball ring.
const FACTORS: [[f64; 2]; 3] = [[4.4, 3.806], [4.1, 2.05], [4.4, 2.2]];

/// A maker's form, by its place in their list.
#[derive(Clone, Copy, Debug)]
pub struct MakerForm(pub usize);
group!(MakerForm);

quantities! {
    /// Of the textbook's form.
    ElementFriction { mu_n: MU_N }
}

quantities! {
    /// Of a maker's form.
    MakerFriction { mu_m: MU_M }
}

/// M_fn = μ_n (D/2) Σ|N|, in N·m. [Ports001, 6.3.1.3]
pub fn by_elements<C: Calc>(raceway: &Raceway<C>, friction: &ElementFriction<C>, spread: &RollingForces<C>) -> C {
    (friction.mu_n * raceway.d / C::constant(2.0) * spread.sum).def(&s::M_FN)
}

/// The greatest of the forms that there are, in N·m: each has its own coefficient, and the scene gives one at least.
pub fn rubbing<C: Calc>(_: &GivenDrive<C>, elements: Option<&Vec<C>>, maker: Option<&Vec<C>>, room: &mut Vec<C>) {
    let forms = [elements, maker];
    let cases = forms.iter().flatten().map(|form| form.len()).max().unwrap_or(0);
    room.clear();
    room.extend(
        (0..cases).map(|case| C::body(case, || most(forms.iter().flatten().map(|form| form[case])).def(&M_FS))),
    );
}

/// M_fm = (μ_m/2) (4.4 M + V D + 3.806 H D) of a ball ring, in N·m. [Rothe Erde]
pub fn by_maker<C: Calc>(
    raceway: &Raceway<C>,
    form: &MakerForm,
    friction: &MakerFriction<C>,
    load: &SupportLoad<C>,
) -> C {
    let [moment, across] = FACTORS[form.0];
    let forces = load.vertical * raceway.d + load.horizontal.scaled(across) * raceway.d;
    (friction.mu_m / C::constant(2.0) * (load.moment.scaled(moment) + forces)).def(&s::M_FM)
}
