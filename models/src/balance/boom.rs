//! The boom system: the moment of its weights about the boom foot, by virtual
//! work and by the power about instant centres.

use crate::balance::{FINITE, Fault, NOT_NEGATIVE, check, symbols as s};
use crate::calc::Calc;
use crate::lemniscate::geometry::{Driven, Geometry, Misfit, Parameters, Weights};
use crate::lemniscate::position::Position;
use crate::lemniscate::statics::{Centres, weight_moment};
use crate::lemniscate::symbols as l;
use crate::lemniscate::velocity::{Pole, Velocity};
use crate::plane::{self, Point};
use crate::symbol::quantities;

quantities! {
    /// A boom without jib: weight (N), distance (m) and angle (rad) of its centre of gravity.
    Plain { g_b: G_B, r_b: R_B, chi_b: CHI_B }
}

/// What has to be balanced.
#[derive(Clone, Copy, Debug)]
pub enum Boom<C> {
    Plain(Plain<C>),
    /// The double-link mechanism with the weights of boom, jib and rocker.
    System(Geometry<C>, Weights<C>),
}

/// What the weights ask for at one boom angle.
#[derive(Clone, Copy, Debug)]
pub struct Load<C> {
    /// Moment about the boom foot, in N·m; positive raises the boom.
    pub m_0: C,
    /// Potential energy, in J, from the height of the boom foot.
    pub u_0: C,
}

impl<C: Calc> Load<C> {
    /// Of the double-link mechanism at a position; `m_g` is the moment of its
    /// weights about the foot of the driven bar (N·m, positive lowers it).
    pub fn new(g: &Geometry<C>, w: &Weights<C>, p: &Position<C>, v: &Velocity<C>, r: &Centres<C>, m_g: C) -> Load<C> {
        // The same power at the boom.
        let m_0 = match p.driven {
            Driven::Boom => -m_g,
            Driven::Rocker => -(m_g / v.i_follower),
        };
        Load {
            m_0: m_0.def(&s::M_0),
            u_0: height(g, w, p, r),
        }
    }
}

/// Potential energy of the double-link mechanism's own weights, in J, from the height of the boom foot.
pub fn height<C: Calc>(g: &Geometry<C>, w: &Weights<C>, p: &Position<C>, r: &Centres<C>) -> C {
    (w.g_1 * r.boom.y + w.g_2 * (p.b.y + r.jib.y) + w.g_3 * (g.lengths.x_6 + r.rocker.y)).def(&s::U_0)
}

impl<C: Calc> Plain<C> {
    /// # Errors
    /// A weight or a distance that is negative or no number.
    pub fn boom(self) -> Result<Boom<C>, Fault> {
        check(&s::G_B, self.g_b.value(), NOT_NEGATIVE)?;
        check(&s::R_B, self.r_b.value(), NOT_NEGATIVE)?;
        check(&s::CHI_B, self.chi_b.value(), FINITE)?;
        Ok(Boom::Plain(self))
    }
}

