//! What a scene says about the drive.

use crate::drive::crank::{CrankRod, arcs, crank_linkage};
use crate::drive::gear::Gear;
use crate::drive::mount::{Anchors, Bore, DriveMount};
use crate::drive::sector::Sector;
use crate::drive::symbols as s;
use crate::kernel::check::missing;
use crate::kernel::diagnostic::Diagnostic;
use crate::kernel::keys::keys;
use crate::kernel::schema::{Key, Kind, Values};
use crate::kernel::sign::Sign;
use crate::kernel::symbol::{Symbol, listed};
use crate::parts::four_bar::Branch;
use crate::parts::plane::{self, Point};

/// The table `[drive]`, also beside the mechanism that it drives.
pub const DRIVE: Key = Key::part(
    "drive",
    KEYS,
    "Cylinder, rack, screw, sector, crank or rope that turns the driving link.",
);

static KEYS: &[Key] = keys! { s:
    E_X [optional], E_Y [optional], S_D > 0 [optional], CHI_D [optional], D_C > 0 [optional], D_R >= 0 [optional];
    Key::new(
        "kind",
        Kind::Choice(&["cylinder", "rack", "screw", "sector", "crank", "rope"]),
        "A hydraulic cylinder, a rack that a pinion on the frame pushes, a screw with its nut, a toothed sector that a pinion turns, a crank on the frame with its rod, or a tackle whose rope a drum on the frame winds.",
    ),
    CRANK_BRANCH.optional(),
    Key::quantity(&s::R_CR, Sign::Positive).optional(),
    Key::quantity(&s::L_CR, Sign::Positive).optional(),
    Key::quantity(&s::R_Z, Sign::Positive).optional(),
    Key::quantity(&s::ETA_D, Sign::Positive).optional(),
    Key::quantity(&s::M_R, Sign::Positive).optional(),
    Key::quantity(&s::R_TR, Sign::Positive).optional(),
    Key::quantity(&s::R_S, Sign::Positive).optional(),
    Key::quantity(&s::DELTA_S, Sign::Any).optional(),
    Key::quantity(&s::D_2, Sign::Positive).optional(),
    Key::quantity(&s::P_H, Sign::Positive).optional(),
    Key::quantity(&s::MU_D, Sign::NotNegative).optional(),
    Key::quantity(&s::BETA_D, Sign::NotNegative).optional()
};

/// What only one kind of drive has.
const OWN: [(&str, &[&Symbol]); 8] = [
    ("cylinder", listed!(s: D_C, D_R)),
    ("rack or sector", listed!(s: R_Z)),
    ("rack, sector, crank or rope", listed!(s: ETA_D)),
    ("rope", listed!(s: M_R, R_TR)),
    ("crank", listed!(s: R_CR, L_CR)),
    ("screw", listed!(s: D_2, P_H, MU_D, BETA_D)),
    ("sector", listed!(s: R_S, DELTA_S)),
    (LINES, LINE),
];

/// Of a crank.
const CRANK_BRANCH: Key = Key::new(
    "branch",
    Kind::Choice(&["left", "right"]),
    "Side of the line from the crank's centre to its anchor on the driving link on which crank and rod meet.",
);

/// What all but a sector have.
const LINES: &str = "cylinder, rack, screw, crank or rope";
const LINE: &[&Symbol] = listed!(s: E_X, E_Y, S_D, CHI_D);

/// The drive, as far as the scene says it.
#[derive(Clone, Copy, Debug, Default)]
pub struct Driving {
    pub mount: Option<DriveMount<f64>>,
    pub cylinder: Option<Bore<f64>>,
    /// What turns it, where its torque is asked for.
    pub gear: Option<Gear<f64>>,
    /// The rod of a crank, and on which side both meet.
    pub crank: Option<(CrankRod<f64>, Branch)>,
}

impl Driving {
    #[must_use]
    pub fn anchors(&self) -> Option<Anchors<f64>> {
        match self.mount {
            Some(DriveMount::Anchors(anchors)) => Some(anchors),
            _ => None,
        }
    }

    #[must_use]
    pub fn rod(&self) -> Option<CrankRod<f64>> {
        self.crank.map(|(rod, _)| rod)
    }

