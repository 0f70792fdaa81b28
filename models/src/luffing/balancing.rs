//! A balance on a boom: what it does at a position, and over the working range. The equations are those of
//! [`crate::balance`].

use num_dual::Dual64;

use crate::balance::Balance;
use crate::balance::analysis::{Analysis, Residual};
use crate::balance::boom::Load;
use crate::balance::scene::Form;
use crate::balance::symbols as s;
use crate::component::extreme::{Extreme, fine};
use crate::component::part::Component;
use crate::component::running::Running;
use crate::component::sheet::Summary;
use crate::component::stages::{Found, absent, results};
use crate::component::standing::Standing;
use crate::kernel::allowed::{FINITE, OutOfRange};
use crate::kernel::calc::Calc;
use crate::kernel::diagnostic::Diagnostic;
use crate::kernel::schema::Values;
use crate::kernel::symbol::Symbol;
use crate::parts::motion::Motion;
use crate::parts::plane::Point;

/// The balance of a boom, at no particular position.
#[derive(Clone, Copy, Debug)]
pub struct Balancing<C> {
    pub balance: Balance<C>,
    /// Boom angles (rad) between the dead points around the working range: beyond
    /// them the linkage would be another assembly of the same bars.
    arc: Option<[f64; 2]>,
}

impl<C: Calc> Balancing<C> {
    /// Assembled as at the boom angle `phi` (rad); `u_0` is the boom's potential energy (J) at a boom angle (rad).
    ///
    /// # Errors
    /// Quantities with which there is no such balance; what `u_0` objects to.
    pub fn new(
        form: &Form<C>,
        phi: f64,
        u_0: impl FnOnce(C) -> Result<C, OutOfRange>,
    ) -> Result<Balancing<C>, OutOfRange> {
        let balance = form.balance(u_0)?;
        let arc = match &balance {
            Balance::Lever(lever) => Some(lever.arc(phi)),
            Balance::Parallelogram(lever) => Some(lever.arc(phi)),
            _ => None,
        };
        Ok(Balancing { balance, arc })
    }

    /// The same over another scalar.
    #[must_use]
    pub fn map<D: Calc>(&self, f: fn(C) -> D) -> Balancing<D> {
        Balancing {
            balance: self.balance.map(f),
            arc: self.arc,
        }
    }

