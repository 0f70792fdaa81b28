//! What a scene says about the steering of a machine.

use std::f64::consts::PI;
use std::ops::Range;

use crate::diagnostic::Diagnostic;
use crate::motion::{Motion, degrees};
use crate::plane::Point;
use crate::scene::Place;
use crate::schema::{Key, Kind, Sign, Values, quantity};
use crate::steering::cylinder::Cylinder;
use crate::steering::load::{Tyre, share};
use crate::steering::machine::{GROUPS, Refusal, within};
use crate::steering::mode::{Command, Mode};
use crate::steering::moving::scene::{FIDELITIES, Moving, TABLES};
use crate::steering::outputs::{Built, By, Group, Inputs, Parameters};
use crate::steering::reach::{reach, stand};
use crate::steering::ring::{Bearing, Catalogue, Curve, Ring};
use crate::steering::sizing::{Hydraulics, Piston};
use crate::steering::slip::Accuracy;
use crate::steering::symbols as s;
use crate::steering::transition::Pace;
use crate::symbol::Symbol;

/// What a scene calls the nine modes.
const MODES: &[&str] = &[
    "straight",
    "crab",
    "crosswise",
    "front_axle",
    "rear_axle",
    "all_wheel",
    "pivot",
    "corner",
    "free",
];

/// Keys of `[steering]`.
pub static KEYS: &[Key] = &[
    Key {
        name: "mode",
        kind: Kind::Choice(MODES),
        required: true,
        text: "Travel mode.",
    },
    Key {
        name: "command",
        kind: Kind::Choice(COMMANDS),
        required: false,
        text: "What commands front_axle, rear_axle and all_wheel; without it the angle of the base group, which is the first one.",
    },
    Key {
        name: "corner",
        kind: Kind::Choice(CORNERS),
        required: false,
        text: "About which corner of the outline the mode corner turns.",
    },
    Key::quantity(&s::R_T, Sign::Any).optional(),
    Key::quantity(&s::O_CX, Sign::Any).optional(),
    Key::quantity(&s::O_CY, Sign::Any).optional(),
    Key {
        name: "groups",
        kind: Kind::Tables(GROUP, GROUPS[1]),
        required: true,
        text: "The steered groups; the first one is the base group, whose angle commands.",
    },
    Key::table(
        "outline",
        OUTLINE,
        "Outline of the machine; without it as far as the groups reach.",
    )
    .optional(),
    Key::table(
        "load",
        LOAD,
        "Weight and centre of gravity, where the groups do not give their loads.",
    )
    .optional(),
    Key::table(
        "range",
        RANGE,
        "How far the groups turn; without it as far as their cylinders turn them.",
    )
    .optional(),
    Key::table(
        "motion",
        MOTION,
        "Working range of the commanded angle, and travel speed.",
    ),
    Key::table("tyre", TYRE, "Tyres and ground.").optional(),
    Key::table("ring", RING, "Slewing ring of a group.").optional(),
    Key::table("cylinder", CYLINDER, "Steering cylinder of a group.").optional(),
    Key::table(
        "accuracy",
        ACCURACY,
        "How exactly the groups' angles are kept: from it follows the slip of the tyres.",
    )
    .optional(),
    Key::table(
        "transition",
        TRANSITION,
        "How fast the groups turn when the mode changes: from it follow set points.",
    )
    .optional(),
    Key::table(
        "hydraulics",
        HYDRAULICS,
        "Oil supply, and what the book checks the cylinder by.",
    )
    .optional(),
    Key {
        name: "fidelity",
        kind: Kind::Choice(FIDELITIES),
        required: false,
        text: "How deep the steering is modelled: groups that stand as commanded (kinematic), or that are turned by their cylinders under the PLC (hydraulic), or as deep as the scene's accuracy needs (auto); without it kinematic.",
    },
    Key::table(TABLES[0].0, TABLES[0].1, TABLES[0].2).optional(),
    Key::table(TABLES[1].0, TABLES[1].1, TABLES[1].2).optional(),
    Key::table(TABLES[2].0, TABLES[2].1, TABLES[2].2).optional(),
    SOURCE,
];

/// What commands, in the order of the numbers in an FMU.
pub const COMMANDS: &[&str] = &["angle", "radius", "centre"];

