//! Every luffing system with a load, weights, a drive and cases.

use super::balances;

pub const DRIVE: &str = include_str!("../../scenes/portal_004_drive.toml");
pub const ROPE: &str = include_str!("../../scenes/rope_luffing_drive.toml");
pub const MOTION: &str = include_str!("../../scenes/portal_004_motion.toml");
pub const PARALLELOGRAM: &str = include_str!("../../scenes/parallelogram.toml");
pub const COMPENSATED: &str = include_str!("../../scenes/rope_compensation.toml");
pub const ELLIPSOGRAPH: &str = include_str!("../../scenes/ellipsograph.toml");
pub const CURVED_TRUNK: &str = include_str!("../../scenes/curved_trunk.toml");
pub const KINDS: [&str; 3] = [
    include_str!("../../scenes/portal_004_screw.toml"),
    include_str!("../../scenes/portal_004_sector.toml"),
    include_str!("../../scenes/portal_004_crank.toml"),
];
/// A rack on the boom or the link of a scene without a drive.
pub const RACK: &str =
    "\n[luffing.drive]\nkind = \"rack\"\nE_x = \"-3.7 m\"\nE_y = \"8.2 m\"\ns_d = \"5.5 m\"\nchi_d = \"0 deg\"\n";
pub const BELOW: &str =
    "\n[luffing.drive]\nkind = \"rack\"\nE_x = \"-2 m\"\nE_y = \"-6 m\"\ns_d = \"5 m\"\nchi_d = \"0 deg\"\n";
pub const SECTOR: &str =
    "\n[luffing.drive]\nkind = \"sector\"\nr_s = \"2 m\"\ndelta_s = \"200 deg\"\nr_z = \"120 mm\"\neta_d = \"0.9\"\n";

/// Bodies and pins of each system.
pub const LINK: [&[&str]; 2] = [&["boom", "jib", "rocker"], &["O1", "B", "C", "O3"]];
pub const GUIDED: [&[&str]; 2] = [&["boom", "link"], &["O1", "C", "B"]];
pub const TRUNK: [&[&str]; 2] = [&["boom", "trunk"], &["O1", "B"]];
pub const BOOM: [&[&str]; 2] = [&["boom"], &["O1"]];

/// Two cases that have all that there is, on a system with these bodies and pins.
pub fn cases([bodies, pins]: [&[&str]; 2], guide: Option<&str>) -> String {
    let mut text = "\n[cases]\nc_air = \"0.613 kg/m3\"\n".to_owned();
    for (name, sign) in [("in", ""), ("out", "-")] {
        text += &format!(
            "[[cases.case]]\nname = \"{name}\"\nk_Q = \"0.8\"\nalpha_s = \"{sign}7 deg\"\nv_w = \"{sign}17 m/s\"\n\
             sigma = \"{sign}1 deg\"\nn_s = \"1.3 1/min\"\nv_s = \"{sign}55 mm/s\"\na_s = \"0.02 m/s2\"\n"
        );
    }
    for (i, body) in (1..).zip(bodies) {
        let (inertia, area) = (90_000 * i, 4 * i);
        text += &format!(
            "[[cases.body]]\non = \"{body}\"\nJ_s = \"{inertia} kg.m2\"\nA_w = \"{area} m2\"\nc_w = \"1.4\"\ns_w = \"3 m\"\n\
             chi_w = \"11 deg\"\n"
        );
    }
    for pin in pins {
        let radius = if guide == Some(pin) { "" } else { "r_p = \"110 mm\"\n" };
        text += &format!("[[cases.pin]]\nat = \"{pin}\"\nmu_p = \"0.05\"\n{radius}");
    }
    text
}

pub fn without(text: &str, table: &str) -> String {
    let Some(start) = text.find(&format!("[{table}]")) else {
        return text.to_owned();
    };
    let end = text[start + 1..].find("\n[").map_or(text.len(), |end| start + 1 + end);
    format!("{}{}", &text[..start], &text[end..])
}

