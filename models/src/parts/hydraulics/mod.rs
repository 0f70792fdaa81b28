//! Hydraulic parts that any mechanism's drive is made of, over any scalar.
//!
//! | file | what |
//! |---|---|
//! | `oil` | compressibility of a volume of oil |
//! | `throttle` | flow through a sharp edge, relief valve, leakage |
//! | `valve` | proportional valve with the dynamics of its spool |
//! | `cylinder` | chambers, ports and their lines |
//! | `anti_cavitation` | valves that feed a chamber from the tank |
//! | `load_holding` | valves that hold the load, whatever happens to a line |
//! | `pump` | limits of flow and power |
//! | `tank` | its pressure |
//! | `parts` | the last four, each of which may be there |
//! | `symbols` | what the book calls flows, areas and volumes |
//!
//! Pressures are in Pa above the atmosphere's, that of the pump above the tank's; flows in m³/s, positive into a volume.

pub mod anti_cavitation;
pub mod cylinder;
pub mod load_holding;
pub mod oil;
pub mod parts;
pub mod pump;
pub mod symbols;
pub mod tank;
pub mod throttle;
pub mod valve;
