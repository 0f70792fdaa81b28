//! What the results of a crane in motion follow from: whatever has a derivative in any of many lively states, in every
//! one of its ways of moving.

use std::collections::{BTreeMap, BTreeSet};

use crate::component::dependencies::{dependencies, recorded};
use crate::component::moving::MovingComponent;
use crate::component::part::Runner;
use crate::component::running::{Running, Tangent};
use crate::component::standing::{Standing, VariablePlace};
use crate::kernel::variable::{Name, Quantity, Role, TIME};
use crate::luffing::moving::brakes::Braking;
use crate::luffing::moving::carried::{at, known, put, regulators};
use crate::luffing::moving::control::continuous::Laws;
use crate::luffing::moving::crane::DRUM;
use crate::luffing::moving::given::{L_R, order};
use crate::luffing::moving::hydraulic::{FIXED, Modes};
use crate::luffing::moving::level::CraneAt;
use crate::luffing::moving::luffs::{LuffingGiven, Luffs, MotionSources};
use crate::luffing::moving::symbols as m;
use crate::parts::hoist::Drum;
use crate::parts::hydraulics::symbols as h;
use crate::parts::joint::Bar;

/// In the place of a parameter that is zero where it is asked what depends on what.
const TRACE: f64 = 1e-6;

/// Every way of a joint; one that is not there is held.
const WAYS: [Bar; 3] = [Bar::Held, Bar::Forward, Bar::Backward];
/// Every way in which a load hangs, whether the rope is taut and what its drum does; the first one is that of none.
const HANGS: [(bool, Bar); 3] = [(true, Bar::Held), (true, Bar::Forward), (false, Bar::Held)];

/// Place of the spool among the states of a crane with oil.
const SPOOL: usize = 6;

/// Of lively states one in so many has other regimes of controllers too, or a slack rope of its drive: as it has no divisor in
/// common with the ways of moving, every one of these is among them.
const OTHERS_EACH: usize = 7;

/// States with no number that is special, in all ways of moving: over the range of the angle and beyond its ends, relief
/// valves open and closed.
fn lively(luffing: &LuffingGiven, now: &CraneAt) -> Vec<CraneAt> {
    let (range, given) = (luffing.range, &luffing.sources);
    let length = given.states.map_or(0.0, |states| states.0[L_R]);
    let (slews, rope) = (given.slewed.is_some(), given.fitted.rope.is_some());
    let first = if given.oil.is_some() { FIXED } else { 2 };
    let stands: &[bool] = if given.ground.is_some() {
        &[false, true]
    } else {
        &[false]
    };
    let slewings = if slews { &WAYS[..] } else { &WAYS[..1] };
    let hangs = if rope { &HANGS[..] } else { &HANGS[..1] }.iter();
    let hangs = hangs.flat_map(|(taut, way)| stands.iter().map(move |grounded| (*taut, *way, *grounded)));
    let mut found = Vec::new();
    for part in [-1e-3, 0.217, 0.613, 0.871, 1.001] {
        for sign in [1.0, -1.0] {
            let mut at = *now;
            at.y[..2].copy_from_slice(&[range.from + part * (range.to - range.from), 0.113 * sign]);
            if slews {
                at.y[first..first + 2].copy_from_slice(&[0.113 * sign, -0.119 * sign]);
                let aside = [0.31, -0.83, 0.27, 0.17, 0.071, -0.053];
                at.y[first + 2..first + 8].copy_from_slice(&aside.map(|x| x * length));
            } else if rope || given.oil.is_none() {
                at.y[first..first + 5].copy_from_slice(&[0.231, -0.119 * sign, length, 0.93 * length, 0.57]);
            }
            if given.oil.is_none() && slews {
                (at.y[1], at.y[2]) = (0.231, 0.113 * sign);
            }
            let pressures: &[f64] = if given.oil.is_some() { &[0.3, 2.0] } else { &[0.0] };
            for p in pressures {
                if let Some(oil) = given.oil {
                    let p = p * oil.p_r;
                    at.y[2..FIXED].copy_from_slice(&[1.07 * p, 0.93 * p, 0.71 * p, 0.41 * p, 0.31 * sign, 1.7]);
                }
                for luffing in WAYS {
                    for &slewing in slewings {
                        for (taut, way, grounded) in hangs.clone() {
                            let drum = Drum { way, command: 0.0 };
                            at.past = Modes {
                                joints: [luffing, slewing],
                                drum,
                                taut,
                                grounded,
                                slack: None,
                                unwound: None,
                                blown: 0.0,
                                braking: Braking::ON,
                            };
                            found.push(at);
                        }
                    }
                }
            }
        }
    }
    if let Some(holding) = given.oil_parts.and_then(|parts| parts.load_holding) {
        // A spool within its underlap.
        let relieved = found.iter().step_by(OTHERS_EACH).map(|at| {
            let mut at = *at;
            at.y[SPOOL] = holding.x_t * 0.37_f64.copysign(at.y[SPOOL]);
            at
        });
        let relieved: Vec<CraneAt> = relieved.collect();
        found.extend(relieved);
    }
    if given.fitted.hauled {
        // Behind angle and rate, the last two.
        let drum = order(&given.fitted).len();
        let slack = found.iter().step_by(OTHERS_EACH).flat_map(|at| {
            WAYS.map(|way| {
                let mut at = *at;
                let speed = 0.241_f64.copysign(at.y[1]);
                at.y[drum..drum + DRUM].copy_from_slice(&[0.137, speed]);
                at.past.unwound = Some(way);
                at
            })
        });
        let slack: Vec<CraneAt> = slack.collect();
        found.extend(slack);
    }
    found
}

