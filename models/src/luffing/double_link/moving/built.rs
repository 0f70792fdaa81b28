//! The equations of a level from what is given: bodies from weights and inertias, joints, hoist, cylinder.

use std::sync::Arc;

use num_dual::Dual64;

use crate::kernel::calc::{Calc, Over};
use crate::kernel::group::{One, quantities};
use crate::kernel::variable::Fault;
use crate::luffing::double_link::geometry::Geometry;
use crate::luffing::double_link::linkage::{Bodies, HeavyLinkage};
use crate::luffing::double_link::moving::symbols as m;
use crate::luffing::double_link::moving::symbols as s;
use crate::luffing::double_link::parameters::{Bore, Parameters, Weights};
use crate::luffing::double_link::pose::Posing;
use crate::luffing::moving::bodies::{Body, Pendulum, Turntable};
use crate::luffing::moving::dynamics::{Coordinate, Dynamics};
use crate::luffing::moving::given::{Constants, CylinderOil, Fitted};
use crate::luffing::moving::hoisting::{HoistMotor, HoistRamp, RopeGive};
use crate::luffing::moving::hydraulic::{Crane, Hydraulic};
use crate::luffing::moving::level::Level;
use crate::luffing::moving::motion::MovingLinkage;
use crate::luffing::moving::space::Slewing;
use crate::parts::hoist::{Elastic, Hoist, HoistCommand, Winch, WinchDrive};
use crate::parts::hydraulics::cylinder::Cylinder;
use crate::parts::hydraulics::valve::Valve;
use crate::parts::joint::{Friction, Joint, JointDrive};
use crate::parts::motion::Motion;
use crate::parts::plane::Point;
use crate::parts::turntable::Turning;

/// Natural frequency, in rad/s, of the mechanism alone against an end stop of the hydraulic level;
/// the stop is damped critically.
const STOP: f64 = 100.0;

quantities! {
    /// Inertias of boom, jib and rocker.
    Inertias { j_1: J_1, j_2: J_2, j_3: J_3 }
}

/// What a crane in motion is made of.
#[derive(Clone)]
pub struct CraneParts<P: Calc> {
    pub parameters: Parameters<P>,
    pub range: Motion,
    pub load: One<P>,
    pub inertias: Inertias<P>,
    pub constants: Constants<P>,
    pub ramp: Option<HoistRamp<P>>,
    pub motor: Option<HoistMotor<P>>,
    pub give: Option<RopeGive<P>>,
    pub turning: Option<Turning<P>>,
    pub oil: Option<CylinderOil<P>>,
    pub fitted: Fitted,
}

