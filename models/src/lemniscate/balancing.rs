//! A balance on this mechanism: what it does to the boom while any bar is
//! driven, and over the working range. The equations are those of
//! [`crate::balance`].

use num_dual::Dual64;

use crate::balance::analysis::{Analysis, Residual};
use crate::balance::boom::{Boom, Load, height};
use crate::balance::{Balance, Fault, symbols as b};
use crate::calc::Calc;
use crate::four_bar::Branch;
use crate::lemniscate::drive::Drive;
use crate::lemniscate::geometry::{Driven, Geometry, Parameters, Weights};
use crate::lemniscate::position::Position;
use crate::lemniscate::scene::Motion;
use crate::lemniscate::statics::{Centres, weight_moment};
use crate::lemniscate::symbols as s;
use crate::lemniscate::velocity::Velocity;
use crate::plane::{self, Point};
use crate::symbol::Symbol;

/// The balance of a mechanism, at no particular position.
#[derive(Clone, Copy, Debug)]
pub struct Balancing<C> {
    pub balance: Balance<C>,
    /// Boom angles (rad) between the dead points around the working range: beyond
    /// them the linkage would be another assembly of the same bars.
    arc: Option<[f64; 2]>,
}

impl<C: Calc> Balancing<C> {
    /// `None` where the parameters have no balance.
    ///
    /// # Errors
    /// Quantities with which there is no such balance; a boom system without weights.
    pub fn new(p: &Parameters<C>, motion: &Motion) -> Result<Option<Balancing<C>>, Fault> {
        let Some(form) = &p.balance else {
            return Ok(None);
        };
        let balance = form.balance(|| Boom::system(&by_boom(p, motion))).map_err(in_scene)?;
        let middle = middle(&p.values(), motion);
        let phi = middle.map_or(0.0, |p| f64::direction(p.x_1.x, p.x_1.y));
        let arc = match &balance {
            Balance::Lever(lever) => Some(lever.arc(phi)),
            Balance::Parallelogram(lever) => Some(lever.arc(phi)),
            _ => None,
        };
        Ok(Some(Balancing { balance, arc }))
    }

    /// The same over another scalar.
    #[must_use]
    pub fn map<D: Calc>(&self, f: fn(C) -> D) -> Balancing<D> {
        Balancing {
            balance: self.balance.map(f),
            arc: self.arc,
        }
    }

    /// At a position with `theta` (rad) of the driven bar; `m_g` is the moment of the
    /// weights `w` about its foot, in N·m.
    ///
    /// # Errors
    /// A boom angle at which the balance cannot be, with those at which it can; a boom
    /// that stands still.
    pub fn at(
        &self,
        g: &Geometry<C>,
        (w, r): (&Weights<C>, &Centres<C>),
        (p, v): (&Position<C>, &Velocity<C>),
        theta: C,
        m_g: C,
    ) -> Result<Residual<C>, Fault> {
        let phi = boom_angle(p, theta);
        self.reached(phi.value()).map_err(|(near, arc)| {
            let what = "the balance linkage cannot get to this angle without passing a dead point";
            Fault::new(&s::THETA_1, near, arc, what)
        })?;
        let load = Load::new(g, w, p, v, r, m_g);
        if !load.m_0.value().is_finite() {
            let what = "the boom stands still here: no moment about its foot balances it";
            return Err(Fault::new(&b::M_0, load.m_0.value(), crate::balance::FINITE, what));
        }
        let action = self.balance.at(phi, &load).map_err(in_scene)?;
        Ok(Residual::of(phi, load, action))
    }

    /// Whether the balance gets to a boom angle (rad); if not, the same angle near its arc, and the arc.
    fn reached(&self, phi: f64) -> Result<(), (f64, [f64; 2])> {
        let Some(arc) = self.arc else {
            return Ok(());
        };
        let turn = std::f64::consts::TAU;
        let near = phi - ((phi - f64::midpoint(arc[0], arc[1])) / turn).round() * turn;
        if (arc[0]..=arc[1]).contains(&near) {
            Ok(())
        } else {
            Err((near, arc))
        }
    }

    /// The counterweight at a position with `theta` (rad) of the driven bar, in m from the boom foot, or on
    /// a straight rail from a place that does not move; `None` where the balance cannot be.
    #[inline]
    pub fn place(&self, g: &Geometry<C>, w: &Weights<C>, p: &Position<C>, theta: C) -> Option<Point<C>> {
        let phi = boom_angle(p, theta);
        self.reached(phi.value()).ok()?;
        self.balance.place(phi, || {
            let l = &g.lengths;
            height(g, w, p, &Centres::new(p, [l.x_1, l.x_2, l.x_3], w))
        })
    }
}