/// Corners of the outline, likewise.
pub const CORNERS: &[&str] = &["front_left", "rear_left", "rear_right", "front_right"];

/// Where the quantities of a table come from that do not say it themselves.
const SOURCE: Key = Key::text(
    "source",
    "Where the quantities of this table come from: a drawing, a publication, an assumption.",
);

static GROUP: &[Key] = &[
    Key::quantity(&s::X_I, Sign::Any),
    Key::quantity(&s::Y_I, Sign::Any),
    Key::weight(&s::G).optional(),
    angle("min", &s::THETA_MIN).optional(),
    angle("max", &s::THETA_MAX).optional(),
    FORBIDDEN,
    Key {
        name: "cylinder",
        kind: Kind::Choice(&["direct", "mirrored"]),
        required: false,
        text: "Whether the cylinder lengthens (direct) or shortens when the group turns counter-clockwise.",
    },
    SOURCE,
];

static OUTLINE: &[Key] = &[
    angle("front", &s::E_F),
    angle("rear", &s::E_R),
    angle("left", &s::E_LEFT),
    angle("right", &s::E_RIGHT),
    SOURCE,
];

static LOAD: &[Key] = &[
    Key::weight(&s::W),
    Key::quantity(&s::X_G, Sign::Any),
    Key::quantity(&s::Y_G, Sign::Any),
    SOURCE,
];

static RANGE: &[Key] = &[
    angle("min", &s::THETA_MIN),
    angle("max", &s::THETA_MAX),
    FORBIDDEN,
    SOURCE,
];

/// Where a group must not turn.
const FORBIDDEN: Key = Key {
    name: "forbidden",
    kind: Kind::Texts(20),
    required: false,
    text: "Ranges through which a group must not turn, each by its two ends: \"20 deg, 25 deg\"; a group's own ones take the place of those of all.",
};

static MOTION: &[Key] = &[
    Key::named("from", &s::THETA_B, Sign::Any, "Commanded angle at the start."),
    Key::named("to", &s::THETA_B, Sign::Any, "Commanded angle at the end."),
    Key::named("step", &s::THETA_B, Sign::Positive, "Step of tables."),
    Key::named(
        "speed",
        &s::OMEGA_S,
        Sign::Positive,
        "Steering speed: rate of the commanded angle.",
    ),
    Key::quantity(&s::V_T, Sign::Any),
    SOURCE,
];

static TYRE: &[Key] = &[
    Key::quantity(&s::F_T, Sign::NotNegative),
    Key::quantity(&s::P_T, Sign::Positive),
    Key::quantity(&s::K_V, Sign::Positive),
    SOURCE,
];

static RING: &[Key] = &[
    Key::quantity(&s::L_MAX, Sign::NotNegative),
    Key::quantity(&s::F_S, Sign::Positive),
    Key::quantity(&s::K_TEST, Sign::Positive),
    Key::quantity(&s::MU_R, Sign::NotNegative),
    Key::quantity(&s::D_L, Sign::Positive),
    Key {
        name: "catalogue",
        kind: Kind::Tables(CATALOGUE, 100),
        required: false,
        text: "Rings with their load curves, from the smallest to the greatest.",
    },
    SOURCE,
];

static CATALOGUE: &[Key] = &[
    Key {
        name: "name",
        kind: Kind::Text,
        required: true,
        text: "Name of the ring.",
    },
    Key::quantity(&s::D_L, Sign::Positive),
    Key {
        name: "ring",
        kind: Kind::Texts(100),
        required: true,
        text: "Load curve of the ring, points of force and moment with rising force: \"400 kN, 280 kN.m\".",
    },
    Key {
        name: "bolts",
        kind: Kind::Texts(100),
        required: true,
        text: "Load curve of its bolts, likewise.",
    },
];

static CYLINDER: &[Key] = &[
    Key::quantity(&s::R_C, Sign::Positive),
    Key::quantity(&s::ALPHA, Sign::Any),
    Key::quantity(&s::L_X, Sign::Positive),
    Key::quantity(&s::L_A, Sign::NotNegative),
    Key::quantity(&s::D_G, Sign::Positive),
    Key::quantity(&s::D, Sign::Positive),
    SOURCE,
];

