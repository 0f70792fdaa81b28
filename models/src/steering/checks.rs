//! What the book checks of the steering.

use crate::component::governing::most;
use crate::component::outline::{Greatest, Most};
use crate::component::running::Running;
use crate::component::sheet::{Check, Summary};
use crate::component::standing::Standing;
use crate::component::telling::{between, fine};
use crate::kernel::symbol::Symbol;
use crate::parts::plane;
use crate::steering::built::Built;
use crate::steering::centre::residual;
use crate::steering::cylinder::Linkage;
use crate::steering::drawing::Stance;
use crate::steering::limits::Limits;
use crate::steering::mode::Mode;
use crate::steering::parts::Parts;
use crate::steering::published::printed;
use crate::steering::scene::Steering;
use crate::steering::symbols as s;
use crate::steering::views::example;

/// Whether the axle lines meet, the angles are those of the publication, lever arms slopes of lengths.
pub fn identities(steering: &Steering, built: &Built) -> Vec<Check> {
    let lever = built.direct().map(|(linkage, _)| lever_arm(linkage, &built.limits[0]));
    let found = [
        ("axle_lines", &s::E_O, Some(astray(steering, built)), 1e-12),
        ("published_angles", &s::AGREEMENT, printed(&built.machine), 1e-12),
        ("lever_arm", &s::AGREEMENT, lever, 1e-9),
    ];
    let check = |(id, symbol, value, limit)| Some(Check::at_most(id, symbol, value?, limit));
    found.into_iter().filter_map(check).collect()
}

/// Whether the parts suffice and the tyres roll; and what is not judged.
pub fn requirements(
    steering: &Steering,
    parts: &Parts,
    model: &Standing,
    governing: &[Summary],
) -> (Vec<Check>, Vec<&'static Symbol>) {
    let given = &steering.given;
    let (mut checks, mut unjudged) = (Vec::new(), Vec::new());
    let mut add = |id, symbol: &'static Symbol, value: Option<f64>, limit: f64, at_most| {
        let check = |value| Check::of(id, &Summary::new(symbol, value), limit, at_most);
        checks.extend(value.map(check));
    };
    add("stroke_out", &s::M_OUT, parts.found(&s::M_OUT), 0.0, false);
    add("stroke_in", &s::M_IN, parts.found(&s::M_IN), 0.0, false);
    if let Some((least, piston)) = parts.found(&s::D_G_MIN).zip(given.piston) {
        add("bore", &s::D_G, Some(piston.d_g), least, false);
    }
    if let Some(bears) = parts.found(&s::F_K) {
        add("buckling", &s::F_G_MAX, parts.found(&s::F_G_MAX), bears, true);
    }
    if parts.ring {
        // A force alone that is too great leaves no moment.
        let used = |symbol| Some(parts.found(symbol).unwrap_or(f64::INFINITY));
        add("ring", &s::RING_USE, used(&s::RING_USE), 1.0, true);
        add("bolts", &s::BOLT_USE, used(&s::BOLT_USE), 1.0, true);
    } else if given.bearing.is_some() {
        unjudged.extend([&s::RING_USE, &s::BOLT_USE]);
    }
    let coordinate = model.variables()[0].symbol;
    let fastest = most(model, &Greatest::new(&s::V_C_WORK, Most::Amount, &s::V_C)).map(|mut found| {
        found.value = found.value.abs();
        Summary::at(&s::V_C_WORK, found, coordinate).of(&s::V_C)
    });
    let slip = governing.iter().find(|found| found.symbol == &s::SLIP_WORK);
    let asked = [
        ("cylinder_speed", fastest.as_ref(), given.pace.map(|pace| pace.speed)),
        ("slip", slip, steering.slip_limit),
    ];
    for (id, found, limit) in asked {
        let Some(found) = found else { continue };
        match limit {
            Some(limit) => checks.push(Check::of(id, found, limit, true)),
            None => unjudged.push(found.symbol),
        }
    }
    (checks, unjudged)
}

/// Greatest distance, in m, at which an axle line passes the turning centre, over the working range and in every mode.
fn astray(steering: &Steering, built: &Built) -> f64 {
    let at = |theta_b: f64| {
        let mut given = steering.given.clone();
        given.theta_b.1 = theta_b;
        given
    };
    let examples = Mode::ALL.into_iter().filter_map(|mode| example(steering, built, mode));
    let stances = fine(&steering.motion).map(at).chain(examples);
    let farthest = |given| {
        let stance = Stance::new(given).expect("checked when the scene was read");
        let groups = built.machine.groups.iter().zip(&stance.angles);
        let each = groups.map(|(p, theta)| residual(&stance.centre, *p, *theta).abs());
        each.fold(0.0, f64::max)
    };
    stances.map(farthest).fold(0.0, f64::max)
}

/// Greatest difference between the lever arm and the slope of the length over the angle, over the arm.
fn lever_arm(linkage: &Linkage<f64>, limits: &Limits) -> f64 {
    const STEP: f64 = 1e-4;
    let difference = |theta: f64| {
        let l = |n: f64| linkage.at_angle(theta + n * STEP).l;
        // A central difference of order six.
        let slope = (45.0 * (l(1.0) - l(-1.0)) - 9.0 * (l(2.0) - l(-2.0)) + (l(3.0) - l(-3.0))) / (60.0 * STEP);
        (slope - linkage.at_angle(theta).od).abs() / plane::length(linkage.c)
    };
    between(limits.min, limits.max).map(difference).fold(0.0, f64::max)
}