    /// On which side crank and rod meet; of any other drive, whichever.
    #[must_use]
    pub fn branch(&self) -> Branch {
        self.crank.map_or(Branch::Left, |(_, branch)| branch)
    }
}

/// `None` with mistakes, which go to `found`.
pub fn read(v: &Values, found: &mut Vec<Diagnostic>) -> Option<Driving> {
    let Some(d) = v.table("drive") else {
        return Some(Driving::default());
    };
    d.text("kind")?;
    let before = found.len();
    only_its_own(d, found);
    all_of_it(d, found);
    let read = Driving {
        mount: Sector::read(d)
            .map(DriveMount::Sector)
            .or(Anchors::read(d).map(DriveMount::Anchors)),
        cylinder: cylinder(d, found),
        gear: Gear::read(d, d.text("kind")?, found),
        crank: CrankRod::read(d).zip(Branch::read(d)),
    };
    (found.len() == before && d.is_sound()).then_some(read)
}

/// Refuses what is of a drive of another kind.
fn only_its_own(d: &Values, found: &mut Vec<Diagnostic>) {
    let kind = d.text("kind").unwrap_or_default();
    if kind != "crank" && d.has("branch") {
        let what = format!("a {kind} has no branch, which is of a crank");
        found.push(d.refuse("branch", what, "not used", "remove it"));
    }
    for (other, symbols) in OWN
        .iter()
        .filter(|(other, _)| !other.split([' ', ',']).any(|one| one == kind))
    {
        for symbol in symbols.iter().filter(|symbol| d.has(symbol.id)) {
            let what = format!("a {kind} has no {}, which is of a {other}", symbol.id);
            found.push(d.refuse(symbol.id, what, "not used", "remove it"));
        }
    }
}

/// Bore and rod of a cylinder; mistakes go to `found`.
fn cylinder(d: &Values, found: &mut Vec<Diagnostic>) -> Option<Bore<f64>> {
    let (bore, rod) = (d.number(s::D_C.id), d.number(s::D_R.id));
    match (d.text("kind")?, bore, rod) {
        ("cylinder", Some(d_c), Some(d_r)) if d_r < d_c => Some(Bore { d_c, d_r }),
        ("cylinder", Some(d_c), Some(d_r)) => {
            let (d_c, d_r) = (s::D_C.written(d_c), s::D_R.written(d_r));
            found.push(d.refuse(
                "d_r",
                format!("the rod d_r = {d_r} does not fit the bore D_c = {d_c}"),
                "too thick",
                "the rod must be thinner than the bore",
            ));
            None
        }
        ("cylinder", ..) if d.stands(s::D_C.id) && d.stands(s::D_R.id) => None,
        ("cylinder", ..) => {
            found.push(
                Diagnostic::new(
                    d.span.clone(),
                    "a cylinder without bore or rod",
                    "D_c and d_r are needed here",
                )
                .help("add D_c = \"... mm\" and d_r = \"... mm\", or make it a rack"),
            );
            None
        }
        _ => None,
    }
}

/// Asks for what a drive of this kind needs, but bore and rod; a rack's pinion may be left out.
fn all_of_it(d: &Values, found: &mut Vec<Diagnostic>) {
    let kind = d.text("kind").unwrap_or_default();
    let pinion = d.stands(s::R_Z.id) || d.stands(s::ETA_D.id);
    let turned: &[&Symbol] = match kind {
        "screw" => listed!(s: D_2, P_H, MU_D, BETA_D),
        "sector" => listed!(s: R_S, DELTA_S, R_Z, ETA_D),
        "rack" if pinion => listed!(s: R_Z, ETA_D),
        "crank" => listed!(s: R_CR, L_CR, ETA_D),
        "rope" => listed!(s: M_R, R_TR, ETA_D),
        _ => &[],
    };
    let line = if kind == "sector" { &[] } else { LINE };
    let symbols = line.iter().chain(turned);
    let keys = symbols.map(|symbol| Key::quantity(symbol, Sign::Positive));
    let branch = (kind == "crank").then_some(CRANK_BRANCH);
    for key in keys.chain(branch).filter(|key| !d.stands(key.name)) {
        let place = format!("in [luffing.drive] of the kind \"{kind}\"");
        found.push(missing(
            d.span.clone(),
            &place,
            &format!("luffing.drive.{}", key.name),
            &key,
        ));
    }
}

