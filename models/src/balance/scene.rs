//! What a scene says about a balance.

use crate::balance::lever::{Dimensions, Lever};
use crate::balance::parallelogram::Parallelogram;
use crate::balance::straight_rail::StraightRail;
use crate::balance::tail::Tail;
use crate::balance::{Balance, curved_rail, symbols as s};
use crate::kernel::allowed::OutOfRange;
use crate::kernel::calc::Calc;
use crate::kernel::check::missing;
use crate::kernel::diagnostic::Diagnostic;
use crate::kernel::group::by_map;
use crate::kernel::keys::keys;
use crate::kernel::schema::{Key, Kind, Values};
use crate::kernel::sign::Sign;
use crate::kernel::symbol::Symbol;
use crate::kernel::text::Text;
use crate::parts::four_bar::Branch;

const KINDS: &[&str] = &["tail", "parallelogram", "lever", "straight_rail", "curved_rail"];

/// The table `[balance]`, also beside the mechanism that it balances.
pub const BALANCE: Key = Key::part(
    "balance",
    KEYS,
    "Counterweight that carries the boom system's own weights.",
);

/// Keys of `[luffing.balance]`; which quantities are needed depends on the kind.
static KEYS: &[Key] = keys! { s:
    G_C [or_mass, optional], R_C >= 0 [optional], CHI_C [optional], D_1 > 0 [optional], DELTA_1 [optional],
    R_K > 0 [optional], ALPHA_K [optional], L_1 > 0 [optional], R_L > 0 [optional], CHI_5 [optional],
    M_5 >= 0 [optional], S_5 > 0 [optional], H_X [optional], H_Y [optional], LAMBDA >= 0 [optional],
    L_R > 0 [optional], Y_0 [optional], PHI_0 [optional];
    Key::new(
        "kind",
        Kind::Choice(KINDS),
        "A weight on the boom's rear, a parallelogram lever, a four-bar lever, or a rope to a weight on a straight \
               or a curved rail.",
    ),
    Key::choice("branch", &["left", "right"], "Side of the line from the lever's pivot to the joint on the boom on which the rod meets the lever."),
    Key::part("published", PUBLISHED, "Published results to stand beside the computed ones.")
};

static PUBLISHED: &[Key] = &[
    Key::new("source", Kind::Text, "Where the results are printed."),
    Key::quantity(&s::DM_MAX, Sign::AtLeast).optional(),
    Key::quantity(&s::DM_5_MAX, Sign::AtLeast).optional(),
    Key::quantity(&s::E, Sign::AtLeast).optional(),
    Key::quantity(&s::GAMMA_MIN, Sign::AtLeast).optional(),
    Key::quantity(&s::N_MAX, Sign::AtLeast).optional(),
];

/// A balance as it is given, before anything follows from it.
#[derive(Clone, Copy, Debug)]
pub enum Form<C> {
    Tail(Tail<C>),
    Parallelogram(Parallelogram<C>),
    /// With the counterweight's arm (m), where that is known.
    Lever(Dimensions<C>, Option<C>, Branch),
    StraightRail(StraightRail<C>),
    CurvedRail(curved_rail::RailDimensions<C>),
}

