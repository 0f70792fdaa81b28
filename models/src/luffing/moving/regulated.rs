//! A crane carried on in time under controllers that are not sampled: set point and integral of each drive are states beside
//! its own, and its moment follows from these and from the drive's speed at every instant.

use crate::kernel::group::One;
use crate::luffing::moving::control::continuous::{Laws, ordered, seen, until, winding};
use crate::luffing::moving::control::{AXES, ByAxis};
use crate::luffing::moving::crane::{Commands, CraneState, Hangs, MOST_CHANGES, MovingCrane, Struck};
use crate::luffing::moving::driven::{Commanded, Slopes};
use crate::luffing::moving::level::{Ahead, CraneAt, Level, Onward, first, put};
use crate::luffing::moving::space;
use crate::parts::control::SpeedControl;
use crate::parts::control::continuous::{Ordered, Sensed};
use crate::parts::solver::pieces::{self, Pieces};
use crate::parts::solver::{Count, Halt};

/// Most states: those of a crane that slews, set point and integral of each drive.
const MOST: usize = space::HAULED + 2 * AXES.len();

/// Controllers, what they are commanded, and where they are.
#[derive(Clone, Copy, Debug)]
pub struct Regulators {
    pub control: ByAxis<SpeedControl>,
    pub commanded: ByAxis<One<f64>>,
    pub laws: Laws,
}

/// A crane and its controllers at one instant: the states of both are those of `y`, the crane's first.
#[derive(Clone, Copy, PartialEq)]
struct Regulated<const N: usize, const J: usize> {
    crane: CraneState<N, J>,
    laws: Laws,
    y: [f64; MOST],
}

impl<const N: usize, const J: usize> Regulated<N, J> {
    fn new(crane: CraneState<N, J>, laws: Laws) -> Regulated<N, J> {
        let mut all = Regulated {
            crane,
            laws,
            y: [0.0; MOST],
        };
        all.put();
        all
    }

    /// The states are those of crane and controllers.
    fn put(&mut self) {
        self.y[..N].copy_from_slice(&self.crane.y);
        for (state, y) in self.laws.states.0.iter().zip(self.y[N..].chunks_exact_mut(2)) {
            if let Some(state) = state {
                y.copy_from_slice(&[state.set, state.integral]);
            }
        }
    }

    /// Crane and controllers have these states.
    fn at(&self, y: &[f64; MOST]) -> Regulated<N, J> {
        let mut all = Regulated { y: *y, ..*self };
        all.crane.y.copy_from_slice(&y[..N]);
        for (state, y) in all.laws.states.0.iter_mut().zip(y[N..].chunks_exact(2)) {
            if let Some(state) = state {
                (state.set, state.integral) = (y[0], y[1]);
            }
        }
        all
    }
}

/// Places of luffing, slewing and hoist in a crane's states, with their speeds.
fn places<const N: usize, const J: usize>(y: &[f64; N]) -> [[f64; 2]; AXES.len()]
where
    MovingCrane<N, J>: Struck<N, J>,
{
    let [luffing, slewing, hoist] = speeds::<N, J>(y);
    let turned = MovingCrane::<N, J>::slewed(y).unwrap_or(0.0);
    let rope = y[<MovingCrane<N, J> as Hangs<N, J, f64>>::LENGTH];
    [[y[0], luffing], [turned, slewing], [rope, hoist]]
}

/// What speeds of luffing, slewing and hoist are in a crane's states, or their accelerations in its rates.
fn speeds<const N: usize, const J: usize>(y: &[f64; N]) -> [f64; AXES.len()]
where
    MovingCrane<N, J>: Struck<N, J>,
{
    let hoist = <MovingCrane<N, J> as Hangs<N, J, f64>>::OWN - 1;
    [y[1], if J > 1 { y[3] } else { 0.0 }, y[hoist]]
}

/// A crane under commands and its controllers, for the solver.
struct Under<'a, const N: usize, const J: usize> {
    commanded: Commanded<'a, N, J>,
    control: &'a ByAxis<SpeedControl>,
    asked: &'a ByAxis<One<f64>>,
}

impl<const N: usize, const J: usize> Under<'_, N, J>
where
    MovingCrane<N, J>: Struck<N, J>,
{
    /// What the controllers see at a time since the start (s), where the crane moves so.
    fn seen(&self, time: f64, at: &Regulated<N, J>, moves: &[f64; N]) -> [Option<Sensed<f64>>; AXES.len()] {
        let commanded = ByAxis(std::array::from_fn(|i| {
            let One(symbol, command) = self.asked.0[i]?;
            Some(One(symbol, command + at.laws.past.0[i]?.slope * time))
        }));
        seen(&commanded, places::<N, J>(&at.crane.y), speeds::<N, J>(moves))
    }

    /// What the controllers give, and all commands with it, at a time since the start, in s.
    fn given(&self, time: f64, at: &Regulated<N, J>) -> ([Option<Ordered<f64>>; AXES.len()], Commands<J>) {
        let Laws { states, past } = &at.laws;
        let found = ordered(self.control, (states, past), speeds::<N, J>(&at.crane.y));
        let mut commands = self.commanded.at(time);
        let [luffing, slewing, hoist] = found.map(|ordered| ordered.map(|ordered| ordered.moment));
        for (drive, moment) in commands.drives.iter_mut().zip([luffing, slewing]) {
            drive.moment = moment.unwrap_or(drive.moment);
        }
        let drum = &mut commands.hoist.drive;
        drum.moment = hoist.unwrap_or(drum.moment);
        (found, commands)
    }

    /// Rates of the crane.
    fn moves(&self, time: f64, at: &Regulated<N, J>, commands: &Commands<J>) -> Option<[f64; N]> {
        self.commanded.blown(time).rates(&at.crane, commands, &at.crane.y)
    }

    /// What the controllers decide at an instant.
    fn decide(&self, time: f64, at: &mut Regulated<N, J>) -> Result<(), Halt> {
        let (_, commands) = self.given(time, at);
        let seen = self.seen(time, at, &self.moves(time, at, &commands).ok_or(Halt::Outside)?);
        let Laws { states, past } = &mut at.laws;
        for (i, (state, past)) in states.0.iter_mut().zip(&mut past.0).enumerate() {
            let all = (self.control.0[i].as_ref().zip(seen[i])).zip(state.as_mut().zip(past.as_mut()));
            if let Some(((control, seen), (state, past))) = all {
                (*state, *past) = control.decided((*state, *past), &seen);
            }
        }
        Ok(())
    }
}

