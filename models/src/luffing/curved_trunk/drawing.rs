//! Boom and trunk to scale.

use crate::balance::symbols as b;
use crate::component::draw::{Draw, along, distance};
use crate::component::extreme::between;
use crate::component::sheet::Drawing;
use crate::component::telling::fine;
use crate::drive;
use crate::drive::scene::Driving;
use crate::kernel::group::One;
use crate::luffing::curved_trunk::contact::Contact;
use crate::luffing::curved_trunk::driving;
use crate::luffing::curved_trunk::leading::leads;
use crate::luffing::curved_trunk::position::TrunkPosition;
use crate::luffing::curved_trunk::stages::Given;
use crate::luffing::curved_trunk::symbols as s;
use crate::luffing::curved_trunk::tail::{Leaving, TrunkTail};
use crate::luffing::curved_trunk::velocity::TrunkTravel;
use crate::luffing::led::drawing::rope;
use crate::luffing::led::scene::LedRopeScene;
use crate::parts::motion::Motion;
use crate::parts::plane::{self, Point};

/// At the ends of the working range (faint) and where it is told of, with tail, tie and the path of the head.
pub fn drawing(given: &Given<f64>, led: &LedRopeScene, driven: &Driving, range: &Motion, told: f64) -> Drawing {
    let Given { trunk, arc, choice, .. } = given;
    let (o1, o3) = (Point::zeros(), Point::new(trunk.o3_x, trunk.o3_y));
    let tail = TrunkTail::new(trunk, arc, choice).expect("checked when the scene was read");
    let at = |phi: f64| {
        let contact = Contact::new(&tail, choice, &phi).expect("checked when the scene was read");
        (TrunkPosition::new(&tail, &contact), contact)
    };
    let (size, led) = (trunk.b, led.reeved());
    let mut draw = Draw::default();
    draw.path(fine(range).map(|phi| at(phi).0.a));
    let [clamp, end] = tail.ends.map(|end| end.place);
    for (phi, faint) in [(range.from, true), (range.to, true), (told, false)] {
        let (p, contact) = at(phi);
        let place = |local: Point<f64>| p.b + plane::turned(local, p.along.x, p.along.y);
        let curve = between(clamp, end).map(|at| place(Leaving::new(arc, choice, at).p));
        let mut outline = vec![p.b];
        outline.extend(curve);
        draw.bar(&[o1, p.b], faint);
        draw.body(&outline, faint);
        draw.bar(&[p.b, p.a], faint);
        draw.bar(&[p.t, o3], faint);
        if let Some(led) = &led {
            rope(&mut draw, led, &leads(&p, &TrunkTravel::new(&p), &phi), faint);
        }
        draw.joint(p.a, "A", false, faint);
        draw.joint(p.b, "B", false, faint);
        draw.pin(p.t, false, faint);
        if faint {
            continue;
        }
        let bar = driving::bar(&p, trunk, &One(&b::PHI, phi));
        drive::drawing::drive(&mut draw, &bar, driven, range);
        draw.label(p.t, "T");
        draw.angle(o1, 0.2 * size, phi, &b::PHI);
        draw.distance(o1, contact.b, -0.05 * size, &s::B);
        draw.distance(p.b, p.a, -0.05 * size, &s::A);
        draw.handle(p.b, &[(&s::B, distance(o1))]);
        draw.handle(p.a, &[(&s::A, distance(p.b))]);
        draw.force(o1, [&s::F_O1X, &s::F_O1Y]);
        draw.force(p.b, [&s::F_BX, &s::F_BY]);
        draw.pull(p.t, o3, &s::N_T);
        draw.centre([[o1, p.b], [o3, p.t]], size);
        draw.transmission(p.t, [p.b - p.t, o3 - p.t], 0.15 * size, &s::MU);
        draw.distance(Point::new(-trunk.x_8, 0.0), Point::new(p.a.x, 0.0), -0.1 * size, &s::R);
        if given.load.is_some() {
            draw.load(p.a, &s::Q);
        }
    }
    draw.joint(o1, "O_1", true, false);
    draw.joint(o3, "O_3", true, false);
    draw.placed(o3, [&s::O3_X, &s::O3_Y]);
    draw.handle(Point::new(-trunk.x_8, 0.0), &[(&s::X_8, along(o1, [-1.0, 0.0]))]);
    draw.axis(-trunk.x_8, -0.15 * size, 0.6 * size);
    draw.done(size)
}
