//! The lemniscate crane of the reference motion with its bodies, and its luffing cylinder.

#![allow(dead_code, reason = "not every test uses all of it")]

use lemnis_models::drive::mount::Anchors;
use lemnis_models::luffing::double_link::geometry::Geometry;
use lemnis_models::luffing::double_link::linkage::{Bodies, HeavyLinkage};
use lemnis_models::luffing::double_link::parameters::{Driven, Jib, Lengths, Parameters};
use lemnis_models::luffing::moving::bodies::{Body, Pendulum, Turntable};
use lemnis_models::luffing::moving::crane::Commands;
use lemnis_models::luffing::moving::dynamics::Dynamics;
use lemnis_models::luffing::moving::hydraulic::{Crane, Hydraulic};
use lemnis_models::luffing::moving::motion::MovingLinkage;
use lemnis_models::luffing::moving::pendulum::Phase;
use lemnis_models::luffing::moving::space::Slewing;
use lemnis_models::parts::four_bar::Branch;
use lemnis_models::parts::hoist::{Hoist, HoistCommand};
use lemnis_models::parts::hydraulics::cylinder::Cylinder;
use lemnis_models::parts::hydraulics::valve::Valve;
use lemnis_models::parts::joint::{Friction, Joint, JointDrive};
use lemnis_models::parts::plane::Point;

pub const PENDULUM: Pendulum = Pendulum {
    mass: 16e3,
    length: 10.0,
    hoist: Hoist::AT_ONCE,
};

/// The same with another load (kg).
pub fn pendulum(mass: f64) -> Pendulum {
    Pendulum { mass, ..PENDULUM }
}

/// Uniform bars of 20 t, 6 t and 4 t; with a load on a rope, or one of 16 t fixed to the head. `mass` multiplies all.
pub fn bodies(g: &Geometry<f64>, mass: f64, pendulum: Option<Pendulum>) -> Bodies {
    let l = g.lengths;
    let zero = Point::new(0.0, 0.0);
    // The jib as one bar from C to A, in the frame of its rear arm BC.
    let a = Point::new(g.kappa.x, -g.kappa.y) * l.x_2;
    let jib = Body::uniform(6e3 * mass, Point::new(l.x_2, 0.0), a);
    Bodies {
        boom: Body::uniform(20e3 * mass, zero, Point::new(l.x_1, 0.0)),
        jib: if pendulum.is_some() {
            jib
        } else {
            jib.with_mass(16e3 * mass, a)
        },
        rocker: Body::uniform(4e3 * mass, zero, Point::new(l.x_3, 0.0)),
        pendulum,
        load: None,
        gravity: 9.81,
    }
}

pub fn geometry() -> Geometry<f64> {
    scaled(1.0)
}

/// The crane with all lengths multiplied.
pub fn scaled(length: f64) -> Geometry<f64> {
    let lengths = Lengths {
        x_1: 19.3 * length,
        x_2: 6.5 * length,
        x_3: 14.7 * length,
        x_4: 16.0 * length,
        x_5: 6.4 * length,
        x_6: 5.3 * length,
        x_8: 5.2 * length,
    };
    let parameters = Parameters {
        lengths,
        jib: Jib::Sag(1.354 * length),
        weights: None,
        anchors: None,
        cylinder: None,
        balance: None,
        driven: Driven::Boom,
        branch: Branch::Left,
    };
    Geometry::new(&parameters).expect("the crane exists")
}

pub fn dynamics(pendulum: Option<Pendulum>) -> Dynamics {
    linkage(pendulum).in_motion()
}

pub fn linkage(pendulum: Option<Pendulum>) -> HeavyLinkage {
    let g = geometry();
    HeavyLinkage::new(&g, bodies(&g, 1.0, pendulum))
}

/// With the luffing cylinder.
fn pushed(pendulum: Option<Pendulum>) -> Dynamics {
    linkage(pendulum).with_drive(&ANCHORS).in_motion().by_cylinder()
}

/// The crane with a boom of a mass (kg) from one place to another on its line (m).
pub fn with_boom(mass: f64, from: f64, to: f64, pendulum: Option<Pendulum>) -> Dynamics {
    let g = geometry();
    let bodies = Bodies {
        boom: Body::uniform(mass, Point::new(from, 0.0), Point::new(to, 0.0)),
        pendulum,
        ..bodies(&g, 1.0, Some(PENDULUM))
    };
    HeavyLinkage::new(&g, bodies).in_motion()
}

