//! What gives and takes power in a crane in motion.

/// Powers at one instant, in W; losses are positive.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Powers {
    /// Of the drives of luffing and slewing, of the hoist, and of the pump.
    pub drive: f64,
    pub slewing: f64,
    pub hoist: f64,
    pub pump: f64,
    /// What friction, brakes and end stops take.
    pub friction: f64,
    /// What edges, lines, relief valves and leakage take.
    pub throttles: f64,
    /// What compresses the oil.
    pub compression: f64,
    /// What the air takes from the load.
    pub air: f64,
}
