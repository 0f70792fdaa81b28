//! What happens to a crane in motion, seen from sample to sample.

use crate::luffing::moving::hydraulic::{FIXED, Modes};
use crate::luffing::moving::level::CraneAt;
use crate::luffing::moving::scene::Moving;
use crate::parts::joint::Bar;
use crate::parts::motion::Motion;

/// What changes at an event.
#[derive(Clone, PartialEq)]
pub(super) struct Watch {
    /// Luffing, slewing and the hoist's drum; `None` where there is none of them, or none that sticks.
    pub joints: [Option<Bar>; 3],
    /// At the lower and the upper stop, and beyond it after the next sample if it went on like this.
    pub stops: [[bool; 2]; 3],
    ahead: [[bool; 2]; 3],
    taut: bool,
    grounded: bool,
    /// A rope that drives luffing pulls.
    pulls: bool,
    relief: [bool; 2],
    drawn: [bool; 2],
}

impl Watch {
    /// With the time between two samples, in s.
    pub(super) fn new(range: &Motion, moving: &Moving, present: &CraneAt, sample: f64) -> Watch {
        let y = present.y;
        let opening = moving.oil.map_or(f64::INFINITY, |oil| oil.p_r);
        let suction = moving
            .oil_parts
            .and_then(|parts| Some((parts.anti_cavitation?, parts.tank)));
        let at = |x: f64, [low, high]: [f64; 2]| [x <= low, x >= high];
        let ends = [range.from, range.to];
        let (oil, own) = (moving.oil.is_some(), if moving.oil.is_some() { FIXED } else { 2 });
        let turning = moving.slewing.map(|_| [y[own], y[own + 1]]);
        let free = [f64::NEG_INFINITY, f64::INFINITY];
        let turns = moving.slewing.map_or(free, |turn| turn.joint.stops);
        let meets = |[x, rate]: [f64; 2], ends| [at(x, ends), at(x + rate * sample, ends)];
        let luffing = meets([y[0], y[1]], ends);
        let slewing = turning.map_or([[false; 2]; 2], |turning| meets(turning, turns));
        let Modes {
            joints,
            drum,
            taut,
            grounded,
            slack,
            unwound,
            ..
        } = present.past;
        Watch {
            joints: [
                (!oil).then_some(joints[0]),
                turning.map(|_| joints[1]),
                moving.has_motor().then_some(drum.way),
            ],
            stops: [luffing[0], slewing[0], [false; 2]],
            ahead: [luffing[1], slewing[1], [false; 2]],
            taut,
            grounded,
            pulls: slack.is_none() && unwound.is_none(),
            relief: if oil {
                [y[2] > opening, y[3] > opening]
            } else {
                [false; 2]
            },
            drawn: suction.map_or([false; 2], |(valves, tank)| {
                let chambers = tank.map_or([y[4], y[5]], |tank| tank.above([y[4], y[5]]));
                chambers.map(|chamber| valves.margin(chamber) < 0.0)
            }),
        }
    }

    /// What has happened since.
    pub(super) fn since(&self, before: &Watch) -> Vec<&'static str> {
        let mut found = Vec::new();
        let names = [
            ["luffing_starts", "luffing_rests", "luffing_low", "luffing_high"],
            ["slewing_starts", "slewing_rests", "slewing_low", "slewing_high"],
            // A drum has no stops.
            ["hoist_starts", "hoist_rests", "", ""],
        ];
        for (i, [starts, rests, low, high]) in names.into_iter().enumerate() {
            // What turns round on the way to a stop has met it.
            let turned = matches!(
                (before.joints[i], self.joints[i]),
                (Some(Bar::Forward), Some(Bar::Backward)) | (Some(Bar::Backward), Some(Bar::Forward))
            );
            let met = [0, 1].map(|end| {
                let there = self.stops[i][end] || turned && before.ahead[i][end];
                there && !before.stops[i][end]
            });
            let stopped = match met {
                [true, _] => Some(low),
                [_, true] => Some(high),
                _ => None,
            };
            match (before.joints[i], self.joints[i]) {
                (Some(Bar::Held), Some(Bar::Forward | Bar::Backward)) => found.push(starts),
                (Some(Bar::Forward | Bar::Backward), Some(Bar::Held)) => found.push(stopped.unwrap_or(rests)),
                (None, None) => found.extend(stopped),
                _ if turned => found.extend(stopped),
                _ => {}
            }
        }
        let switches = [
            (before.taut, self.taut, "rope_taut", "rope_slack"),
            (before.grounded, self.grounded, "load_down", "load_lifted"),
            (before.pulls, self.pulls, "tackle_taut", "tackle_slack"),
            (before.relief[0], self.relief[0], "relief_1_opens", "relief_1_closes"),
            (before.relief[1], self.relief[1], "relief_2_opens", "relief_2_closes"),
            (before.drawn[0], self.drawn[0], "suction_A_opens", "suction_A_closes"),
            (before.drawn[1], self.drawn[1], "suction_B_opens", "suction_B_closes"),
        ];
        for (before, now, on, off) in switches {
            if before != now {
                found.push(if now { on } else { off });
            }
        }
        found
    }
}
