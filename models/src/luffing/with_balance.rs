//! What every mechanism has whose boom a balance may carry: its results of the range, checks, what its scene needs.

use num_dual::Dual64;

use crate::balance::analysis::Analysis;
use crate::balance::residual::Residual;
use crate::balance::scene::Form;
use crate::balance::symbols as s;
use crate::component::extreme::fine;
use crate::component::part::Component;
use crate::component::running::Running;
use crate::component::scalar::Scalar;
use crate::component::sheet::Summary;
use crate::component::stages::Found;
use crate::component::standing::Standing;
use crate::kernel::allowed::OutOfRange;
use crate::kernel::diagnostic::Diagnostic;
use crate::kernel::schema::Values;
use crate::kernel::symbol::Symbol;
use crate::luffing::balancing::Balancing;
use crate::parts::plane::Point;

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
    fn residual<C: Scalar>(known: &mut Self::Known<C>) -> Found<Residual<C>>;
}

/// Implements [`WithBalance`] beside the stages of a component, which have the names of its methods: its symbols, and the
/// stage and the point that its boom's head is.
macro_rules! with_balance {
    ($component:ident by [$($symbol:expr),+], head $stage:ident $point:ident) => {
        impl $crate::luffing::with_balance::WithBalance for $component {
            const SYMBOLS: [&'static $crate::kernel::symbol::Symbol; 3] = [$($symbol),+];

            fn form(given: &Given<f64>) -> Option<$crate::balance::scene::Form<f64>> {
                given.balance
            }

            fn balance(
                known: &mut Known<f64>,
            ) -> Found<($crate::luffing::balancing::Balancing<f64>, $crate::balance::analysis::Analysis)> {
                Ok((*known.balancing()?, known.analysed()?.clone()))
            }

            fn head(known: &mut Known<f64>) -> Found<$crate::parts::plane::Point<f64>> {
                Ok(known.$stage()?.$point)
            }

            fn residual<C: $crate::component::scalar::Scalar>(
                known: &mut Known<C>,
            ) -> Found<$crate::balance::residual::Residual<C>> {
                known.residual().copied()
            }
        }
    };
}
pub(crate) use with_balance;

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
