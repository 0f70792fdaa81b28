//! A crane carried on in time under commands that may follow from it.

use std::borrow::Cow;

use crate::luffing::moving::crane::{Commands, CraneState, MovingCrane, Struck};
use crate::luffing::moving::given::Inputs;
use crate::luffing::moving::weather::Weather;
use crate::parts::joint::JointDrive;
use crate::parts::solver::pieces::{self, Pieces};
use crate::parts::solver::{Count, Halt};

/// A crane under commands, for the solver.
pub(super) struct Commanded<'a, const N: usize, const J: usize> {
    pub(super) crane: &'a MovingCrane<N, J>,
    pub(super) commands: &'a Commands<J>,
    pub(super) slopes: Option<&'a Slopes<J>>,
}

/// How fast commands change, the speed (m/s²) and direction (rad/s) of the wind at the load, and what the bodies meet.
#[derive(Clone, Copy, Debug)]
pub struct Slopes<const J: usize> {
    pub commands: Commands<J>,
    pub wind: [f64; 2],
    pub weather: Weather,
}

impl<const J: usize> Slopes<J> {
    pub(super) fn of(slopes: &Inputs) -> Slopes<J> {
        Slopes {
            commands: slopes.of(),
            wind: slopes.wind,
            weather: slopes.weather,
        }
    }
}

impl<const N: usize, const J: usize> Commanded<'_, N, J> {
    /// At a time since the start, in s.
    #[inline]
    pub(super) fn at(&self, time: f64) -> Commands<J> {
        match self.slopes {
            None => *self.commands,
            Some(slopes) => self.commands.changed(&slopes.commands, time),
        }
    }

    /// In the wind of a time since the start, in s.
    #[inline]
    pub(super) fn blown(&self, time: f64) -> Cow<'_, MovingCrane<N, J>> {
        let changes = |slopes: &&Slopes<J>| slopes.wind != [0.0; 2] || !slopes.weather.is_calm();
        let Some(slopes) = self.slopes.filter(changes) else {
            return Cow::Borrowed(self.crane);
        };
        let mut crane = self.crane.clone();
        let ([speed, to], [gains, turns]) = (self.crane.dynamics.blows(), slopes.wind);
        crane.dynamics.put_wind([speed + gains * time, to + turns * time]);
        crane.dynamics.put_later(&slopes.weather, time);
        Cow::Owned(crane)
    }

    /// Refuses commands that cannot be, now or at the end of a duration (s).
    pub(super) fn check(&self, duration: f64) -> Result<(), Halt> {
        let sound =
            |Commands { drives, hoist, .. }: Commands<J>| drives.iter().all(JointDrive::is_sound) && hoist.is_sound();
        let all = [0.0, duration].into_iter().all(|time| sound(self.at(time)));
        all.then_some(()).ok_or(Halt::Outside)
    }
}

impl<const N: usize, const J: usize> Pieces<N, CraneState<N, J>> for Commanded<'_, N, J>
where
    MovingCrane<N, J>: Struck<N, J>,
{
    fn states(state: &mut CraneState<N, J>) -> &mut [f64; N] {
        &mut state.y
    }

    #[inline]
    fn rates(&self, time: f64, state: &CraneState<N, J>, y: &[f64; N]) -> Option<[f64; N]> {
        self.blown(time).rates(state, &self.at(time), y)
    }

    fn is_forced(&self) -> bool {
        self.slopes.is_some()
    }

    #[inline]
    fn crossed(&self, time: f64, state: &CraneState<N, J>, y: &[f64; N]) -> bool {
        pieces::crossed(self.blown(time).indicators(state, &self.at(time), y))
    }

    fn event(&self, time: f64, state: &mut CraneState<N, J>) -> Result<(), Halt> {
        self.blown(time).event(state, &self.at(time)).map(|_| ())
    }
}

impl<const N: usize, const J: usize> MovingCrane<N, J>
where
    Self: Struck<N, J>,
{
    /// Moves on by a duration (s) in equal steps of at most `longest` (s), events located on the way
    /// to the last bits of the step. Returns the work done.
    ///
    /// # Errors
    /// See [`Halt`]; the state is that of the last step that succeeded.
    pub fn advance(
        &self,
        state: &mut CraneState<N, J>,
        commands: &Commands<J>,
        duration: f64,
        longest: f64,
    ) -> Result<Count, Halt> {
        self.follow(state, (commands, None), duration, longest)
    }

    /// The same under commands and in a wind that may change at some rates.
    ///
    /// # Errors
    /// As [`advance`](MovingCrane::advance).
    pub fn follow(
        &self,
        state: &mut CraneState<N, J>,
        (commands, slopes): (&Commands<J>, Option<&Slopes<J>>),
        duration: f64,
        longest: f64,
    ) -> Result<Count, Halt> {
        let commanded = Commanded {
            crane: self,
            commands,
            slopes,
        };
        commanded.check(duration)?;
        pieces::advance(&commanded, state, duration, longest)
    }
}
