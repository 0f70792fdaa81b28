//! What a sheet says of a mechanism in motion.

use crate::component::sheet::{Curve, Section, Summary};
use crate::kernel::symbol::Symbol;

/// The mechanism in motion: manoeuvres, what they ask of its parts, and its equations at one instant of them.
pub struct InMotion {
    /// Time from the start of a manoeuvre.
    pub time: &'static Symbol,
    /// What moves the mechanism.
    pub coordinate: &'static Symbol,
    /// The time in which drives come up to their speed, in s, where they have one.
    pub ramp: Option<(&'static Symbol, f64)>,
    /// Ids of the sentences that say how the commands of manoeuvres are chosen.
    pub rules: Vec<&'static str>,
    /// At which instant the formulas are worked out: ids of what makes it one and of the manoeuvre, and when it is, in s.
    pub instant: (&'static str, &'static str, f64),
    /// Which of several bodies the formulas speak of, numbered from 1.
    pub of: Option<usize>,
    /// States and commands at that instant.
    pub state: Vec<(&'static Symbol, f64)>,
    pub sections: Vec<Section>,
    pub manoeuvres: Vec<Manoeuvre>,
    pub envelope: Vec<Envelope>,
    /// What amounts of the energy are sums of over the time of a manoeuvre.
    pub integrals: Vec<Integral>,
}

/// An amount of energy: the integral of powers over time.
pub struct Integral {
    pub symbol: &'static Symbol,
    pub of: Vec<Power>,
}

/// A product, over another quantity or not.
pub struct Power {
    pub negative: bool,
    pub factors: Vec<&'static Symbol>,
    pub over: Option<&'static Symbol>,
}

/// A named sequence of commands, and a run of the model under it.
pub struct Manoeuvre {
    /// Of its name, and of the sentence that says how its commands are chosen.
    pub id: &'static str,
    /// Of the coordinate.
    pub start: f64,
    /// Inputs with their values, each from its time (s) until the next one's.
    pub commands: Vec<(&'static Symbol, Vec<[f64; 2]>)>,
    /// Duration of the run, and the time between its samples, in s.
    pub run: [f64; 2],
    pub curves: Vec<Curve>,
    /// What happened: when (s), and its id.
    pub events: Vec<(f64, &'static str)>,
    /// How many more events there were.
    pub more_events: usize,
    pub energy: Energy,
}

/// Between what values a result lies.
pub struct Envelope {
    pub symbol: &'static Symbol,
    /// At rest over the working range, where it is known.
    pub still: Option<[Summary; 2]>,
    /// In each of the manoeuvres.
    pub moving: Vec<[Stand; 2]>,
}

/// A value with its time (s) and the coordinate then.
#[derive(Clone, Copy)]
pub struct Stand {
    pub value: f64,
    pub time: f64,
    pub at: f64,
}

/// Where energy came from, what stores it and what took it, in J: what was given is what is stored and taken; empty where
/// nobody counts it.
#[derive(Default)]
pub struct Energy {
    pub given: Vec<(&'static Symbol, f64)>,
    pub stored: Vec<(&'static Symbol, f64)>,
    /// With what is left over, last.
    pub taken: Vec<(&'static Symbol, f64)>,
}