impl<C: Calc> Boom<C> {
    /// The double-link mechanism, driven by its boom.
    ///
    /// # Errors
    /// A mechanism that does not exist, has no weights or is driven by its rocker.
    pub fn system(p: &Parameters<C>) -> Result<Boom<C>, Fault> {
        let lengths = p.lengths;
        let fault = |misfit| {
            let values = p.values();
            let words = values.describe(misfit);
            let (symbol, value) = match misfit {
                Misfit::Jib => (&l::X_2, lengths.x_2.value()),
                Misfit::Frame => (&l::X_5, lengths.x_5.value()),
                Misfit::Linkage => (&l::X_3, lengths.x_3.value()),
            };
            Fault::new(symbol, value, FINITE, format!("{}; {}", words.what, words.help))
        };
        if p.driven != Driven::Boom {
            return Err(Fault::new(
                &l::X_3,
                lengths.x_3.value(),
                FINITE,
                "a balance needs a scene that is driven by its boom",
            ));
        }
        let Some(weights) = p.weights else {
            return Err(Fault::new(
                &l::G_1,
                0.0,
                NOT_NEGATIVE,
                "the boom system has no weights: there is nothing to balance",
            ));
        };
        let mut sound = Ok(());
        weights.map(&mut |symbol, value: C| {
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
        Ok(Boom::System(Geometry::new(p).map_err(fault)?, weights))
    }

    /// Angles between which the boom can be, in rad, around `phi`.
    #[must_use]
    pub fn arc(&self, phi: f64) -> [f64; 2] {
        match self {
            Boom::Plain(_) => FINITE,
            Boom::System(g, _) if g.linkage.turns_fully() => FINITE,
            Boom::System(g, _) => {
                let arcs = g.linkage.arcs();
                let near = arcs
                    .iter()
                    .find(|arc| (arc.from..=arc.to).contains(&phi))
                    .unwrap_or(&arcs[0]);
                [near.from, near.to]
            }
        }
    }

    /// Moment and potential energy at boom angle `phi` (rad). [Balance004, eq. 1]
    ///
    /// # Errors
    /// An angle at which the boom system does not close, with the angles at which it does.
    pub fn at(&self, phi: C) -> Result<Load<C>, Fault> {
        match self {
            Boom::Plain(p) => {
                let (sin, cos) = (phi + p.chi_b).sin_cos();
                Ok(Load {
                    m_0: (-(p.g_b * p.r_b * cos)).def(&s::M_0),
                    u_0: (p.g_b * p.r_b * sin).def(&s::U_0),
                })
            }
            Boom::System(g, w) => {
                let (p, centres) = self.place(g, w, phi)?;
                let v = Velocity::new(&p);
                let load = Load::new(g, w, &p, &v, &centres, weight_moment(w, &centres, &p, &v));
                if load.m_0.value().is_finite() {
                    Ok(load)
                } else {
                    Err(self.outside(phi))
                }
            }
        }
    }

    /// What each weight contributes to the moment, in N·m: boom, jib, rocker.
    ///
    /// # Errors
    /// As [`at`](Boom::at).
    pub fn parts(&self, phi: C) -> Result<[C; 3], Fault> {
        let nothing = C::constant(0.0);
        match self {
            Boom::Plain(p) => {
                let m_0 = self.at(phi)?.m_0;
                Ok([m_0, nothing * p.g_b * p.r_b, nothing * p.g_b * p.r_b])
            }
            Boom::System(g, w) => {
                let alone = |keep: usize| {
                    let [g_1, g_2, g_3] = [w.g_1, w.g_2, w.g_3].map(|weight| nothing * weight);
                    let mut alone = Weights { g_1, g_2, g_3, ..*w };
                    match keep {
                        0 => alone.g_1 = w.g_1,
                        1 => alone.g_2 = w.g_2,
                        _ => alone.g_3 = w.g_3,
                    }
                    Boom::System(*g, alone).at(phi).map(|load| load.m_0)
                };
                Ok([alone(0)?, alone(1)?, alone(2)?])
            }
        }
    }

    /// The same moment by the power of each weight about the instant centre of
    /// its bar; angular velocities come from the centres too. [Ports001, 9]
    ///
    /// # Errors
    /// As [`at`](Boom::at).
    pub fn moment_by_power(&self, phi: C) -> Result<C, Fault> {
        let (g, w) = match self {
            Boom::Plain(_) => return self.at(phi).map(|load| load.m_0.def(&s::M_0_P)),
            Boom::System(g, w) => (g, w),
        };
        let (p, r) = self.place(g, w, phi)?;
        let one = C::constant(1.0);
        // Jib about its centre, and the rocker's ratio.
        let (jib, i_3) = match Pole::new(g, &p, Velocity::new(&p).i_2) {
            Pole::Finite { o1p, o3p, at } => {
                let i_2 = (one / (one - o1p / g.lengths.x_1)).def(&l::I_2);
                let i_3 = (i_2 * (one - o3p / g.lengths.x_3)).def(&l::I_3);
                (i_2 * (p.b.x + r.jib.x - at.x), i_3)
            }
            // The jib only shifts: boom and rocker are parallel.
            Pole::AtInfinity => (
                p.x_1.x,
                (plane::dot(p.x_1, p.x_3) / g.lengths.x_3.square()).def(&l::I_3),
            ),
        };
        Ok((-(w.g_1 * r.boom.x + w.g_2 * jib + w.g_3 * i_3 * r.rocker.x)).def(&s::M_0_P))
    }

    fn place(&self, g: &Geometry<C>, w: &Weights<C>, phi: C) -> Result<(Position<C>, Centres<C>), Fault> {
        let p = Position::new(g, phi).ok_or_else(|| self.outside(phi))?;
        let lengths = [g.lengths.x_1, g.lengths.x_2, g.lengths.x_3];
        let centres = Centres::new(&p, lengths, w);
        Ok((p, centres))
    }

    fn outside(&self, phi: C) -> Fault {
        let phi = phi.value();
        Fault::new(
            &s::PHI,
            phi,
            self.arc(phi),
            "the boom system does not close at this angle",
        )
    }
}

/// The joint on the boom at `r` (m) and `alpha` (rad) from its axis.
pub fn joint<C: Calc>(phi: C, r: C, alpha: C) -> Point<C> {
    let (sin, cos) = (phi + alpha).def(&s::PHI_K).sin_cos();
    plane::def(Point::new(r * cos, r * sin), [&s::K_X, &s::K_Y])
}
