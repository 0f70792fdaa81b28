//! Steering: the publication's equations, limits, transitions, sizing, refusals.

use std::f64::consts::{FRAC_PI_2, PI};

use lemnis_models::kernel::calc::Calc;
use lemnis_models::kernel::record::{Rec, record};
use lemnis_models::parts::load_curve::LoadCurve;
use lemnis_models::parts::plane::{self, Point};
use lemnis_models::steering::accuracy::Accuracy;
use lemnis_models::steering::built::Built;
use lemnis_models::steering::centre::{Centre, residual};
use lemnis_models::steering::changes::greatest_flow;
use lemnis_models::steering::cylinder::{Linkage, Mounting, Pose};
use lemnis_models::steering::demand::{greatest_demand, rates};
use lemnis_models::steering::flow::{Piston, flow};
use lemnis_models::steering::limits::Limits;
use lemnis_models::steering::load::{Tyre, force, resistance, share};
use lemnis_models::steering::machine::{Footprint, Machine};
use lemnis_models::steering::mode::{Command, Mode};
use lemnis_models::steering::plan::{Crew, Plan};
use lemnis_models::steering::progress::Moment;
use lemnis_models::steering::published::Layout;
use lemnis_models::steering::reach::{Reach, reach};
use lemnis_models::steering::refusal::{Refusal, within};
use lemnis_models::steering::ring::{Bearing, Catalogue, Duty, Ring, Safety, friction};
use lemnis_models::steering::sizing::{
    BORES, EXAMPLE_STROKES, Rod, bore, buckling, choose_stroke, next, power, pump, relief, slenderness,
};
use lemnis_models::steering::slip::Slip;
use lemnis_models::steering::stand::stand;
use lemnis_models::steering::swept::{Swept, moved};
use lemnis_models::steering::symbols as s;
use num_dual::Dual64;

#[path = "common/rolled.rs"]
mod common;

use common::{Motion, Rolled, axes, free, plain};

/// The paper prints no dimensions: these are an example of its layout.
const LAYOUT: Layout<f64> = Layout {
    s_t: 12.0,
    l_1: 4.0,
    l_2: 9.0,
};

const CYLINDER: Mounting<f64> = Mounting {
    r: 0.5,
    alpha: 0.3,
    l_x: 1.25,
    l_a: 0.4,
};

fn machine() -> Machine<f64> {
    let outline = Footprint(Some([11.0, -11.0, 7.0, -7.0]));
    Machine::new(&axes(&LAYOUT.groups()), &outline).expect("apart")
}

fn rolled(machine: &Machine<f64>, centre: &Centre<f64>, v: f64) -> (Vec<Rolled<f64>>, Motion<f64>) {
    let (wheels, travel) = common::rolled(machine, &free(machine.groups.len()), centre, v);
    for wheel in &wheels {
        assert!(
            [wheel.theta, wheel.turn.x, wheel.turn.y, wheel.v]
                .iter()
                .all(|x| x.is_finite()),
            "{wheel:?}"
        );
    }
    (wheels, travel)
}

/// All angles of a change at a time (s), and the motion, unless the machine stands.
fn under_way(plan: &Plan, crew: &Crew<'_>, time: f64, angles: &mut [f64]) -> Option<[f64; 3]> {
    let moment = plan.at(crew.machine, time);
    for (i, angle) in angles.iter_mut().enumerate() {
        *angle = plan.angle(&moment, i, crew.machine, &crew.linkages[i]);
    }
    plan.motion(&moment)
}

/// The angles that it ends on.
fn target(plan: &Plan, crew: &Crew<'_>) -> Vec<f64> {
    let each = crew.linkages.iter().enumerate();
    each.map(|(i, linkage)| plan.angle(&Moment::End, i, crew.machine, linkage))
        .collect()
}

fn ranges(n: usize, degrees: f64) -> Vec<Limits> {
    vec![Limits::new(-degrees.to_radians(), degrees.to_radians(), Vec::new()).expect("valid"); n]
}

fn tan(theta: f64) -> f64 {
    let (sin, cos) = Calc::sin_cos(theta);
    sin / cos
}

/// The mended equations (1)-(8) of [Zhang2016, 2] are the general geometry on
/// the paper's layout, for turns to the left from 1 m to 10 km; so is eq. (9).
#[test]
fn the_papers_equations() {
    let machine = machine();
    for r in [1.0, 3.7, 12.0, 150.0, 1e4] {
        let centre = Mode::AllWheel
            .centre(&machine, Command::Radius(r + 6.0))
            .expect("allowed");
        let (wheels, _) = rolled(&machine, &centre, 1.0);
        let [one, two, five, six] = LAYOUT.angles(r);
        let mended = [one, two, -two, -one, five, six, -six, -five];
        for (wheel, right) in wheels.iter().zip(mended) {
            assert!((wheel.theta - right).abs() <= 1e-15, "{r}: {} {right}", wheel.theta);
        }
        let cot = |theta: f64| 1.0 / tan(theta);
        assert!((cot(five) - cot(one) - 12.0 / 9.0).abs() <= 1e-12 * (r + 12.0));
        assert!((cot(six) - cot(two) - 12.0 / 4.0).abs() <= 1e-12 * (r + 12.0));
    }
    let (wheels, travel) = rolled(
        &machine,
        &Mode::Pivot.centre(&machine, Command::None).expect("allowed"),
        1.0,
    );
    // tan(theta_1) = 2 L_2/S = 18/12; the inner groups stand at 2 L_1/S.
    assert!((LAYOUT.pivot() - 0.982_793_723_247_329).abs() <= 1e-15);
    for (i, wheel) in wheels.iter().enumerate() {
        let outer = [0, 3, 4, 7].contains(&i);
        let amount = if outer {
            LAYOUT.pivot()
        } else {
            f64::direction(12.0, 8.0)
        };
        assert!((wheel.theta.abs() - amount).abs() <= 1e-15, "{i}");
        assert!((wheel.v.abs() - if outer { 1.0 } else { (52.0_f64 / 117.0).sqrt() }).abs() <= 1e-15);
    }
    assert!((travel.omega - 1.0 / 117.0_f64.sqrt()).abs() <= 1e-16);
    assert_eq!(travel.middle, Point::zeros());
}

/// As printed in section 2 the equations do not describe this machine: read with cos,
/// (7) has no angle as soon as S + R > L_2; read with cot, (7) and (8) give groups
/// 1 and 2 one angle, and their parallel axle lines pass the centre metres apart.
#[test]
fn the_printed_equations_do_not_meet() {
    let r = 8.0;
    assert!((LAYOUT.s_t + r) / LAYOUT.l_2 > 1.0, "no arccos");
    let machine = machine();
    let centre = Mode::AllWheel
        .centre(&machine, Command::Radius(r + 6.0))
        .expect("allowed");
    let printed = f64::direction(LAYOUT.s_t + r, LAYOUT.l_2);
    let [one, two, ..] = LAYOUT.angles(r);
    let (by_one, by_two) = (
        residual(&centre, machine.groups[0], printed),
        residual(&centre, machine.groups[1], printed),
    );
    assert!(by_one.abs() > 3.0 && (by_one - by_two).abs() > 2.0, "{by_one} {by_two}");
    println!(
        "R = 8 m: printed theta_1 = theta_2 = {:.3} deg, axle lines {by_one:.2} and {by_two:.2} m off; mended {:.3} and {:.3} deg",
        printed.to_degrees(),
        one.to_degrees(),
        two.to_degrees()
    );
    for (group, angle) in [(0, one), (1, two)] {
        assert!(residual(&centre, machine.groups[group], angle).abs() <= 1e-14);
    }
    // (3) and (4) pair groups 5 with 6 and 7 with 8, which stand at different distances from the centre's line.
    let [.., five, six] = LAYOUT.angles(r);
    assert!((five - six).abs() > 0.1);
}