static ACCURACY: &[Key] = &[
    Key::quantity(&s::Q_E, Sign::NotNegative),
    Key::quantity(&s::B_V, Sign::NotNegative),
    Key::quantity(&s::SLIP_LIMIT, Sign::Positive).optional(),
    SOURCE,
];

static TRANSITION: &[Key] = &[
    Key::quantity(&s::V_CX, Sign::Positive),
    Key {
        name: "from",
        kind: Kind::Choice(MODES),
        required: false,
        text: "Mode from which the change starts that the book draws; without it that of the scene.",
    },
    Key {
        name: "to",
        kind: Kind::Choice(MODES),
        required: false,
        text: "Mode in which it ends; without it the one whose change from there takes longest.",
    },
    SOURCE,
];

static HYDRAULICS: &[Key] = &[
    Key::quantity(&s::P, Sign::Positive),
    Key::quantity(&s::N, Sign::Positive),
    Key::quantity(&s::ETA, Sign::Positive),
    Key::quantity(&s::K_R, Sign::Positive),
    Key::quantity(&s::E, Sign::Positive),
    Key::quantity(&s::NU, Sign::Positive),
    SOURCE,
];

/// A quantity under a name of its own.
const fn angle(name: &'static str, symbol: &'static Symbol) -> Key {
    Key::named(name, symbol, Sign::Any, symbol.text)
}

/// The steering of a machine as the scene describes it; SI.
#[derive(Clone, Debug)]
pub struct Steering {
    pub parameters: Parameters<f64>,
    /// At the start: command and travel as the scene has them.
    pub inputs: Inputs<f64>,
    pub motion: Motion,
    /// Weight and centre of gravity, where the loads of the groups follow from them.
    pub weight: Option<(f64, Point<f64>)>,
    pub hydraulics: Option<Hydraulics<f64>>,
    /// Slip that is allowed.
    pub slip_limit: Option<f64>,
    /// Modes between which the book draws the change.
    pub drawn: [Option<Mode>; 2],
    pub catalogue: Option<Catalogue>,
    /// With `fidelity = "hydraulic"`; with `auto` where the scene's tables allow it.
    pub moving: Option<Moving>,
    /// Whether the level is left to the accuracy that the scene asks for.
    pub auto: bool,
}

impl Steering {
    /// A position as a scene writes it, for the book: a commanded angle, `from`,
    /// `middle`, `to` or `governing`; on failure a message and help.
    pub fn place(&self, text: &str) -> Result<Place, (String, String)> {
        let named = ["governing", "from", "middle", "to"];
        self.motion.place(text, &s::THETA_B, "a commanded angle", &named)
    }