impl<const N: usize, const J: usize> Pieces<MOST, Regulated<N, J>> for Under<'_, N, J>
where
    MovingCrane<N, J>: Struck<N, J>,
{
    fn states(state: &mut Regulated<N, J>) -> &mut [f64; MOST] {
        &mut state.y
    }

    fn rates(&self, time: f64, state: &Regulated<N, J>, y: &[f64; MOST]) -> Option<[f64; MOST]> {
        let at = state.at(y);
        let (found, commands) = self.given(time, &at);
        let moves = self.moves(time, &at, &commands)?;
        let seen = self.seen(time, &at, &moves);
        let winding = winding(self.control, &at.laws.past, &found, &seen);
        let mut rates = [0.0; MOST];
        rates[..N].copy_from_slice(&moves);
        for (rates, winding) in rates[N..].chunks_exact_mut(2).zip(winding) {
            rates.copy_from_slice(&winding.unwrap_or_default());
        }
        Some(rates)
    }

    fn is_forced(&self) -> bool {
        self.commanded.slopes.is_some()
    }

    fn crossed(&self, time: f64, state: &Regulated<N, J>, y: &[f64; MOST]) -> bool {
        let at = state.at(y);
        let (found, commands) = self.given(time, &at);
        let crane = self.commanded.blown(time);
        if pieces::crossed(crane.indicators(&at.crane, &commands, &at.crane.y)) {
            return true;
        }
        let Some(moves) = self.moves(time, &at, &commands) else {
            return true;
        };
        let (states, past) = (&at.laws.states, &at.laws.past);
        let seen = self.seen(time, &at, &moves);
        let until = until(self.control, (states, past), &found, &seen);
        until.into_iter().flatten().any(|z| pieces::crossed(Some(z)))
    }

    /// As often as a controller's law and the crane cause each other's events.
    fn event(&self, time: f64, state: &mut Regulated<N, J>) -> Result<(), Halt> {
        let mut at = state.at(&state.y);
        for _ in 0..MOST_CHANGES {
            let before = at;
            self.decide(time, &mut at)?;
            let (_, commands) = self.given(time, &at);
            self.commanded.blown(time).event(&mut at.crane, &commands)?;
            if at == before {
                break;
            }
        }
        at.put();
        *state = at;
        Ok(())
    }
}

/// Moves a crane on, or decides what follows at an instant.
fn run<const N: usize, const J: usize>(
    crane: &MovingCrane<N, J>,
    at: &mut CraneAt,
    regulators: &mut Regulators,
    on: Option<Onward>,
) -> Result<Count, Halt>
where
    MovingCrane<N, J>: Struck<N, J>,
{
    let commands = &at.inputs.of();
    let slopes = on.and_then(|on| on.slopes).map(|slopes| Slopes::of(&slopes));
    let under = Under {
        commanded: Commanded {
            crane,
            commands,
            slopes: slopes.as_ref(),
        },
        control: &regulators.control,
        asked: &regulators.commanded,
    };
    let mut state = Regulated::new(at.past.crane(first(&at.y)), regulators.laws);
    let work = match on {
        None => under.event(0.0, &mut state).map(|()| Count::default())?,
        Some(on) => {
            under.commanded.check(on.duration)?;
            pieces::advance(&under, &mut state, on.duration, on.longest)?
        }
    };
    let state = state.at(&state.y);
    at.past.follow(&state.crane);
    put(&mut at.y, &state.crane.y);
    regulators.laws = state.laws;
    Ok(work)
}

impl Level {
    /// As [`Level::run`], under controllers that are not sampled where there are any.
    ///
    /// # Errors
    /// See [`Halt`].
    ///
    /// # Panics
    /// For such controllers of a crane that a cylinder luffs.
    pub fn carry(
        &self,
        at: &mut CraneAt,
        ahead: &mut Ahead,
        regulators: Option<&mut Regulators>,
        on: Option<Onward>,
    ) -> Result<Count, Halt> {
        match (self, regulators) {
            (_, None) => self.run(at, ahead, on),
            (Level::Free(crane), Some(regulators)) => run(crane, at, regulators, on),
            (Level::Slewing(crane), Some(regulators)) => run(crane, at, regulators, on),
            (Level::Hauled(crane), Some(regulators)) => run(crane, at, regulators, on),
            (Level::HauledSlewing(crane), Some(regulators)) => run(crane, at, regulators, on),
            (Level::Fixed(_) | Level::Hanging(_), _) => unreachable!("refused where the scene is read"),
        }
    }
}