/// What controllers that are not sampled may do besides having set points at rest and moments within their limits: set points on
/// their way, and all that the limit does with the integral.
fn regimes(laws: Laws) -> [Laws; 3] {
    [[1.0, 1.0], [-1.0, 2.0], [1.0, 3.0]].map(|[way, hold]| {
        let mut laws = laws;
        for past in laws.past.0.iter_mut().flatten() {
            (past.way, past.hold) = (way, hold);
        }
        laws
    })
}

/// What stands in the present position alone, as of a crane at rest.
fn at_rest<T: Luffs>(model: &MovingComponent) -> Standing {
    let moving = model.standing();
    let given = moving.of::<T>().given();
    let LuffingGiven { theta, omega, .. } = T::luffing(given);
    let part = Runner::<T, f64>::new(T::with(given, [theta.1, omega.1], MotionSources::NONE));
    Standing::new(Box::new(part), *moving.motion(), None).expect("it stands there")
}

/// What each variable depends on: results of the position on angle and angular velocity in the place of the time.
#[must_use]
pub fn follows<T: Luffs>(model: &MovingComponent) -> Vec<BTreeSet<Name>> {
    let still = at_rest::<T>(model);
    let position = dependencies(&still, recorded::<T>);
    let variables = model.variables();
    let name = |index: usize| -> Name { (variables[index].symbol.id, variables[index].number) };
    let luffing = T::luffing(model.standing().of::<T>().given());
    let given = &luffing.sources;
    let states = T::GROUPS.iter().position(|(group, _)| *group == "states");
    let moves = |index: usize| match model.standing().places()[index] {
        VariablePlace::Result(slot) => states.is_some_and(|group| slot.sources >> group & 1 == 1),
        _ => false,
    };
    let of = |index: usize| {
        let symbol = variables[index].symbol;
        let pressures = [&m::P_1, &m::P_2, &m::P_A, &m::P_B].map(|symbol| (symbol.id, None));
        if variables[index].role == Role::State {
            BTreeSet::from([name(index)])
        } else if symbol == &h::CAVITATES || symbol == &h::Z_VACUUM {
            // Any of them may be the least.
            pressures.into()
        } else if symbol == &m::D_V_R && given.ramp.is_some() {
            // Decided at events.
            BTreeSet::from([(m::V_H.id, None)])
        } else if moves(index) {
            BTreeSet::new()
        } else {
            let same = still
                .variables()
                .iter()
                .position(|known| known.quantity() == variables[index].quantity());
            let found = same.map_or(BTreeSet::new(), |same| position[same].clone());
            found.into_iter().filter(|name| *name != (TIME.id, None)).collect()
        }
    };
    let mut found: Vec<BTreeSet<Name>> = (0..variables.len()).map(of).collect();
    let mut lively_model = model.clone();
    for index in 0..variables.len() {
        // What is zero now may hide what else acts: an arm that weighs nothing, a gap that lets nothing pass.
        if lively_model.check(index, TRACE).is_ok() && lively_model.get(index) == Ok(0.0) {
            let _ = lively_model.set(index, TRACE);
        }
    }
    let moving: Vec<usize> = (0..variables.len()).filter(|index| moves(*index)).collect();
    let roles = [Role::Input, Role::Parameter, Role::Tunable, Role::State];
    let givens: Vec<Name> = (0..variables.len())
        .filter(|i| roles.contains(&variables[*i].role))
        .map(name)
        .collect();
    let now = at::<T>(lively_model.parts().0);
    let laws = regulators::<T>(lively_model.parts().0).map(|all| all.laws);
    let all = lively(&luffing, &now);
    let within = all.iter().map(|at| (at, laws));
    let others = laws.into_iter().flat_map(regimes);
    let others = others.flat_map(|laws| all.iter().step_by(OTHERS_EACH).map(move |at| (at, Some(laws))));
    let mut groups = alike(&moving, &givens, &found);
    let mut tangent = lively_model.tangent(&|_| 0.0);
    for (at, laws) in within.chain(others) {
        put::<T>(lively_model.parts().0, at);
        if let Some(laws) = laws {
            T::put_laws(known::<T>(lively_model.parts().0), laws);
        }
        if !groups
            .iter()
            .any(|alike| alike.follow_more(&lively_model, &mut tangent))
        {
            continue;
        }
        for known in &givens {
            let seed = |(symbol, number): Quantity| f64::from((symbol.id, number) == *known);
            lively_model.tangent_into(&seed, &mut tangent);
            for &index in &moving {
                if lively_model.derivative(&mut tangent, index) != Ok(0.0) {
                    found[index].insert(*known);
                }
            }
        }
        groups = alike(&moving, &givens, &found);
    }
    found
}

