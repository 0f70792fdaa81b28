//! Hydraulic parts that any mechanism's drive is made of, over any scalar.
//!
//! | file | what |
//! |---|---|
//! | `oil` | compressibility of a volume of oil |
//! | `throttle` | flow through a sharp edge, relief valve, leakage |
//! | `valve` | proportional valve with the dynamics of its spool |
//! | `cylinder` | chambers, ports and their lines |
//! | `symbols` | what the book calls flows, areas and volumes |
//!
//! Pressures are in Pa above the tank's, flows in m³/s, positive into a volume.

pub mod cylinder;
pub mod oil;
pub mod symbols;
pub mod throttle;
pub mod valve;
