//! Where one may drag: which numbers of a scene's text place a point, and how.

use lemnis_models::component::sheet::Gauge;
use lemnis_models::kernel::symbol::Symbol;
use lemnis_models::kernel::unit;
use lemnis_models::scene::Scene;
use serde::Serialize;

use crate::answer::place::Places;
use crate::answer::point::{Point, rounded};
use crate::print::script::Script;

/// A number in the text.
#[derive(Serialize)]
pub struct Draggable {
    /// As in the scene: `luffing.X_1`.
    pub key: String,
    pub symbol: Script,
    /// Number and unit within their quotes, in code units of UTF-16.
    pub utf16: [usize; 2],
    pub unit: String,
    /// Of that unit, in SI.
    pub factor: f64,
    /// Of the number as it is written.
    pub decimals: usize,
}

/// What a number measures to the point that is dragged.
#[derive(Clone, PartialEq, Serialize)]
pub struct Set {
    /// Which of the numbers.
    number: usize,
    #[serde(flatten)]
    by: By,
}

/// As [`Gauge`]; in m and rad.
#[derive(Clone, PartialEq, Serialize)]
#[serde(tag = "by", rename_all = "snake_case")]
enum By {
    Distance { from: Point },
    Along { from: Point, direction: Point },
    Direction { from: Point, zero: f64 },
}

impl From<&Gauge> for By {
    fn from(gauge: &Gauge) -> By {
        match *gauge {
            Gauge::Distance { from } => By::Distance { from: rounded(from) },
            Gauge::Along { from, direction } => By::Along {
                from: rounded(from),
                direction,
            },
            Gauge::Direction { from, zero } => By::Direction {
                from: rounded(from),
                zero,
            },
        }
    }
}

impl Draggable {
    /// Of a quantity that the scene gives once, as a number that stays.
    fn new(scene: &Scene, symbol: &Symbol) -> Option<Draggable> {
        let mut all = scene.given.all().filter(|known| known.symbol == symbol);
        let origin = all.next()?.given.as_ref().filter(|_| all.next().is_none())?;
        let text = scene.text().get(origin.place.clone())?;
        let from = 1 + text.find('"').filter(|_| !origin.over_time)?;
        let inner = text[from..].split('"').next()?;
        let end = inner.find(|c: char| !(c.is_ascii_digit() || "+-.".contains(c)))?;
        let (number, unit) = (&inner[..end], inner[end..].trim());
        let decimals = number.split_once('.').map_or(0, |(_, decimals)| decimals.len());
        let start = origin.place.start + from;
        Some(Draggable {
            key: origin.key.clone(),
            symbol: Script::of_math(symbol.print),
            utf16: Places::new(scene.text()).of(&(start..start + inner.len())).utf16,
            factor: unit::find(unit)?.factor,
            unit: unit.to_owned(),
            decimals,
        })
    }
}

/// The numbers that place a point, added to those that are known; `None` where the scene does not give one of them.
pub fn sets(scene: &Scene, wanted: &[(&'static Symbol, Gauge)], known: &mut Vec<Draggable>) -> Option<Vec<Set>> {
    let numbers = wanted.iter().map(|(symbol, _)| Draggable::new(scene, symbol));
    let numbers: Vec<Draggable> = numbers.collect::<Option<_>>()?;
    let mut place = |number: Draggable| {
        let found = known.iter().position(|known| known.key == number.key);
        found.unwrap_or_else(|| {
            known.push(number);
            known.len() - 1
        })
    };
    let sets = numbers.into_iter().zip(wanted).map(|(number, (_, gauge))| Set {
        number: place(number),
        by: gauge.into(),
    });
    Some(sets.collect())
}