/// Fig. 1: the 4×2 car, cot(outer) − cot(inner) = track/wheelbase, rear wheels straight.
#[test]
fn the_car() {
    let (track, base) = (1.5, 2.7);
    let groups = [(base, 0.75), (base, -0.75), (0.0, 0.75), (0.0, -0.75)].map(|(x, y)| Point::new(x, y));
    let car = plain(&groups);
    let mut limits = ranges(4, 45.0);
    limits[2] = Limits::new(0.0, 0.0, Vec::new()).expect("straight only");
    limits[3] = limits[2].clone();
    for degrees in [-30.0_f64, -5.0, 1.0, 20.0, 40.0] {
        let command = Command::Angle(degrees.to_radians());
        let centre = Mode::FrontAxle.centre(&car, command).expect("allowed");
        let (wheels, _) = rolled(&car, &centre, 5.0);
        assert_eq!((wheels[2].theta, wheels[3].theta), (0.0, 0.0));
        assert!((wheels[0].theta - degrees.to_radians()).abs() <= 2e-16);
        let gap = 1.0 / tan(wheels[1].theta) - 1.0 / tan(wheels[0].theta);
        assert!((gap - track / base).abs() <= 1e-13, "{degrees}: {gap}");
        assert_eq!(reach(&car, &limits, Mode::FrontAxle, command), Ok(Reach::Reachable));
    }
    let beyond = reach(&car, &limits, Mode::AllWheel, Command::Angle(0.2)).expect("a verdict");
    assert!(matches!(beyond, Reach::Unreachable { group: 2, nearest: Some((_, Command::Angle(x))), .. } if x == 0.0));
}

/// Each mode has the centre that its name promises.
#[test]
fn nine_modes() {
    let machine = machine();
    let turn = |mode: Mode, command| rolled(&machine, &mode.centre(&machine, command).expect("allowed"), 1.0);
    let all = |wheels: &[Rolled<f64>], theta: f64| wheels.iter().all(|w| w.theta == theta && w.v == 1.0);
    assert!(all(&turn(Mode::Straight, Command::None).0, 0.0));
    assert!(all(&turn(Mode::Crosswise, Command::None).0, FRAC_PI_2));
    let (crab, travel) = turn(Mode::Crab, Command::Angle(0.4));
    assert!(
        crab.iter()
            .all(|w| (w.theta - 0.4).abs() <= 1e-16 && (w.v - 1.0).abs() <= 2e-16)
    );
    let direction = Mode::Crab.centre(&machine, Command::Angle(0.4)).expect("allowed");
    assert!(direction.turning().is_none() && travel.omega == 0.0);
    let (front, _) = turn(Mode::FrontAxle, Command::Angle(0.4));
    assert!([3, 7].iter().all(|&i| front[i].theta == 0.0) && (front[0].theta - 0.4).abs() <= 1e-16);
    let (rear, travel) = turn(Mode::RearAxle, Command::Angle(-0.4));
    assert!([0, 4].iter().all(|&i| rear[i].theta == 0.0) && (rear[3].theta + 0.4).abs() <= 1e-16);
    assert!(travel.omega > 0.0 && travel.middle.x > 0.0, "to the left, forward");
    let (corner, _) = turn(Mode::Corner, Command::Corner(3));
    let centre = Centre::At {
        at: Point::new(11.0, -7.0),
        clockwise: true,
    };
    for (wheel, p) in corner.iter().zip(&machine.groups) {
        assert!(residual(&centre, *p, wheel.theta).abs() <= 1e-14);
    }
    for mode in Mode::ALL {
        assert_eq!(Mode::parse(mode.id()), Ok(mode));
    }
}

/// The radius to infinity is straight travel: to the last bit at infinity, on
/// both sides, and in proportion 1/R before.
#[test]
fn the_radius_to_infinity() {
    let machine = machine();
    for sign in [1.0, -1.0] {
        for exponent in 2..=300 {
            let radius = sign * 10.0_f64.powi(exponent);
            let centre = Mode::AllWheel
                .centre(&machine, Command::Radius(radius))
                .expect("allowed");
            let (wheels, travel) = rolled(&machine, &centre, 1.0);
            for (wheel, p) in wheels.iter().zip(&machine.groups) {
                let right = f64::direction(1.0, p.x / (radius - p.y));
                assert!(
                    (wheel.theta - right).abs() <= 1e-15 * right.abs(),
                    "{radius}: {} {right}",
                    wheel.theta
                );
                assert!((wheel.v - 1.0).abs() <= 13.0 / radius.abs() + 4e-16);
            }
            let fastest = machine
                .groups
                .iter()
                .map(|p| plane::length(Point::new(p.x, p.y - radius)));
            if exponent < 100 {
                let right = sign / fastest.fold(0.0, f64::max);
                assert!((travel.omega / right - 1.0).abs() <= 4e-16);
            }
        }
        let centre = Mode::AllWheel
            .centre(&machine, Command::Radius(sign * f64::INFINITY))
            .expect("allowed");
        let (wheels, travel) = rolled(&machine, &centre, 1.0);
        assert!(wheels.iter().all(|w| w.theta == 0.0 && w.v == 1.0));
        assert_eq!((centre.turning(), travel.omega), (Some(0.0), 0.0));
        assert!(centre.point().is_none());
    }
    // By angle, through zero.
    for theta in [0.0, 1e-300, -1e-300, 1e-18, -1e-18, 5e-324] {
        let centre = Mode::AllWheel.centre(&machine, Command::Angle(theta)).expect("allowed");
        let (wheels, travel) = rolled(&machine, &centre, 1.0);
        assert_eq!(wheels[0].theta, theta);
        assert!(wheels.iter().all(|w| w.theta.abs() <= 2.0 * theta.abs()));
        assert!(travel.omega.abs() <= theta.abs());
    }
    for far in [1e10, 1e200, -1e300] {
        let centre = Mode::Free
            .centre(&machine, Command::Centre(Point::new(far, far)))
            .expect("allowed");
        let (wheels, _) = rolled(&machine, &centre, 1.0);
        assert!(
            wheels
                .iter()
                .all(|w| (w.theta + PI / 4.0).abs() <= 20.0 / far.abs() + 2e-16),
            "{far}"
        );
    }
}

