//! The equations of a level from what is given: joints, hoist, cylinder, slewing.

use std::sync::Arc;

use crate::component::scalar::Scalar;
use crate::drive::mount::Bore;
use crate::kernel::calc::Calc;
use crate::luffing::moving::bodies::{Pendulum, Turntable};
use crate::luffing::moving::dynamics::{Coordinate, Dynamics};
use crate::luffing::moving::exposed::{Exposed, shared};
use crate::luffing::moving::geared::Geared;
use crate::luffing::moving::given::{Constants, CylinderOil, Fitted, SlewedParts};
use crate::luffing::moving::hoisting::{HoistFalls, HoistMotor, HoistRamp, RopeGive};
use crate::luffing::moving::hydraulic::{Crane, Hydraulic};
use crate::luffing::moving::level::Level;
use crate::luffing::moving::motion::{HauledLinkage, MovingLinkage};
use crate::luffing::moving::reduced::Renewed;
use crate::luffing::moving::space::{HauledSlewing, Slewing};
use crate::luffing::moving::symbols as m;
use crate::luffing::moving::weather::Exposes;
use crate::luffing::resistances::placed::Placing;
use crate::parts::air::{AirAround, AirDrag};
use crate::parts::ground::GroundBelow;
use crate::parts::hoist::{Elastic, Hoist, HoistCommand, Winch, WinchDrive};
use crate::parts::hydraulics::cylinder::Cylinder;
use crate::parts::hydraulics::parts::OilParts;
use crate::parts::hydraulics::valve::Valve;
use crate::parts::joint::{Friction, Joint, JointDrive};
use crate::parts::motion::Motion;

/// Natural frequency, in rad/s, of the mechanism alone against an end stop of the hydraulic level;
/// the stop is damped critically.
const STOP: f64 = 100.0;

/// The hoist of a load's rope as a scene gives it.
#[derive(Clone, Copy)]
pub struct HoistParts<P: Calc> {
    pub ramp: Option<HoistRamp<P>>,
    pub motor: Option<HoistMotor<P>>,
    pub give: Option<RopeGive<P>>,
    pub falls: HoistFalls<P>,
}

impl<P: Calc> HoistParts<P> {
    pub fn new(
        ramp: &Option<HoistRamp<P>>,
        motor: &Option<HoistMotor<P>>,
        give: &Option<RopeGive<P>>,
        falls: &Option<HoistFalls<P>>,
    ) -> HoistParts<P> {
        HoistParts {
            ramp: *ramp,
            motor: *motor,
            give: *give,
            falls: falls.unwrap_or(HoistFalls { m_h: P::constant(1.0) }),
        }
    }

    /// With the falls (over one) of a tackle whose rope the mechanism leads, where it does.
    #[must_use]
    pub fn led(self, falls: Option<P>) -> HoistParts<P> {
        let falls = falls.map_or(self.falls, |m_h| HoistFalls { m_h });
        HoistParts { falls, ..self }
    }

    /// The load of a mass (kg) on its rope of a length (m), where it has one.
    pub fn pendulum(&self, mass: P, length: Option<f64>) -> Option<Pendulum<P>> {
        let mut hoist = Hoist {
            winch: self.winch(),
            rope: self.give.map(|RopeGive { c_r, d_r }| Elastic {
                stiffness: c_r,
                damping: d_r,
            }),
        };
        if mass.value() == 0.0 {
            // With nothing on it a rope is not stretched: the limit of ever lighter loads.
            hoist.rope = None;
        }
        length.map(|length| Pendulum {
            mass,
            length: P::known(&m::L_R, length),
            hoist,
        })
    }

    /// A hoist as the rope at the head feels it.
    fn winch(&self) -> Winch<P> {
        if let Some(HoistMotor { j_h, r_h, m_f_h }) = self.motor {
            let ratio = self.falls.m_h / r_h;
            return Winch::Motor(WinchDrive {
                mass: (j_h * ratio.square()).def(&m::MASS_H),
                ratio,
                coulomb: m_f_h,
            });
        }
        self.ramp.map_or(Winch::AtOnce, |ramp| Winch::Ramp(ramp.a_h))
    }
}

/// What a level is made of besides the mechanism.
#[derive(Clone)]
pub struct LevelParts<P: Calc> {
    pub range: Motion,
    /// Of slewing, from the mechanism's origin, in m.
    pub axis: P,
    pub constants: Constants<P>,
    pub slewed: Option<SlewedParts<P>>,
    /// Around the load.
    pub around: Option<AirAround<P>>,
    pub ground: Option<GroundBelow<P>>,
    pub fitted: Fitted,
}

/// What a scene may give a mechanism in motion: a motor that turns with it or a cylinder that moves it, wind and slope that it
/// meets.
#[derive(Clone)]
pub struct Outfit<P: Calc> {
    geared: Option<Arc<Geared<P>>>,
    cylinder: Option<Cylinder<P>>,
    outdoors: Option<Arc<dyn Exposes<P>>>,
}

impl<C: Scalar> Outfit<C> {
    pub fn new<K: Placing>(
        geared: &[Renewed<Geared<C>>],
        cylinder: Option<&Cylinder<C>>,
        exposed: &[Renewed<Exposed<K, C>>],
    ) -> Outfit<C> {
        Outfit {
            geared: geared.first().map(|geared| geared.now().clone()),
            cylinder: cylinder.copied(),
            outdoors: shared(exposed),
        }
    }
}