impl<C: Copy> Form<C> {
    /// As in a scene.
    #[must_use]
    pub fn kind(&self) -> &'static str {
        KINDS[match self {
            Form::Tail(_) => 0,
            Form::Parallelogram(_) => 1,
            Form::Lever(..) => 2,
            Form::StraightRail(_) => 3,
            Form::CurvedRail(_) => 4,
        }]
    }

    /// Whether a balance of this kind has a result.
    #[must_use]
    pub fn has(&self, result: &'static Symbol) -> bool {
        let turns = matches!(self, Form::Lever(..) | Form::Parallelogram(_));
        let pulls = !matches!(self, Form::Tail(_));
        // Without the arm of its counterweight a lever has neither place nor weight of it.
        let heavy = !matches!(self, Form::Lever(_, None, _));
        let is = |list: &[&'static Symbol]| list.contains(&result);
        if is(&[&s::DM_5, &s::DM_5_MAX, &s::PSI, &s::I_5, &s::GAMMA, &s::GAMMA_MIN]) {
            turns
        } else if is(&[&s::N_1, &s::N_MAX]) {
            pulls
        } else if is(&[&s::C_5Y, &s::DELTA_Y_5]) {
            heavy
        } else if is(&[&s::F_MX, &s::F_MY]) {
            pulls && heavy
        } else {
            true
        }
    }

    /// The same balance over another scalar.
    pub fn map<D>(&self, f: &mut dyn FnMut(&'static Symbol, C) -> D) -> Form<D> {
        match self {
            Form::Tail(it) => Form::Tail(it.map(f)),
            Form::Parallelogram(it) => Form::Parallelogram(it.map(f)),
            Form::Lever(it, s_5, branch) => Form::Lever(it.map(f), s_5.map(|s_5| f(&s::S_5, s_5)), *branch),
            Form::StraightRail(it) => Form::StraightRail(it.map(f)),
            Form::CurvedRail(it) => Form::CurvedRail(it.map(f)),
        }
    }
}

by_map!(Form: 9);

impl<C: Calc> Form<C> {
    /// The balance of a boom.
    ///
    /// # Errors
    /// Quantities with which there is no such balance; whatever `u_0`, the boom's potential energy (J) at a boom angle
    /// (rad), objects to, which only the curved rail asks for.
    pub fn balance(&self, u_0: impl FnOnce(C) -> Result<C, OutOfRange>) -> Result<Balance<C>, OutOfRange> {
        Ok(match *self {
            Form::Tail(it) => Balance::Tail(it.new()?),
            Form::Parallelogram(it) => Balance::Parallelogram(it.new()?),
            Form::Lever(it, s_5, branch) => Balance::Lever(Lever::new(it, s_5, branch)?),
            Form::StraightRail(it) => Balance::StraightRail(it.new()?),
            Form::CurvedRail(it) => Balance::CurvedRail(curved_rail::CurvedRail::new(it, u_0)?),
        })
    }
}

impl Form<f64> {
    /// The balance of a checked table; mistakes go to `found`.
    pub fn read(v: &Values, found: &mut Vec<Diagnostic>) -> Option<Form<f64>> {
        let kind = v.text("kind")?;
        let needed = match kind {
            "tail" => Tail::<f64>::SYMBOLS,
            "parallelogram" => Parallelogram::<f64>::SYMBOLS,
            "lever" => Dimensions::<f64>::SYMBOLS,
            "straight_rail" => StraightRail::<f64>::SYMBOLS,
            _ => curved_rail::RailDimensions::<f64>::SYMBOLS,
        };
        let lever = kind == "lever";
        for key in KEYS {
            let (needs, takes) = match key.number() {
                Some((symbol, _)) => {
                    let needs = needed.contains(&symbol);
                    (needs, needs || (lever && symbol == &s::S_5))
                }
                None if key.name == "branch" => (lever, lever),
                None => continue,
            };
            let given = v.stands(key.name);
            if needs && !given {
                found.push(missing(
                    v.span.clone(),
                    "in [luffing.balance]",
                    &format!("luffing.balance.{}", key.name),
                    key,
                ));
            } else if given && !takes {
                found.push(v.refuse(
                    key.name,
                    format!(
                        "`luffing.balance.{}`: a balance of the kind \"{kind}\" has none",
                        key.name
                    ),
                    "not used",
                    "remove it",
                ));
            }
        }
        let n = |symbol: &Symbol| v.number(symbol.id);
        match kind {
            "tail" => Tail::of(n).map(Form::Tail),
            "parallelogram" => Parallelogram::of(n).map(Form::Parallelogram),
            "lever" => {
                let branch = Branch::read(v)?;
                Dimensions::of(n).map(|it| Form::Lever(it, n(&s::S_5), branch))
            }
            "straight_rail" => StraightRail::of(n).map(Form::StraightRail),
            _ => curved_rail::RailDimensions::of(n).map(Form::CurvedRail),
        }
    }
}

/// Published results of a balance, in SI.
#[derive(Clone, Debug)]
pub struct PublishedBalance {
    pub source: Text,
    pub values: Vec<(&'static Symbol, f64)>,
}

impl PublishedBalance {
    /// Those of the balance's table.
    #[must_use]
    pub fn read(v: &Values) -> Option<PublishedBalance> {
        let table = v.table("published")?;
        let value = |key: &Key| {
            let (symbol, _) = key.number()?;
            Some((symbol, table.number(key.name)?))
        };
        Some(PublishedBalance {
            source: table.words("source")?.clone(),
            values: PUBLISHED.iter().filter_map(value).collect(),
        })
    }
}
