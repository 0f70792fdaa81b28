//! The motion that all levels make. Where the scene's deepest level has a
//! command of its own (`M_A`, `u_v`), it is that; otherwise a luffing cycle: out
//! through the working range at its speed, a rest, and back.
//!
//! Where the angle is an input it follows the plan exactly. Where it is a state
//! the drive has a controller, sampled at the communication steps, the same at
//! all settings of a level: a moment that would move the crane so, or a valve
//! that would let as much oil through, each with what corrects the angle.
//! A hoist rests meanwhile: it would lift for as long as the cycle lasts.

use std::any::Any;

use lemnis_models::component::model::Model;
use lemnis_models::component::moving::MovingComponent;
use lemnis_models::kernel::number::short;
use lemnis_models::kernel::variable::{Fault, PART_OF_RANGE, Quantity, Role, Variable};
use lemnis_models::parts::motion::Motion;
use lemnis_models::scene::Scene;

use crate::setting::index;

/// Part of the range that the cycle keeps away from its ends, so that it meets no end stop on the way.
const MARGIN: f64 = 0.05;
/// Parts of the way's duration to start and to stop in, and to rest at each end.
const RAMP: f64 = 0.2;
const REST: f64 = 0.1;
/// Correction of the angle by the moment, as a frequency in rad/s with critical damping.
const MOMENT_LOOP: f64 = 2.0;
/// Correction of the cylinder's length by the valve, in 1/s.
const VALVE_LOOP: f64 = 1.0;

/// Most communication steps of a motion.
const MOST_SAMPLES: f64 = 1e6;
/// Most evaluations of the rates in one run by a model's own solver: more take minutes.
const MOST_RATES: u32 = 50_000_000;

/// Where the driven bar should be, in rad, rad/s and rad/s².
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Wanted {
    pub angle: f64,
    pub rate: f64,
    pub acceleration: f64,
}

/// A motion of a scene, sampled.
#[derive(Clone, Debug)]
pub struct Experiment {
    /// Communication step, in s.
    pub sample: f64,
    /// Number of communication steps.
    pub samples: u32,
    /// The input that commands the deepest level, where the scene gives it.
    own: Option<&'static str>,
    plan: Vec<Wanted>,
}

/// Inputs that drive a level, by their ids.
const COMMANDS: [&str; 2] = ["M_A", "u_v"];
/// That of a hoist.
const HOIST: &str = "v_h";
/// That of what slews alone, which follows no plan: the scene's own moment turns it. Anything else follows what its scene tells
/// over time.
const SLEWING: &str = "M_sl";

/// What was seen at the communication points.
#[derive(Clone, Debug, Default)]
pub struct Seen {
    /// One series for each result asked for; empty where the level has none.
    pub series: Vec<Vec<f64>>,
    /// What the drive was told at each communication step: inputs and values.
    pub commands: Vec<[(usize, f64); 2]>,
}

/// Moves a model from one time to another, both in s.
pub type Solve<'a> = dyn FnMut(&mut Model, f64, f64) -> Result<(), Fault> + 'a;

impl Experiment {
    /// The scene's motion with communication steps of `sample` s.
    ///
    /// # Errors
    /// As [`Scene::model`], and a motion that takes too long.
    pub fn new(scene: &Scene, sample: f64) -> Result<Experiment, Fault> {
        let mut model = scene.model()?;
        let mut own = None;
        for id in COMMANDS {
            if let Some(index) = index(&model, id) {
                let told = model.variables()[index].role == Role::Output;
                own = own.or((told || model.get(index)? != 0.0).then_some(id));
            }
        }
        let driven = COMMANDS.iter().any(|id| index(&model, id).is_some());
        if !driven {
            own = index(&model, SLEWING).map(|_| SLEWING).or_else(|| told(&model));
        }
        let cycle = Cycle::new(scene.mechanism.motion());
        let duration = if own.is_some() {
            model.stop_time()
        } else {
            cycle.duration()
        };
        let samples = (duration / sample).ceil().max(1.0);
        if samples > MOST_SAMPLES {
            return Err(Fault::new(format!(
                "the motion lasts {} s, which takes {} communication steps of {} s, and at most {} are run: raise its \
                 speed, or take longer steps",
                short(duration),
                short(samples),
                short(sample),
                short(MOST_SAMPLES)
            )));
        }
        let samples = samples as u32;
        Ok(Experiment {
            sample,
            samples,
            own,
            plan: (0..=samples).map(|i| cycle.at(f64::from(i) * sample)).collect(),
        })
    }