/// Refuses a crank that does not meet the driving link, which turns about `foot`, in m, or about the origin, all over these
/// angles of it, in rad.
pub fn meets(v: &Values, driving: &Driving, foot: Option<Point<f64>>, range: [f64; 2], found: &mut Vec<Diagnostic>) {
    let (Some(d), Some((rod, crank)), Some(anchors)) = (v.table("drive"), driving.crank, driving.anchors()) else {
        return;
    };
    let centre = Point::new(anchors.e_x, anchors.e_y) - foot.unwrap_or(Point::new(0.0, 0.0));
    if plane::length(centre) <= 1e-9 * (anchors.s_d + rod.r_cr) {
        let what = "the crank's centre lies at the foot of the driving link: both turn as one, and nothing drives";
        found.push(d.refuse("E_x", what, "at the foot", "move the crank's centre away from there"));
        return;
    }
    let Some(linkage) = crank_linkage(&rod, &anchors, foot, crank) else {
        let what = "crank and rod meet the anchor on the driving link at no angle";
        found.push(d.refuse(
            "l_cr",
            what,
            "cannot reach",
            "change the rod's length, the crank's radius or centre",
        ));
        return;
    };
    let [from, to] = range.map(|angle| angle + anchors.chi_d);
    if linkage.turns_fully() || linkage.arcs().iter().any(|arc| arc.covers(from, to)) {
        return;
    }
    let what = "crank and rod do not meet over the whole working range";
    let help = format!(
        "they meet for {} of the driving link: change the working range, or rod, crank or its centre",
        arcs(&linkage, anchors.chi_d)
    );
    found.push(d.refuse("l_cr", what, "does not reach", help));
}

/// Kinds of drives whose shaft may turn with a single boom in motion, and with a linkage whose pins carry the line of a drive.
pub const TURNED: [&str; 4] = ["rack", "sector", "crank", ROPE];
pub const TURNED_LINE: [&str; 2] = ["rack", ROPE];
/// Of which all is known in motion without a motor too.
const ROPE: &str = "rope";

/// Refuses a torque in a mechanism that moves, but of a rope, or with a motor, by a drive of some kinds, and limits of what the drive has
/// not, with or without `forces`; `None` of what does not move.
pub fn fits(
    v: &Values,
    gear: Option<&Gear<f64>>,
    (moves, forces): (Option<&[&str]>, bool),
    found: &mut Vec<Diagnostic>,
) {
    let motor = v.table("cases").is_some_and(|cases| cases.has("motor"));
    let turns = |d: &&Values| {
        let kind = d.text("kind").unwrap_or_default();
        (motor || kind == ROPE) && moves.is_some_and(|kinds| kinds.contains(&kind))
    };
    let told = v.table("drive").filter(|_| moves.is_some() && gear.is_some());
    if let Some(d) = told.filter(|d| !turns(d)) {
        let key = if d.text("kind") == Some("rack") {
            s::R_Z.id
        } else {
            "kind"
        };
        let what = "the torque of a drive's shaft is calculated at rest alone, and this mechanism moves by itself";
        let help = "set fidelity = \"static\" or \"table\" in [luffing] and leave out what moves, make it a rack without r_z, or give the motor whose shaft turns with a rack, [cases.motor]";
        found.push(d.refuse(key, what, "not at this level", help));
    }
    let Some(limits) = v.table("limits") else { return };
    let torques = listed!(s: T_D_OUT_MAX, T_D_IN_MAX, S_L_MAX);
    for symbol in listed!(s: LOCK_D, T_D_OUT_MAX, T_D_IN_MAX, S_L_MAX)
        .iter()
        .filter(|symbol| limits.has(symbol.id))
    {
        let has = gear.is_some_and(|gear| gear.has(symbol)) && (forces || !torques.contains(symbol));
        if !has {
            let what = format!("a limit {} that this drive has no result for", symbol.id);
            found.push(limits.refuse(symbol.id, what, "nothing to check", "remove the limit"));
        }
    }
}
