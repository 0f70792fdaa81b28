//! The greatest oil flow that a mode asks for at once.

use crate::steering::built::Built;
use crate::steering::flow::{Piston, flow};
use crate::steering::machine::Machine;
use crate::steering::mode::{Command, Mode};
use crate::steering::refusal::Refusal;
use crate::steering::stand::{obstacle, stand};
use crate::steering::travel::rate;

/// Angle of each group for one radian of the command's angle.
pub fn rates(machine: &Machine<f64>, mode: Mode, theta: f64, rates: &mut [f64]) -> Result<(), Refusal> {
    let centre = mode.centre(machine, Command::Angle(theta))?;
    let slope = mode.slope(machine, theta);
    for (p, slot) in machine.groups.iter().zip(rates.iter_mut()) {
        *slot = slope.map_or(0.0, |slope| rate(centre.rolling(*p), slope.rolling(*p)));
    }
    Ok(())
}

/// The greatest oil flow that a mode asks for at once.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Demand {
    /// In m³/s, of all cylinders together.
    pub flow: f64,
    /// Commanded angle at which it is asked for, in rad.
    pub at: f64,
    /// Whether the commanded angle grows or falls there.
    pub rising: bool,
}

/// Greatest simultaneous flow while the commanded angle moves at `omega_s`
/// (rad/s), either way, over all reachable angles on a grid of 0.25°.
pub fn greatest_demand(built: &Built, piston: &Piston<f64>, mode: Mode, omega_s: f64) -> Result<Demand, Refusal> {
    let Built {
        machine,
        limits,
        linkages,
    } = built;
    let mut slopes = vec![0.0; machine.groups.len()];
    let mut worst = Demand {
        flow: 0.0,
        at: 0.0,
        rising: true,
    };
    // Beyond a right angle the axle lines repeat.
    for step in -360..=360_i32 {
        let theta = (f64::from(step) / 4.0).to_radians();
        let centre = mode.centre(machine, Command::Angle(theta))?;
        if obstacle(machine, limits, &centre).is_some() {
            continue;
        }
        rates(machine, mode, theta, &mut slopes)?;
        let poses = linkages.iter().zip(stand(machine, limits, &centre));
        let arms: Vec<f64> = poses.map(|(linkage, theta)| linkage.at_angle(theta).od).collect();
        for rising in [true, false] {
            let sense = if rising { omega_s } else { -omega_s };
            let flows = arms
                .iter()
                .zip(&slopes)
                .map(|(od, slope)| flow(piston, &(od * slope * sense)));
            let sum = flows.map(f64::abs).sum();
            if sum > worst.flow {
                worst = Demand {
                    flow: sum,
                    at: theta,
                    rising,
                };
            }
        }
    }
    Ok(worst)
}
