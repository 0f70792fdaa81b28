//! What a scene says about the steering of a machine.

use std::ops::Range;

use crate::component::description::Description;
use crate::component::stages::{Stages, Use};
use crate::kernel::diagnostic::Diagnostic;
use crate::kernel::group::One;
use crate::kernel::measure::quantity;
use crate::kernel::schema::{Kind, Values};
use crate::kernel::sign::Sign;
use crate::kernel::symbol::{Enumeration, Symbol};
use crate::kernel::variable::TIME;
use crate::parts::load_curve::LoadCurve;
use crate::parts::motion::{Motion, degrees};
use crate::parts::plane::Point;
use crate::steering::accuracy::Accuracy;
use crate::steering::built::Built;
use crate::steering::change::Change;
use crate::steering::cylinder::Mounting;
use crate::steering::flow::Piston;
use crate::steering::frame::Mount;
use crate::steering::keys::KEYS;
use crate::steering::load::{GroupLoad, Tyre, share};
use crate::steering::machine::{Axis, Footprint};
use crate::steering::mode::{By, Command, Corner, Mode, Wanted};
use crate::steering::moving::scene::MovingGroups;
use crate::steering::reach::reach;
use crate::steering::refusal::{Refusal, within};
use crate::steering::ring::{Bearing, Catalogue, Ring, Safety};
use crate::steering::sizing::Hydraulics;
use crate::steering::stages::{Given, SteeredGroups};
use crate::steering::stand::stand;
use crate::steering::symbols as s;
use crate::steering::transition::Pace;

/// The steering of a machine as the scene describes it, with its working range.
pub type Steering = Description<SteeringScene>;

/// What the scene says of it; SI.
#[derive(Clone, Debug)]
pub struct SteeringScene {
    /// At the start of the working range: machine, command and travel as the scene has them.
    pub given: Given<f64>,
    /// Weight and centre of gravity, where the loads of the groups follow from them.
    pub weight: Option<(f64, Point<f64>)>,
    pub safety: Option<Safety<f64>>,
    pub hydraulics: Option<Hydraulics<f64>>,
    /// Slip that is allowed.
    pub slip_limit: Option<f64>,
    /// Modes between which the book draws the change.
    pub drawn: [Option<Mode>; 2],
    pub catalogue: Option<Catalogue>,
    /// With `fidelity = "hydraulic"`; with `auto` where the scene's tables allow it.
    pub moving: Option<MovingGroups<f64>>,
}

impl SteeringScene {
    /// Builds the machine of a checked table; mistakes go to `found`.
    pub fn new(v: &Values, found: &mut Vec<Diagnostic>) -> Option<(SteeringScene, Motion)> {
        let before = found.len();
        let n = |table: &Values, symbol: &Symbol| table.number(symbol.id);
        let mut given = given(v, found)?;
        let safety = v.part("ring", Safety::read)?;
        let hydraulics = v.part("hydraulics", Hydraulics::read)?;
        allowed(v, &given, safety, hydraulics, found);
        let catalogue = v.table("ring").and_then(|ring| catalogue(ring, found));
        if found.len() > before {
            return None;
        }
        let built = match Built::new(&given) {
            Ok(built) => built,
            Err(refusal) => {
                found.push(told(v, refusal));
                return None;
            }
        };
        let ranges = built.linkages.iter().zip(&built.limits);
        let refused = ranges
            .map(|(linkage, limits)| linkage.over(limits))
            .find_map(Result::err);
        found.extend(refused.map(|refusal| told(v, refusal)));
        let weight = v.part("load", |t| {
            Some((n(t, &s::W)?, Point::new(n(t, &s::X_G)?, n(t, &s::Y_G)?)))
        })?;
        given.loads = loads(v, &built, weight, found);
        complete(v, &given, found);
        let machine = &built.machine;
        let radius = n(v, &s::R_T).unwrap_or(3.0 * machine.extent());
        let m = v.table("motion")?;
        let motion = Motion::read(m, found)?;
        for (name, angle) in [("from", motion.from), ("to", motion.to)] {
            if let Err(refusal) = within(&s::THETA_B, angle) {
                found.push(m.refuse(name, refusal.what, "beyond half a turn", refusal.help));
                return None;
            }
        }
        (given.theta_b.1, given.omega_s.1, given.v_t.1) = (motion.from, motion.speed, n(m, &s::V_T)?);
        given.r_t.1 = radius;
        given.wanted = Wanted {
            x: n(v, &s::X_C).unwrap_or(machine.middle.x),
            y: n(v, &s::Y_C).unwrap_or(machine.middle.y + radius),
        };
        let drawn = drawn(v, given.mode, found);
        let moving = MovingGroups::new(v, found);
        let built_in = given.cylinder.zip(given.piston);
        if let Some((moving, (mounting, piston))) = moving.zip(built_in)
            && let Err(refusal) = moving.reasonable(&mounting, &piston)
        {
            found.push(told(v, refusal));
        }
        if found.len() > before {
            return None;
        }
        let steering = SteeringScene {
            given,
            weight,
            safety,
            hydraulics,
            slip_limit: v.table("accuracy").and_then(|table| n(table, &s::SLIP_LIMIT)),
            drawn,
            catalogue,
            moving,
        };
        match steering.unreachable(v, m, &motion, &built) {
            None => Some((steering, motion)),
            Some(mistake) => {
                found.push(mistake);
                None
            }
        }
    }