    /// At a boom angle (rad), with what the boom asks for there.
    ///
    /// # Errors
    /// A boom angle at which the balance cannot be, with those at which it can; a boom that stands still.
    pub fn at(&self, phi: C, load: impl FnOnce() -> Load<C>) -> Result<Residual<C>, OutOfRange> {
        self.reached(phi.value()).map_err(|(near, arc)| {
            let what = "the balance linkage cannot get to this angle without passing a dead point";
            OutOfRange::new(&s::PHI, near, arc, what)
        })?;
        let load = load();
        if !load.m_0.value().is_finite() {
            let what = "the boom stands still here: no moment about its foot balances it";
            return Err(OutOfRange::new(&s::M_0, load.m_0.value(), FINITE, what));
        }
        let action = self.balance.at(phi, &load)?;
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

    /// The counterweight at a boom angle (rad), in m from the boom foot, or on a straight rail from a place that does
    /// not move; `u_0` is the boom's potential energy (J) there. `None` where the balance cannot be.
    #[inline]
    pub fn place(&self, phi: C, u_0: impl FnOnce() -> C) -> Option<Point<C>> {
        self.reached(phi.value()).ok()?;
        self.balance.place(phi, u_0)
    }
}

/// Load, weights and balance together, against the mechanism without the balance.
#[derive(Clone, Copy, Debug)]
pub struct Balanced<C> {
    /// Total moment about the boom foot, in N·m; positive raises the boom.
    pub m_sum: C,
    /// Moment (N·m) that the drive would have to give without the balance, and its force (N).
    pub m_d_0: C,
    pub f_d_0: Option<C>,
}
results! { Balanced as b => {
    M_SUM: b.m_sum;
    M_D_0: b.m_d_0;
    F_D_0: b.f_d_0.ok_or_else(absent)?;
} }

impl<C: Calc> Balanced<C> {
    /// With the load's moment about the boom foot, load's and weights' moment about the foot of what is driven (N·m,
    /// positive where they lower it), and the force (N) that the drive needs for a moment, where there is a drive.
    pub fn new(
        residual: &Residual<C>,
        about_foot: C,
        [m_q, m_g]: [C; 2],
        force: impl FnOnce(C) -> Option<C>,
    ) -> Balanced<C> {
        let m_sum = (residual.dm - about_foot).def(&s::M_SUM);
        let m_d_0 = (m_q + m_g).def(&s::M_D_0);
        let f_d_0 = force(m_d_0);
        Balanced { m_sum, m_d_0, f_d_0 }
    }
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
results! { Criteria as c => {
    DM_MAX: c.dm_max;
    DM_5_MAX: c.dm_5_max.ok_or_else(absent)?;
    E: c.e_abs;
    E_PLUS: c.e_plus;
    GAMMA_MIN: c.gamma_min.ok_or_else(absent)?;
    N_MAX: c.n_max.ok_or_else(absent)?;
    DELTA_Y_5: c.travel.ok_or_else(absent)?;
} }

impl<C: Calc> Criteria<C> {
    /// # Errors
    /// As [`Balancing::at`].
    pub fn new(
        found: &Analysis,
        motion: &Motion,
        at: &dyn Fn(C) -> Result<Residual<C>, OutOfRange>,
    ) -> Result<Criteria<C>, OutOfRange> {
        let at = |theta: f64| at(C::constant(theta));
        let ends = [motion.from, motion.to];
        let places = std::iter::once(ends[0])
            .chain(found.equilibria.iter().map(|e| e.at))
            .chain(std::iter::once(ends[1]));
        let mut energies = places.map(|place| at(place).map(|r| (r.phi, r.boom.u_0 + r.action.u_5)));
        let mut last = energies.next().expect("a range has a start")?;
        let nothing = C::constant(0.0) * last.1;
        let (mut e_abs, mut e_plus) = (nothing, nothing);
        for next in energies {
            let next = next?;
            let fall = last.1 - next.1;
            e_abs += fall.abs();
            // The residual raises the boom where the energy falls with a growing boom angle.
            if (fall.value() > 0.0) == (next.0.value() > last.0.value()) {
                e_plus += fall.abs();
            }
            last = next;
        }
        let of = |extreme: Option<Extreme>, pick: fn(&Residual<C>) -> Option<C>| match extreme {
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

/// A mechanism whose boom a balance may carry.
pub trait WithBalance: Component {
    /// The boom's angle, its reach, and the moment that the drive must give.
    const SYMBOLS: [&'static Symbol; 3];

    /// `None` where the scene has no balance.
    fn form(given: &Self::Given<f64>) -> Option<Form<f64>>;

    /// The balance, and what it comes to over the working range.
    ///
    /// # Errors
    /// Quantities with which there is no such balance.
    fn balance(known: &mut Self::Known<f64>) -> Found<(Balancing<f64>, Analysis)>;

    /// The boom's head, in m from its foot.
    ///
    /// # Errors
    /// A position that does not exist.
    fn head(known: &mut Self::Known<f64>) -> Found<Point<f64>>;

    /// # Errors
    /// A position at which the balance cannot be.
    fn residual<C: Calc>(known: &mut Self::Known<C>) -> Found<Residual<C>>;
}

/// Results of the balance over the working range, with their places.
#[must_use]
pub fn searched<T: WithBalance>(model: &Standing) -> Vec<Summary> {
    let (coordinate, given) = (model.variables()[0].symbol, model.of::<T>().given());
    let found = T::form(given).and_then(|_| T::balance(&mut T::new(given.clone())).ok());
    found.map_or(Vec::new(), |(_, found)| found.extremes(coordinate))
}

/// Largest differences of independent ways over the working range, relative to the greatest moment: the balance's moment
/// against the fall of its counterweight's energy, the weights' moment by virtual work against their power about the
/// instant centres at a boom angle (rad). `None` where the scene has no balance.
pub fn agreement<T: WithBalance>(
    model: &Standing,
    by_power: impl Fn(f64) -> Result<f64, OutOfRange>,
) -> Option<[f64; 2]> {
    let given = model.of::<T>().given();
    T::form(given)?;
    let mut known = T::new(T::map(given, &mut |_, _, value| Dual64::from_re(value)));
    let (mut worst, mut scale) = ([0.0_f64; 2], f64::MIN_POSITIVE);
    for theta in fine(model.motion()) {
        T::put(&mut known, model.coordinate(), Dual64::new(theta, 1.0));
        let Ok(r) = T::residual(&mut known) else {
            return Some([f64::INFINITY; 2]);
        };
        let (m_0, m_b) = (r.boom.m_0.re, r.action.m_b.re);
        let by_energy = -r.action.u_5.eps / r.phi.eps;
        let by_power = by_power(r.phi.re).unwrap_or(f64::INFINITY);
        worst = [
            worst[0].max((m_b - by_energy).abs()),
            worst[1].max((m_0 - by_power).abs()),
        ];
        scale = scale.max(m_0.abs()).max(m_b.abs());
    }
    Some(worst.map(|difference| difference / scale))
}

/// What own weights, a balance and its limits need; `weights` are those of this mechanism, in words. Mistakes go to
/// `found`.
pub fn complete(v: &Values, form: Option<&Form<f64>>, weights: &str, found: &mut Vec<Diagnostic>) {
    // A load that cannot be read is not one that is missing.
    let loaded = v.has("Q") || !found.is_empty();
    let mut mistake = |place, what: String, label: &str, help: &str| {
        found.push(Diagnostic::new(place, what, label).help(help));
    };
    if v.has("weights") && !loaded {
        mistake(
            v.place("weights"),
            "own weights without a load".to_owned(),
            "these need forces to be modelled",
            "add Q = \"0 kN\" or more to [luffing]",
        );
    }
    if v.has("balance") && !v.has("weights") {
        mistake(
            v.place("balance"),
            "a balance without own weights".to_owned(),
            "there is nothing to balance",
            &format!("add [luffing.weights] with {weights}"),
        );
    }
    let Some(limits) = v.table("limits") else { return };
    let of_balance = [&s::DM_MAX, &s::GAMMA_MIN, &s::N_MAX];
    for symbol in of_balance.into_iter().filter(|symbol| limits.has(symbol.id)) {
        let what = match form {
            Some(form) if form.has(symbol) => continue,
            Some(form) => format!("a balance of the kind \"{}\" has no {}", form.kind(), symbol.id),
            None => format!("a limit {} without a balance", symbol.id),
        };
        mistake(limits.place(symbol.id), what, "nothing to check", "remove the limit");
    }
}