    /// The input by which the scene itself moves its deepest level.
    #[must_use]
    pub fn own_command(&self) -> Option<&'static str> {
        self.own
    }

    /// Simulated time, in s.
    #[must_use]
    pub fn duration(&self) -> f64 {
        self.sample * f64::from(self.samples)
    }

    /// With a solution of the deepest level as what the others follow: angles and rates of the driven bar.
    pub fn follow(&mut self, angles: &[f64], rates: &[f64]) {
        if self.own.is_none() {
            return;
        }
        let next = |i: usize| rates.get(i + 1).or(rates.last()).copied().unwrap_or(0.0);
        self.plan = (angles.iter().zip(rates).enumerate())
            .map(|(i, (&angle, &rate))| Wanted {
                angle,
                rate,
                acceleration: (next(i) - rate) / self.sample,
            })
            .collect();
    }

    /// Runs a model through the motion and looks at results by their names.
    ///
    /// # Errors
    /// What the model or the solver refuses.
    pub fn run(
        &self,
        scene: &Scene,
        model: &mut Model,
        names: &[String],
        solve: &mut Solve<'_>,
    ) -> Result<Seen, Fault> {
        let mut drive = Controller::new(self, scene, model)?;
        self.begin(model)?;
        let indices: Vec<Option<usize>> = names.iter().map(|name| index(model, name)).collect();
        let mut seen = Seen {
            series: vec![Vec::new(); names.len()],
            commands: Vec::new(),
        };
        let mut look = |model: &mut Model| -> Result<(), Fault> {
            for (series, index) in seen.series.iter_mut().zip(&indices) {
                if let Some(index) = index {
                    series.push(model.get(*index)?);
                }
            }
            Ok(())
        };
        if model.states() == 0 {
            // An angle that is an input is where it should be.
            for i in 0..=self.samples {
                let command = drive.command(model, self.plan[i as usize], self.sample)?;
                tell(model, command)?;
                let now = f64::from(i) * self.sample;
                solve(model, now, now)?;
                look(model)?;
                seen.commands.push(command);
            }
            return Ok(seen);
        }
        look(model)?;
        for i in 0..self.samples {
            let command = drive.command(model, self.plan[i as usize], self.sample)?;
            tell(model, command)?;
            let now = f64::from(i) * self.sample;
            solve(model, now, now + self.sample)?;
            if model.count().rates > MOST_RATES {
                return Err(Fault::outside(format!(
                    "the motion of {} s takes more than {MOST_RATES} evaluations of its rates, the first {} s of it: \
                     shorten it or raise its speed",
                    short(self.duration()),
                    short(now + self.sample)
                )));
            }
            look(model)?;
            seen.commands.push(command);
        }
        Ok(seen)
    }

    /// What rests while the crane luffs by a plan is told so.
    ///
    /// # Errors
    /// A model that cannot be told.
    pub fn begin(&self, model: &mut Model) -> Result<(), Fault> {
        let hoist = index(model, HOIST).filter(|_| self.own.is_none());
        hoist.map_or(Ok(()), |hoist| tell(model, [(hoist, 0.0); 2]))
    }

    /// The same motion again from what the drive was told, as an importer would make it: for the clock.
    ///
    /// # Errors
    /// As [`run`](Experiment::run).
    pub fn replay(&self, model: &mut Model, names: &[String], commands: &[[(usize, f64); 2]]) -> Result<f64, Fault> {
        let indices: Vec<usize> = names.iter().filter_map(|name| index(model, name)).collect();
        let mut sum = 0.0;
        self.begin(model)?;
        for (i, command) in commands.iter().enumerate() {
            self.step(model, *command, i as f64 * self.sample)?;
            for index in &indices {
                sum += model.get(*index)?;
            }
        }
        Ok(sum)
    }

    /// One communication step from a time (s) under what the drive is told.
    ///
    /// # Errors
    /// As [`run`](Experiment::run).
    pub fn step(&self, model: &mut Model, command: [(usize, f64); 2], from: f64) -> Result<(), Fault> {
        tell(model, command)?;
        model.advance(from, from + self.sample)
    }
}