/// The centre on a wheel, within 1e-15 m of one all around, and on an axle line.
#[test]
fn the_centre_on_a_wheel() {
    let machine = machine();
    let p = machine.groups[1];
    let centre = Mode::Free.centre(&machine, Command::Centre(p)).expect("allowed");
    let (wheels, _) = rolled(&machine, &centre, 1.0);
    assert_eq!((wheels[1].theta, wheels[1].v), (0.0, 0.0));
    for (i, wheel) in wheels.iter().enumerate() {
        assert!(residual(&centre, machine.groups[i], wheel.theta).abs() <= 1e-14, "{i}");
    }
    // (4, 6) is surrounded by doubles 4.4e-16 to 8.9e-16 m away.
    for (dx, dy) in [(1, 0), (-1, 0), (0, 1), (0, -1), (1, 1), (-1, 1)] {
        let near = |x: f64, bits: i64| f64::from_bits(x.to_bits().wrapping_add_signed(bits));
        let at = Point::new(near(p.x, dx), near(p.y, dy));
        let off = at - p;
        assert!(plane::length(off) > 0.0 && plane::length(off) <= 1.3e-15);
        let centre = Mode::Free.centre(&machine, Command::Centre(at)).expect("allowed");
        let (wheels, _) = rolled(&machine, &centre, 1.0);
        // At a right angle to the direction of the centre, exactly as far as atan2 goes.
        let (sin, cos) = Calc::sin_cos(wheels[1].theta);
        assert!((cos * off.x + sin * off.y).abs() <= 2e-16 * plane::length(off));
        assert!(wheels[1].v.abs() <= 1e-15 && wheels[1].v != 0.0);
        assert!(residual(&centre, p, wheels[1].theta).abs() <= 1e-15);
    }
    // On the axle line of the foremost groups: exactly straight there.
    for y in [-20.0, -6.1, 0.3, 7.0, 55.0] {
        let centre = Mode::Free
            .centre(&machine, Command::Centre(Point::new(9.0, y)))
            .expect("allowed");
        let (wheels, _) = rolled(&machine, &centre, 1.0);
        assert_eq!((wheels[0].theta, wheels[4].theta), (0.0, 0.0));
    }
}

/// Zero track: one line of groups turns, pivots and crabs.
#[test]
fn zero_track() {
    let groups: Vec<Point<f64>> = [6.0, 2.0, -2.0, -6.0].map(|x| Point::new(x, 0.0)).to_vec();
    let line = plain(&groups);
    let (wheels, _) = rolled(&line, &Mode::Pivot.centre(&line, Command::None).expect("allowed"), 1.0);
    assert!(wheels.iter().all(|w| w.theta == FRAC_PI_2));
    assert_eq!(
        wheels.iter().map(|w| w.v.signum()).collect::<Vec<_>>(),
        [1.0, 1.0, -1.0, -1.0]
    );
    let (wheels, _) = rolled(
        &line,
        &Mode::AllWheel.centre(&line, Command::Angle(0.5)).expect("allowed"),
        1.0,
    );
    assert!((wheels[3].theta + 0.5).abs() <= 1e-16 && wheels[0].v == 1.0);
    let mut sideways = [0.0; 4];
    let slip = Slip::new(
        &line,
        &Mode::Straight.centre(&line, Command::None).expect("allowed"),
        1.0,
        &[0.0; 4],
        &mut sideways,
    );
    assert_eq!((slip.rms, sideways), (0.0, [0.0; 4]));
    let none = share(&line, 1e6, Point::zeros(), &mut [0.0; 4]).expect_err("statically open");
    assert!(none.what.contains("one line"), "{none}");
}

/// Exactly at the end of the range is reachable; one part in 1e9 beyond is not,
/// and the nearest command is the end. The same for the pivot at the stop.
#[test]
fn the_ends_of_the_range() {
    let machine = machine();
    let stop = LAYOUT.pivot();
    let at_stop = vec![Limits::new(-stop, stop, Vec::new()).expect("valid"); 8];
    assert_eq!(
        reach(&machine, &at_stop, Mode::Pivot, Command::None),
        Ok(Reach::Reachable)
    );
    let short = vec![Limits::new(-stop + 1e-9, stop - 1e-9, Vec::new()).expect("valid"); 8];
    let found = reach(&machine, &short, Mode::Pivot, Command::None).expect("a verdict");
    // Turning on the spot leaves no choice. A centre that is nearer to the groups of one end or side is farther from
    // those of the other: the nearest one that they reach has the same angles from outside, at twice half the track.
    let Reach::Unreachable {
        group: 0,
        nearest: Some((Mode::Free, Command::Centre(at))),
        ..
    } = found
    else {
        panic!("{found:?}")
    };
    assert!(at.x.abs() <= 1e-9 && (at.y.abs() - 12.0).abs() <= 1e-7, "{at:?}");
    let limits = ranges(8, 50.0);
    let end = 50.0_f64.to_radians();
    // Group 1 is the one that turns most while the centre is on its side.
    for mode in [Mode::AllWheel, Mode::FrontAxle] {
        assert_eq!(
            reach(&machine, &limits, mode, Command::Angle(end)),
            Ok(Reach::Reachable)
        );
        let beyond = reach(&machine, &limits, mode, Command::Angle(end + 1e-6)).expect("a verdict");
        let Reach::Unreachable {
            group: 0,
            nearest: Some((found, nearest)),
            ..
        } = beyond
        else {
            panic!("{beyond:?}")
        };
        assert!(
            found == mode && matches!(nearest, Command::Angle(x) if x == end),
            "{nearest:?}"
        );
        assert_eq!(reach(&machine, &limits, mode, nearest), Ok(Reach::Reachable));
    }
    let crab = reach(&machine, &limits, Mode::Crab, Command::Angle(-0.9)).expect("a verdict");
    assert!(
        matches!(crab, Reach::Unreachable { nearest: Some((Mode::Crab, Command::Angle(x))), .. } if (x + end).abs() <= 1e-15)
    );
    // R from the inner side: L_2/tan(50°), and 6 m to the middle.
    let radius = 6.0 + 9.0 / tan(end);
    let beyond = reach(&machine, &limits, Mode::AllWheel, Command::Radius(12.0)).expect("a verdict");
    let Reach::Unreachable {
        nearest: Some((Mode::AllWheel, Command::Radius(found))),
        ..
    } = beyond
    else {
        panic!("{beyond:?}")
    };
    assert!((found - radius).abs() <= 1e-14, "{found} {radius}");
}

/// The nearest reachable centre of free steering is not farther than any that a search finds.
#[test]
fn the_nearest_centre() {
    let machine = machine();
    let limits = ranges(8, 50.0);
    for (x, y) in [(1.0, 8.0), (5.0, 10.0), (-20.0, 12.0), (0.0, 0.0), (30.0, -3.0)] {
        let wanted = Point::new(x, y);
        let found = reach(&machine, &limits, Mode::Free, Command::Centre(wanted)).expect("a verdict");
        let Reach::Unreachable {
            nearest: Some((Mode::Free, Command::Centre(nearest))),
            ..
        } = found
        else {
            panic!("{found:?}")
        };
        assert_eq!(
            reach(&machine, &limits, Mode::Free, Command::Centre(nearest)),
            Ok(Reach::Reachable)
        );
        let distance = plane::length(nearest - wanted);
        for ring in 1..100 {
            for step in 0..360 {
                let (sin, cos) = Calc::sin_cos(f64::from(step).to_radians());
                let at = wanted + Point::new(cos, sin) * (distance * (f64::from(ring) / 100.0));
                let nearer = reach(&machine, &limits, Mode::Free, Command::Centre(at)).expect("a verdict");
                assert_ne!(
                    nearer,
                    Reach::Reachable,
                    "{at:?} is nearer to {wanted:?} than {nearest:?}"
                );
            }
        }
    }
}