    /// The machine of plain numbers.
    ///
    /// # Panics
    /// Never for a scene that was read.
    #[must_use]
    pub fn built(&self) -> Built {
        Built::new(&self.given).expect("checked when the scene was read")
    }

    /// The first command that the groups cannot follow; where an angle commands, the working range: a group's angle
    /// grows or falls with it.
    fn unreachable(&self, v: &Values, m: &Values, motion: &Motion, built: &Built) -> Option<Diagnostic> {
        let (machine, mode) = (&built.machine, self.given.mode);
        let mut given = self.given.clone();
        let angles = match given.command() {
            Command::Angle(_) => motion.angles(),
            _ => vec![motion.from],
        };
        let mut last: Option<Vec<f64>> = None;
        for theta_b in angles {
            given.theta_b.1 = theta_b;
            let command = given.command();
            let refusal = match reach(machine, &built.limits, mode, command) {
                Ok(reach) => reach.refusal(&built.limits),
                Err(refusal) => Some(refusal),
            };
            if let Some(refusal) = refusal {
                let (place, what) = match command {
                    Command::Angle(_) => (m.span.clone(), format!("theta_b = {}: ", degrees(theta_b))),
                    _ => (v.place("mode"), String::new()),
                };
                let message = format!("the mode {} is out of reach: {what}{}", mode.id(), refusal.what);
                return Some(Diagnostic::new(place, message, "cannot be steered").help(refusal.help));
            }
            if let Some((group, turn)) = passes(built, mode, command, &mut last) {
                let message = format!(
                    "the mode {} is out of reach: on the way to theta_b = {} group {group} would turn from {} to {}",
                    mode.id(),
                    degrees(theta_b),
                    degrees(turn[0]),
                    degrees(turn[1])
                );
                let help = "end the working range before it, or choose another mode";
                return Some(Diagnostic::new(m.span.clone(), message, "passes a forbidden range").help(help));
            }
        }
        None
    }
}

/// What the tables give by themselves: commands, loads and travel are not known yet. `None` where something in them cannot
/// be read.
fn given(v: &Values, found: &mut Vec<Diagnostic>) -> Option<Given<f64>> {
    let outline = v.part("outline", |t| {
        Some([
            t.number("front")?,
            t.number("rear")?,
            t.number("left")?,
            t.number("right")?,
        ])
    })?;
    Some(Given {
        theta_b: One(&s::THETA_B, 0.0),
        omega_s: One(&s::OMEGA_S, 0.0),
        v_t: One(&s::V_T, 0.0),
        mode: Mode::ALL[number(v, "mode", &s::MODES)],
        by: By::ALL[number(v, "command", &s::COMMANDS)],
        corner: Corner(number(v, "corner", &s::CORNERS)),
        r_t: One(&s::R_T, 0.0),
        wanted: Wanted { x: 0.0, y: 0.0 },
        loads: Vec::new(),
        axes: v.tables("groups").iter().map(Axis::read).collect::<Option<_>>()?,
        tyre: v.part("tyre", Tyre::read)?,
        bearing: v.part("ring", Bearing::read)?,
        cylinder: v.part("cylinder", Mounting::read)?,
        piston: v.part("cylinder", Piston::read)?,
        accuracy: v.part("accuracy", Accuracy::read)?,
        pace: v.part("transition", Pace::read)?,
        moving: None,
        moved: Vec::new(),
        mounts: mounts(v, found),
        outline: Footprint(outline),
        clock: One(&TIME, 0.0),
        change: Change::new(v.tables("groups").len()),
        held: Vec::new(),
    })
}

/// Place of a choice among its items; the first without one.
fn number(v: &Values, name: &str, of: &Enumeration) -> usize {
    let chosen = v.text(name);
    of.items.iter().position(|(item, _)| chosen == Some(item)).unwrap_or(0)
}

/// How each group is built in.
fn mounts(v: &Values, found: &mut Vec<Diagnostic>) -> Vec<Mount> {
    let range = v.table("range");
    let end = |group: &Values, name: &str| group.number(name).or_else(|| range?.number(name));
    // Told once, however many groups share them.
    let common = range.map_or_else(Vec::new, |range| forbidden(range, found));
    let mount = |group: &Values| Mount {
        mirrored: group.text("cylinder") == Some("mirrored"),
        range: end(group, "min").zip(end(group, "max")).map(|(min, max)| [min, max]),
        forbidden: match group.has("forbidden") {
            true => forbidden(group, found),
            false => common.clone(),
        },
    };
    v.tables("groups").iter().map(mount).collect()
}

