//! How the ropes of grab and trolley are led.

use crate::kernel::group::group;

/// The schemes, as scenes name them.
pub const SCHEMES: [&str; 4] = ["planetary", "simple", "auxiliary_trolley", "middle_drum"];

/// How the ropes of grab and trolley are led.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Scheme {
    Planetary,
    Simple,
    AuxiliaryTrolley,
    MiddleDrum,
}

impl Scheme {
    /// By its place among [`SCHEMES`].
    pub const ALL: [Scheme; 4] = [
        Scheme::Planetary,
        Scheme::Simple,
        Scheme::AuxiliaryTrolley,
        Scheme::MiddleDrum,
    ];

    /// Hoisting and closing drums of sea and land side; or one of each, and that of the trolley.
    #[must_use]
    pub fn drums(self) -> usize {
        if self == Scheme::Planetary { 4 } else { 3 }
    }
}

/// How the ropes are led: the scheme, and the sheaves that a rope passes as the trolley travels.
#[derive(Clone, Copy, Debug)]
pub struct Reeving {
    pub scheme: Scheme,
    pub sheaves: u8,
}
group!(Reeving);
