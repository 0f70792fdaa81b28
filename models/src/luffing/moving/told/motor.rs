//! A drive with a brake, told what to do so that a joint, or the hoist's drum, follows a speed.

use crate::component::moving::MovingComponent;
use crate::component::running::Running;
use crate::kernel::symbol::Symbol;
use crate::kernel::variable::Fault;
use crate::parts::joint::JointDrive;

/// By how much more than what holds it a drive sets a joint going.
const BREAKAWAY: f64 = 1e-6;

/// A drive whose moment is found from the rate that it is to reach, with a brake.
#[derive(Clone, Copy)]
pub(super) struct JointMotor {
    /// Inputs of drive and brake.
    pub inputs: [usize; 2],
    pub rate: usize,
    pub acceleration: usize,
    /// Fall below zero where it breaks loose backwards and forwards.
    pub margins: [usize; 2],
    /// Least, greatest moment of the drive, and that of the brake, in N·m.
    pub least: f64,
    pub most: f64,
    pub braking: f64,
    /// 1 where a positive moment turns it forwards, −1 where backwards.
    pub sense: f64,
    /// Which way the scene's own moment turns it.
    pub way: f64,
}

/// A brake's moment: where the scene has none, as much as the drive gives, in N·m.
pub(super) fn braking(JointDrive { moment, brake }: JointDrive) -> f64 {
    if brake > 0.0 { brake } else { moment.abs() }
}

pub(super) fn place(model: &dyn Running, symbol: &Symbol) -> Option<usize> {
    model.variables().iter().position(|variable| variable.symbol == symbol)
}

/// By how much more moment a joint that is held comes to the middle of what holds it (way zero), or just beyond that; its
/// margins against breaking loose backwards and forwards. Where an end stop holds it no moment goes beyond.
fn beyond([back, forth]: [f64; 2], way: f64) -> f64 {
    match [back, forth].map(|margin| margin == f64::MAX) {
        [false, false] => 0.5 * (forth - back) + way * (0.5 + BREAKAWAY) * (forth + back),
        [true, false] if way > 0.0 => (1.0 + BREAKAWAY) * forth,
        [false, true] if way < 0.0 => -(1.0 + BREAKAWAY) * back,
        _ => 0.0,
    }
}

impl JointMotor {
    pub(super) fn new(
        model: &MovingComponent,
        symbols: [&Symbol; 6],
        drive: JointDrive,
        sense: f64,
    ) -> Option<JointMotor> {
        let [input, brake, rate, acceleration, back, forth] = symbols.map(|symbol| place(model, symbol));
        let moment = drive.moment;
        let most = if moment == 0.0 { f64::INFINITY } else { moment.abs() };
        Some(JointMotor {
            inputs: [input?, brake?],
            rate: rate?,
            acceleration: acceleration?,
            margins: [back?, forth?],
            least: -most,
            most,
            braking: braking(drive),
            sense,
            way: moment.signum(),
        })
    }

    /// The moment (N·m) with which the joint has a rate (rad/s) after a time (s); of one that is braked, what holds it at
    /// rest.
    fn moment(&self, model: &mut MovingComponent, wanted: f64, time: f64, braked: bool) -> Result<f64, Fault> {
        let [input, _] = self.inputs;
        let (now, acceleration) = (model.get(input)?, model.get(self.acceleration)?);
        let unit = if self.most.is_finite() { self.most } else { 1e3 };
        model.set(input, now + unit)?;
        let slope = (model.get(self.acceleration)? - acceleration) / unit;
        model.set(input, now)?;
        let moment = if slope == 0.0 {
            let [back, forth] = [model.get(self.margins[0])?, model.get(self.margins[1])?];
            let way = if wanted == 0.0 {
                0.0
            } else {
                self.sense * wanted.signum()
            };
            now + beyond([back, forth], way)
        } else if braked {
            now
        } else {
            now + ((wanted - model.get(self.rate)?) / time - acceleration) / slope
        };
        Ok(moment.clamp(self.least, self.most))
    }

    /// Brakes a joint whose rates (rad/s) at the start and the end of a time (s) are zero, and drives it to the latter.
    pub(super) fn follow(&self, model: &mut MovingComponent, rates: [f64; 2], time: f64) -> Result<[f64; 2], Fault> {
        let braked = rates == [0.0; 2] && self.braking > 0.0;
        let brake = if braked { self.braking } else { 0.0 };
        model.set(self.inputs[1], brake)?;
        Ok([self.moment(model, rates[1], time, braked)?, brake])
    }
}