impl<P: Coordinate<P>> LevelParts<P> {
    /// The equations, nothing being asked of them; with a motor that turns with it, where no cylinder moves it.
    pub fn level(self, mut dynamics: Dynamics<P>, fittings: Outfit<P>) -> Level<P> {
        let (fitted, constants) = (self.fitted, self.constants);
        let joint = |viscous, coulomb, stops| Joint {
            friction: Friction { viscous, coulomb },
            stops,
        };
        let luffing = joint(constants.c_v, constants.m_f, [self.range.from, self.range.to]);
        let turning = self.slewed.map(|slewed| slewed.turning);
        let slewing = (turning.zip(fitted.slewing)).map(|(t, stops)| joint(t.c_sl, t.m_f_sl, stops));
        if let Some(around) = &self.around {
            dynamics = dynamics.in_air(AirDrag::new(around, constants.g), [P::constant(0.0); 2]);
        }
        if let Some(area) = self.slewed.and_then(|slewed| slewed.area) {
            dynamics = dynamics.from_the_side(area.in_air(self.around.as_ref()));
        }
        if let Some(slope) = self.slewed.and_then(|slewed| slewed.slope) {
            dynamics = dynamics.on_slope(slope);
        }
        if let Some(ground) = self.ground {
            dynamics = dynamics.above_ground(ground.y_g);
        }
        if let Some(outdoors) = fittings.outdoors {
            dynamics = dynamics.outdoors(outdoors);
        }
        if fitted.meets.slewing {
            dynamics = dynamics.slewed_about(self.axis);
        }
        if let Some(turning) = turning {
            dynamics = dynamics.with_slewing(Turntable {
                axis: self.axis,
                inertia: turning.j_sl,
            });
        }
        let Some(cylinder) = fittings.cylinder else {
            if let Some(geared) = fittings.geared {
                dynamics = dynamics.by_motor(geared);
            }
            if fitted.hauled {
                return hauled(dynamics, luffing, slewing);
            }
            return match crane(dynamics, luffing, slewing) {
                Crane::Plane(motion) => Level::Free(motion),
                Crane::Slewing(slewing) => Level::Slewing(slewing),
            };
        };
        dynamics = dynamics.by_cylinder();
        let start = P::reduced(&dynamics, P::constant(self.range.from));
        let inertia = start.map_or(P::constant(0.0), |r| r.inertia);
        let stop = P::known(&m::OMEGA_S, STOP);
        let (stiffness, damping) = (inertia * stop.square(), inertia * P::constant(2.0) * stop);
        let buffer = [stiffness.def(&m::K_S), damping.def(&m::D_S)];
        let crane = crane(dynamics, luffing, slewing);
        if fitted.rope.is_some() || fitted.slewing.is_some() {
            Level::Hanging(hydraulic(crane, cylinder, buffer))
        } else {
            Level::Fixed(hydraulic(crane, cylinder, buffer))
        }
    }
}

/// The cylinder that moves a mechanism, its lines whole.
pub fn cylinder<P: Calc>(oil: &CylinderOil<P>, bore: &Bore<P>, parts: &Option<OilParts<P>>) -> Cylinder<P> {
    Cylinder {
        areas: Cylinder::areas(bore.d_c, bore.d_r),
        lengths: [oil.l_min, oil.l_max],
        dead_volume: oil.v_0,
        port_volume: oil.v_1,
        line: Valve::rated(oil.q_n, oil.dp_l),
        leakage: oil.k_l,
        bulk_modulus: oil.beta_e,
        relief: [oil.p_r, oil.k_r],
        valve: Valve {
            conductance: Valve::rated(oil.q_n, oil.dp_n),
            overlap: P::constant(0.0),
            frequency: oil.omega_v,
            damping: oil.zeta_v,
        },
        parts: *parts,
        torn: [P::constant(0.0); 2],
    }
}

/// A crane with its joints of luffing and, where it slews, slewing. A call, as its many numbers would be moved one
/// by one.
#[inline(never)]
fn crane<P: Copy>(dynamics: Dynamics<P>, luffing: Joint<P>, slewing: Option<Joint<P>>) -> Crane<P> {
    match slewing {
        None => Crane::Plane(MovingLinkage {
            dynamics,
            joints: [luffing],
        }),
        Some(slewing) => Crane::Slewing(Slewing {
            dynamics,
            joints: [luffing, slewing],
        }),
    }
}

/// The same where the rope of its drive may go slack.
#[inline(never)]
fn hauled<P: Copy>(dynamics: Dynamics<P>, luffing: Joint<P>, slewing: Option<Joint<P>>) -> Level<P> {
    match slewing {
        None => Level::Hauled(HauledLinkage {
            dynamics,
            joints: [luffing],
        }),
        Some(slewing) => Level::HauledSlewing(HauledSlewing {
            dynamics,
            joints: [luffing, slewing],
        }),
    }
}

/// The same with its cylinder, which nothing is asked of.
#[inline(never)]
fn hydraulic<const N: usize, P: Calc>(crane: Crane<P>, cylinder: Cylinder<P>, buffer: [P; 2]) -> Hydraulic<N, P> {
    let nothing = P::constant(0.0);
    let still = JointDrive {
        moment: nothing,
        brake: nothing,
    };
    Hydraulic {
        crane,
        cylinder,
        buffer,
        command: nothing,
        supply: nothing,
        hoist: HoistCommand {
            speed: nothing,
            drive: still,
        },
        slewing: still,
    }
}