    /// Builds the machine of a checked table; mistakes go to `found`.
    pub fn new(v: &Values, found: &mut Vec<Diagnostic>) -> Option<Steering> {
        let before = found.len();
        let n = |table: &Values, symbol: &Symbol| table.number(symbol.id);
        let tables = v.tables("groups");
        let range = v.table("range");
        let end = |group: &Values, name: &str| {
            group
                .number(name)
                .or_else(|| range.and_then(|range| range.number(name)))
        };
        // Told once, however many groups share them.
        range.into_iter().for_each(|range| drop(forbidden(range, found)));
        let mut groups = Vec::new();
        for group in tables {
            groups.push(Group {
                at: Point::new(n(group, &s::X_I)?, n(group, &s::Y_I)?),
                mirrored: group.text("cylinder") == Some("mirrored"),
                range: end(group, "min").zip(end(group, "max")).map(|(min, max)| [min, max]),
                forbidden: if group.has("forbidden") {
                    forbidden(group, found)
                } else {
                    range.map_or_else(Vec::new, |range| forbidden(range, &mut Vec::new()))
                },
            });
        }
        let outline = match v.table("outline") {
            Some(o) => Some([
                o.number("front")?,
                o.number("rear")?,
                o.number("left")?,
                o.number("right")?,
            ]),
            None => None,
        };
        let (cylinder, piston) = match v.table("cylinder") {
            Some(c) => {
                let cylinder = Cylinder {
                    r: n(c, &s::R_C)?,
                    alpha: n(c, &s::ALPHA)?,
                    l_x: n(c, &s::L_X)?,
                    l_a: n(c, &s::L_A)?,
                };
                let piston = Piston {
                    d_g: n(c, &s::D_G)?,
                    d: n(c, &s::D)?,
                };
                if piston.d >= piston.d_g {
                    let (d, d_g) = (s::D.written(piston.d), s::D_G.written(piston.d_g));
                    let message = format!("the rod d = {d} does not fit the bore D_g = {d_g}");
                    found.push(
                        Diagnostic::new(c.place("d"), message, "too thick")
                            .help("the rod must be thinner than the bore"),
                    );
                }
                (Some(cylinder), Some(piston))
            }
            None => (None, None),
        };
        let tyre = match v.table("tyre") {
            Some(t) => Some(Tyre {
                f_t: n(t, &s::F_T)?,
                p_t: n(t, &s::P_T)?,
                k_v: n(t, &s::K_V)?,
            }),
            None => None,
        };
        let (bearing, catalogue) = match v.table("ring") {
            Some(r) => {
                let bearing = Bearing {
                    l_max: n(r, &s::L_MAX)?,
                    f_s: n(r, &s::F_S)?,
                    k_test: n(r, &s::K_TEST)?,
                    mu_r: n(r, &s::MU_R)?,
                    d_l: n(r, &s::D_L)?,
                };
                (Some(bearing), catalogue(r, found))
            }
            None => (None, None),
        };
        let hydraulics = match v.table("hydraulics") {
            Some(h) => Some(Hydraulics {
                p: n(h, &s::P)?,
                n: n(h, &s::N)?,
                eta: n(h, &s::ETA)?,
                k_r: n(h, &s::K_R)?,
                e: n(h, &s::E)?,
                nu: n(h, &s::NU)?,
            }),
            None => None,
        };
        let (accuracy, slip_limit) = match v.table("accuracy") {
            Some(a) => {
                let accuracy = Accuracy {
                    step: n(a, &s::Q_E)?,
                    dead_band: n(a, &s::B_V)?,
                };
                (Some(accuracy), n(a, &s::SLIP_LIMIT))
            }
            None => (None, None),
        };
        let (pace, drawn) = match v.table("transition") {
            Some(t) => {
                let mode = |name| t.text(name).and_then(|text| Mode::parse(text).ok());
                let pace = Pace { speed: n(t, &s::V_CX)? };
                (Some(pace), ["from", "to"].map(mode))
            }
            None => (None, [None; 2]),
        };
        let parameters = Parameters {
            groups,
            outline,
            tyre,
            bearing,
            cylinder,
            piston,
            accuracy,
            pace,
        };
        let built = match parameters.build() {
            Ok(built) => built,
            Err(refusal) => {
                found.push(told(v, refusal));
                return None;
            }
        };
        for (linkage, limits) in built.linkages.iter().zip(&built.limits) {
            if let Err(refusal) = linkage.over(limits) {
                found.push(told(v, refusal));
                break;
            }
        }
        let weight = match v.table("load") {
            Some(l) => Some((n(l, &s::W)?, Point::new(n(l, &s::X_G)?, n(l, &s::Y_G)?))),
            None => None,
        };
        let given: Vec<f64> = tables.iter().filter_map(|group| n(group, &s::G)).collect();
        let mut loads = given.clone();
        if let Some((weight, centre)) = weight {
            loads = vec![0.0; tables.len()];
            if let Err(refusal) = share(&built.machine, weight, centre, &mut loads) {
                found.push(told(v, refusal));
            }
        }
        let unclear = (weight.is_some() && !given.is_empty()) || ![0, tables.len()].contains(&given.len());
        // A load that cannot be read is not one that is missing.
        if unclear && found.is_empty() {
            let message = "some groups give their load, but not every one does, or [steering.load] gives it too";
            found.push(
                Diagnostic::new(v.place("groups"), message, "G here")
                    .help("give G of every group, or [steering.load] with W, x_G and y_G"),
            );
        }
        let forces = tyre.is_some() || bearing.is_some() || hydraulics.is_some();
        if forces && loads.is_empty() {
            let needs = ["tyre", "ring", "hydraulics"]
                .into_iter()
                .find(|name| v.table(name).is_some());
            found.push(
                Diagnostic::new(
                    v.place(needs.unwrap_or("tyre")),
                    "forces without loads",
                    "this needs the loads of the groups",
                )
                .help("give G of every group, or [steering.load] with W, x_G and y_G"),
            );
        }
        if !loads.is_empty() && tyre.is_none() {
            found.push(
                Diagnostic::new(v.span.clone(), "loads without tyres", "[steering.tyre] is needed here")
                    .help("add [steering.tyre] with f_t, p_t and k_v, or leave the loads out"),
            );
        }
        for (name, message) in [
            ("hydraulics", "oil without a cylinder"),
            ("accuracy", "angle errors without a cylinder"),
            ("transition", "changes of mode without a cylinder"),
        ] {
            if v.has(name) && cylinder.is_none() {
                found.push(
                    Diagnostic::new(v.place(name), message, "[steering.cylinder] is needed")
                        .help("add [steering.cylinder], or remove this"),
                );
            }
        }
        let machine = &built.machine;
        let size = (machine.front - machine.rear).max(machine.left - machine.right);
        let radius = n(v, &s::R_T).unwrap_or(3.0 * size);
        let m = v.table("motion")?;
        let motion = Motion::read(m, found)?;
        for (name, angle) in [("from", motion.from), ("to", motion.to)] {
            if let Err(refusal) = within(&s::THETA_B, angle, -PI, PI, false) {
                found.push(Diagnostic::new(m.place(name), refusal.what, "beyond half a turn").help(refusal.help));
                return None;
            }
        }
        let number =
            |name: &str, names: &[&str]| names.iter().position(|known| v.text(name) == Some(known)).unwrap_or(0);
        let inputs = Inputs {
            mode: Mode::ALL[number("mode", MODES)],
            by: [By::Angle, By::Radius, By::Centre][number("command", COMMANDS)],
            corner: number("corner", CORNERS),
            theta_b: motion.from,
            omega_s: motion.speed,
            v_t: n(m, &s::V_T)?,
            r_t: radius,
            centre: Point::new(
                n(v, &s::O_CX).unwrap_or(machine.middle.x),
                n(v, &s::O_CY).unwrap_or(machine.middle.y + radius),
            ),
            loads,
        };
        if let [from, Some(to)] = drawn
            && from.unwrap_or(inputs.mode) == to
        {
            let place = v.table("transition").map_or_else(|| v.span.clone(), |t| t.place("to"));
            let message = format!("a change from the mode {0} to the mode {0}", to.id());
            found.push(Diagnostic::new(place, message, "no change").help("name two modes, or leave `to` out"));
        }
        let moving = Moving::new(v, found).unwrap_or_else(|refusal| {
            found.push(told(v, refusal));
            None
        });
        if found.len() > before {
            return None;
        }
        // The command; where an angle commands, the working range: a group's angle grows or falls with it.
        let angles = match inputs.command() {
            Command::Angle(_) => motion.angles(),
            _ => vec![motion.from],
        };
        let mut last: Option<Vec<f64>> = None;
        for theta_b in angles {
            let command = Inputs {
                theta_b,
                ..inputs.clone()
            }
            .command();
            let refusal = match reach(machine, &built.limits, inputs.mode, command) {
                Ok(reach) => reach.refusal(&built.limits),
                Err(refusal) => Some(refusal),
            };
            let Some(refusal) = refusal else {
                if let Some((group, turn)) = passes(&built, inputs.mode, command, &mut last) {
                    let message = format!(
                        "the mode {} is out of reach: on the way to theta_b = {} group {group} would turn from {} to {}",
                        inputs.mode.id(),
                        degrees(theta_b),
                        degrees(turn[0]),
                        degrees(turn[1])
                    );
                    found.push(
                        Diagnostic::new(m.span.clone(), message, "passes a forbidden range")
                            .help("end the working range before it, or choose another mode"),
                    );
                    return None;
                }
                continue;
            };
            let (place, what) = match command {
                Command::Angle(_) => (m.span.clone(), format!("theta_b = {}: ", degrees(theta_b))),
                _ => (v.place("mode"), String::new()),
            };
            let message = format!("the mode {} is out of reach: {what}{}", inputs.mode.id(), refusal.what);
            found.push(Diagnostic::new(place, message, "cannot be steered").help(refusal.help));
            return None;
        }
        Some(Steering {
            parameters,
            inputs,
            motion,
            weight,
            hydraulics,
            slip_limit,
            drawn,
            catalogue,
            moving,
            auto: v.text("fidelity") == Some("auto"),
        })
    }
}