/// A crane with a heavy tail that rocks freely about the upright, in steps of 1 ms: least and greatest angle (rad),
/// and by how much its energy has changed, relative to that of rocking alone.
pub fn rock(steps: u32) -> ([f64; 2], f64) {
    let crane = with_boom(120e3, -12.0, 2.0, None);
    let mut m = Phase {
        theta: 1.2,
        omega: 0.05,
        swing: 0.0,
        swing_rate: 0.0,
    };
    let energy = |m: &Phase| crane.energy(m).expect("closes");
    let (first, mut extremes) = (energy(&m), [f64::INFINITY, f64::NEG_INFINITY]);
    // The energy of rocking is that above rest at the lowest point of the path.
    let mut lowest = f64::INFINITY;
    for _ in 0..steps {
        m = crane.step(&m, 0.0, 1e-3).expect("stays within the range");
        extremes = [extremes[0].min(m.theta), extremes[1].max(m.theta)];
        lowest = lowest.min(energy(&Phase { omega: 0.0, ..m }));
    }
    (extremes, (energy(&m) - first) / (first - lowest))
}

/// The crane on a turntable whose axis lies X_8 behind O1.
pub fn turning(pendulum: Option<Pendulum>, inertia: f64) -> Dynamics {
    dynamics(pendulum).with_slewing(Turntable { axis: -5.2, inertia })
}

/// What drives a crane that luffs: a moment, and a brake's beside the dry friction (N·m).
pub const fn commands(moment: f64, brake: f64) -> Commands<1> {
    Commands {
        shaft: 0.0,
        drives: [JointDrive { moment, brake }],
        hoist: HoistCommand::speed(0.0),
    }
}

pub fn driven(moment: f64) -> Commands<1> {
    commands(moment, 0.0)
}

pub fn braked(brake: f64) -> Commands<1> {
    commands(0.0, brake)
}

/// Luffing between 60 and 120 deg, slewing without end; both with viscous (N·m·s/rad) and dry friction (N·m).
pub fn slewing(pendulum: Option<Pendulum>, inertia: f64, [luff, slew]: [[f64; 2]; 2]) -> Slewing {
    let joint = |[viscous, coulomb]: [f64; 2], stops: [f64; 2]| Joint {
        friction: Friction { viscous, coulomb },
        stops,
    };
    Slewing {
        dynamics: turning(pendulum, inertia),
        joints: [
            joint(luff, [60_f64.to_radians(), 120_f64.to_radians()]),
            joint(slew, [f64::NEG_INFINITY, f64::INFINITY]),
        ],
    }
}

/// Bore 320 mm, rod 220 mm; 600 l/min over one edge at 35 bar; ports of 0.2 l.
pub fn cylinder() -> Cylinder {
    Cylinder {
        areas: Cylinder::areas(0.32, 0.22),
        lengths: [4.0, 9.0],
        dead_volume: 2e-3,
        port_volume: 2e-4,
        line: Valve::rated(0.01, 2e5),
        leakage: 1e-12,
        bulk_modulus: 1.4e9,
        relief: [280e5, 1e-9],
        valve: Valve {
            conductance: Valve::rated(0.01, 35e5),
            overlap: 0.0,
            frequency: 300.0,
            damping: 0.7,
        },
        parts: None,
        torn: [0.0; 2],
    }
}

/// The anchors of the luffing cylinder.
pub const ANCHORS: Anchors<f64> = Anchors {
    e_x: 3.0,
    e_y: -1.5,
    s_d: 7.0,
    chi_d: -5.0 * std::f64::consts::PI / 180.0,
};

pub fn hydraulic<const N: usize>(pendulum: Option<Pendulum>) -> Hydraulic<N> {
    oiled(Crane::Plane(MovingLinkage {
        dynamics: pushed(pendulum),
        joints: [Joint {
            friction: Friction {
                viscous: 2e4,
                coulomb: 0.0,
            },
            stops: [0.5, 2.5],
        }],
    }))
}

/// The same on a turntable without friction.
pub fn hydraulic_slewing<const N: usize>(pendulum: Option<Pendulum>, inertia: f64) -> Hydraulic<N> {
    let mut crane = slewing(pendulum, inertia, [[2e4, 0.0], [0.0; 2]]);
    let turntable = crane.dynamics.turntable().expect("it slews");
    crane.dynamics = pushed(pendulum).with_slewing(turntable);
    crane.joints[0].stops = [0.5, 2.5];
    oiled(Crane::Slewing(crane))
}

fn oiled<const N: usize>(crane: Crane) -> Hydraulic<N> {
    Hydraulic {
        crane,
        cylinder: cylinder(),
        buffer: [0.0; 2],
        command: 0.0,
        supply: 250e5,
        hoist: HoistCommand::speed(0.0),
        slewing: JointDrive {
            moment: 0.0,
            brake: 0.0,
        },
    }
}
