//! Results that are searched for, and so have no derivative: the nearest command that all groups can follow, and the
//! greatest slip. They are kept until the inputs change.

use crate::model::Fault;
use crate::steering::machine::GROUPS;
use crate::steering::mode::{Centre, Command, Mode};
use crate::steering::outputs::{Evaluation, Output};
use crate::steering::reach::{nearest, stand};
use crate::steering::slip::worst;

/// A result that is searched for; those of groups with the group's number from 0.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Searched {
    Theta(usize),
    ThetaB,
    Radius,
    CentreX,
    CentreY,
    Slip(usize),
    SlipMax,
}

/// What has been found for the current inputs.
#[derive(Clone, Debug)]
pub struct Search {
    nearest: Option<Nearest>,
    /// Angles there, in rad.
    angles: Vec<f64>,
    /// Greatest slip of each group, once it was asked for.
    slips: Vec<f64>,
    slipped: bool,
}

/// The nearest command that all groups can follow.
#[derive(Clone, Copy, Debug)]
pub struct Nearest {
    /// `None` where there is none.
    pub found: Option<(Mode, Command<f64>)>,
    /// Its turning centre.
    pub centre: Option<Centre<f64>>,
}

impl Search {
    #[must_use]
    pub fn new(groups: usize) -> Search {
        Search {
            nearest: None,
            angles: vec![0.0; groups],
            slips: vec![0.0; groups],
            slipped: false,
        }
    }

    /// The inputs have changed.
    #[inline]
    pub fn forget(&mut self) {
        (self.nearest, self.slipped) = (None, false);
    }

    /// The nearest command, the commanded one where that is reachable, and the angles of the groups there, in rad:
    /// straight ahead where there is none.
    ///
    /// # Errors
    /// As [`Evaluation::update`].
    pub fn nearest(&mut self, evaluation: &mut Evaluation<f64>) -> Result<(Nearest, &[f64]), Fault> {
        let nearest = match self.nearest {
            Some(known) => known,
            None => {
                let (mode, command) = (evaluation.inputs().mode, evaluation.inputs().command());
                let reachable = evaluation.output(Output::Reachable)? != 0.0;
                let (built, centre) = evaluation.stance()?;
                let (machine, limits) = (&built.machine, &built.limits);
                // The centre of the command itself is exact.
                let (found, centre) = if reachable {
                    (Some((mode, command)), Some(*centre))
                } else {
                    let found = nearest(machine, limits, mode, command);
                    let centre = found.and_then(|(mode, command)| mode.centre(machine, command).ok());
                    (found, centre)
                };
                match &centre {
                    Some(centre) => stand(machine, limits, centre, &mut self.angles),
                    None => self.angles.fill(0.0),
                }
                *self.nearest.insert(Nearest { found, centre })
            }
        };
        Ok((nearest, &self.angles))
    }

    /// A result in SI. A kind of command that the mode does not take is the one given.
    ///
    /// # Errors
    /// As [`Evaluation::update`].
    pub fn get(&mut self, evaluation: &mut Evaluation<f64>, what: Searched) -> Result<f64, Fault> {
        match what {
            Searched::Theta(i) => return Ok(self.nearest(evaluation)?.1[i]),
            Searched::Slip(i) => return Ok(self.slips(evaluation)?[i]),
            Searched::SlipMax => return Ok(self.slips(evaluation)?.iter().copied().fold(0.0, f64::max)),
            _ => {}
        }
        let command = self.nearest(evaluation)?.0.found;
        let inputs = evaluation.inputs();
        Ok(match (what, command) {
            (Searched::ThetaB, Some((_, Command::Angle(theta)))) => theta,
            (Searched::Radius, Some((_, Command::Radius(radius)))) => radius,
            (Searched::CentreX, Some((_, Command::Centre(at)))) => at.x,
            (Searched::CentreY, Some((_, Command::Centre(at)))) => at.y,
            (Searched::ThetaB, _) => inputs.theta_b,
            (Searched::Radius, _) => inputs.r_t,
            (Searched::CentreX, _) => inputs.centre.x,
            _ => inputs.centre.y,
        })
    }

    fn slips(&mut self, evaluation: &mut Evaluation<f64>) -> Result<&[f64], Fault> {
        if !self.slipped {
            let mut errors = [0.0; GROUPS[1]];
            let n = self.slips.len();
            for (i, slot) in errors[..n].iter_mut().enumerate() {
                *slot = evaluation.output(Output::Delta(i))?;
            }
            let (built, centre) = evaluation.stance()?;
            worst(&built.machine, centre, &errors[..n], &mut self.slips);
            self.slipped = true;
        }
        Ok(&self.slips)
    }
}