/// The first group, from 1, that passes a forbidden range on its way from the `last` angles to those of a reachable
/// command, with both angles (rad); the angles of the command become the last ones.
fn passes(
    built: &Built<f64>,
    mode: Mode,
    command: Command<f64>,
    last: &mut Option<Vec<f64>>,
) -> Option<(usize, [f64; 2])> {
    let centre = mode.centre(&built.machine, command).ok()?;
    let mut angles = vec![0.0; built.limits.len()];
    stand(&built.machine, &built.limits, &centre, &mut angles);
    let before = last.replace(angles)?;
    let mut turns = (1..).zip(before.iter().zip(last.as_ref()?)).zip(&built.limits);
    turns.find_map(|((group, (&from, &to)), limits)| (!limits.allows_turn(from, to)).then_some((group, [from, to])))
}

/// A refusal with its place: the quantity in its table, that of a group where it has a number.
fn told(v: &Values, refusal: Refusal) -> Diagnostic {
    let Refusal { key, what, help } = refusal;
    Diagnostic::new(place(v, &key), what, "not possible").help(help)
}

fn place(v: &Values, key: &str) -> Range<usize> {
    if let Some((name, number)) = key.split_once('[') {
        let number = number.split(']').next().and_then(|number| number.parse::<usize>().ok());
        if let Some(group) = number.and_then(|number| v.tables("groups").get(number.checked_sub(1)?)) {
            let common = v.table("range").filter(|range| !group.has(name) && range.has(name));
            return common.unwrap_or(group).place(name);
        }
    }
    let key = if key == "theta" { "range" } else { key };
    let tables = [
        "tyre",
        "ring",
        "cylinder",
        "hydraulics",
        "motion",
        "load",
        "oil",
        "plc",
        "dynamics",
        "accuracy",
        "transition",
    ];
    let within = tables.into_iter().filter_map(|name| v.table(name));
    within
        .filter(|table| table.number(key).is_some())
        .map(|table| table.place(key))
        .next()
        .unwrap_or_else(|| v.place(key))
}

