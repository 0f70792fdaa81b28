//! Sobol's points with the direction numbers of Joe and Kuo, scrambled as Owen does it: by a hash, so that each point is a
//! function of its number and the seed alone. The first 2^k of them lie one in each of 2^k equal parts of every axis.
//!
//! S. Joe, F. Y. Kuo, Constructing Sobol sequences with better two-dimensional projections, SIAM J. Sci. Comput. 30 (2008);
//! B. Burley, Practical hash-based Owen scrambling, J. Comput. Graph. Tech. 9 (2020), with the better hash of N. Vegdahl.

use lemnis_models::study::MOST_VARIED;

const BITS: usize = 32;

/// Of each axis behind the first one its primitive polynomial, a bit for each coefficient, and the first direction numbers.
const AXES: [(u32, &[u32]); MOST_VARIED - 1] = [
    (3, &[1]),
    (7, &[1, 3]),
    (11, &[1, 3, 1]),
    (13, &[1, 1, 1]),
    (19, &[1, 1, 3, 3]),
    (25, &[1, 3, 5, 13]),
    (37, &[1, 1, 5, 5, 17]),
    (41, &[1, 1, 5, 5, 5]),
    (47, &[1, 1, 7, 11, 19]),
    (55, &[1, 1, 5, 1, 1]),
    (59, &[1, 1, 1, 3, 11]),
    (61, &[1, 3, 5, 5, 31]),
    (67, &[1, 3, 3, 9, 7, 49]),
    (91, &[1, 1, 1, 15, 21, 21]),
    (97, &[1, 3, 1, 13, 27, 49]),
    (103, &[1, 1, 1, 15, 7, 5]),
    (109, &[1, 3, 1, 15, 13, 25]),
    (115, &[1, 1, 5, 5, 19, 61]),
    (131, &[1, 3, 7, 11, 23, 15, 103]),
    (137, &[1, 3, 7, 13, 13, 15, 69]),
    (143, &[1, 1, 3, 13, 7, 35, 63]),
    (145, &[1, 3, 5, 9, 1, 25, 53]),
    (157, &[1, 3, 1, 13, 9, 35, 107]),
    (167, &[1, 3, 1, 5, 27, 61, 31]),
    (171, &[1, 1, 5, 11, 19, 41, 61]),
    (185, &[1, 3, 5, 3, 3, 13, 69]),
    (191, &[1, 1, 7, 13, 1, 19, 1]),
    (193, &[1, 3, 7, 5, 13, 19, 59]),
    (203, &[1, 1, 3, 9, 25, 29, 41]),
    (211, &[1, 3, 5, 13, 23, 1, 55]),
    (213, &[1, 3, 7, 3, 13, 59, 17]),
    (229, &[1, 3, 1, 3, 5, 53, 69]),
    (239, &[1, 1, 5, 5, 23, 33, 13]),
    (241, &[1, 1, 7, 7, 1, 61, 123]),
    (247, &[1, 1, 7, 9, 13, 61, 49]),
    (253, &[1, 3, 3, 5, 3, 55, 33]),
    (285, &[1, 3, 1, 15, 31, 13, 49, 245]),
    (299, &[1, 3, 5, 15, 31, 59, 63, 97]),
    (301, &[1, 3, 1, 11, 11, 11, 77, 249]),
    (333, &[1, 3, 1, 11, 27, 43, 71, 9]),
    (351, &[1, 1, 7, 15, 21, 11, 81, 45]),
    (355, &[1, 3, 7, 3, 25, 31, 65, 79]),
    (357, &[1, 3, 1, 1, 19, 11, 3, 205]),
    (361, &[1, 1, 5, 9, 19, 21, 29, 157]),
    (369, &[1, 3, 7, 11, 1, 33, 89, 185]),
    (391, &[1, 3, 3, 3, 15, 9, 79, 71]),
    (397, &[1, 3, 7, 11, 15, 39, 119, 27]),
    (425, &[1, 1, 3, 1, 11, 31, 97, 225]),
    (451, &[1, 1, 1, 3, 23, 43, 57, 177]),
    (463, &[1, 3, 7, 7, 17, 17, 37, 71]),
    (487, &[1, 3, 1, 5, 27, 63, 123, 213]),
    (501, &[1, 1, 3, 5, 11, 43, 53, 133]),
    (529, &[1, 3, 5, 5, 29, 17, 47, 173, 479]),
    (539, &[1, 3, 3, 11, 3, 1, 109, 9, 69]),
    (545, &[1, 1, 1, 5, 17, 39, 23, 5, 343]),
    (557, &[1, 3, 1, 5, 25, 15, 31, 103, 499]),
    (563, &[1, 1, 1, 11, 11, 17, 63, 105, 183]),
    (601, &[1, 1, 5, 11, 9, 29, 97, 231, 363]),
    (607, &[1, 1, 5, 15, 19, 45, 41, 7, 383]),
    (617, &[1, 3, 7, 7, 31, 19, 83, 137, 221]),
    (623, &[1, 1, 1, 3, 23, 15, 111, 223, 83]),
    (631, &[1, 1, 5, 13, 31, 15, 55, 25, 161]),
    (637, &[1, 1, 3, 13, 25, 47, 39, 87, 257]),
];

