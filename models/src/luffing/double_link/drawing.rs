//! The mechanism to scale.

use crate::component::draw::{Draw, along, distance};
use crate::component::sheet::Drawing;
use crate::component::telling::fine;
use crate::drive::drawing::drive;
use crate::kernel::calc::Calc;
use crate::kernel::group::One;
use crate::luffing::double_link::driving;
use crate::luffing::double_link::geometry::Geometry;
use crate::luffing::double_link::leading::leads;
use crate::luffing::double_link::parameters::Driven;
use crate::luffing::double_link::position::Position;
use crate::luffing::double_link::scene::Luffing;
use crate::luffing::double_link::symbols as s;
use crate::luffing::double_link::velocity::Velocity;
use crate::luffing::led::drawing::rope;
use crate::parts::plane::Point;

/// At the ends of the working range (faint) and where it is told of, with the path of the head.
#[must_use]
pub fn drawing(g: &Geometry<f64>, luffing: &Luffing, told: f64) -> Drawing {
    if luffing.is_plain() {
        return boom(g, luffing, told);
    }
    let (motion, led) = (&luffing.motion, luffing.led.reeved());
    let mut draw = Draw::default();
    draw.path(fine(motion).filter_map(|theta| Position::new(g, theta)).map(|p| p.a));
    let (o1, o3, axis) = (Point::zeros(), g.lengths.o3(), Point::new(-g.lengths.x_8, 0.0));
    for (theta, faint) in [(motion.from, true), (motion.to, true), (told, false)] {
        let Some(p) = Position::new(g, theta) else { continue };
        draw.bar(&[o1, p.b], faint);
        draw.bar(&[o3, p.c], faint);
        draw.body(&[p.c, p.b, p.a], faint);
        if let Some(led) = &led {
            rope(&mut draw, led, &leads(g, &p, &Velocity::new(&p)), faint);
        }
        for joint in [p.b, p.c, p.a] {
            draw.pin(joint, false, faint);
        }
        if faint {
            continue;
        }
        let bar = driving::bar(&p, &g.lengths, &One(g.driven.coordinate(), theta));
        drive(&mut draw, &bar, &luffing.driving, motion);
        draw.label(p.a, "A");
        draw.label(p.b, "B");
        draw.label(p.c, "C");
        draw.angle(o1, 4.0, Calc::direction(p.x_1.x, p.x_1.y), &s::THETA_1);
        draw.angle(o3, 3.0, Calc::direction(p.x_3.x, p.x_3.y), &s::THETA_3);
        draw.distance(axis, Point::new(p.a.x, 0.0), -5.9, &s::R);
        draw.distance(o1, p.b, -2.0, &s::X_1);
        draw.distance(p.c, p.b, 1.3, &s::X_2);
        draw.distance(o3, p.c, -2.0, &s::X_3);
        draw.distance(p.b, p.a, -1.3, &s::X_4);
        draw.handle(p.b, &[(&s::X_1, distance(o1))]);
        draw.handle(p.c, &[(&s::X_2, distance(p.b)), (&s::X_3, distance(o3))]);
        draw.handle(p.a, &[(&s::X_4, distance(p.b))]);
        draw.force(o1, [&s::F_O1X, &s::F_O1Y]);
        draw.force(o3, [&s::F_O3X, &s::F_O3Y]);
        draw.force(p.b, [&s::F_BX, &s::F_BY]);
        draw.force(p.c, [&s::F_CX, &s::F_CY]);
        draw.centre([[o1, p.b], [o3, p.c]], g.lengths.x_1);
        let (joint, link, foot, length) = match g.driven {
            Driven::Boom => (p.c, p.x_3, o1, g.lengths.x_1),
            Driven::Rocker => (p.b, p.x_1, o3, g.lengths.x_3),
        };
        draw.transmission(joint, [p.x_2, link], 0.15 * g.lengths.x_1, &s::MU);
        if !g.linkage.turns_fully() {
            let arcs = g.linkage.arcs();
            draw.dead_points(foot, length, arcs.iter().flat_map(|arc| [arc.from, arc.to]));
        }
        if luffing.q.is_some() {
            draw.load(p.a, &s::Q);
        }
    }
    draw.pin(o1, true, false);
    draw.pin(o3, true, false);
    draw.label(o1, "O_1");
    draw.label(o3, "O_3");
    draw.axis(-g.lengths.x_8, -5.0, 8.0);
    let below = Point::new(o3.x, 0.0);
    draw.distance(below, o1, -2.3, &s::X_5);
    draw.distance(below, o3, 2.6, &s::X_6);
    draw.distance(axis, o1, -4.1, &s::X_8);
    draw.handle(
        o3,
        &[(&s::X_5, along(o1, [-1.0, 0.0])), (&s::X_6, along(o1, [0.0, 1.0]))],
    );
    draw.handle(axis, &[(&s::X_8, along(o1, [-1.0, 0.0]))]);
    draw.done(g.lengths.x_1 + g.lengths.x_4)
}

/// A plain boom.
fn boom(g: &Geometry<f64>, luffing: &Luffing, told: f64) -> Drawing {
    let motion = &luffing.motion;
    let mut draw = Draw::default();
    let o1 = Point::zeros();
    for (theta, faint) in [(motion.from, true), (motion.to, true), (told, false)] {
        let Some(p) = Position::new(g, theta) else { continue };
        draw.bar(&[o1, p.b], faint);
        draw.pin(p.b, false, faint);
        if !faint {
            let bar = driving::bar(&p, &g.lengths, &One(g.driven.coordinate(), theta));
            drive(&mut draw, &bar, &luffing.driving, motion);
            draw.label(p.b, "B");
            draw.angle(o1, 4.0, theta, &s::THETA_1);
            draw.distance(o1, p.b, -2.0, &s::X_1);
            draw.handle(p.b, &[(&s::X_1, distance(o1))]);
            draw.force(o1, [&s::F_O1X, &s::F_O1Y]);
        }
    }
    draw.joint(o1, "O_1", true, false);
    draw.done(g.lengths.x_1)
}