/// The machine moves as a rigid body about the centre, and in a straight line
/// where that is at infinity; the lane's limits are those of the outline's points.
#[test]
fn swept_paths() {
    let machine = machine();
    let fastest = |centre: &Centre<f64>| {
        machine
            .groups
            .iter()
            .map(|p| plane::length(centre.rolling(*p)))
            .fold(0.0, f64::max)
    };
    for radius in [3.0, -15.0, 40.0, 1e6] {
        let centre = Mode::AllWheel
            .centre(&machine, Command::Radius(radius))
            .expect("allowed");
        let at = Point::new(0.0, radius);
        for &p in &machine.corners {
            let q = moved(&centre, fastest(&centre), p, 7.0);
            assert!((plane::length(q - at) - plane::length(p - at)).abs() <= 1e-14 * radius.abs().max(20.0));
            let turned = 7.0 / fastest(&centre);
            let chord = 2.0 * plane::length(p - at) * Calc::sin(turned / 2.0);
            assert!((plane::length(q - p) - chord).abs() <= 1e-13);
        }
        // Points of the outline on a fine grid.
        let edges = machine.corners.iter().zip(machine.corners.iter().cycle().skip(1));
        let points = edges.flat_map(|(p, q)| (0..=4000).map(move |i| p + (q - p) * (f64::from(i) / 4000.0)));
        let (low, high) = points
            .map(|p| plane::length(p - at))
            .fold((f64::INFINITY, 0.0_f64), |(l, h), x| (l.min(x), h.max(x)));
        let swept = Swept::new(&machine, &centre);
        let inside = radius == 3.0;
        assert!((swept.outer - high).abs() <= 1e-9 && (swept.inner - if inside { 0.0 } else { low }).abs() <= 1e-9);
        assert!((swept.width - (swept.outer - swept.inner)).abs() <= 1e-9);
    }
    let straight = Mode::Straight.centre(&machine, Command::None).expect("allowed");
    assert_eq!(moved(&straight, 1.0, Point::new(1.0, 2.0), 7.0), Point::new(8.0, 2.0));
    assert_eq!(Swept::new(&machine, &straight).width, 14.0);
    let nearly = Mode::AllWheel.centre(&machine, Command::Radius(1e12)).expect("allowed");
    assert!((Swept::new(&machine, &nearly).width - 14.0).abs() <= 1e-9);
    let crab = Mode::Crab.centre(&machine, Command::Angle(PI / 4.0)).expect("allowed");
    assert!((Swept::new(&machine, &crab).width - 36.0 / 2.0_f64.sqrt()).abs() <= 1e-13);
}

/// Slip of the tyres: none without error; a common error of crab travel is a
/// drift, no slip; one wrong group of n slips by its error times (1 − share).
#[test]
fn slip_from_angle_errors() {
    let machine = machine();
    let mut sideways = [0.0; 8];
    let turning = Mode::AllWheel.centre(&machine, Command::Angle(0.5)).expect("allowed");
    let slip = Slip::new(&machine, &turning, 0.5, &[0.0; 8], &mut sideways);
    assert!(slip.rms <= 1e-16 && slip.turn.abs() <= 1e-16);
    let straight = Mode::Straight.centre(&machine, Command::None).expect("allowed");
    let slip = Slip::new(&machine, &straight, 0.5, &[0.01; 8], &mut sideways);
    assert!(slip.rms <= 1e-16, "{slip:?}");
    assert!((slip.drift.y - 0.5 * tan(0.01)).abs() <= 1e-16);
    // The fore-and-aft pattern of a left turn's errors becomes a turn.
    let errors: Vec<f64> = machine.groups.iter().map(|p| 1e-6 * p.x).collect();
    let slip = Slip::new(&machine, &straight, 0.5, &errors, &mut sideways);
    assert!((slip.turn - 0.5e-6).abs() <= 1e-15 && slip.rms <= 1e-10, "{slip:?}");
    // Least squares: any other drift is worse. The residual is orthogonal to what drift can do.
    let errors = [0.01, 0.0, -0.004, 0.0, 0.0, 0.007, 0.0, 0.0];
    let slip = Slip::new(&machine, &straight, 0.5, &errors, &mut sideways);
    let across: f64 = sideways.iter().zip(errors).map(|(v, e)| v * Calc::sin_cos(e).1).sum();
    let about: f64 = machine
        .groups
        .iter()
        .zip(sideways)
        .zip(errors)
        .map(|((p, v), e)| {
            let (sin, cos) = Calc::sin_cos(e);
            v * (p.x * cos + p.y * sin)
        })
        .sum();
    assert!(
        across.abs() <= 1e-15 && about.abs() <= 1e-14 && slip.rms > 1e-4,
        "{across} {about}"
    );
    // A 12-bit encoder and 0.5 mm of dead band on 0.4 m.
    let accuracy = Accuracy {
        step: 2.0 * PI / 4096.0,
        dead_band: 0.5e-3,
    };
    let error = accuracy.angle_error(&Pose { l: 1.0, od: 0.4 });
    assert!((error - (PI / 4096.0 + 0.00125)).abs() <= 1e-18);
}

/// dR/dtheta = od by dual numbers, both mountings; R and od by the law of cosines
/// of [Zhang2016, 5.1]; the inverse; od is greatest straight ahead, where it is the arm.
#[test]
fn the_cylinder() {
    let beta = f64::direction(CYLINDER.r, 0.4 + 1.5 * 1.25);
    for mirrored in [false, true] {
        let linkage = CYLINDER.linkage(mirrored);
        let dual: Linkage<Dual64> = CYLINDER.map(&mut |_, x| Dual64::from_re(x)).linkage(mirrored);
        let sense = if mirrored { -1.0 } else { 1.0 };
        let ob = plane::length(linkage.b);
        let [low, high] = linkage.dead_points();
        for step in 1..1000 {
            let theta = low + (high - low) * f64::from(step) / 1000.0;
            let pose = linkage.at_angle(theta);
            let slope = dual.at_angle(Dual64::new(theta, 1.0)).l.eps;
            assert!((slope - pose.od).abs() <= 1e-15, "{theta}: {slope} {}", pose.od);
            let (sin, cos) = Calc::sin_cos(beta + sense * theta);
            let paper = (ob * ob + 0.25 - 2.0 * ob * 0.5 * cos).sqrt();
            assert!((pose.l - paper).abs() <= 4e-15);
            assert!((pose.od - sense * ob * 0.5 * sin / paper).abs() <= 4e-15);
            assert!(pose.od.abs() <= 0.5 + 1e-15 && pose.od * sense > 0.0);
            assert!((linkage.angle(pose.l).expect("reaches") - theta).abs() <= 1e-15 / pose.od.abs() * 4.0);
        }
        assert!((linkage.at_angle(0.0).od - sense * 0.5).abs() <= 1e-15);
        assert!(linkage.at_angle(low).od.abs() <= 1e-15 && linkage.at_angle(high).od.abs() <= 1e-15);
        assert!(linkage.angle(ob + 0.5001).is_none() && linkage.angle(ob - 0.5001).is_none());
        // The smallest arm over the paper's interval [−θ1, θ1] is at its shortest end.
        let limits = Limits::new(-LAYOUT.pivot(), LAYOUT.pivot(), Vec::new()).expect("valid");
        let found = linkage.over(&limits).expect("between dead points");
        let grid = (0..=2000).map(|i| linkage.at_angle(LAYOUT.pivot() * (f64::from(i) / 1000.0 - 1.0)));
        let [least, shortest, longest] = grid.fold([f64::INFINITY, f64::INFINITY, 0.0], |[a, b, c], p| {
            [a.min(p.od.abs()), b.min(p.l), c.max(p.l)]
        });
        assert!((found.od_min - least).abs() <= 1e-15 && found.od_min_at == -sense * LAYOUT.pivot());
        assert!((found.shortest - shortest).abs() <= 1e-15 && (found.longest - longest).abs() <= 1e-15);
        println!(
            "R({:.2} deg) {shortest:.4} to {longest:.4} m, od_min {least:.4} m",
            LAYOUT.pivot().to_degrees()
        );
    }
    // R(θ1) ≤ 2 l_x + l_A and R(−θ1) ≥ l_x + l_A: the next shorter stroke fails one of them.
    let limits = Limits::new(-LAYOUT.pivot(), LAYOUT.pivot(), Vec::new()).expect("valid");
    let chosen = choose_stroke(&CYLINDER, false, &limits, &EXAMPLE_STROKES).expect("one fits");
    let index = EXAMPLE_STROKES.iter().position(|x| *x == chosen).expect("of the list");
    let margins = |l_x| {
        let cylinder = Mounting { l_x, ..CYLINDER };
        let found = cylinder.linkage(false).over(&limits).expect("between dead points");
        cylinder.stroke_margins(found.longest, found.shortest)
    };
    assert!(margins(chosen).iter().all(|m| *m >= 0.0) && margins(EXAMPLE_STROKES[index - 1]).iter().any(|m| *m < 0.0));
    println!("stroke {chosen} m, margins {:?} m", margins(chosen));
}