/// Results that follow from the same, as far as is known, and a direction in which all changes at once that they are not known
/// to follow from.
struct Alike {
    results: Vec<usize>,
    direction: BTreeMap<Name, f64>,
}

fn alike(results: &[usize], givens: &[Name], found: &[BTreeSet<Name>]) -> Vec<Alike> {
    let mut alike: BTreeMap<&BTreeSet<Name>, Vec<usize>> = BTreeMap::new();
    for &index in results {
        alike.entry(&found[index]).or_default().push(index);
    }
    let with_direction = |(known, results): (&BTreeSet<Name>, Vec<usize>)| {
        // No two of them by the same amount, so that nothing cancels.
        let open = givens.iter().zip(1_u32..).filter(|(name, _)| !known.contains(name));
        Alike {
            results,
            direction: open.map(|(name, i)| (*name, f64::from(i).sqrt())).collect(),
        }
    };
    alike.into_iter().map(with_direction).collect()
}

impl Alike {
    /// Whether one of them changes in that direction.
    fn follow_more(&self, model: &MovingComponent, tangent: &mut Tangent) -> bool {
        let seed = |(symbol, number): Quantity| self.direction.get(&(symbol.id, number)).copied().unwrap_or(0.0);
        model.tangent_into(&seed, tangent);
        let mut results = self.results.iter();
        results.any(|index| model.derivative(tangent, *index) != Ok(0.0))
    }
}
