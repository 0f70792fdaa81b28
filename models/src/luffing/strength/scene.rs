//! What a scene says of the sizes that are checked in its cases.

use crate::drive::symbols as d;
use crate::kernel::diagnostic::Diagnostic;
use crate::kernel::keys::keys;
use crate::kernel::schema::{Key, Kind, Values};
use crate::kernel::symbol::{Symbol, listed};
use crate::luffing::resistances::train::named;
use crate::luffing::strength::given::{Nut, PinSize, Profile, Strut, Teeth, Wire};
use crate::luffing::strength::symbols as s;

/// Beside the cases.
pub const BUCKLING: Key = Key::part("buckling", BUCKLING_KEYS, "The drive's bar against buckling.");
pub const TEETH: Key = Key::part("teeth", TEETH_KEYS, "Teeth of the pinion with its rack or sector.");
pub const NUT: Key = Key::part("nut", NUT_KEYS, "Core of the drive's screw, and its nut.");
pub const ROPE: Key = Key::part("rope", ROPE_KEYS, "The luffing rope, its drum and its sheaves.");
pub const PIN_SIZE: Key = Key::new("pin_size", Kind::Tables(PIN_KEYS, 16), "Sizes of pins.").optional();

const BUCKLING_KEYS: &[Key] = keys! { s:
    E_K > 0, SIGMA_Y > 0, S_K > 0, MU_K > 0, L_0 >= 0 [usually(0.0)], A_K > 0 [optional], I_MIN > 0 [optional]
};
const TEETH_KEYS: &[Key] = keys! { s: K_F > 0, Y_F > 0, B_F > 0, M_T > 0, ALPHA_T > 0, E_T > 0, NU_T >= 0 };
const NUT_KEYS: &[Key] = keys! { s: D_3 > 0, H_1 > 0, P_1 > 0, L_N > 0 };
const ROPE_KEYS: &[Key] = keys! { s: F_MIN > 0, Z_P > 0, D_W > 0, D_TR > 0, D_SH > 0 };
static PIN_KEYS: &[Key] = keys! { s: D_P > 0, B_P > 0; Key::new("at", Kind::Name, "The pin, by its letter.") };

/// What drives a boom on a luffing rope.
const TACKLE: &str = "luffing tackle";

/// The tables, each with the drives that have it.
const OF_KINDS: [(&str, &[&str]); 4] = [
    ("buckling", &["cylinder", "rack", "screw", "crank"]),
    ("teeth", &["rack", "sector"]),
    ("nut", &["screw"]),
    ("rope", &[TACKLE]),
];

/// What limits ask of, and whether a table that is there cannot do without them.
const JUDGED: [(&str, bool, &[&Symbol]); 7] = [
    ("buckling", false, listed!(s: LAMBDA_K_MAX)),
    ("teeth", true, listed!(s: SIGMA_F_MAX, SIGMA_H_MAX)),
    ("nut", true, listed!(s: P_N_MAX, SIGMA_V_MAX)),
    ("rope", true, listed!(s: H_TR, H_SH)),
    ("rope", false, listed!(s: S_W_MIN)),
    ("pin_size", true, listed!(s: P_B_MAX, TAU_P_MAX)),
    ("cylinder", false, listed!(s: P_C_MAX)),
];

/// Sizes of a scene that are checked.
#[derive(Clone, Debug, Default)]
pub struct Sizes {
    pub strut: Option<Strut<f64>>,
    pub profile: Option<Profile<f64>>,
    pub teeth: Option<Teeth<f64>>,
    pub nut: Option<Nut<f64>>,
    pub wire: Option<Wire<f64>>,
    pub pins: Option<Vec<PinSize<f64>>>,
    /// Which of the mechanism's pins each is.
    pub at: Vec<usize>,
}

impl Sizes {
    /// Of the table of cases of a checked mechanism with these pins; mistakes go to `found`.
    pub fn read(
        v: &Values,
        table: Option<&Values>,
        pins: (&[&str], Option<&str>),
        found: &mut Vec<Diagnostic>,
    ) -> Sizes {
        let drive = v.table("drive");
        if table.is_some() && drive.is_none() && !v.has("tackle") {
            // Cases without a drive are refused as such.
            return Sizes::default();
        }
        let kind = drive.and_then(|drive| drive.text("kind")).unwrap_or(TACKLE);
        judged(v, table, kind, found);
        let Some(table) = table else { return Sizes::default() };
        fits(drive, table, kind, found);
        let of = |name| table.table(name);
        let mut sizes = Sizes {
            strut: of("buckling").and_then(Strut::read),
            profile: of("buckling").and_then(Profile::read),
            teeth: of("teeth").and_then(Teeth::read),
            nut: of("nut").and_then(Nut::read),
            wire: of("rope").and_then(Wire::read),
            ..Sizes::default()
        };
        sizes.take_pins(table, pins, found);
        sizes
    }