impl<P: Posing<P> + Coordinate<P> + Send + Sync + 'static> CraneParts<P>
where
    Dual64: Over<P>,
{
    /// The mechanism with its bodies.
    ///
    /// # Errors
    /// Quantities with which there is no such mechanism, or no such balance.
    pub fn linkage(&self) -> Result<Arc<HeavyLinkage<P>>, Fault> {
        let p = &self.parameters;
        let geometry = Geometry::new(p).map_err(|misfit| {
            let words = p.values().describe(misfit);
            Fault::outside(format!("{}; {}", words.what, words.help))
        })?;
        let linkage = HeavyLinkage::new(&geometry, self.bodies(&geometry))
            .with_balance(p, &self.range)
            .map_err(|fault| Fault::outside(fault.to_string()))?;
        Ok(Arc::new(match &p.anchors {
            Some(anchors) => linkage.with_drive(anchors),
            None => linkage,
        }))
    }

    /// The equations of its level, nothing being asked of it.
    pub fn level(&self, linkage: &Arc<HeavyLinkage<P>>) -> Level<P> {
        let (fitted, constants) = (self.fitted, self.constants);
        let Bodies { pendulum, gravity, .. } = linkage.bodies;
        let mut dynamics = Dynamics::new(linkage.clone(), pendulum, gravity);
        let joint = |viscous, coulomb, stops| Joint {
            friction: Friction { viscous, coulomb },
            stops,
        };
        let luffing = joint(constants.c_v, constants.m_f, [self.range.from, self.range.to]);
        let slewing = (self.turning.zip(fitted.slewing)).map(|(t, stops)| joint(t.c_sl, t.m_f_sl, stops));
        if let Some(turning) = self.turning {
            dynamics = dynamics.with_slewing(Turntable {
                axis: -self.parameters.lengths.x_8,
                inertia: turning.j_sl,
            });
        }
        if self.oil.is_some() && self.parameters.anchors.is_some() {
            dynamics = dynamics.by_cylinder();
        }
        let Some((oil, bore)) = self.oil.as_ref().zip(self.parameters.cylinder) else {
            return match crane(dynamics, luffing, slewing) {
                Crane::Plane(motion) => Level::Free(motion),
                Crane::Slewing(slewing) => Level::Slewing(slewing),
            };
        };
        let start = <P as Coordinate<P>>::reduced(&dynamics, P::constant(self.range.from));
        let inertia = start.map_or(P::constant(0.0), |r| r.inertia);
        let stop = P::known(&m::OMEGA_S, STOP);
        let (stiffness, damping) = (inertia * stop.square(), inertia * P::constant(2.0) * stop);
        let buffer = [stiffness.def(&m::K_S), damping.def(&m::D_S)];
        let crane = crane(dynamics, luffing, slewing);
        if fitted.rope.is_some() || fitted.slewing.is_some() {
            Level::Hanging(hydraulic(crane, cylinder(oil, &bore), buffer))
        } else {
            Level::Fixed(hydraulic(crane, cylinder(oil, &bore), buffer))
        }
    }

    fn bodies(&self, geometry: &Geometry<P>) -> Bodies<P> {
        let (inertias, constants) = (self.inertias, self.constants);
        let weights: &Weights<P> = self
            .parameters
            .weights
            .as_ref()
            .expect("checked when the scene was read");
        let load = (self.load.1 / constants.g).def(&m::MASS_Q);
        let mut hoist = Hoist {
            winch: self.winch(),
            rope: self.give.map(|RopeGive { c_r, d_r }| Elastic {
                stiffness: c_r,
                damping: d_r,
            }),
        };
        if load.value() == 0.0 {
            // With nothing on it a rope is not stretched: the limit of ever lighter loads.
            hoist.rope = None;
        }
        // Boom and rocker lie along their bars, the jib along the line from its tail to its head.
        let bar = Point::new(P::constant(1.0), P::constant(0.0));
        let head = Point::new(geometry.kappa.x, -geometry.kappa.y) * geometry.lengths.x_2;
        let axis = head - bar * geometry.lengths.x_2;
        let body = |weight: P, inertia: P, distance: P, angle: P, along: Point<P>| {
            let (sin, cos) = angle.sin_cos();
            let centre = Point::new(distance * cos, distance * sin);
            Body::slender(weight / constants.g, inertia, centre, along)
        };
        let jib = body(weights.g_2, inertias.j_2, weights.s_2, weights.chi_2, axis);
        let pendulum = self.fitted.rope.map(|length| Pendulum {
            mass: load,
            length: P::known(&m::L_R, length),
            hoist,
        });
        Bodies {
            boom: body(weights.g_1, inertias.j_1, weights.s_1, weights.chi_1, bar),
            jib: if pendulum.is_some() {
                jib
            } else {
                let loaded = jib.with_mass(load, head);
                Body {
                    inertia: loaded.inertia.def(&m::J_2Q),
                    ..loaded
                }
            },
            rocker: body(weights.g_3, inertias.j_3, weights.s_3, weights.chi_3, bar),
            pendulum,
            gravity: constants.g,
        }
    }

    /// A hoist as the rope at the head feels it.
    fn winch(&self) -> Winch<P> {
        if let Some(HoistMotor { j_h, r_h, m_h, m_f_h }) = self.motor {
            let ratio = m_h / r_h;
            return Winch::Motor(WinchDrive {
                mass: (j_h * ratio.square()).def(&m::MASS_H),
                ratio,
                coulomb: m_f_h,
            });
        }
        self.ramp.map_or(Winch::AtOnce, |ramp| Winch::Ramp(ramp.a_h))
    }
}

fn cylinder<P: Calc>(oil: &CylinderOil<P>, bore: &Bore<P>) -> Cylinder<P> {
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
