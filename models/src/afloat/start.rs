//! A floating crane that moves, as scenes describe it: it begins at rest under its load.

use crate::afloat::crane::LuffingMotion;
use crate::afloat::driving::{LuffingCommand, LuffingServo};
use crate::afloat::riding::{BuoyedMass, HullMotion};
use crate::afloat::stages::{FloatingCrane, Given, Known};
use crate::afloat::swaying::{RopedLoad, SlewingCommand, SlewingServo};
use crate::afloat::symbols as s;
use crate::component::stages::{Found, Stages};
use crate::kernel::calc::Calc;
use crate::kernel::diagnostic::Diagnostic;
use crate::kernel::group::One;
use crate::kernel::keys::keys;
use crate::kernel::schema::{Key, Values};
use crate::kernel::symbol::Symbol;
use crate::parts::motion::short_step;

/// Keys of the hull that say something of the motion alone, with the table of what moves.
pub const MOVING: [&str; 5] = ["l_R", "omega_csl", "psi_sl", "omega_c1", "dynamics"];

pub static DYNAMICS: &[Key] = keys! { s:
    M_A >= 0, J_X > 0, J_Y > 0, D_Z >= 0 [usually(0.0)], D_X >= 0 [usually(0.0)], D_Y >= 0 [usually(0.0)],
    T_SL > 0 [usually(2.0)], T_1 > 0 [optional], STEP > 0 [optional]
};

/// Longest step of the solver over the time in which the fastest part turns by one radian, and the shortest that may be given
/// over that.
const LONGEST: f64 = 0.1;
const SHORTEST: f64 = 1e-2;

/// A load that hangs at rest under the head on a rope of a length (m).
pub fn hanging(length: f64) -> RopedLoad<f64> {
    RopedLoad {
        r_x: 0.0,
        r_y: 0.0,
        r_z: -length,
        w_x: 0.0,
        w_y: 0.0,
        w_z: 0.0,
    }
}

/// Refuses what is missing for a motion, and what has no use without one.
pub fn suits(v: &Values, found: &mut Vec<Diagnostic>) {
    let moves = v.text("fidelity") == Some("swing");
    if moves {
        let [rope, dynamics] = [s::L_R.id, "dynamics"].map(|key| !v.stands(key));
        if rope {
            let help = "add l_R = \"15 m\", the length of the rope from head to load";
            let what = "a swinging load without a rope";
            found.push(v.refuse(s::L_R.id, what, "l_R is missing in [hull]", help));
        }
        if dynamics {
            let help = "add m_a, J_x and J_y in [hull.dynamics]: what heaves, rolls and pitches";
            let what = "`dynamics` is missing in [hull]";
            found.push(v.refuse("dynamics", what, "needed for a motion", help));
        }
        return;
    }
    let told = |symbol: &Symbol| v.course(symbol.id).map(|_| symbol.id);
    if let Some(key) = MOVING.into_iter().find(|key| v.has(key)).or(told(&s::Q)) {
        let what = format!("`{key}` of a hull that stands still");
        let help = "set fidelity = \"swing\", or give no motion";
        found.push(v.refuse(key, what, "not used", help));
    }
}

/// What moves, all of it or nothing.
pub struct MovingHull {
    pub buoyed: BuoyedMass<f64>,
    pub servo: SlewingServo<f64>,
    pub command: SlewingCommand<f64>,
    luffing: (LuffingServo<f64>, LuffingCommand<f64>),
    pub roped: RopedLoad<f64>,
    /// Slewing angle at the start, in rad.
    pub psi: f64,
}