/// The stops of the cylinder are the ends of its group's range: stroke left over
/// by the chosen range is range left over, and a stop beyond a dead point is refused.
#[test]
fn the_range_of_the_cylinder() {
    for mirrored in [false, true] {
        // 1.65 m and 2.9 m are beyond |o–b| ∓ |o–c| = 2.329 ∓ 0.5 m: the dead points end the range.
        let (linkage, limits) = (CYLINDER.linkage(mirrored), Limits::between(CYLINDER.ends(mirrored)));
        assert_eq!([limits.min, limits.max], linkage.dead_points());
        let refused = linkage.over(&limits).expect_err("no lever arm");
        assert!(refused.what.contains("cannot turn"), "{refused}");
        let shorter = Mounting { l_x: 0.8, ..CYLINDER };
        let (linkage, limits) = (shorter.linkage(mirrored), Limits::between(shorter.ends(mirrored)));
        let ends = [limits.min, limits.max].map(|theta| linkage.at_angle(theta).l);
        let [low, high] = if mirrored { [ends[1], ends[0]] } else { ends };
        assert!((low - 1.2).abs() <= 1e-14 && (high - 2.0).abs() <= 1e-14, "{ends:?}");
        // choose_stroke finds 0.9 m for the pivot, and not 0.8 m.
        let pivot = LAYOUT.pivot();
        assert!(!(limits.allows(pivot) && limits.allows(-pivot)));
        let chosen = Limits::between(Mounting { l_x: 0.9, ..CYLINDER }.ends(mirrored));
        assert!(chosen.allows(pivot) && chosen.allows(-pivot));
        println!(
            "stops at {:.2} and {:.2} deg",
            limits.min.to_degrees(),
            limits.max.to_degrees()
        );
    }
}

/// A small catalogue: the figures are of no maker, and nothing may be built from them.
fn example() -> Catalogue {
    let ring = |size: u32, f: f64, m: f64| Ring {
        name: format!("EXAMPLE {size}"),
        d_l: f64::from(size) / 1e3,
        ring: LoadCurve(vec![[0.0, m], [0.4 * f, 0.8 * m], [0.8 * f, 0.3 * m], [f, 0.0]]),
        bolts: LoadCurve(vec![[0.0, 0.7 * m], [f, 0.7 * m]]),
    };
    Catalogue {
        rings: vec![
            ring(800, 1.6e6, 0.35e6),
            ring(1000, 2.4e6, 0.65e6),
            ring(1250, 3.4e6, 1.1e6),
            ring(1600, 5.0e6, 2.1e6),
        ],
    }
}

/// The paper's numbers: f = 0.7 and T_r/2.5 (section 3), 1.25 and F_s = 1.25 (section 4), all in SI and
/// once in the paper's units, where the pressure must be in kPa although MPa is printed.
#[test]
fn loads_and_sizing() {
    let tyre = Tyre {
        f_t: 0.7,
        p_t: 0.9e6,
        k_v: 2.5,
    };
    let found = resistance(&tyre, 900e3);
    let in_kn_kpa = 0.7 / 3.0 * (900.0_f64.powi(3) / 900.0).sqrt();
    assert!((found.standing / 1e3 - in_kn_kpa).abs() <= 1e-10 && (in_kn_kpa - 210.0).abs() <= 1e-10);
    assert!((found.travelling / 1e3 - 84.0).abs() <= 1e-10);
    // With MPa, as printed, the number would be 31.6 times too great for kN·m.
    let in_mpa = 0.7 / 3.0 * (900.0_f64.powi(3) / 0.9).sqrt();
    assert!((in_mpa / in_kn_kpa - 1000.0_f64.sqrt()).abs() <= 1e-12);
    let bearing = Bearing {
        l_max: 0.3,
        mu_r: 0.006,
        d_l: 1.0,
    };
    let safety = Safety {
        f_s: 1.25,
        k_test: 1.25,
    };
    let duty = Duty::new(&bearing, &safety, 900e3);
    assert!((duty.f - 1406.25e3).abs() <= 1e-9 && (duty.m - 421.875e3).abs() <= 1e-9);
    assert!((duty.f_bolt - 1125e3).abs() <= 1e-9 && (duty.m_bolt - 337.5e3).abs() <= 1e-9);
    let catalogue = example();
    let ring = catalogue.choose(&duty).expect("one fits");
    assert!(ring.use_of(&duty).expect("within").iter().all(|part| *part <= 1.0));
    let smaller = catalogue.rings.iter().take_while(|other| other.name != ring.name);
    assert!(
        smaller
            .map(|other| other.use_of(&duty))
            .all(|parts| parts.is_none_or(|p| p.iter().any(|x| *x > 1.0)))
    );
    // mu/2 (4.4 M + F D) = 0.003 · (4.4 · 270 + 900) kN·m.
    let drag = friction(&bearing, 900e3);
    assert!((drag - 0.003 * 2088e3).abs() <= 1e-9);
    let limits = Limits::new(-LAYOUT.pivot(), LAYOUT.pivot(), Vec::new()).expect("valid");
    let extremes = CYLINDER.linkage(false).over(&limits).expect("between dead points");
    let f_g = force(found.standing + drag, extremes.od_min);
    let d_min = bore(f_g, 25e6, 0.14);
    // The annulus at this pressure gives exactly the force.
    assert!((PI / 4.0 * (d_min * d_min - 0.14 * 0.14) * 25e6 / f_g - 1.0).abs() <= 1e-14);
    let d_g = next(&BORES, d_min).expect("within the series");
    assert!(d_g >= d_min && BORES.iter().all(|x| *x >= d_g || *x < d_min));
    assert_eq!(next(&BORES, 0.25), Ok(0.25));
    let rod = Rod {
        e: 210e9,
        d: 0.14,
        l_k: extremes.longest,
        nu: 3.5,
    };
    let inertia = PI / 64.0 * 0.14_f64.powi(4);
    let euler = PI * PI * 210e9 * inertia / (3.5 * extremes.longest * extremes.longest);
    assert!((buckling(&rod) / euler - 1.0).abs() <= 1e-14);
    let area = PI / 4.0 * 0.14 * 0.14;
    let [lambda, sigma_e] = slenderness(&rod);
    assert!((lambda * (inertia / area).sqrt() / extremes.longest - 1.0).abs() <= 1e-14);
    assert!((sigma_e * area / 3.5 / euler - 1.0).abs() <= 1e-14);
    assert_eq!(power(2e-3, 25e6), 50e3);
    let piston = Piston { d_g: 0.2, d: 0.1 };
    assert!((flow(&piston, &0.01) - PI / 4.0 * 0.04 * 0.01).abs() <= 1e-18);
    assert!((flow(&piston, &-0.01) + PI / 4.0 * 0.03 * 0.01).abs() <= 1e-18);
    assert!((pump(1e-3, 25.0, 0.95) - 1e-3 / 23.75).abs() <= 1e-18);
    assert_eq!(relief(25e6, 1.1), 25e6 * 1.1);
    println!(
        "T_r 210 kN.m, f_g {:.1} kN, D_g {:.1} mm -> {:.0} mm, ring {}",
        f_g / 1e3,
        d_min * 1e3,
        d_g * 1e3,
        ring.name
    );
}

