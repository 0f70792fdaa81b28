//! A crane that luffs by one coordinate, in motion: what its bodies come to at that coordinate, the load on its rope, the
//! hoist, slewing, oil.
//!
//! | file | what |
//! |---|---|
//! | `bodies`, `reduced` | bodies with their derivatives; what a mechanism is to the equations of motion |
//! | `dynamics`, `pendulum`, `blown` | the mechanism with what hangs on it; with its load as a pendulum, between events; that in the air |
//! | `crane`, `driven`, `motion`, `space`, `hanging` | joints that stick, stops, a rope that goes slack; load in the plane and in space |
//! | `grounded` | a load on the ground |
//! | `control`, `regulated` | controllers of luffing, slewing and hoist; a crane under those that are not sampled |
//! | `pulled`, `unwound`, `caught` | a crane that a rope luffs, which may go slack; that of a drive, whose drum has inertia |
//! | `hydraulic`, `held` | the same moved by a cylinder; how its oil holds it at rest |
//! | `weather`, `exposed`, `leaning` | wind, slope and given slewing, as told; what they come to on a mechanism's bodies; a slope under one that slews |
//! | `geared`, `brakes` | a motor whose shaft turns with the mechanism; brakes on it, which fall on after a delay |
//! | `weighed` | the counterweight of a balance with its derivatives |
//! | `level`, `shares`, `powers`, `energies` | what the levels have in common; what turns the driving link; what gives and takes power, and what blows do |
//! | `inertia_forces`, `balance_in_motion` | weight and inertia of one body; what a balance does to its boom |
//! | `given`, `symbols`, `listed` | inputs, states and memory as groups; quantities; which of them a scene has |
//! | `scene`, `hoisting`, `oil_scene`, `weather_scene`, `step`, `levels` | keys of motion, of rope and hoist, of oil, of wind and slope; the solver's step; the levels that descriptions have in common |
//! | `stages`, `luffs` | rates, event indicators, reactions as stages; a component that has them |
//! | `outline`, `told` | what the book tells of all that |
//! | `single` | a single boom in motion, from what a mechanism says of it |
//! | `built`, `start`, `carried`, `follows` | the equations of a level; where the motion begins, how it is carried on; what depends on what |

pub mod balance_in_motion;
mod blown;
pub mod bodies;
pub mod brakes;
pub mod built;
pub(crate) mod carried;
mod caught;
pub mod control;
pub mod crane;
mod driven;
pub mod dynamics;
mod energies;
pub mod exposed;
pub mod follows;
pub mod fragments;
pub mod geared;
pub mod given;
mod grounded;
pub mod hanging;
mod held;
pub mod hoisting;
pub mod hydraulic;
pub mod inertia_forces;
pub mod leaning;
pub mod level;
pub mod levels;
pub mod listed;
pub mod luffs;
pub mod motion;
pub mod oil_scene;
pub mod outline;
pub mod pendulum;
mod powers;
mod pulled;
pub mod reduced;
pub mod regulated;
pub mod scene;
pub mod shares;
pub mod single;
pub mod space;
pub mod stages;
pub mod start;
mod step;
pub mod symbols;
pub(crate) mod told;
mod unwound;
pub mod weather;
mod weather_scene;
pub mod weighed;
