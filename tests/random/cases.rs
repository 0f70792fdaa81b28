//! What makes the cases of a luffing scene legal: what they weigh and drive is there, bodies and pins are those of the
//! mechanism.

use lemnis_models::luffing::resistances::scene::CaseParts;

use crate::scene::Node;

/// Greatest angle of a swaying rope and greatest slope, in rad.
const SWAY: f64 = 0.5;
const SLOPE: f64 = 0.2;

/// Cases of a mechanism that is legal without them, or none.
pub fn cases(n: &mut Node, parts: &CaseParts) {
    let behind = n.child("balance").map(|balance| {
        let kind = balance.text("kind").unwrap_or("").to_owned();
        (kind, balance.has("s_5"))
    });
    let armless = matches!(&behind, Some((kind, false)) if kind == "lever");
    if armless || !n.has("Q") || !n.has("weights") || !n.has("drive") && !n.has("tackle") {
        n.remove(&["cases"]);
    }
    let Some(mut c) = n.child("cases") else { return };
    c.remove(&["case", "body", "pin"]);
    let counterweight = behind.as_ref().map(|_| "counterweight");
    for name in parts.bodies.iter().copied().chain(counterweight) {
        c.more("body", |body| {
            body.put("on", name);
            if body.has("A_w") {
                body.keep("c_w", true);
            }
        });
    }
    let rod = matches!(&behind, Some((kind, _)) if matches!(kind.as_str(), "lever" | "parallelogram"));
    let behind = ["K", "L", "M"].into_iter().filter(|_| rod);
    for name in parts.pins.iter().copied().chain(behind) {
        if c.draw.coin(0.5) {
            c.more("pin", |pin| {
                pin.put("at", name);
                pin.keep("r_p", parts.guide != Some(name));
            });
        }
    }
    c.keep("c_air", true);
    // A motor and brakes that are strong enough for a drive that nearly points at the foot of its bar.
    if !c.has("motor") {
        c.remove(&["brake"]);
    }
    let brakes = c.has("brake");
    if !brakes {
        c.remove(&["second_brake"]);
    }
    if let Some(mut motor) = c.child("motor") {
        motor.put("heating", "I");
        for (name, least, most) in [
            ("P_N", 1e14, 9e14),
            ("n_N", 5.0, 50.0),
            ("k_a", 1e5, 9e5),
            ("eta_M", 0.5, 1.0),
        ] {
            let value = motor.draw.between(least, most);
            motor.set(name, value);
        }
        let travel = motor.draw.between(1e-4, 1e-3);
        motor.set("l_M", travel);
    }
    let first = c.child("brake").map(|mut brake| {
        brake.set("T_b", 9e17);
        brake.get("tau_b")
    });
    if let Some((mut second, first)) = c.child("second_brake").zip(first)
        && second.get("tau_b2") < first
    {
        second.set("tau_b2", 2.0 * first);
    }
    for number in 1..=c.draw.rng.u8(1..4) {
        c.more("case", |case| {
            case.put("name", "I".repeat(number.into()));
            case.keep("p_w", true);
            case.keep("K_b", brakes);
            if number == 1 && case.get("v_s") == 0.0 {
                case.set("v_s", 0.1);
            }
            for (name, most) in [("alpha_s", SWAY), ("sigma", SLOPE)] {
                let angle = case.draw.between(-most, most);
                case.set(name, angle);
            }
        });
    }
}
