//! The air around a load that swings while its crane slews by itself: [`crate::parts::air`] from a head at a reach.

use nalgebra::Vector3;

use crate::component::stages::results;
use crate::kernel::calc::Calc;
use crate::parts::air::{AirAround, AirDrag, Stream, WindAtLoad};
use crate::parts::hanging::turned;
use crate::slewing::swinging::Swinging;
use crate::slewing::symbols as s;
use crate::slewing::turning::{Hung, SlewedLoad};

/// The air as the load meets it, in the frame that slews.
pub fn stream<C: Calc>(around: &AirAround<C>, blowing: &WindAtLoad<C>, hung: &Hung<C>, psi: &C) -> Stream<C> {
    Stream::new(AirDrag::new(around, hung.g), [blowing.v_air, blowing.chi_air], *psi)
}

/// What the air does to the load: its force, in N, and the power that it takes, in W.
#[derive(Clone, Copy, Debug)]
pub struct FeltAir<C>([C; 2]);
results! { FeltAir as a => { F_AIR: a.0[0]; P_AIR: a.0[1]; } }

impl<C: Calc> FeltAir<C> {
    /// F = m (δ + κ u) u and P = m (δ + κ u) u·v, at the load's velocity v against the ground and u against the air.
    pub fn new(
        stream: &Stream<C>,
        swinging: &Swinging<C>,
        hung: &Hung<C>,
        carried: &SlewedLoad<C>,
        omega: &C,
    ) -> FeltAir<C> {
        let zero = C::constant(0.0);
        let from_axis = swinging.load.place + Vector3::new(hung.r, zero, zero);
        let velocity = swinging.found.rate + turned(from_axis).map(|part| part * *omega);
        FeltAir(stream.felt(velocity).map(|over| carried.mass * over))
    }
}