/// The first of the commands that the scene tells over time.
fn told(model: &Model) -> Option<&'static str> {
    let Model::Moving(moving) = model else { return None };
    let moving = (&**moving as &dyn Any).downcast_ref::<MovingComponent>()?;
    moving.told().first().map(|(_, (id, _))| *id)
}

fn tell(model: &mut Model, command: [(usize, f64); 2]) -> Result<(), Fault> {
    for (index, value) in command {
        // What the scene tells over time it tells itself.
        if model.variables()[index].role == Role::Input {
            model.set(index, value)?;
        }
    }
    Ok(())
}

/// Out, rest, back, rest.
struct Cycle {
    from: f64,
    way: f64,
    speed: f64,
    margin: f64,
}

impl Cycle {
    fn new(motion: &Motion) -> Cycle {
        let range = motion.to - motion.from;
        Cycle {
            from: motion.from,
            way: range * (1.0 - MARGIN),
            speed: motion.speed,
            margin: range * MARGIN,
        }
    }

    /// Duration of one way, in s.
    fn move_time(way: f64, speed: f64) -> f64 {
        way / speed * (1.0 + RAMP)
    }

    fn duration(&self) -> f64 {
        let out = Cycle::move_time(self.way, self.speed);
        let back = Cycle::move_time(self.way - self.margin, self.speed);
        out + back + 2.0 * REST * out
    }

    fn at(&self, time: f64) -> Wanted {
        let out = Cycle::move_time(self.way, self.speed);
        let back = Cycle::move_time(self.way - self.margin, self.speed);
        let rest = REST * out;
        let turn = out + rest;
        if time < turn {
            let mut wanted = rise(self.way, self.speed, time);
            wanted.angle += self.from;
            return wanted;
        }
        let down = rise(self.way - self.margin, self.speed, (time - turn).min(back));
        Wanted {
            angle: self.from + self.way - down.angle,
            rate: -down.rate,
            acceleration: -down.acceleration,
        }
    }
}

/// From rest to rest over a way (rad) at most at a speed (rad/s): the rate rises and falls along cubic ramps.
fn rise(way: f64, speed: f64, time: f64) -> Wanted {
    let ramp = RAMP * way / speed;
    let whole = Cycle::move_time(way, speed);
    // On a ramp, a part x of it: rate 3x² − 2x³ of the speed.
    let on = |x: f64| {
        let x = x.clamp(0.0, 1.0);
        [
            ramp * (x * x * x - x * x * x * x / 2.0),
            x * x * (3.0 - 2.0 * x),
            6.0 * x * (1.0 - x) / ramp,
        ]
    };
    if time >= whole {
        return Wanted {
            angle: way,
            ..Wanted::default()
        };
    }
    if time <= whole / 2.0 {
        let [gone, rate, acceleration] = on(time / ramp);
        let steady = (time - ramp).max(0.0);
        return Wanted {
            angle: speed * (gone + steady),
            rate: speed * rate,
            acceleration: speed * acceleration,
        };
    }
    let mirrored = rise(way, speed, whole - time);
    Wanted {
        angle: way - mirrored.angle,
        rate: mirrored.rate,
        acceleration: -mirrored.acceleration,
    }
}

/// What a level's inputs are told.
enum Controller {
    /// Angle, or the part of this range at which it is, and angular velocity, which are inputs.
    Input([usize; 2], Option<Motion>),
    /// Nothing: the scene's command stands.
    Own(usize, f64),
    Moment {
        input: usize,
        /// The mechanism at rest where it is, and the moment that holds it there.
        still: Box<Model>,
        holding: usize,
        viscous: f64,
        dry: f64,
    },
    Valve {
        input: usize,
        length: usize,
        /// The mechanism where it should be, and its length and speed there.
        shadow: Box<Model>,
        planned: [usize; 2],
        /// Speed of the cylinder with the valve fully open, in m/s.
        open: f64,
    },
}

