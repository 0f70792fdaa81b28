//! What a scene says of a led hoist rope.

use crate::component::running::Running;
use crate::component::standing::Standing;
use crate::component::telling::fine;
use crate::kernel::diagnostic::Diagnostic;
use crate::kernel::keys::keys;
use crate::kernel::schema::{Key, Kind, Values};
use crate::kernel::symbol::Symbol;
use crate::luffing::led::reeved::{Leading, LedFalls, MOST, Reeved};
use crate::luffing::led::stretch::Sheave;
use crate::luffing::moving::scene::Moving;
use crate::luffing::moving::symbols::L_R;
use crate::luffing::resistances::placed::BARS;
use crate::luffing::resistances::train::named;
use crate::parts::motion::degrees;

/// Quantities of the led rope and of the tackle that carries the load.
mod s {
    pub use crate::luffing::led::symbols::*;
    pub use crate::luffing::moving::symbols::M_H;
}

/// The table `[luffing.rope]`.
pub const ROPE: Key = Key::part(
    "rope",
    KEYS,
    "Hoist rope that is led from the head over sheaves to the frame; without it the load keeps its distance below the head.",
);

static KEYS: &[Key] = keys! { s:
    M_H > 0, H_Q >= 0;
    Key::new("sheave", Kind::Tables(SHEAVE, MOST), "Sheaves in the order in which the rope runs over them from the head; the last one is on the frame.")
};

static SHEAVE: &[Key] = keys! { s:
    X_R, Y_R;
    Key::new("on", Kind::Name, "The bar that carries the sheave, or the frame.")
};

/// Name of what carries all bars.
const FRAME: &str = "frame";

/// Least length of rope between two sheaves on one bar and on two, which move towards each other, as a part of the whole rope: nearer,
/// no sheaves have room.
const NEAREST: [f64; 2] = [1e-9, 1e-3];

/// A led rope as a scene has it; nothing of one that it does not have.
#[derive(Clone, Debug, Default)]
pub struct LedRopeScene {
    pub falls: Option<LedFalls<f64>>,
    pub sheaves: Vec<Sheave<f64>>,
    pub leading: Leading,
}

impl LedRopeScene {
    /// As it is reeved, where there is one.
    #[must_use]
    pub fn reeved(&self) -> Option<Reeved<f64>> {
        self.falls
            .map(|falls| Reeved::new(&falls, &self.sheaves, &self.leading))
    }

    /// Of a checked mechanism's table, whose bars have these names; mistakes go to `found`.
    pub fn read(v: &Values, bars: &[&str], moving: Option<&Moving>, found: &mut Vec<Diagnostic>) -> LedRopeScene {
        let Some(table) = v.table("rope") else {
            return LedRopeScene::default();
        };
        if let Some(moving) = moving {
            found.extend(elsewhere(Some(table), s::H_Q.id, moving));
        }
        let known: Vec<&str> = bars.iter().copied().chain([FRAME]).collect();
        let mut led = LedRopeScene {
            falls: LedFalls::read(table),
            ..LedRopeScene::default()
        };
        let tables = table.tables("sheave");
        for (sheave, on) in tables.iter().zip(&mut led.leading.0) {
            let place = named(sheave, "on", "bar", &known, found);
            *on = place.filter(|place| known[*place] != FRAME).unwrap_or(BARS);
            led.sheaves.extend(Sheave::read(sheave));
        }
        // Without any the key is missing.
        if let Some((sheave, on)) = tables.last().and_then(|sheave| Some((sheave, sheave.text("on")?)))
            && on != FRAME
        {
            let what = format!("a hoist rope that ends on the {on}");
            let help = "it runs to its drum from a sheave on the frame: let the last [[luffing.rope.sheave]] be on = \"frame\"";
            found.push(sheave.refuse("on", what, "not on the frame", help));
        }
        led
    }

    /// What is assumed of it in motion; `None` without one.
    #[must_use]
    pub fn assumed(&self, moving: &Moving) -> Option<Vec<&'static str>> {
        let swings = moving.rope.map(|_| "led_rope_moves");
        self.falls.map(|_| ["led_rope"].into_iter().chain(swings).collect())
    }

    /// Whether sheaves have room between them over the whole working range, and from the head, which a bar carries; mistakes go to
    /// `found`.
    pub fn check(&self, model: &Standing, carries: usize, v: &Values, found: &mut Vec<Diagnostic>) {
        if self.falls.is_none() {
            return;
        }
        let (mut model, range) = (model.clone(), *model.motion());
        let of = |symbol: &'static Symbol| {
            let all = model.variables().iter().enumerate();
            all.filter(move |(_, variable)| variable.symbol == symbol)
                .map(|(index, _)| index)
        };
        let (each, whole): (Vec<usize>, Vec<usize>) = (of(&s::L_RS).collect(), of(&s::L_LED).collect());
        let near = fine(&range).find_map(|phi| {
            model.set(0, phi).ok()?;
            // What has no length is no result.
            let mut length = |index: &usize| model.get(*index).unwrap_or(0.0);
            let whole = length(&whole[0]);
            let from = [carries].into_iter().chain(self.leading.0);
            let least = from
                .zip(self.leading.0)
                .map(|(one, other)| NEAREST[usize::from(one != other)] * whole);
            let mut all = (0..).zip(each.iter().zip(least));
            all.find_map(|(place, (index, least))| {
                let length = length(index);
                (length <= least).then_some((place, length, least, phi))
            })
        });
        let Some((place, length, least, phi)) = near else {
            return;
        };
        let what = format!(
            "sheave {} of the hoist rope comes within {} of where the rope comes from at {} = {}, {} are needed",
            place + 1,
            s::L_RS.written(length),
            model.variables()[0].symbol.id,
            degrees(phi),
            s::L_RS.written(least)
        );
        let help = "move the sheave, or keep the working range away from there";
        let table = v.table("rope").and_then(|rope| rope.tables("sheave").get(place));
        let span = table.map_or(0..0, |table| table.place(s::X_R.id));
        found.push(Diagnostic::new(span, what, "no room for a sheave").help(help));
    }
}

/// Part of a length by which two that are the same may differ, as their units are.
const SAME: f64 = 1e-9;

/// A load that hangs at two places at the start of the working range, by a table of its rope with the height under this key.
pub fn elsewhere(table: Option<&Values>, key: &str, moving: &Moving) -> Option<Diagnostic> {
    let (rope, table) = (moving.rope?, table?);
    let h_q = table.number(key)?;
    if (h_q - rope.length).abs() <= SAME * rope.length {
        return None;
    }
    let (h_q, l_r) = (s::H_Q.written(h_q), L_R.written(rope.length));
    let what = format!("h_Q = {h_q} where l_R = {l_r}: the load hangs at two places");
    let help = format!("at the start the load hangs l_R below the head: set h_Q = \"{l_r}\"");
    Some(table.refuse(key, what, "not l_R", help))
}