/// Points of a cube.
#[derive(Clone, Debug)]
pub struct Sobol {
    /// Of each axis.
    directions: Vec<[u32; BITS]>,
    seeds: Vec<u32>,
}

impl Sobol {
    /// # Panics
    /// With more axes than there are direction numbers.
    #[must_use]
    pub fn new(axes: usize, seed: u64) -> Sobol {
        let own = |axis: usize| mixed(seed.wrapping_add((axis as u64 + 1).wrapping_mul(0x9e37_79b9_7f4a_7c15)));
        Sobol {
            directions: (0..axes).map(directions).collect(),
            seeds: (0..axes).map(|axis| (own(axis) >> 32) as u32).collect(),
        }
    }

    /// Where a point lies along an axis, inside (0, 1).
    #[must_use]
    pub fn at(&self, point: u32, axis: usize) -> f64 {
        let bits = (0..BITS).filter(|bit| point >> bit & 1 == 1);
        let place = bits.fold(0, |place, bit| place ^ self.directions[axis][bit]);
        (f64::from(scrambled(place, self.seeds[axis])) + 0.5) / 2.0_f64.powi(BITS as i32)
    }
}

/// What each bit of a point's number adds along an axis.
fn directions(axis: usize) -> [u32; BITS] {
    let mut all = [0_u32; BITS];
    let Some(before) = axis.checked_sub(1) else {
        return std::array::from_fn(|bit| 1 << (BITS - 1 - bit));
    };
    let (polynomial, first) = AXES[before];
    let degree = first.len();
    for bit in 0..BITS {
        all[bit] = match first.get(bit) {
            Some(number) => number << (BITS - 1 - bit),
            None => (1..=degree)
                .filter(|back| polynomial >> (degree - back) & 1 == 1)
                .fold(all[bit - degree] >> degree, |sum, back| sum ^ all[bit - back]),
        };
    }
    all
}

/// Each bit turned or left by a hash of those above it.
fn scrambled(place: u32, seed: u32) -> u32 {
    let mut x = place.reverse_bits();
    x ^= x.wrapping_mul(0x3d20_adea);
    x = x.wrapping_add(seed);
    x = x.wrapping_mul(seed >> 16 | 1);
    x ^= x.wrapping_mul(0x0552_6c56);
    x ^= x.wrapping_mul(0x53a2_2864);
    x.reverse_bits()
}

/// A number that looks like any other. (SplitMix64)
fn mixed(mut x: u64) -> u64 {
    x = (x ^ x >> 30).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    x = (x ^ x >> 27).wrapping_mul(0x94d0_49bb_1331_11eb);
    x ^ x >> 31
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The first 2^k points, and any 2^k that follow a multiple of it, have one in each part of every axis.
    #[test]
    fn every_axis_is_filled_evenly() {
        let points = Sobol::new(MOST_VARIED, 7);
        for k in [1, 5, 10] {
            let count = 1_u32 << k;
            for axis in 0..MOST_VARIED {
                for start in [0, count, 5 * count] {
                    let mut seen = vec![false; count as usize];
                    for point in start..start + count {
                        let part = (points.at(point, axis) * f64::from(count)) as usize;
                        assert!(
                            !std::mem::replace(&mut seen[part], true),
                            "axis {axis}, 2^{k} from {start}"
                        );
                    }
                }
            }
        }
    }

    /// The first two axes make a (0, 2)-sequence: one point in each box of the same area, whatever its sides.
    #[test]
    fn two_axes_fill_boxes_of_any_sides() {
        let (points, k) = (Sobol::new(2, 3), 8_u32);
        for wide in 0..=k {
            let (columns, rows) = (1_u32 << wide, 1_u32 << (k - wide));
            let mut seen = vec![false; 1 << k];
            for point in 0..1 << k {
                let part = |axis, parts: u32| (points.at(point, axis) * f64::from(parts)) as usize;
                let at = part(0, columns) * rows as usize + part(1, rows);
                assert!(!std::mem::replace(&mut seen[at], true), "{columns} by {rows}");
            }
        }
    }

    #[test]
    fn a_seed_gives_other_points() {
        let [a, b] = [1, 2].map(|seed| Sobol::new(1, seed));
        assert!((0..16).any(|point| a.at(point, 0) != b.at(point, 0)));
    }
}
