//! The drive to scale.

use crate::component::draw::{Draw, direction, distance, polar};
use crate::component::extreme::between;
use crate::drive::crank::crank_linkage;
use crate::drive::mount::{Anchors, DriveMount, DrivenBar};
use crate::drive::scene::Driving;
use crate::drive::symbols as d;
use crate::kernel::calc::Calc;
use crate::parts::motion::Motion;
use crate::parts::plane::{self, Point};

/// The drive, where there is one, and the lug that carries its anchor beside the bar, or the sector as far as its pinion goes.
pub fn drive(draw: &mut Draw, bar: &DrivenBar<f64>, driving: &Driving, motion: &Motion) {
    let foot = bar.foot.unwrap_or_else(Point::zeros);
    let anchors = match driving.mount {
        None => return,
        Some(DriveMount::Sector(sector)) => {
            let half = (motion.to - motion.from) / 2.0;
            let rim = between(sector.delta_s - half, sector.delta_s + half).map(|at| foot + polar(sector.r_s, at));
            let points: Vec<Point<f64>> = std::iter::once(foot).chain(rim).collect();
            draw.body(&points, false);
            let pinion = foot + polar(sector.r_s, sector.delta_s);
            draw.pin(pinion, true, false);
            draw.handle(
                pinion,
                &[(&d::R_S, distance(foot)), (&d::DELTA_S, direction(foot, 0.0))],
            );
            return;
        }
        Some(DriveMount::Anchors(anchors)) => anchors,
    };
    let (sin, cos) = Calc::sin_cos(anchors.chi_d);
    let along = bar.along * (anchors.s_d * cos / bar.length);
    let arm = plane::turned(
        bar.along,
        anchors.s_d * cos / bar.length,
        anchors.s_d * sin / bar.length,
    );
    let (e, joint) = (Point::new(anchors.e_x, anchors.e_y), foot + arm);
    draw.bar(&[joint, foot + along], false);
    match crank_pin(bar, driving, &anchors, joint - foot) {
        Some(pin) => {
            draw.bar(&[e, pin], false);
            draw.bar(&[pin, joint], false);
            draw.pin(pin, false, false);
            draw.handle(pin, &[(&d::R_CR, distance(e)), (&d::L_CR, distance(joint))]);
        }
        None => {
            draw.bar(&[e, joint], false);
            draw.pull(joint, joint * 2.0 - e, &d::F_D);
        }
    }
    draw.pin(e, true, false);
    draw.pin(joint, false, false);
    draw.label(e, "E");
    draw.placed(e, [&d::E_X, &d::E_Y]);
    let bearing = Calc::direction(bar.along.x, bar.along.y);
    draw.handle(
        joint,
        &[(&d::S_D, distance(foot)), (&d::CHI_D, direction(foot, bearing))],
    );
}

/// Where crank and rod meet, with the link's arm to its anchor; `None` without a crank.
fn crank_pin(bar: &DrivenBar<f64>, driving: &Driving, a: &Anchors<f64>, arm: Point<f64>) -> Option<Point<f64>> {
    let (rod, branch) = driving.crank?;
    let linkage = crank_linkage(&rod, a, bar.foot, branch)?;
    let closed = rod.at(&linkage, Calc::direction(arm.x, arm.y))?;
    Some(Point::new(a.e_x, a.e_y) + closed.crank)
}