/// Loads of a rigid frame on equal springs: sum and moments of the weight.
#[test]
fn shares_of_the_load() {
    let machine = machine();
    let (weight, at) = (6e6, Point::new(1.2, -0.4));
    let mut loads = [0.0; 8];
    share(&machine, weight, at, &mut loads).expect("all carry");
    let sum: f64 = loads.iter().sum();
    let moment: Point<f64> = machine.groups.iter().zip(loads).map(|(p, g)| p * g).sum();
    assert!((sum - weight).abs() <= 1e-8 && plane::length(moment - at * weight) <= 1e-7);
    assert!(loads[0] > loads[3] && loads[4] > loads[0]);
    let lifted = share(&machine, weight, Point::new(9.5, 0.0), &mut loads).expect_err("lifts off");
    assert!(
        lifted.key.starts_with("G[") && lifted.what.contains("would carry -"),
        "{lifted}"
    );
}

/// Rates by dual numbers against differences, and the worst demand against a plain sum.
#[test]
fn flows() {
    let machine = machine();
    let mut slopes = [0.0; 8];
    let angles = |theta: f64| {
        let centre = Mode::AllWheel.centre(&machine, Command::Angle(theta)).expect("allowed");
        rolled(&machine, &centre, 1.0)
            .0
            .iter()
            .map(|w| w.theta)
            .collect::<Vec<_>>()
    };
    for theta in [-0.5, 0.0, 0.6] {
        rates(&machine, Mode::AllWheel, theta, &mut slopes).expect("allowed");
        let (above, below) = (angles(theta + 1e-6), angles(theta - 1e-6));
        for i in 0..8 {
            assert!((slopes[i] - (above[i] - below[i]) / 2e-6).abs() <= 1e-8, "{theta} {i}");
        }
        assert!((slopes[0] - 1.0).abs() <= 1e-15);
    }
    let built = Built {
        machine,
        limits: ranges(8, 56.0),
        linkages: vec![CYLINDER.linkage(false); 8],
    };
    let piston = Piston { d_g: 0.2, d: 0.1 };
    // Crab: every group at the commanded rate; the flow is greatest straight ahead, lengthening.
    let crab = greatest_demand(&built, &piston, Mode::Crab, 0.05).expect("allowed");
    assert!((crab.flow - 8.0 * PI / 4.0 * 0.04 * 0.5 * 0.05).abs() <= 1e-15 && crab.at == 0.0 && crab.rising);
    let all = greatest_demand(&built, &piston, Mode::AllWheel, 0.05).expect("allowed");
    println!(
        "greatest flow: crab {:.1} L/min, all-wheel {:.1} L/min at {:.2} deg",
        crab.flow * 6e4,
        all.flow * 6e4,
        all.at.to_degrees()
    );
    assert!(all.flow > 0.0);
}

/// From mode to mode: axle lines meet all the way while travelling, no cylinder
/// is faster than its limit, all arrive together, forbidden ranges are not entered.
#[test]
#[expect(clippy::too_many_lines, reason = "one case after the other")]
fn transitions() {
    let machine = machine();
    let linkages: Vec<_> = (0..8).map(|i| CYLINDER.linkage(i % 2 == 1)).collect();
    let limits = ranges(8, 60.0);
    let crew = Crew {
        machine: &machine,
        limits: &limits,
        linkages: &linkages,
        speed: 0.05,
    };
    let centre = |mode: Mode, command| mode.centre(&machine, command).expect("allowed");
    let stance = |centre: &Centre<f64>| {
        let (wheels, _) = common::rolled(&machine, &limits, centre, 1.0);
        assert!(wheels.iter().all(|wheel| wheel.placed), "within reach");
        wheels.iter().map(|w| w.theta).collect::<Vec<f64>>()
    };
    let straight = centre(Mode::Straight, Command::None);
    let left = centre(Mode::AllWheel, Command::Angle(0.6));
    let right = centre(Mode::AllWheel, Command::Radius(-25.0));
    let crab = centre(Mode::Crab, Command::Angle(-0.5));
    let front = centre(Mode::FrontAxle, Command::Angle(0.7));
    let pivot = centre(Mode::Pivot, Command::None);
    let cases = [
        ("straight to left", &straight, &left, false),
        ("left to right", &left, &right, false),
        ("crab to front", &crab, &front, false),
        ("straight to pivot", &straight, &pivot, true),
        ("pivot to crab", &pivot, &crab, true),
        ("left to left", &left, &left, false),
    ];
    for (name, from, to, standing) in cases {
        let (start, end) = (stance(from), stance(to));
        let way = crew.transition(from, &start, to).expect("possible");
        assert_eq!(way.standing, standing, "{name}");
        let mut at = [0.0; 8];
        for (found, right) in target(&way, &crew).iter().zip(&end) {
            assert!((found - right).abs() <= 1e-12, "{name}");
        }
        let (steps, mut last) = (2000, start.clone());
        let slice = way.time / f64::from(steps);
        let mut fastest = 0.0_f64;
        for step in 0..=steps {
            let motion = under_way(&way, &crew, slice * f64::from(step), &mut at);
            assert_eq!(motion.is_none(), standing);
            let centre = motion.map(|motion| machine.about(motion));
            for i in 0..8 {
                if let Some(centre) = &centre {
                    assert!(residual(centre, machine.groups[i], at[i]).abs() <= 1e-12, "{name}");
                }
                assert!(at[i].is_finite() && limits[i].allows(at[i]), "{name}");
                if step > 0 && slice > 0.0 {
                    let run = linkages[i].at_angle(at[i]).l - linkages[i].at_angle(last[i]).l;
                    fastest = fastest.max(run.abs() / slice);
                }
            }
            last.copy_from_slice(&at);
        }
        assert!(fastest <= 0.05 * (1.0 + 1e-9), "{name}: {fastest} m/s");
        let longest = (0..8)
            .map(|i| (linkages[i].at_angle(end[i]).l - linkages[i].at_angle(start[i]).l).abs() / 0.05)
            .fold(0.0, f64::max);
        assert!(way.time >= longest * (1.0 - 1e-12), "{name}");
        let piston = Piston { d_g: 0.2, d: 0.1 };
        assert!(greatest_flow(&way, &crew, &piston) <= 8.0 * PI / 4.0 * 0.04 * 0.05 * 1.001);
        println!(
            "{name}: {:.2} s (one cylinder alone {longest:.2} s), {}",
            way.time,
            if standing { "standing" } else { "travelling" }
        );
    }
    // Every mode to every mode, from a centre on a group too: it ends where it should, without NaN.
    let wide = ranges(8, 76.0);
    let every = Crew { limits: &wide, ..crew };
    let stances = [
        straight,
        crab,
        front,
        centre(Mode::RearAxle, Command::Radius(30.0)),
        left,
        pivot,
        centre(Mode::Corner, Command::Corner(0)),
        centre(Mode::Free, Command::Centre(Point::new(9.0, 60.0))),
        centre(Mode::Free, Command::Centre(Point::new(3.0, 20.0))),
    ];
    let (mut reachable, mut possible, mut standing) = (0, 0, 0);
    for from in &stances {
        let (start, _) = common::rolled(&machine, &wide, from, 1.0);
        if !start.iter().all(|wheel| wheel.placed) {
            continue;
        }
        reachable += 1;
        let start: Vec<f64> = start.iter().map(|w| w.theta).collect();
        for to in &stances {
            let Ok(way) = every.transition(from, &start, to) else {
                continue;
            };
            assert!(way.time.is_finite() && way.time >= 0.0);
            let angles = target(&way, &every);
            assert_eq!(angles, stand(&machine, &wide, to));
            for (p, theta) in machine.groups.iter().zip(angles) {
                assert!(residual(to, *p, theta).abs() <= 1e-12);
            }
            possible += 1;
            standing += usize::from(way.standing);
        }
    }
    println!("{possible} of 81 changes possible, {standing} of them standing");
    // Without forbidden ranges every reachable stance leads to every other.
    assert_eq!((reachable, possible), (8, 64));
    assert!(standing > 0 && standing < possible);
    // A forbidden range between: crab at 20° cannot become crab at 40°, nor a wheel turn around it.
    let mut barred = ranges(8, 60.0);
    barred[2] = Limits::new(-1.0, 1.0, vec![[0.4, 0.6]]).expect("valid");
    let crew = Crew {
        limits: &barred,
        ..crew
    };
    let (from, to) = (
        centre(Mode::Crab, Command::Angle(0.35)),
        centre(Mode::Crab, Command::Angle(0.7)),
    );
    let refused = crew.transition(&from, &[0.35; 8], &to).expect_err("barred");
    assert_eq!(refused, 2);
    assert!(!Limits::allows(&barred[2], 0.5) && Limits::allows(&barred[2], 0.4));
    // With room enough all groups turn the other way round, and the machine may travel.
    let wide = vec![Limits::new(-PI + 0.1, PI - 0.1, vec![[0.4, 0.6]]).expect("valid"); 8];
    let crew = Crew { limits: &wide, ..crew };
    let way = crew.transition(&from, &[0.35; 8], &to).expect("the other way round");
    assert!(!way.standing && target(&way, &crew).iter().all(|x| (x - (0.7 - PI)).abs() <= 1e-12));
}