/// The forbidden ranges of a table, in rad.
fn forbidden(table: &Values, found: &mut Vec<Diagnostic>) -> Vec<[f64; 2]> {
    let mut list = Vec::new();
    for (text, span) in table.texts("forbidden") {
        let ends = text.split_once(',').and_then(|(from, to)| {
            let from = quantity(from, &s::THETA, Sign::Any).ok()?;
            Some([from, quantity(to, &s::THETA, Sign::Any).ok()?])
        });
        match ends {
            Some(ends) => list.push(ends),
            None => found.push(
                Diagnostic::new(span.clone(), format!("\"{text}\" is no range of angles"), "not this")
                    .help("write its two ends: \"20 deg, 25 deg\""),
            ),
        }
    }
    list
}

/// The rings of a catalogue; `None` without one.
fn catalogue(ring: &Values, found: &mut Vec<Diagnostic>) -> Option<Catalogue> {
    let tables = ring.tables("catalogue");
    let mut curve = |table: &Values, name: &str| {
        let mut points: Vec<[f64; 2]> = Vec::new();
        for (text, span) in table.texts(name) {
            let parts = text.split_once(',').and_then(|(force, moment)| {
                let force = quantity(force, &s::F_A_REF, Sign::NotNegative).ok()?;
                Some([force, quantity(moment, &s::M_REF, Sign::NotNegative).ok()?])
            });
            match parts {
                Some(point) if points.last().is_none_or(|last| last[0] < point[0]) => points.push(point),
                _ => found.push(
                    Diagnostic::new(
                        span.clone(),
                        format!("\"{text}\" is no point of a load curve"),
                        "not this",
                    )
                    .help("write force and moment, with rising force: \"400 kN, 280 kN.m\""),
                ),
            }
        }
        Curve(points)
    };
    let rings = tables.iter().filter_map(|table| {
        Some(Ring {
            name: table.text("name")?.to_owned(),
            d_l: table.number(s::D_L.id)?,
            ring: curve(table, "ring"),
            bolts: curve(table, "bolts"),
        })
    });
    let rings: Vec<Ring> = rings.collect();
    (!rings.is_empty()).then_some(Catalogue { rings })
}
