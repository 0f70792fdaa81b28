//! A load that sways under a trolley on a straight beam: its equation of motion as a simple pendulum whose rope is reeled, feedback
//! by the trolley, starts that leave no sway.
//!
//! | id | function | source |
//! |---|---|---|
//! | `sway.pendulum` | [`pendulum::Swung::new`], [`pendulum::Feedback::answer`], [`pendulum::Damped::new`] | Lagrange; state feedback |
//! | `sway.starts` | [`starts::Start::left`], [`starts::Start::greatest`] | linear oscillator |

pub mod pendulum;
pub mod scene;
pub mod starts;
