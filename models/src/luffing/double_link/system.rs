//! The boom system of the mechanism, as a balance sees it: what its weights ask for over the boom angle.

use num_dual::Dual64;

use crate::balance::boom::{Boom, Load};
use crate::balance::symbols as b;
use crate::kernel::allowed::{FINITE, NOT_NEGATIVE, OutOfRange, check};
use crate::kernel::calc::Calc;
use crate::luffing::double_link::geometry::Geometry;
use crate::luffing::double_link::misfit::Misfit;
use crate::luffing::double_link::parameters::{Driven, Parameters, Weights};
use crate::luffing::double_link::pole::Pole;
use crate::luffing::double_link::position::Position;
use crate::luffing::double_link::statics::{Centres, Own};
use crate::luffing::double_link::symbols as s;
use crate::luffing::double_link::velocity::Velocity;
use crate::luffing::led::pull::Hauled;
use crate::parts::plane::{self, Point};

/// The mechanism with the weights of boom, jib and rocker, driven by its boom.
#[derive(Clone, Copy, Debug)]
pub struct BoomSystem<C> {
    pub g: Geometry<C>,
    pub w: Weights<C>,
}

/// What the weights ask for of the boom at a position.
pub fn load<C: Calc>(g: &Geometry<C>, w: &Weights<C>, p: &Position<C>, v: &Velocity<C>, own: &Own<C>) -> Load<C> {
    // The same power at the boom.
    let m_0 = match p.driven {
        Driven::Boom => -own.m_g,
        Driven::Rocker => -(own.m_g / v.i_follower),
    };
    Load {
        m_0: m_0.def(&b::M_0),
        u_0: height(g, w, p, &own.centres),
    }
}

/// Potential energy of the own weights, in J, from the height of the boom foot.
pub fn height<C: Calc>(g: &Geometry<C>, w: &Weights<C>, p: &Position<C>, r: &Centres<C>) -> C {
    (w.g_1 * r.boom.y + w.g_2 * (p.b.y + r.jib.y) + w.g_3 * (g.lengths.x_6 + r.rocker.y)).def(&b::U_0)
}

/// How the links turn for one radian of the driving one, by their instantaneous centres: no loop of velocities is in it.
#[derive(Clone, Copy, Debug)]
pub struct ByCentres<C> {
    /// Angular velocity of the bar that is not driven over the driving link's.
    pub follower: C,
    /// The jib's, and its centre, in m from O1; where it only shifts, its travel, in m.
    jib: Result<(C, Point<C>), Point<C>>,
}

impl<C: Calc> ByCentres<C> {
    /// [Ports001, 5.4, 5.9]
    pub fn new(g: &Geometry<C>, p: &Position<C>) -> ByCentres<C> {
        let one = C::constant(1.0);
        let (x_1, x_3) = ((p.x_1, g.lengths.x_1), (p.x_3, g.lengths.x_3));
        let ((driving, _), (follower, length), name) = match p.driven {
            Driven::Boom => (x_1, x_3, &s::I_3),
            Driven::Rocker => (x_3, x_1, &s::I_1),
        };
        match Pole::new(g, p, &Velocity::new(p)) {
            Pole::Finite { o1p, o3p, at } => {
                let (boom, rocker) = (o1p / g.lengths.x_1, o3p / g.lengths.x_3);
                let [first, last] = match p.driven {
                    Driven::Boom => [boom, rocker],
                    Driven::Rocker => [rocker, boom],
                };
                let i_2 = (one / (one - first)).def(&s::I_2);
                ByCentres {
                    follower: (i_2 * (one - last)).def(name),
                    jib: Ok((i_2, at)),
                }
            }
            // Boom and rocker are parallel.
            Pole::AtInfinity(_) => ByCentres {
                follower: (plane::dot(driving, follower) / length.square()).def(name),
                jib: Err(Point::new(-driving.y, driving.x)),
            },
        }
    }

    /// Rise of a point of the jib this far forward of O1, in m, for one radian.
    pub fn rise(&self, x: C) -> C {
        match self.jib {
            Ok((i_2, centre)) => i_2 * (x - centre.x),
            Err(travel) => travel.y,
        }
    }

    /// What the jib's centre is of every such rise, in m.
    pub fn lever(&self) -> C {
        match self.jib {
            Ok((i_2, centre)) => i_2 * centre.x,
            Err(_) => C::constant(0.0),
        }
    }

    /// Power of load and weights (N) of boom, jib and rocker for one radian of the driving link, in N·m.
    pub fn power(&self, p: &Position<C>, q: C, own: Option<(&Weights<C>, &Centres<C>)>) -> [C; 3] {
        let load = q * self.rise(p.a.x);
        let Some((w, r)) = own else {
            return [C::constant(0.0), load, C::constant(0.0)];
        };
        let (boom, rocker) = (w.g_1 * r.boom.x, w.g_3 * r.rocker.x);
        let jib = load + w.g_2 * self.rise(p.b.x + r.jib.x);
        match p.driven {
            Driven::Boom => [boom, jib, rocker * self.follower],
            Driven::Rocker => [boom * self.follower, jib, rocker],
        }
    }

