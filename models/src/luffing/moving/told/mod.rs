//! What the book tells of a crane in motion: its manoeuvres, and its equations at one instant of them.
//!
//! | file | what |
//! |---|---|
//! | `shown` | what is a mechanism's own in that |
//! | `manoeuvres`, `motor`, `travel` | which manoeuvres there are, and what inputs are told in each |
//! | `run`, `events`, `energy`, `present`, `stop` | a run of the running model; what is asked of the model at an instant; a stop by brakes |
//! | `motion` | the chapter of all runs |

mod energy;
mod events;
mod manoeuvres;
pub mod motion;
mod motor;
mod present;
mod run;
pub mod shown;
mod stop;
mod travel;
