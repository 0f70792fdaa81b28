//! The controller of slewing by itself: [`crate::parts::turntable_control`] as the source of its drive's moment.

use crate::component::stages::results;
use crate::kernel::calc::Calc;
use crate::parts::shaping::Shaping;
use crate::parts::turntable::Turning;
use crate::parts::turntable_control::{Latched, SlewingControl};
use crate::slewing::motion::SlewingDrive;
use crate::slewing::swinging::{RopeLength, SwingingLoad};
use crate::slewing::symbols as s;
use crate::slewing::turning::Hung;

/// What the controller holds.
#[derive(Clone, Copy, Debug)]
pub struct Controlled<C>(Latched<C>);
results! { Controlled as c => { M_SL: c.0.moment.def(&s::M_SL); OMEGA_S_SL: c.0.set; M_I_SL: c.0.integral; } }

impl<C: Calc> Controlled<C> {
    pub fn new(latched: &Latched<C>) -> Controlled<C> {
        Controlled(*latched)
    }
}

/// The drive: its moment as given, or as the controller holds it.
pub fn acting<C: Calc>(given: &SlewingDrive<C>, latched: &Option<Latched<C>>) -> SlewingDrive<C> {
    latched.map_or(*given, |latched| SlewingDrive {
        m_sl: latched.moment,
        ..*given
    })
}

/// The speed under the controller, in closed form.
#[derive(Clone, Copy, Debug)]
pub struct Regulated<C>([C; 2]);
results! { Regulated as r => { OMEGA_0_SL: r.0[0]; ZETA_SL: r.0[1]; } }

impl<C: Calc> Regulated<C> {
    /// With the load where that keeps its place under the head.
    pub fn new(
        control: &SlewingControl<C>,
        turning: &Turning<C>,
        swung: &Option<SwingingLoad<C>>,
        total: &C,
    ) -> Regulated<C> {
        Regulated(control.vibration(turning, if swung.is_some() { turning.j_sl } else { *total }))
    }
}

/// What a shaped command leaves of the swing.
#[derive(Clone, Copy, Debug)]
pub struct SwayLeft<C>([C; 2]);
results! { SwayLeft as w => { T_R: w.0[0]; RHO_SH: w.0[1]; } }

impl<C: Calc> SwayLeft<C> {
    pub fn new(shaping: &Shaping<C>, rope: &RopeLength<C>, hung: &Hung<C>) -> SwayLeft<C> {
        SwayLeft(shaping.left(rope.l_r, hung.g))
    }
}
