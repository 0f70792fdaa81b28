//! What gives and takes power in a crane in motion.

use crate::luffing::moving::crane::{Commands, CraneState, MovingCrane, Snapshot, Struck};
use crate::luffing::moving::dynamics::Coordinate;
use crate::luffing::moving::hydraulic::{FIXED, Hydraulic, Modes};

/// Powers at one instant, in W; losses are positive.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Powers {
    /// Of the drives of luffing and slewing, of the hoist, and of the pump.
    pub drive: f64,
    pub slewing: f64,
    pub hoist: f64,
    pub pump: f64,
    /// What friction, brakes and end stops take.
    pub friction: f64,
    /// What edges, lines, relief valves and leakage take.
    pub throttles: f64,
    /// What compresses the oil.
    pub compression: f64,
    /// What the air takes from the load, and the wind gives the bodies and all that slews.
    pub air: f64,
    pub wind: f64,
    /// Of the centrifugal forces of a crane that is slewed.
    pub slewed: f64,
}

/// Powers of a crane without oil, and the energy of all bodies (J); `None` where the linkage does not close.
pub(super) fn powers_of<const N: usize, const J: usize>(
    crane: &MovingCrane<N, J>,
    state: &CraneState<N, J>,
    commands: &Commands<J>,
) -> Option<(Powers, f64)>
where
    MovingCrane<N, J>: Struck<N, J>,
{
    let (y, hoist) = (&state.y, crane.hoist_powers(state, commands)?);
    let r = &crane.reduced(state, y[0])?;
    let at = &Snapshot { state, r, y, commands };
    let [given, braked] = crane.drum_powers(at);
    let (mut drives, mut friction) = ([given, 0.0], braked);
    for (i, drive) in commands.drives.iter().enumerate() {
        let rate = y[2 * i + 1];
        if i > 0 {
            drives[i] = drive.moment * rate;
        }
        friction += -crane.friction_moment(i, state, commands, y)? * rate;
    }
    let aside = MovingCrane::<N, J>::slewed(y).and_then(|psi| crane.dynamics.pushed_aside(psi));
    let aside = aside.map_or(0.0, |moment| moment * y[3]);
    let [wind, _, centrifugal] = r.outside.unwrap_or_default();
    let powers = Powers {
        drive: drives[0],
        slewing: drives[1],
        hoist: hoist.given,
        air: crane.in_air(at)[1],
        wind: wind * y[1] + aside,
        slewed: centrifugal * y[1],
        friction: friction + hoist.lost,
        ..Powers::default()
    };
    Some((powers, crane.energy(state)?))
}

/// The same of one with oil.
pub(super) fn oil_powers<const N: usize>(system: &Hydraulic<N>, modes: Modes, y: &[f64; N]) -> Option<(Powers, f64)> {
    let r = f64::reduced(system.dynamics(), y[0])?;
    let [_, arm] = r.drive;
    let oil = Hydraulic::<N>::oil(y);
    let [pump, throttles, compression] = system.cylinder.powers(&oil, arm * y[1], system.supply);
    // A crane that slews does so by the state behind its angle.
    let turning = match system.dynamics().turntable() {
        Some(_) => y[FIXED + 1],
        None => 0.0,
    };
    let aside = match system.dynamics().turntable() {
        Some(_) => system.dynamics().pushed_aside(y[FIXED]).unwrap_or(0.0),
        None => 0.0,
    };
    let hoist = system.hoist_powers(modes, y)?;
    let [wind, _, centrifugal] = r.outside.unwrap_or_default();
    let powers = Powers {
        slewing: system.slewing.moment * turning,
        hoist: hoist.given,
        pump,
        throttles,
        compression,
        air: system.in_air(modes, y)?[1],
        wind: wind * y[1] + aside * turning,
        slewed: centrifugal * y[1],
        friction: -system.reaction(y[0], y[1]) * y[1] - system.slewing_friction(modes, y)? * turning + hoist.lost,
        ..Powers::default()
    };
    Some((powers, system.energy(modes, y)?))
}