    /// Power of a led rope on boom, jib and rocker for one radian of the driving link, in N·m.
    pub fn hauled(&self, p: &Position<C>, [boom, jib, rocker]: &[Hauled<C>; 3]) -> [C; 3] {
        let jib = match self.jib {
            Ok((i_2, centre)) => i_2 * (jib.moment + plane::cross(p.b - centre, jib.force)),
            Err(travel) => plane::dot(jib.force, travel),
        };
        match p.driven {
            Driven::Boom => [boom.moment, jib, rocker.moment * self.follower],
            Driven::Rocker => [boom.moment * self.follower, jib, rocker.moment],
        }
    }
}

impl<C: Calc> BoomSystem<C> {
    /// # Errors
    /// A mechanism that does not exist, has no weights or is driven by its rocker.
    pub fn new(p: &Parameters<C>) -> Result<BoomSystem<C>, OutOfRange> {
        let lengths = p.lengths;
        let fault = |misfit| {
            let values = p.values();
            let words = values.describe(misfit);
            let (symbol, value) = match misfit {
                Misfit::Jib => (&s::X_2, lengths.x_2.value()),
                Misfit::Frame => (&s::X_5, lengths.x_5.value()),
                Misfit::Linkage => (&s::X_3, lengths.x_3.value()),
            };
            OutOfRange::new(symbol, value, FINITE, format!("{}; {}", words.what, words.help))
        };
        if p.driven != Driven::Boom {
            let what = "a balance needs a scene that is driven by its boom";
            return Err(OutOfRange::new(&s::X_3, lengths.x_3.value(), FINITE, what));
        }
        let Some(w) = p.weights else {
            let what = "the boom system has no weights: there is nothing to balance";
            return Err(OutOfRange::new(&s::G_1, 0.0, NOT_NEGATIVE, what));
        };
        let mut sound = Ok(());
        w.map(&mut |symbol, value: C| {
            let allowed = if symbol.id.starts_with("chi") {
                FINITE
            } else {
                NOT_NEGATIVE
            };
            if sound.is_ok() {
                sound = check(symbol, value.value(), allowed);
            }
        });
        sound?;
        Ok(BoomSystem {
            g: Geometry::new(p).map_err(fault)?,
            w,
        })
    }

    fn place(&self, phi: C) -> Result<Position<C>, OutOfRange> {
        Position::new(&self.g, phi).ok_or_else(|| self.outside(phi))
    }

    fn outside(&self, phi: C) -> OutOfRange {
        let phi = phi.value();
        let what = "the boom system does not close at this angle";
        OutOfRange::new(&b::PHI, phi, self.arc(phi), what)
    }
}

impl<C: Calc> Boom<C> for BoomSystem<C> {
    /// [Balance004, eq. 1]
    fn at(&self, phi: C) -> Result<Load<C>, OutOfRange> {
        let p = self.place(phi)?;
        let v = Velocity::new(&p);
        let own = Own::new(&p, &v, &self.g.lengths, &self.w);
        let load = load(&self.g, &self.w, &p, &v, &own);
        if load.m_0.value().is_finite() {
            Ok(load)
        } else {
            Err(self.outside(phi))
        }
    }

    /// Of boom, jib, rocker.
    fn parts(&self, phi: C) -> Result<[C; 3], OutOfRange> {
        let nothing = C::constant(0.0);
        let w = &self.w;
        let alone = |keep: usize| {
            let [g_1, g_2, g_3] = [w.g_1, w.g_2, w.g_3].map(|weight| nothing * weight);
            let mut alone = Weights { g_1, g_2, g_3, ..*w };
            match keep {
                0 => alone.g_1 = w.g_1,
                1 => alone.g_2 = w.g_2,
                _ => alone.g_3 = w.g_3,
            }
            BoomSystem { g: self.g, w: alone }.at(phi).map(|load| load.m_0)
        };
        Ok([alone(0)?, alone(1)?, alone(2)?])
    }

    /// Angular velocities come from the centres too.
    fn moment_by_power(&self, phi: C) -> Result<C, OutOfRange> {
        let BoomSystem { g, w } = self;
        let p = self.place(phi)?;
        let r = Centres::new(&p, &g.lengths, w);
        let by = ByCentres::new(g, &p);
        let jib = by.rise(p.b.x + r.jib.x);
        Ok((-(w.g_1 * r.boom.x + w.g_2 * jib + w.g_3 * by.follower * r.rocker.x)).def(&b::M_0_P))
    }

    fn slope(&self, phi: f64) -> Result<[f64; 2], OutOfRange> {
        let dual = BoomSystem {
            g: self.g.map(|value| Dual64::from_re(value.value())),
            w: self.w.map(&mut |_, value| Dual64::from_re(value.value())),
        };
        let m_0 = dual.at(Dual64::new(phi, 1.0))?.m_0;
        Ok([m_0.re, m_0.eps])
    }

    fn arc(&self, phi: f64) -> [f64; 2] {
        if self.g.linkage.turns_fully() {
            return FINITE;
        }
        let arcs = self.g.linkage.arcs();
        let near = arcs.iter().find(|arc| (arc.from..=arc.to).contains(&phi));
        let near = near.unwrap_or(&arcs[0]);
        [near.from, near.to]
    }
}