    fn take_pins(&mut self, table: &Values, (pins, guide): (&[&str], Option<&str>), found: &mut Vec<Diagnostic>) {
        for pin in table.tables("pin_size") {
            let Some(at) = named(pin, "at", "pin", pins, found) else {
                continue;
            };
            let wrong = if guide == Some(pins[at]) {
                Some(("is a guide and has no diameter", "no pin"))
            } else {
                self.at
                    .contains(&at)
                    .then_some(("has two sizes", "there is one already"))
            };
            if let Some((what, label)) = wrong {
                found.push(pin.refuse("at", format!("pin {} {what}", pins[at]), label, "remove it"));
            }
            self.at.push(at);
            self.pins.get_or_insert_default().extend(PinSize::read(pin));
        }
    }
}

/// Refuses limits of what the scene has no result for, and tables without what they may come to.
fn judged(v: &Values, table: Option<&Values>, kind: &str, found: &mut Vec<Diagnostic>) {
    let limits = v.table("limits");
    for (name, needed, symbols) in JUDGED {
        let there = table.is_some_and(|table| match name {
            "cylinder" => kind == name,
            "pin_size" => !table.tables(name).is_empty(),
            _ => table.has(name) && of_kind(name, kind),
        });
        for symbol in symbols {
            match (limits.filter(|limits| limits.has(symbol.id)), there, table) {
                (Some(limits), false, _) => {
                    let what = format!("a limit {} that this scene has no result for", symbol.id);
                    let help = match name {
                        "cylinder" => "remove it: it is for a cylinder in cases".to_owned(),
                        _ => format!("add [cases.{name}], or remove the limit"),
                    };
                    found.push(limits.refuse(symbol.id, what, "nothing to check", help));
                }
                (None, true, Some(table)) if needed => {
                    let what = format!("[cases.{name}] without what is allowed of {}", symbol.id);
                    let help = format!("add {} to the limits, with its source", symbol.id);
                    found.push(table.refuse(name, what, "nothing to compare with", help));
                }
                _ => {}
            }
        }
    }
}

/// Whether a drive of a kind has a table.
fn of_kind(name: &str, kind: &str) -> bool {
    OF_KINDS
        .iter()
        .any(|(table, kinds)| *table == name && kinds.contains(&kind))
}

/// Refuses sizes of what this drive does not have, and asks for what else they need.
fn fits(drive: Option<&Values>, table: &Values, kind: &str, found: &mut Vec<Diagnostic>) {
    let mut refuse = |name: &str, what: String, label: &str, help: &str| {
        found.push(table.refuse(name, what, label, help));
    };
    for (name, kinds) in OF_KINDS {
        if table.has(name) && !of_kind(name, kind) {
            let what = format!("[cases.{name}] with a {kind}, which has none");
            refuse(
                name,
                what,
                "not used",
                &format!("remove it, or take a {}", kinds.join(" or ")),
            );
        }
    }
    let pinion = drive.is_some_and(|drive| drive.has(d::R_Z.id));
    if kind == "rack" && table.has("teeth") && !pinion {
        let what = "teeth of a rack whose pinion is not told".to_owned();
        refuse(
            "teeth",
            what,
            "their pinion is needed",
            "add r_z and eta_d to [luffing.drive]",
        );
    }
    if let Some(buckling) = table.table("buckling") {
        let profile = [&s::A_K, &s::I_MIN].map(|symbol| buckling.has(symbol.id));
        match kind {
            "rack" | "crank" if profile.contains(&false) => {
                let what = format!("buckling of a {kind} without its cross-section");
                refuse(
                    "buckling",
                    what,
                    "A_k and i_min are needed",
                    "add A_k = \"... m2\" and i_min = \"... mm\"",
                );
            }
            "screw" if !table.has("nut") => {
                let what = "buckling of a screw without its core diameter".to_owned();
                refuse("buckling", what, "d_3 is needed", "add [cases.nut] with d_3");
            }
            "screw" | "cylinder" if profile.contains(&true) => {
                let what = format!("buckling of a {kind} with another cross-section than its own");
                refuse("buckling", what, "it is round", "remove A_k and i_min");
            }
            "cylinder" if drive.and_then(|drive| drive.number(d::D_R.id)) == Some(0.0) => {
                let what = "buckling of a cylinder without a rod: d_r = 0 mm".to_owned();
                refuse("buckling", what, "no rod to buckle", "give d_r in [luffing.drive]");
            }
            _ => {}
        }
    }
    let pitch = drive.and_then(|drive| drive.number(d::D_2.id));
    let core = table.table("nut").and_then(|nut| nut.number(s::D_3.id));
    if let Some((d_2, d_3)) = pitch.zip(core).filter(|(d_2, d_3)| d_3 >= d_2) {
        let (d_2, d_3) = (d::D_2.written(d_2), s::D_3.written(d_3));
        let what = format!("the core d_3 = {d_3} does not fit the pitch diameter d_2 = {d_2}");
        refuse(
            "nut",
            what,
            "too thick",
            "the core must be thinner than the pitch diameter",
        );
    }
}
