//! The load chart as data: what is permitted at every reach and length of the boom.

use crate::component::sheet::{Chart, Curve, Table};
use crate::kernel::group::group;
use crate::kernel::symbol::listed;
use crate::supports::mobile::symbols as s;

/// What is only a rounding apart is the same length, in m.
pub const SAME: f64 = 1e-9;

/// A cell: lengths in m, angle in rad, loads in N.
#[derive(Clone, Copy, Debug)]
pub struct Cell {
    pub length: f64,
    pub reach: f64,
    pub angle: f64,
    /// Height of the head.
    pub height: f64,
    /// Rated load with and without hook block; none where nothing is permitted.
    pub load: f64,
    pub net: f64,
    /// Slewing angle where it is so, and what governs there, a place among [`GOVERNING`](s::GOVERNING).
    pub heading: f64,
    pub governs: usize,
}

/// All cells that the boom reaches, by length and then by reach, each growing.
#[derive(Clone, Debug)]
pub struct LoadChart(pub Vec<Cell>);
group!(LoadChart);

impl LoadChart {
    /// The rated load (N) of the next greater reach with the next longer boom there; zero beyond them.
    #[must_use]
    pub fn at(&self, length: f64, reach: f64) -> f64 {
        let lengths = self
            .0
            .iter()
            .map(|cell| cell.length)
            .filter(|known| *known >= length - SAME);
        let longer = lengths.fold(f64::INFINITY, f64::min);
        let cell = |cell: &&Cell| cell.length == longer && cell.reach >= reach - SAME;
        self.0.iter().find(cell).map_or(0.0, |cell| cell.load)
    }

    /// As the book prints it.
    #[must_use]
    pub fn told(&self) -> Chart {
        let row = |c: &Cell| vec![c.length, c.reach, c.angle, c.height, c.heading, c.load, c.net];
        let lengths = self.0.chunk_by(|a, b| a.length == b.length);
        let allowed = |c: &&Cell| c.load > 0.0 && c.load.is_finite();
        let piece = |cells: &[Cell]| cells.iter().filter(allowed).map(|c| [c.reach, c.load]).collect();
        let pieces = (1..)
            .zip(lengths.map(piece))
            .filter(|(_, piece): &(usize, Vec<[f64; 2]>)| piece.len() > 1);
        let (numbers, pieces): (Vec<_>, Vec<_>) = pieces.unzip();
        Chart {
            id: "mobile_chart",
            points: Table {
                columns: listed!(s: L, R, PHI, H_A, PSI, Q_RAT, Q_NET).to_vec(),
                rows: self.0.iter().map(row).collect(),
            },
            shown: &s::Q_RAT,
            marks: self.0.iter().map(|c| s::GOVERNING.items[c.governs].0).collect(),
            curve: (!pieces.is_empty()).then_some(Curve {
                id: "mobile_chart",
                x: &s::R,
                y: &s::Q_RAT,
                pieces,
                numbers,
            }),
        }
    }
}
