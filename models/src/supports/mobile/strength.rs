//! What the strength of boom, ropes and luffing cylinder permits, as tables.

use crate::component::sheet::{Section, Table};
use crate::kernel::group::group;
use crate::supports::mobile::chart::SAME;
use crate::supports::mobile::symbols as s;

/// Place of the first of them among [`GOVERNING`](s::GOVERNING).
pub const FIRST_STRENGTH: usize = 2;

/// A strength as a table: loads (N) at reaches (m), up to a length of the boom (m).
#[derive(Clone, Debug)]
pub struct Strength {
    /// Place among [`GOVERNING`](s::GOVERNING).
    pub of: usize,
    pub length: f64,
    pub points: Vec<[f64; 2]>,
}

/// Whose strengths a scene may give, in the order of [`GOVERNING`](s::GOVERNING).
pub const STRENGTHS: [&str; 4] = ["boom", "rope", "tackle", "cylinder"];

/// All strengths of the scene.
#[derive(Clone, Debug)]
pub struct Strengths(pub Vec<Strength>);
group!(Strengths);

impl Strengths {
    /// The tables as they are given, each under the name of what it is of.
    pub fn told(&self) -> impl Iterator<Item = Section> {
        const IDS: [&str; 4] = [
            "mobile_strength_boom",
            "mobile_strength_rope",
            "mobile_strength_tackle",
            "mobile_strength_cylinder",
        ];
        let of = |(of, id): (usize, &'static str)| {
            let those = self.0.iter().filter(move |table| table.of == of);
            let rows = those.flat_map(|table| {
                table
                    .points
                    .iter()
                    .map(|[reach, load]| vec![table.length, *reach, *load])
            });
            let table = Table {
                columns: vec![&s::L, &s::R, &s::Q_S],
                rows: rows.collect(),
            };
            (!table.rows.is_empty()).then(|| Section {
                id,
                table: Some(table),
                ..Section::default()
            })
        };
        (FIRST_STRENGTH..).zip(IDS).filter_map(of)
    }

    /// The least load and what it is of: each from its table of the next longer boom, at the next greater reach there;
    /// nothing beyond them.
    pub fn at(&self, length: f64, reach: f64) -> Option<(usize, f64)> {
        let those = |of: usize| self.0.iter().filter(move |table| table.of == of);
        let of = |of: usize| {
            let longer = those(of).filter(|table| table.length >= length - SAME);
            let table = longer.min_by(|a, b| a.length.total_cmp(&b.length));
            let point = table.and_then(|table| table.points.iter().find(|point| point[0] >= reach - SAME));
            those(of).next().map(|_| (of, point.map_or(0.0, |point| point[1])))
        };
        (0..s::GOVERNING.items.len())
            .filter_map(of)
            .min_by(|a, b| a.1.total_cmp(&b.1))
    }
}