/// Random machines with random forbidden ranges: whatever change is possible ends exactly on the commanded angles,
/// keeps every cylinder within its speed limit and every group out of its forbidden ranges; no range between two
/// stances that a group could pass is a reason to refuse.
#[test]
fn random_transitions() {
    let mut seed = 88_172_645_463_325_252_u64;
    let mut random = |low: f64, high: f64| {
        seed ^= seed << 13;
        seed ^= seed >> 7;
        seed ^= seed << 17;
        low + (high - low) * (seed >> 11) as f64 / (1_u64 << 53) as f64
    };
    let (mut travelled, mut stood, mut refused) = (0, 0, 0);
    for _ in 0..300 {
        let n = random(4.0, 12.0) as usize;
        let groups: Vec<_> = (0..n)
            .map(|_| Point::new(random(-15.0, 15.0), random(-8.0, 8.0)))
            .collect();
        let Ok(machine) = Machine::new(&axes(&groups), &Footprint(None)) else {
            continue;
        };
        let linkages: Vec<_> = (0..n).map(|i| CYLINDER.linkage(i % 2 == 1)).collect();
        let limits: Vec<Limits> = (0..n)
            .map(|_| {
                let (from, side) = (random(0.1, 0.8), random(-1.0, 1.0).signum());
                let ends = [side * from, side * (from + 0.1)];
                let barred = vec![[ends[0].min(ends[1]), ends[0].max(ends[1])]];
                let forbidden = if random(0.0, 1.0) < 0.1 { barred } else { Vec::new() };
                Limits::new(-1.2, 1.2, forbidden).expect("valid")
            })
            .collect();
        let crew = Crew {
            machine: &machine,
            limits: &limits,
            linkages: &linkages,
            speed: 0.05,
        };
        let mut stance = || loop {
            let turn = random(-1.0, 1.0);
            let found = match turn {
                x if x < -0.4 => Mode::Crab.centre(&machine, Command::Angle(turn)),
                x if x < 0.9 => {
                    let at = Point::new(random(-10.0, 10.0), random(-12.0, 12.0));
                    Mode::Free.centre(&machine, Command::Centre(at))
                }
                _ => Mode::Straight.centre(&machine, Command::None),
            };
            let centre = found.expect("allowed");
            let angles = stand(&machine, &limits, &centre);
            if limits.iter().zip(&angles).all(|(limits, theta)| limits.allows(*theta)) {
                return (centre, angles);
            }
        };
        let ((from, start), (to, end)) = (stance(), stance());
        let blocked = (0..n).any(|i| !limits[i].allows_turn(start[i], end[i]));
        let Ok(plan) = crew.transition(&from, &start, &to) else {
            assert!(blocked);
            refused += 1;
            continue;
        };
        assert!(!blocked && target(&plan, &crew) == end);
        if plan.standing {
            stood += 1
        } else {
            travelled += 1
        }
        let (mut last, mut now) = (start.clone(), start);
        let slice = plan.time / 500.0;
        for step in 1..=500 {
            let motion = under_way(&plan, &crew, slice * f64::from(step), &mut now);
            for i in 0..n {
                let run = linkages[i].at_angle(now[i]).l - linkages[i].at_angle(last[i]).l;
                assert!(run.abs() <= 0.05 * slice * (1.0 + 1e-9) + 1e-12, "{run} {slice}");
                assert!(limits[i].allows_turn(last[i], now[i]));
                if let Some(motion) = motion {
                    assert!(residual(&machine.about(motion), machine.groups[i], now[i]).abs() <= 1e-12);
                }
            }
            last.copy_from_slice(&now);
        }
    }
    assert!(
        travelled > 100 && stood > 5 && refused > 20,
        "{travelled} {stood} {refused}"
    );
}

/// Where only half a turn over brings a group into its range, it rolls backwards.
#[test]
fn turned_over() {
    let machine = machine();
    let limits = vec![Limits::new(-95_f64.to_radians(), 45_f64.to_radians(), Vec::new()).expect("valid"); 8];
    let centre = Mode::Crosswise.centre(&machine, Command::None).expect("allowed");
    let (wheels, _) = common::rolled(&machine, &limits, &centre, 1.0);
    assert!(
        wheels
            .iter()
            .all(|w| w.placed && w.theta == -FRAC_PI_2 && w.turn == Point::new(0.0, -1.0) && w.v == -1.0)
    );
    let (wheels, _) = common::rolled(&machine, &ranges(8, 95.0), &centre, 1.0);
    assert!(wheels.iter().all(|w| w.placed && w.theta == FRAC_PI_2 && w.v == 1.0));
    let (wheels, _) = common::rolled(&machine, &ranges(8, 60.0), &centre, 1.0);
    assert!(wheels.iter().all(|w| !w.placed && w.theta == FRAC_PI_2));
}

