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
use crate::luffing::double_link::parameters::{Parameters, Weights};
use crate::luffing::double_link::pose::Posing;
use crate::luffing::led::reeved::Reeved;
use crate::luffing::moving::bodies::Body;
use crate::luffing::moving::built::{HoistParts, LevelParts, Outfit};
use crate::luffing::moving::dynamics::{Coordinate, Dynamics};
use crate::luffing::moving::given::{Constants, Fitted, SlewedParts};
use crate::luffing::moving::hoisting::{HoistFalls, HoistMotor, HoistRamp, RopeGive};
use crate::luffing::moving::level::Level;
use crate::parts::air::AirAround;
use crate::parts::ground::GroundBelow;
use crate::parts::motion::Motion;
use crate::parts::plane::Point;

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
    pub reeved: Option<Reeved<P>>,
    pub constants: Constants<P>,
    pub ramp: Option<HoistRamp<P>>,
    pub motor: Option<HoistMotor<P>>,
    pub hoist_falls: Option<HoistFalls<P>>,
    pub give: Option<RopeGive<P>>,
    pub around: Option<AirAround<P>>,
    pub ground: Option<GroundBelow<P>>,
    pub slewed: Option<SlewedParts<P>>,
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
    pub fn linkage(&self) -> Result<HeavyLinkage<P>, Fault> {
        let p = &self.parameters;
        let geometry = Geometry::new(p).map_err(|misfit| {
            let words = p.values().describe(misfit);
            Fault::outside(format!("{}; {}", words.what, words.help))
        })?;
        let linkage = HeavyLinkage::new(&geometry, self.bodies(&geometry))
            .with_balance(p, &self.range)
            .map_err(|fault| Fault::outside(fault.to_string()))?
            .with_rope(self.reeved);
        Ok(match &p.anchors {
            Some(anchors) => linkage.with_drive(anchors),
            None => linkage,
        })
    }

    /// The equations of its level, nothing being asked of it.
    pub fn level(&self, linkage: &Arc<HeavyLinkage<P>>, fittings: Outfit<P>) -> Level<P> {
        let Bodies { pendulum, gravity, .. } = linkage.bodies;
        let dynamics = Dynamics::new(linkage.clone(), pendulum, gravity);
        LevelParts {
            range: self.range,
            axis: -self.parameters.lengths.x_8,
            constants: self.constants,
            slewed: self.slewed,
            around: self.around,
            ground: self.ground,
            fitted: self.fitted,
        }
        .level(dynamics, fittings)
    }

    fn bodies(&self, geometry: &Geometry<P>) -> Bodies<P> {
        let (inertias, constants) = (self.inertias, self.constants);
        let weights: &Weights<P> = self
            .parameters
            .weights
            .as_ref()
            .expect("checked when the scene was read");
        let load = (self.load.1 / constants.g).def(&m::MASS_Q);
        let [boom, jib, rocker] = slender(geometry, Some(weights), &inertias, constants.g);
        let head = head(geometry);
        // Where the crane does not turn nothing asks for it.
        let turns = self.slewed.is_some() || self.fitted.meets.slewing;
        let spread = |jib: Body<P>| match turns {
            true => {
                let [along, both, across] = jib.spread;
                Body {
                    spread: [along.def(&m::J_XI2), both.def(&m::J_XIETA2), across.def(&m::J_ETA2)],
                    ..jib
                }
            }
            false => jib,
        };
        let hoist = HoistParts::new(&self.ramp, &self.motor, &self.give, &self.hoist_falls);
        let led = self.reeved.map(|led| led.falls.m_h);
        let pendulum = hoist.led(led).pendulum(load, self.fitted.rope);
        Bodies {
            boom,
            load: self.reeved.filter(|_| pendulum.is_none()).map(|_| load),
            jib: spread(if pendulum.is_some() || self.reeved.is_some() {
                jib
            } else {
                let loaded = jib.with_mass(load, head);
                Body {
                    inertia: loaded.inertia.def(&m::J_2Q),
                    ..loaded
                }
            }),
            rocker,
            pendulum,
            gravity: constants.g,
        }
    }
}

/// The jib's head in the frame of its rear arm, in m.
fn head<P: Calc>(geometry: &Geometry<P>) -> Point<P> {
    Point::new(geometry.kappa.x, -geometry.kappa.y) * geometry.lengths.x_2
}

/// Boom, jib and rocker under gravity (m/s²), or none that weigh: boom and rocker lie along their bars, the jib along the line
/// from its tail to its head.
pub fn slender<P: Calc>(
    geometry: &Geometry<P>,
    weights: Option<&Weights<P>>,
    inertias: &Inertias<P>,
    gravity: P,
) -> [Body<P>; 3] {
    let Some(w) = weights else {
        return [Body::nothing(); 3];
    };
    let bar = Point::new(P::constant(1.0), P::constant(0.0));
    let axis = head(geometry) - bar * geometry.lengths.x_2;
    [
        (w.g_1, inertias.j_1, w.s_1, w.chi_1, bar),
        (w.g_2, inertias.j_2, w.s_2, w.chi_2, axis),
        (w.g_3, inertias.j_3, w.s_3, w.chi_3, bar),
    ]
    .map(|(weight, inertia, distance, angle, along)| {
        let (sin, cos) = angle.sin_cos();
        let centre = Point::new(distance * cos, distance * sin);
        Body::slender(weight / gravity, inertia, centre, along)
    })
}