impl Controller {
    fn new(experiment: &Experiment, scene: &Scene, model: &mut Model) -> Result<Controller, Fault> {
        let known = |model: &Model, id: &str| {
            index(model, id).ok_or_else(|| {
                Fault::new(format!(
                    "the drive's controller needs {id}, which the scene does not give"
                ))
            })
        };
        // A steering is commanded alike at every level.
        let coordinate = scene.at("static").model()?.variables()[..2].to_vec();
        let input = |wanted: Quantity| {
            let same = |v: &Variable| v.quantity() == wanted && v.role == Role::Input;
            model.variables().iter().position(same)
        };
        let [angle, rate] = [0, 1].map(|i| input(coordinate[i].quantity()));
        if let (Some(angle), Some(rate)) = (angle, rate) {
            return Ok(Controller::Input([angle, rate], None));
        }
        if let (Some(part), Some(rate)) = (input((&PART_OF_RANGE, None)), rate) {
            return Ok(Controller::Input([part, rate], Some(*scene.mechanism.motion())));
        }
        if let Some(input) = experiment.own.and_then(|id| index(model, id)) {
            return Ok(Controller::Own(input, model.get(input)?));
        }
        let value = |model: &mut Model, id: &str| known(model, id).and_then(|index| model.get(index));
        let input = model
            .variables()
            .iter()
            .position(|v| v.role == Role::Input && COMMANDS.contains(&v.symbol.id));
        let Some(input) = input else {
            return Err(Fault::new("no input drives this level"));
        };
        if model.variables()[input].symbol.id == COMMANDS[0] {
            let (viscous, dry) = (value(model, "c_v")?, value(model, "M_F")?);
            let still = scene.at("static").model()?;
            return Ok(Controller::Moment {
                input,
                holding: known(&still, "M_D")?,
                still: Box::new(still),
                viscous,
                dry,
            });
        }
        let (bore, rated, drop, supply) = (
            value(model, "D_c")?,
            value(model, "Q_N")?,
            value(model, "dp_N")?,
            value(model, "p_P")?,
        );
        let area = std::f64::consts::FRAC_PI_4 * bore * bore;
        let shadow = scene.at("static").model()?;
        Ok(Controller::Valve {
            input,
            length: known(model, "L_d")?,
            planned: [known(&shadow, "L_d")?, known(&shadow, "v_d")?],
            shadow: Box::new(shadow),
            open: rated / area * (0.5 * supply / drop).sqrt(),
        })
    }

    /// Inputs and their values for the next communication step.
    fn command(&mut self, model: &mut Model, wanted: Wanted, sample: f64) -> Result<[(usize, f64); 2], Fault> {
        let single = |input: usize, value: f64| [(input, value); 2];
        match self {
            Controller::Input([angle, rate], range) => {
                let at = range.map_or(wanted.angle, |range| range.part(wanted.angle));
                Ok([(*angle, at), (*rate, wanted.rate)])
            }
            Controller::Own(input, value) => Ok(single(*input, *value)),
            Controller::Moment {
                input,
                still,
                holding,
                viscous,
                dry,
            } => {
                let (angle, rate) = (model.get(0)?, model.get(1)?);
                let inertia = model.inertia()?;
                let correction =
                    2.0 * MOMENT_LOOP * (wanted.rate - rate) + MOMENT_LOOP * MOMENT_LOOP * (wanted.angle - angle);
                // Friction is overcome where the bar is to move.
                let way = if wanted.rate == 0.0 { 0.0 } else { wanted.rate.signum() };
                still.set(0, angle)?;
                still.update()?;
                let moment = still.get(*holding)?
                    + inertia * (wanted.acceleration + correction)
                    + *viscous * wanted.rate
                    + *dry * way;
                Ok(single(*input, moment))
            }
            Controller::Valve {
                input,
                length,
                shadow,
                planned,
                open,
            } => {
                shadow.set(0, wanted.angle + 0.5 * sample * wanted.rate)?;
                shadow.set(1, wanted.rate)?;
                shadow.update()?;
                let [at, speed] = [shadow.get(planned[0])?, shadow.get(planned[1])?];
                let opening = (speed + VALVE_LOOP * (at - model.get(*length)?)) / *open;
                Ok(single(*input, opening.clamp(-1.0, 1.0)))
            }
        }
    }
}