/// Every formula that a book prints has consistent dimensions, and the recorder's bits are those of f64.
#[test]
#[expect(clippy::too_many_lines, reason = "one case after the other")]
fn dimensions() {
    let given = |symbol, x: f64| Rec::given(symbol, x);
    let (trace, theta) = record(|| {
        let layout = LAYOUT.map(&mut given.clone());
        let _ = (layout.angles(given(&s::R_T, 8.0)), layout.pivot());
        let machine = plain(&layout.groups());
        let mut theta = 0.0;
        for (mode, command) in [
            (Mode::Straight, Command::None),
            (Mode::Crab, Command::Angle(given(&s::THETA_B, 0.4))),
            (Mode::AllWheel, Command::Angle(given(&s::THETA_B, 0.4))),
            (Mode::RearAxle, Command::Angle(given(&s::THETA_B, -0.4))),
            (Mode::AllWheel, Command::Radius(given(&s::R_T, 20.0))),
            (Mode::FrontAxle, Command::Radius(given(&s::R_T, 1e12))),
            (
                Mode::Free,
                Command::Centre(Point::new(given(&s::O_X, 3.0), given(&s::O_Y, -20.0))),
            ),
            (
                Mode::Free,
                Command::Centre(Point::new(given(&s::O_X, 3e12), given(&s::O_Y, -20.0))),
            ),
            (Mode::Pivot, Command::None),
        ] {
            let centre = mode.centre(&machine, command).expect("allowed");
            let (wheels, _) = common::rolled(&machine, &free(8), &centre, given(&s::V_T, 0.5));
            let _ = centre.point();
            if mode == Mode::AllWheel {
                theta = wheels[4].theta.value();
            }
        }
        let cylinder = CYLINDER.map(&mut given.clone());
        let pose = cylinder.linkage(true).at_angle(given(&s::THETA, 0.3));
        cylinder.stroke_margins(pose.l, pose.l);
        let tyre = Tyre {
            f_t: 0.7,
            p_t: 0.9e6,
            k_v: 2.5,
        }
        .map(&mut given.clone());
        let moment = resistance(&tyre, given(&s::G, 900e3)).standing;
        let bearing = Bearing {
            l_max: 0.3,
            mu_r: 0.006,
            d_l: 1.0,
        }
        .map(&mut given.clone());
        let safety = Safety {
            f_s: 1.25,
            k_test: 1.25,
        }
        .map(&mut given.clone());
        let f_a = given(&s::F_A, 900e3);
        Duty::new(&bearing, &safety, f_a);
        let drag = friction(&bearing, f_a);
        let f_g = force((moment + drag).def(&s::T_G), pose.od);
        bore(f_g, given(&s::P, 25e6), given(&s::D, 0.14));
        let q = flow(
            &Piston { d_g: 0.2, d: 0.1 }.map(&mut given.clone()),
            &given(&s::V_T, -0.01),
        );
        pump(q, given(&s::N, 25.0), given(&s::ETA_V, 0.9));
        relief(given(&s::P, 25e6), given(&s::K_R, 1.1));
        buckling(
            &Rod {
                e: 210e9,
                d: 0.14,
                l_k: 2.5,
                nu: 3.5,
            }
            .map(&mut given.clone()),
        );
        let accuracy = Accuracy {
            step: 0.0015,
            dead_band: 0.001,
        };
        let _ = accuracy.map(&mut |symbol, x| given(symbol, x)).angle_error(&pose);
        theta
    });
    assert!(trace.faults.is_empty(), "{:?}", trace.faults);
    assert!(trace.steps.len() > 100, "{}", trace.steps.len());
    let machine = machine();
    let centre = Mode::AllWheel.centre(&machine, Command::Radius(20.0)).expect("allowed");
    assert_eq!(rolled(&machine, &centre, 0.5).0[4].theta.to_bits(), theta.to_bits());
}

/// A place given in centimetres is the same axle line: 26.5705 m and 2657.05 cm differ by their last bit.
#[test]
fn the_unit_of_a_place_does_not_decide_which_group_commands() {
    let (one, other) = (26.570_5, 2_657.05 * 0.01);
    assert_ne!(one, other);
    for (left, right) in [(one, other), (other, one), (one, one)] {
        let places = [(one, 10.0), (one, -10.0), (-left, 10.0), (-right, -10.0)];
        let groups = places.map(|(x, y)| Point::new(x, y));
        let machine = Machine::new(&axes(&groups), &Footprint(None)).expect("apart");
        assert_eq!(machine.rear_base, 2, "in line with the first");
    }
}

/// What is refused, in words.
#[test]
fn refusals() {
    let at = |points: &[(f64, f64)]| {
        let points: Vec<_> = points.iter().map(|&(x, y)| Point::new(x, y)).collect();
        Machine::new(&axes(&points), &Footprint(None))
            .map(|_| ())
            .expect_err("refused")
            .to_string()
    };
    let machine = machine();
    let text = |result: Result<Centre<f64>, Refusal>| result.expect_err("refused").to_string();
    let outside = |symbol, value: f64| within(symbol, value).expect_err("refused").to_string();
    let weak = CYLINDER
        .linkage(false)
        .over(&Limits::new(-1.5, 1.5, Vec::new()).expect("valid"))
        .expect_err("dead point");
    let far = reach(&machine, &ranges(8, 50.0), Mode::AllWheel, Command::Angle(1.0)).expect("a verdict");
    let found = [
        at(&[(0.0, 0.0), (1.0, 0.0), (1.0, 1.0)]),
        at(&[(0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (1.0, 0.0005)]),
        outside(&s::X, f64::NAN),
        outside(&s::G, -5e3),
        outside(&s::P_T, 0.0),
        weak.to_string(),
        choose_stroke(
            &CYLINDER,
            false,
            &Limits::new(-1.5, 1.5, Vec::new()).expect("valid"),
            &[0.5, 1.0],
        )
        .expect_err("refused")
        .to_string(),
        Mode::parse("sideways").expect_err("refused").to_string(),
        text(Mode::Pivot.centre(&machine, Command::Angle(0.1))),
        text(Mode::RearAxle.centre(
            &Machine {
                rear_base: 0,
                ..machine.clone()
            },
            Command::Angle(0.1),
        )),
        text(Mode::AllWheel.centre(&machine, Command::Centre(Point::new(1.0, 20.0)))),
        text(Mode::Crab.centre(&machine, Command::Angle(f64::NAN))),
        text(Mode::Corner.centre(&machine, Command::Corner(4))),
        text(Mode::Free.centre(&machine, Command::Centre(Point::new(f64::INFINITY, 0.0)))),
        far.refusal(&ranges(8, 50.0)).expect("out of reach").to_string(),
        next(&BORES, 0.7).expect_err("refused").to_string(),
        Limits::new(0.1, 1.0, Vec::new()).expect_err("refused").to_string(),
        Limits::new(-1.0, 1.0, vec![[0.5, 0.4]])
            .expect_err("refused")
            .to_string(),
        Limits::new(-1.0, 1.0, vec![[-0.1, 0.1]])
            .expect_err("refused")
            .to_string(),
    ];
    let golden = include_str!("steering_refusals.txt");
    assert_eq!(found.join("\n") + "\n", golden);
}