/// Angle of the boom (rad) where the driven bar is at `theta` (rad).
fn boom_angle<C: Calc>(p: &Position<C>, theta: C) -> C {
    match p.driven {
        Driven::Boom => theta,
        Driven::Rocker => p.follower_angle(),
    }
}

/// Load, weights and balance together, against the mechanism without the balance.
#[derive(Clone, Copy, Debug)]
pub struct Balanced<C> {
    pub residual: Residual<C>,
    /// Total moment about the boom foot, in N·m; positive raises the boom.
    pub m_sum: C,
    /// Moment (N·m) that the drive would have to give without the balance, and its force (N).
    pub without: (C, Option<C>),
}

impl<C: Calc> Balanced<C> {
    /// `m_q` and `m_g` are the moments of load and weights about the foot of the
    /// driven bar, in N·m; positive lowers it.
    pub fn new(residual: Residual<C>, v: &Velocity<C>, driven: Driven, m_q: C, m_g: C) -> Balanced<C> {
        let load = match driven {
            Driven::Boom => m_q,
            Driven::Rocker => m_q / v.i_follower,
        };
        Balanced {
            residual,
            m_sum: (residual.dm - load).def(&b::M_SUM),
            without: ((m_q + m_g).def(&b::M_D_0), None),
        }
    }

    /// With the force of a drive.
    #[must_use]
    pub fn driven_by(mut self, drive: &Drive<C>) -> Balanced<C> {
        self.without.1 = Some(drive.force(self.without.0, &b::F_D_0));
        self
    }
}

/// The residual over any scalar at an angle (rad) of the driven bar.
///
/// # Errors
/// As [`Balancing::at`]; an angle at which the linkage does not close.
pub fn residual<C: Calc>(
    balancing: &Balancing<C>,
    g: &Geometry<C>,
    w: &Weights<C>,
    theta: C,
) -> Result<Residual<C>, Fault> {
    let l = &g.lengths;
    let Some(p) = Position::new(g, theta) else {
        let what = "the linkage does not close at this angle";
        return Err(Fault::new(&s::THETA_1, theta.value(), crate::balance::FINITE, what));
    };
    let (v, r) = (Velocity::new(&p), Centres::new(&p, [l.x_1, l.x_2, l.x_3], w));
    let m_g = weight_moment(w, &r, &p, &v);
    balancing.at(g, (w, &r), (&p, &v), theta, m_g)
}

/// Results of the balance over the working range; `None` where there is no balance.
///
/// # Errors
/// Where boom or balance cannot be over the whole range, with where they can.
pub fn analysis(p: &Parameters<f64>, motion: &Motion) -> Result<Option<Analysis>, Fault> {
    let (Some(balancing), Some(w)) = (Balancing::new(p, motion)?, &p.weights) else {
        return Ok(None);
    };
    let Ok(g) = Geometry::new(p) else { return Ok(None) };
    let at = |theta: f64| residual(&balancing, &g, w, theta);
    Analysis::over([motion.from, motion.to], &at)
        .map(Some)
        .map_err(in_scene)
}

/// Results of the working range over any scalar: found with `f64`, and then computed
/// where they occur, so that their derivatives are exact too (at an extreme, and
/// at a zero of the residual, the place's own change has no effect).
#[derive(Clone, Copy, Debug)]
pub struct Criteria<C> {
    pub dm_max: C,
    pub dm_5_max: Option<C>,
    pub e_abs: C,
    pub e_plus: C,
    pub gamma_min: Option<C>,
    pub n_max: Option<C>,
    pub travel: Option<C>,
}

