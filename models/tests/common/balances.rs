//! Scenes of the portal crane with every kind of balance, and driven by either bar.

pub const EXISTING: &str = include_str!("../../scenes/portal_004_existing.toml");
pub const NEW: &str = include_str!("../../scenes/portal_004_new.toml");

/// The portal crane with another balance, without limits and published results.
pub fn with(balance: &str) -> String {
    let start = NEW.find("[luffing.balance]").expect("there");
    let end = NEW.find("[luffing.drive]").expect("there");
    let limits = NEW.find("[luffing.limits]").expect("there");
    format!("{}[luffing.balance]\n{balance}\n{}", &NEW[..start], &NEW[end..limits])
}

pub const KINDS: [(&str, &str); 5] = [
    (
        "tail",
        r#"
kind = "tail"
G_c = "600 kN"
r_c = "4 m"
chi_c = "0 deg"
"#,
    ),
    (
        "parallelogram",
        r#"
kind = "parallelogram"
G_c = "600 kN"
r_c = "4 m"
chi_c = "-2 deg"
r_1 = "3 m"
alpha_K = "5 deg"
d_1 = "6 m"
delta_1 = "143 deg"
"#,
    ),
    (
        "lever",
        r#"
kind = "lever"
branch = "left"
d_1 = "10.358 m"
delta_1 = "105.11 deg"
r_1 = "1.602 m"
alpha_K = "18.94 deg"
l_1 = "9.058 m"
R_1 = "0.364 m"
chi_5 = "156.81 deg"
M_5 = "984.8 kN.m"
"#,
    ),
    (
        "straight_rail",
        r#"
kind = "straight_rail"
G_c = "300 kN"
r_1 = "8 m"
alpha_K = "2 deg"
H_x = "-2 m"
H_y = "11 m"
lambda = "70 deg"
"#,
    ),
    (
        "curved_rail",
        r#"
kind = "curved_rail"
G_c = "300 kN"
r_1 = "9 m"
alpha_K = "10 deg"
L_r = "14 m"
y_0 = "10 m"
phi_0 = "60 deg"
"#,
    ),
];

/// Every kind, the two publications' levers, and the rocker driven.
pub fn every_kind() -> Vec<String> {
    let kinds = KINDS.iter().map(|(_, balance)| with(balance));
    let published = [EXISTING.to_owned(), NEW.to_owned()];
    let rocker = KINDS.iter().map(|(_, balance)| driven_by_rocker(&with(balance)));
    kinds.chain(published).chain(rocker).collect()
}

/// The same crane driven by its rocker, over nearly the same range: 44 and 82 deg
/// of the boom are 28.3518 and 69.0881 deg of the rocker.
pub fn driven_by_rocker(text: &str) -> String {
    text.replace("driven = \"boom\"", "driven = \"rocker\"")
        .replace("branch = \"left\"\n\nX_1", "branch = \"right\"\n\nX_1")
        .replace("from  = \"44 deg\"", "from = \"28.4 deg\"")
        .replace("to    = \"82 deg\"", "to = \"69 deg\"")
}
