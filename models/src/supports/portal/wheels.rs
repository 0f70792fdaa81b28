//! What a corner of the portal as it is built bears, and its wheels.

use crate::component::stages::results;
use crate::kernel::calc::Calc;
use crate::kernel::group::{group, quantities};
use crate::supports::portal::symbols as s;

/// The kinds of a portal, as scenes name them.
pub const FRAMES: [&str; 2] = ["rigid", "hinged"];

/// Whether the portal is hinged: then each corner bears by the product form.
#[derive(Clone, Copy, Debug)]
pub struct Hinged(pub bool);
group!(Hinged);

quantities! {
    /// The wheels of a corner.
    CornerWheels { n_w: N_W }
}

quantities! {
    /// Part of its load with which a corner's wheels press sideways.
    Sideways { k_l: K_L }
}

/// The load of a corner, in N: of the rigid portal more than of the hinged one; by the kind of the portal; of a wheel;
/// sideways.
#[derive(Clone, Copy, Debug)]
pub struct CornerLoad<C> {
    more: C,
    load: C,
    pub wheel: C,
    sideways: C,
}
results! { each CornerLoad as c => { D_N: c.more; N: c.load; F_W: c.wheel; H: c.sideways; } }

impl<C: Calc> CornerLoad<C> {
    /// ΔN = N_r − N_h, F_w = N / n_w, H = k_l N.
    pub fn new(
        kind: &Hinged,
        sideways: &Sideways<C>,
        wheels: &CornerWheels<C>,
        rigid: &C,
        hinged: &C,
    ) -> CornerLoad<C> {
        let load = if kind.0 { *hinged } else { *rigid }.def(&s::N);
        CornerLoad {
            more: (*rigid - *hinged).def(&s::D_N),
            load,
            wheel: (load / wheels.n_w).def(&s::F_W),
            sideways: (sideways.k_l * load).def(&s::H),
        }
    }
}

/// The greatest corner load, in N.
pub fn top<C: Calc>(corners: &[CornerLoad<C>]) -> C {
    let loads = corners.iter().map(|corner| corner.load);
    loads.reduce(C::greater).expect("four corners").def(&s::N_TOP)
}