impl<C: Calc> Criteria<C> {
    /// # Errors
    /// As [`analysis`].
    pub fn new(
        found: &Analysis,
        motion: &Motion,
        at: &dyn Fn(C) -> Result<Residual<C>, Fault>,
    ) -> Result<Criteria<C>, Fault> {
        let at = |theta: f64| at(C::constant(theta));
        let ends = [motion.from, motion.to];
        let places = std::iter::once(ends[0])
            .chain(found.equilibria.iter().map(|e| e.at))
            .chain(std::iter::once(ends[1]));
        let energies = places
            .map(|place| at(place).map(|r| (r.phi, r.boom.u_0 + r.action.u_5)))
            .collect::<Result<Vec<_>, Fault>>()?;
        let nothing = C::constant(0.0) * energies[0].1;
        let (mut e_abs, mut e_plus) = (nothing, nothing);
        for pair in energies.windows(2) {
            let fall = pair[0].1 - pair[1].1;
            e_abs += fall.abs();
            // The residual raises the boom where the energy falls with a growing boom angle.
            if (fall.value() > 0.0) == (pair[1].0.value() > pair[0].0.value()) {
                e_plus += fall.abs();
            }
        }
        let of = |extreme: Option<crate::lemniscate::range::Extreme>, pick: fn(&Residual<C>) -> Option<C>| match extreme
        {
            Some(extreme) if extreme.value.is_infinite() => Ok(Some(C::constant(extreme.value))),
            Some(extreme) => at(extreme.at).map(|r| pick(&r)),
            None => Ok(None),
        };
        let y_5 = |end: usize| of(found.y_5.map(|ends| ends[end]), |r| r.action.y_5);
        Ok(Criteria {
            dm_max: at(found.dm_max.at)?.dm.abs(),
            dm_5_max: of(found.dm_5_max, |r| r.dm_5.map(C::abs))?,
            e_abs,
            e_plus,
            gamma_min: of(found.gamma_min, |r| r.action.lever.map(|turn| turn.gamma))?,
            n_max: of(found.n_max, |r| r.action.n_1.map(C::abs))?,
            travel: y_5(1)?.zip(y_5(0)?).map(|(high, low)| high - low),
        })
    }
}

/// Largest differences of independent ways over `places` of the driven bar (rad),
/// relative to the greatest moment: the balance's moment against the fall of its
/// counterweight's energy, the weights' moment by virtual work against their power
/// about the instant centres.
pub fn agreement(p: &Parameters<f64>, motion: &Motion, places: impl Iterator<Item = f64>) -> [f64; 2] {
    let dual = p.map(&mut |_, value| Dual64::from_re(value));
    let boom = Boom::system(&by_boom(p, motion)).ok();
    let (balancing, g) = (Balancing::new(&dual, motion), Geometry::new(&dual));
    let (Ok(Some(balancing)), Ok(g), Some(w), Some(boom)) = (balancing, g, &dual.weights, boom) else {
        return [f64::INFINITY; 2];
    };
    let (mut worst, mut scale) = ([0.0_f64; 2], f64::MIN_POSITIVE);
    for theta in places {
        let Ok(r) = residual(&balancing, &g, w, Dual64::new(theta, 1.0)) else {
            return [f64::INFINITY; 2];
        };
        let (m_0, m_b) = (r.boom.m_0.re, r.action.m_b.re);
        let by_energy = -r.action.u_5.eps / r.phi.eps;
        let by_power = boom.moment_by_power(r.phi.re).unwrap_or(f64::INFINITY);
        worst = [
            worst[0].max((m_b - by_energy).abs()),
            worst[1].max((m_0 - by_power).abs()),
        ];
        scale = scale.max(m_0.abs()).max(m_b.abs());
    }
    worst.map(|difference| difference / scale)
}

/// The same mechanism with its boom as the driven bar, assembled as in the middle of the range.
fn by_boom<C: Calc>(p: &Parameters<C>, motion: &Motion) -> Parameters<C> {
    let branch = match p.driven {
        Driven::Boom => p.branch,
        Driven::Rocker => match middle(&p.values(), motion) {
            // C on the left of the line from O3 to B.
            Some(p) if plane::cross(p.x_3 - p.x_2, p.x_3) > 0.0 => Branch::Left,
            _ => Branch::Right,
        },
    };
    Parameters {
        driven: Driven::Boom,
        branch,
        ..*p
    }
}

/// The boom system as its boom moves it, and its boom angles (rad) over the working range.
///
/// # Errors
/// A mechanism without weights.
pub fn boom(p: &Parameters<f64>, motion: &Motion) -> Result<(Boom<f64>, [f64; 2]), Fault> {
    let boom = Boom::system(&by_boom(p, motion))?;
    let ends = [motion.from, motion.to].map(|theta| match p.driven {
        Driven::Boom => Some(theta),
        Driven::Rocker => Position::new(&Geometry::new(p).ok()?, theta).map(|p| p.follower_angle()),
    });
    let [Some(a), Some(b)] = ends else {
        let what = "the linkage does not close over the whole working range";
        return Err(Fault::new(&s::THETA_1, motion.from, crate::balance::FINITE, what));
    };
    Ok((boom, [a.min(b), a.max(b)]))
}

fn middle(p: &Parameters<f64>, motion: &Motion) -> Option<Position<f64>> {
    let g = Geometry::new(p).ok()?;
    Position::new(&g, f64::midpoint(motion.from, motion.to))
}

/// A fault in the names of this mechanism: its boom angle is `theta_1`.
fn in_scene(fault: Fault) -> Fault {
    let quantity: &'static Symbol = if fault.quantity == &b::PHI {
        &s::THETA_1
    } else {
        fault.quantity
    };
    Fault { quantity, ..fault }
}