impl MovingHull {
    /// Of a scene whose hull moves, from the start of its working range where nothing else is given.
    pub fn read(v: &Values, from: f64, luffing: LuffingCommand<f64>) -> Option<MovingHull> {
        let dynamics = v.table("dynamics").filter(|_| v.text("fidelity") == Some("swing"))?;
        let n = |symbol: &Symbol, usual| v.number(symbol.id).unwrap_or(usual);
        Some(MovingHull {
            buoyed: BuoyedMass::read(dynamics)?,
            servo: SlewingServo::read(dynamics)?,
            command: SlewingCommand {
                omega_c: n(&s::OMEGA_CSL, 0.0),
            },
            luffing: (
                LuffingServo {
                    t_1: dynamics.of(&s::T_1).unwrap_or(f64::INFINITY),
                },
                luffing,
            ),
            roped: hanging(v.of(&s::L_R)?),
            psi: n(&s::PSI_SL, from),
        })
    }

    /// Puts it where it begins at rest, and returns the longest step of the solver, in s.
    pub fn begin(self, v: &Values, given: &mut Given<f64>, found: &mut Vec<Diagnostic>) -> Option<f64> {
        let mut resting = FloatingCrane::new(given.clone());
        resting.psi().1 = self.psi;
        let begun = rest(&mut resting).and_then(|motion| Ok((motion, self.fastest(&mut resting)?)));
        let (motion, fastest) = begun
            .map_err(|fault| {
                let help = "begin elsewhere, or give less load or reach";
                found.push(v.refuse("motion", fault.message, "the motion cannot begin so", help));
            })
            .ok()?;
        let longest = LONGEST / fastest;
        let dynamics = v.table("dynamics")?;
        found.extend(short_step(dynamics, &s::STEP, [SHORTEST * longest, longest]));
        (given.psi, given.omega) = (One(&s::PSI_SL, self.psi), One(&s::OMEGA_SL, 0.0));
        (given.buoyed, given.servo, given.command) = (Some(self.buoyed), Some(self.servo), Some(self.command));
        (given.moved, given.roped) = (Some(motion), Some(self.roped));
        if let Some(held) = given.held.take() {
            let (servo, command) = self.luffing;
            (given.luffing_servo, given.luffing_command) = (Some(servo), Some(command));
            given.luffing = Some(LuffingMotion {
                theta_1: held.1,
                omega_1: 0.0,
            });
        }
        Some(dynamics.of(&s::STEP).unwrap_or(longest))
    }

    /// Of heaving, rolling, pitching and swinging, each by itself, and of slewing, the greatest angular frequency, in 1/s.
    fn fastest(&self, known: &mut Known<f64>) -> Found<f64> {
        let weight = known.loaded()?.all.weight;
        let upright = *known.upright()?;
        let given = FloatingCrane::given(known);
        let (g, density) = (given.gravity.1, given.density.1);
        let BuoyedMass { m_a, j_x, j_y, .. } = self.buoyed;
        let luffing = if given.luffer.is_some() {
            self.luffing.0.t_1.powi(-2)
        } else {
            0.0
        };
        let squares = [
            luffing,
            density * g * upright.waterplane() / (weight / g + m_a),
            weight * upright.height[0] / j_x,
            weight * upright.height[1] / j_y,
            g / -self.roped.r_z,
            self.servo.t_sl.powi(-2),
        ];
        Ok(squares.into_iter().fold(0.0, f64::max).sqrt())
    }
}

/// Heave, heel and pitch at rest.
fn rest(known: &mut Known<f64>) -> Found<HullMotion<f64>> {
    let dead = known.dead()?;
    let (weight, [along, across], up) = (dead.all.weight, dead.own, dead.all.up);
    let [draft, a, b] = known.posture()?.lie();
    let heel = f64::direction(1.0, b);
    let (_, cos) = Calc::sin_cos(heel);
    let pitch = f64::direction(1.0, a * cos);
    let (_, level) = Calc::sin_cos(pitch);
    Ok(HullMotion {
        h_g: ((up - a * along - b * across) / weight - draft) * cos * level,
        phi_x: heel,
        theta_y: pitch,
        v_g: 0.0,
        omega_x: 0.0,
        omega_y: 0.0,
    })
}