/// A scene without its own cases and what it allows there.
pub fn plain(text: &str) -> String {
    let text = text.split("\n[cases]").next().expect("a scene");
    let allowed = |line: &&str| !["p_n_max", "sigma_v_max"].iter().any(|key| line.starts_with(key));
    text.lines()
        .filter(allowed)
        .map(|line| line.to_owned() + "\n")
        .collect()
}

/// With a load, weights, a drive and the cases.
pub fn systems() -> Vec<(String, String)> {
    let link = cases(LINK, None);
    let portal = balances::with(balances::KINDS[0].1);
    let mut all: Vec<(String, String)> = Vec::new();
    for (name, balance) in balances::KINDS {
        // A lever without its counterweight's arm has no inertia.
        let balance = balance.replace("M_5 = ", "s_5 = \"3 m\"\nM_5 = ");
        all.push((name.to_owned(), balances::with(&balance) + &link));
    }
    all.extend(
        (1..)
            .zip(KINDS)
            .map(|(i, kind)| (format!("drive {i}"), plain(kind) + &link)),
    );
    all.push(("parallelogram".to_owned(), PARALLELOGRAM.to_owned() + RACK + &link));
    all.push(("compensated".to_owned(), COMPENSATED.to_owned() + &cases(BOOM, None)));
    all.push((
        "guided".to_owned(),
        ELLIPSOGRAPH.to_owned() + BELOW + &cases(GUIDED, Some("B")),
    ));
    all.push(("trunk".to_owned(), CURVED_TRUNK.to_owned() + RACK + &cases(TRUNK, None)));
    let by_rocker = without(&balances::driven_by_rocker(&portal), "luffing.drive") + SECTOR + &link;
    all.push(("by its rocker".to_owned(), by_rocker));
    all.push(("portal".to_owned(), DRIVE.to_owned()));
    all.push(("rope".to_owned(), ROPE.to_owned()));
    all
}

/// A system in motion, of a level, with more keys of its dynamics, and the inertias of its cases; all of the load in these.
pub fn moving(text: &str, level: &str, more: &str) -> String {
    let bodies = [
        ("\"jib\"", "1 2 3"),
        ("\"link\"", "b l"),
        ("\"trunk\"", "b t"),
        ("\"boom\"", "b"),
    ];
    let (_, keys) = bodies.iter().find(|(body, _)| text.contains(body)).expect("a boom");
    let inertias = keys.split(' ').zip(1..);
    let inertias: String = inertias
        .map(|(key, i)| format!("J_{key} = \"{} t.m2\"\n", 90 * i))
        .collect();
    let dynamics = format!("[luffing.dynamics]\n{inertias}{more}\n[cases]");
    text.replacen("[luffing]\n", &format!("[luffing]\nfidelity = \"{level}\"\n"), 1)
        .replacen("[cases]", &dynamics, 1)
        .replace("k_Q = \"0.8\"", "k_Q = \"1\"")
        + if text.contains("[luffing.drive]") { MOTOR } else { "" }
}

/// A motor, of which the torque of any drive that turns is told in motion.
const MOTOR: &str = "[cases.motor]\nP_N = \"9e5 kW\"\nn_N = \"970 1/min\"\nlambda_M = \"3\"\nk_a = \"2\"\nJ_M = \"0.5 kg.m2\"\nl_M = \"4 mm\"\n\
    eta_M = \"0.9\"\nheating = \"in\"\n";

/// Those whose cases have a wind speed, with every balance: all but the ready scenes. A rocker is driven by a rack.
pub fn blown() -> impl Iterator<Item = (String, String)> {
    let balanced = |(name, text): &(String, String)| text.contains("v_w") && !name.starts_with("drive");
    let all = systems().into_iter().filter(balanced);
    all.map(|(name, text)| (name, text.replace(SECTOR, RACK)))
}
