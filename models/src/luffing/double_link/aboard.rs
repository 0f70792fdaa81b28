//! The double link on something that moves: its bars as point masses, its jib's head.

use num_dual::{Dual2, Dual64};

use crate::balance::scene::BALANCE;
use crate::balance::symbols as b;
use crate::component::outline::joined;
use crate::kernel::calc::Calc;
use crate::kernel::diagnostic::Diagnostic;
use crate::kernel::keys::keys;
use crate::kernel::schema::{Key, SOURCE, Values};
use crate::kernel::symbol::{Symbol, listed};
use crate::luffing::aboard::{Aboard, MOTION, Posed};
use crate::luffing::double_link::balancing;
use crate::luffing::double_link::geometry::Geometry;
use crate::luffing::double_link::keys::{LINKS, WEIGHTS};
use crate::luffing::double_link::linkage::{Bodies, HeavyLinkage, bars};
use crate::luffing::double_link::moving::built::{Inertias, slender};
use crate::luffing::double_link::moving::symbols as m;
use crate::luffing::double_link::parameters::Parameters;
use crate::luffing::double_link::position::Position;
use crate::luffing::double_link::scene::{balanced, motion, parameters};
use crate::luffing::double_link::symbols as s;
use crate::luffing::moving::bodies::parts;
use crate::parts::motion::Motion;
use crate::parts::plane::Point;

/// Keys of `[luffing]` that it has there.
pub const KEYS: &[Key] = &joined::<_, 13, 5, 18>(
    LINKS,
    [
        Key::table("motion", MOTION, "Working range of the driving link."),
        Key::part("weights", WEIGHTS, "Own weights and their centres of gravity."),
        BALANCE,
        Key::part("dynamics", INERTIAS, "Inertias of boom, jib and rocker."),
        SOURCE,
    ],
);

static INERTIAS: &[Key] = keys! { m: J_1 >= 0, J_2 >= 0, J_3 >= 0 };

/// What is given of it.
pub const GIVEN: &[&Symbol] = &joined::<_, 22, 18, 40>(
    [
        &s::X_1,
        &s::X_2,
        &s::X_3,
        &s::X_4,
        &s::X_5,
        &s::X_6,
        &s::X_7,
        &s::X_8,
        &s::BETA_0,
        &s::AC,
        &s::G_1,
        &s::S_1,
        &s::CHI_1,
        &s::G_2,
        &s::S_2,
        &s::CHI_2,
        &s::G_3,
        &s::S_3,
        &s::CHI_3,
        &m::J_1,
        &m::J_2,
        &m::J_3,
    ],
    *listed!(b:
        G_C, R_C, CHI_C, D_1, DELTA_1, R_K, ALPHA_K, L_1, R_L, CHI_5, M_5, S_5, H_X, H_Y, LAMBDA, L_R, Y_0, PHI_0
    ),
);

/// A double link with its bodies.
#[derive(Debug)]
pub struct LinkAboard {
    linkage: HeavyLinkage,
    parameters: Parameters<f64>,
    range: Motion,
}

impl LinkAboard {
    /// As [`carried`](crate::luffing::kinds::carried).
    pub fn read(v: &Values, gravity: f64, moves: bool, found: &mut Vec<Diagnostic>) -> Option<LinkAboard> {
        let before = found.len();
        let parameters = parameters(v, found)?;
        if parameters.balance.is_some() && parameters.weights.is_none() {
            let help = "add [luffing.weights], the weights of boom, jib and rocker, or remove it";
            found.push(v.refuse(
                "balance",
                "a balance of bars without weight",
                "nothing to balance",
                help,
            ));
        }
        let range = motion(v, &parameters, found)?;
        if let Some(table) = v.table("balance").filter(|_| parameters.weights.is_some()) {
            balanced(v, table, &parameters, &range, found);
        }
        let inertias = v.table("dynamics").and_then(Inertias::read);
        if moves && parameters.weights.is_some() && inertias.is_none() {
            let help = "add [luffing.dynamics] with J_1, J_2 and J_3 (kg.m2)";
            found.push(v.refuse(
                "weights",
                "bars that weigh and have no inertia",
                "they move with the hull",
                help,
            ));
        }
        let geometry = Geometry::new(&parameters).ok().filter(|_| found.len() == before)?;
        let inertias = inertias.unwrap_or(Inertias {
            j_1: 0.0,
            j_2: 0.0,
            j_3: 0.0,
        });
        let [boom, jib, rocker] = slender(&geometry, parameters.weights.as_ref(), &inertias, gravity);
        let bodies = Bodies {
            boom,
            jib,
            rocker,
            pendulum: None,
            load: None,
            gravity,
        };
        let linkage = HeavyLinkage::new(&geometry, bodies)
            .with_balance(&parameters, &range)
            .ok()?;
        Some(LinkAboard {
            linkage,
            parameters,
            range,
        })
    }
}

impl Aboard for LinkAboard {
    fn range(&self) -> &Motion {
        &self.range
    }

    fn offset(&self) -> f64 {
        self.parameters.lengths.x_8
    }

    fn gravity(&self) -> f64 {
        self.linkage.bodies.gravity
    }

    fn posed(&self, theta: Dual64) -> Option<Posed<Dual64>> {
        let (positions, of) = (&self.linkage.thrice, Dual64::constant);
        let (g, theta) = (&positions.geometry, Dual2::new(theta, of(1.0), of(0.0)));
        let p = Position::new(g, theta)?;
        let gravity = self.linkage.bodies.gravity;
        let mut weights = Vec::with_capacity(7);
        for (body, bar) in self.linkage.bodies.bars().into_iter().zip(bars(g, &p)) {
            let halves = body.halves();
            weights.extend(halves.map(|(mass, at)| (of(mass * gravity), bar.point(at.map(of)))));
        }
        if let Some(weight) = &positions.counterweight {
            let place = balancing::place(&weight.balancing, g, &weight.weights, &p, theta)?;
            weights.push((weight.mass.scaled(gravity), parts(place)));
        }
        Some(Posed {
            head: parts(p.a),
            weights,
        })
    }

    fn bars(&self, theta: f64) -> Vec<Vec<Point<f64>>> {
        let Some(p) = Geometry::new(&self.parameters)
            .ok()
            .and_then(|geometry| Position::new(&geometry, theta))
        else {
            return Vec::new();
        };
        let c = p.b + p.x_2;
        vec![
            vec![Point::new(0.0, 0.0), p.b],
            vec![p.a, p.b, c, p.a],
            vec![self.parameters.lengths.o3(), c],
        ]
    }
}