/// What no machine has: values out of their range, and a rod that does not fit its bore.
fn allowed(
    v: &Values,
    given: &Given<f64>,
    safety: Option<Safety<f64>>,
    hydraulics: Option<Hydraulics<f64>>,
    found: &mut Vec<Diagnostic>,
) {
    let mut check = |(symbol, number): (&'static Symbol, Option<u16>), value: f64| {
        let numbered = |refusal: Refusal| match number {
            Some(number) => Refusal {
                key: format!("{}[{number}]", symbol.id),
                what: format!("group {number}: {}", refusal.what),
                ..refusal
            },
            None => refusal,
        };
        found.extend(within(symbol, value).err().map(|refusal| told(v, numbered(refusal))));
        value
    };
    SteeredGroups::map(
        given,
        &mut |source, quantity, value| match SteeredGroups::GROUPS[usize::from(source.group)].1 {
            Use::Parameter => check(quantity, value),
            _ => value,
        },
    );
    safety.map(|safety| safety.map(&mut |symbol, value| check((symbol, None), value)));
    hydraulics.map(|hydraulics| hydraulics.map(&mut |symbol, value| check((symbol, None), value)));
    let sides = [&s::E_F, &s::E_R, &s::E_LEFT, &s::E_RIGHT];
    let outline = given.outline.0.into_iter().flatten();
    sides.into_iter().zip(outline).for_each(|(side, value)| {
        check((side, None), value);
    });
    if let Some(piston) = given.piston.filter(|piston| piston.d >= piston.d_g) {
        let (d, d_g) = (s::D.written(piston.d), s::D_G.written(piston.d_g));
        let place = v.table("cylinder").map_or(0..0, |table| table.place("d"));
        let message = format!("the rod d = {d} does not fit the bore D_g = {d_g}");
        found.push(Diagnostic::new(place, message, "too thick").help("the rod must be thinner than the bore"));
    }
}

/// Loads of the groups, given one by one or by weight and centre of gravity; empty where the scene models no forces.
fn loads(
    v: &Values,
    built: &Built,
    weight: Option<(f64, Point<f64>)>,
    found: &mut Vec<Diagnostic>,
) -> Vec<GroupLoad<f64>> {
    let groups = v.tables("groups");
    let given: Vec<f64> = groups.iter().filter_map(|group| group.number(s::G.id)).collect();
    let unclear = (weight.is_some() && !given.is_empty()) || ![0, groups.len()].contains(&given.len());
    let mut loads = given;
    if let Some((weight, centre)) = weight {
        loads = vec![0.0; groups.len()];
        if let Err(refusal) = share(&built.machine, weight, centre, &mut loads) {
            found.push(told(v, refusal));
        }
    }
    // A load that cannot be read is not one that is missing.
    if unclear && found.is_empty() {
        let message = "some groups give their load, but not every one does, or [steering.load] gives it too";
        found.push(v.refuse(
            "groups",
            message,
            "G here",
            "give G of every group, or [steering.load] with W, x_G and y_G",
        ));
    }
    loads.into_iter().map(|g| GroupLoad { g }).collect()
}

/// That what a table needs is there.
fn complete(v: &Values, given: &Given<f64>, found: &mut Vec<Diagnostic>) {
    let forces = ["tyre", "ring", "hydraulics"]
        .into_iter()
        .find(|name| v.table(name).is_some());
    if let Some(name) = forces.filter(|_| given.loads.is_empty()) {
        found.push(v.refuse(
            name,
            "forces without loads",
            "this needs the loads of the groups",
            "give G of every group, or [steering.load] with W, x_G and y_G",
        ));
    }
    if !given.loads.is_empty() && given.tyre.is_none() {
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
        if v.has(name) && given.cylinder.is_none() {
            found.push(v.refuse(
                name,
                message,
                "[steering.cylinder] is needed",
                "add [steering.cylinder], or remove this",
            ));
        }
    }
}

/// The modes between which the book draws the change, where the scene names them.
fn drawn(v: &Values, mode: Mode, found: &mut Vec<Diagnostic>) -> [Option<Mode>; 2] {
    let Some(table) = v.table("transition") else {
        return [None; 2];
    };
    let drawn = ["from", "to"].map(|name| table.text(name).and_then(|text| Mode::parse(text).ok()));
    if let [from, Some(to)] = drawn
        && from.unwrap_or(mode) == to
    {
        let message = format!("a change from the mode {0} to the mode {0}", to.id());
        let help = "name two modes, or leave `to` out";
        found.push(table.refuse("to", message, "no change", help));
    }
    drawn
}

/// The first group, from 1, that passes a forbidden range on its way from the `last` angles to those of a reachable
/// command, with both angles (rad); the angles of the command become the last ones.
fn passes(built: &Built, mode: Mode, command: Command<f64>, last: &mut Option<Vec<f64>>) -> Option<(usize, [f64; 2])> {
    let centre = mode.centre(&built.machine, command).ok()?;
    let before = last.replace(stand(&built.machine, &built.limits, &centre))?;
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
    let tables = KEYS.iter().filter(|key| matches!(key.kind, Kind::Table(_)));
    let mut within = tables.filter_map(|table| v.table(table.name));
    let table = within.find(|table| table.number(key).is_some());
    table.unwrap_or(v).place(key)
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
        LoadCurve(points)
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
