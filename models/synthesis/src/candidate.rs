//! One candidate of a search over the whole working range, fast: the boom's
//! side is computed once, the linkage closes by squares of lengths alone. What
//! a search finds is computed again by [`Analysis`](lemnis_models::balance::analysis::Analysis).

use lemnis_models::balance::boom::Boom;
use lemnis_models::balance::lever::Dimensions;
use lemnis_models::balance::symbols as s;
use lemnis_models::kernel::allowed::{OutOfRange, POSITIVE};
use lemnis_models::kernel::calc::Calc;
use lemnis_models::parts::four_bar::Branch;

/// The boom at equally spaced positions of its working range.
#[derive(Clone, Debug)]
pub struct Positions {
    /// First and last boom angle, in rad.
    pub range: [f64; 2],
    places: Vec<Place>,
    /// Greatest amount of the moment to be balanced, in N·m.
    pub scale: f64,
}

#[derive(Clone, Copy, Debug)]
struct Place {
    sin: f64,
    cos: f64,
    m_0: f64,
    /// What each weight of the boom system contributes to it, in N·m.
    parts: [f64; 3],
}

/// The linkage at one position.
struct Bar {
    place: Place,
    /// The rod arm of the lever, in m.
    lever: [f64; 2],
    /// Arm of the rod about the boom foot times the rod's length, in m².
    rod_arm: f64,
    /// ±4 × the area of the triangle of diagonal, rod and lever, in m².
    area: f64,
}

/// What a candidate is worth.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Criteria {
    /// Greatest amount of the residual about the boom foot, in N·m.
    pub dm_max: f64,
    /// ∫ |dM| dφ by the trapezoidal rule, in J.
    pub e_abs: f64,
    /// Greatest amount of the force in the rod, in N.
    pub n_max: f64,
    /// Sine of the smallest transmission angle.
    pub sin_gamma: f64,
    /// Residual at both ends, in N·m.
    pub ends: [f64; 2],
    /// Greatest cosine of the counterweight arm's angle: negative where the
    /// counterweight stays behind the lever's pivot.
    pub cos_psi: f64,
}

impl Positions {
    /// `count` positions over the boom angles `range` (rad).
    ///
    /// # Errors
    /// A range that is empty or where the boom does not close; a boom without
    /// moment, which needs no balance.
    pub fn new(boom: &(dyn Boom<f64> + Sync), range: [f64; 2], count: usize) -> Result<Positions, OutOfRange> {
        let [from, to] = range;
        if !(from < to && from.is_finite() && to.is_finite() && count >= 2) {
            return Err(OutOfRange::new(
                &s::PHI,
                to,
                [from, f64::INFINITY],
                "the working range is empty",
            ));
        }
        let place = |i: usize| {
            let phi = from + (to - from) * i as f64 / (count - 1) as f64;
            let (sin, cos) = Calc::sin_cos(phi);
            let phi = if i + 1 == count { to } else { phi };
            let m_0 = boom.at(phi)?.m_0;
            let parts = boom.parts(phi)?;
            Ok(Place { sin, cos, m_0, parts })
        };
        let places = (0..count).map(place).collect::<Result<Vec<Place>, OutOfRange>>()?;
        let scale = places.iter().map(|place| place.m_0.abs()).fold(0.0, f64::max);
        if scale == 0.0 {
            let what = "the boom has no moment: there is nothing to balance";
            return Err(OutOfRange::new(&s::M_0, 0.0, POSITIVE, what));
        }
        Ok(Positions { range, places, scale })
    }

    /// The same positions with each weight of the boom system stretched by a factor.
    #[must_use]
    pub fn weighted(&self, factors: [f64; 3]) -> Positions {
        let mut other = self.clone();
        for place in &mut other.places {
            place.m_0 = place
                .parts
                .iter()
                .zip(factors)
                .map(|(part, factor)| part * factor)
                .sum();
        }
        other
    }

    /// # Errors
    /// Where the linkage does not close everywhere: by how much the worst
    /// position misses, relative to the square of the frame.
    #[inline]
    pub fn evaluate(&self, d: &Dimensions<f64>, branch: Branch) -> Result<Criteria, f64> {
        let (sin_c, cos_c) = Calc::sin_cos(d.chi_5);
        // Counterweight's moment over the rod arm's length.
        let (along_m, across_m) = (d.m_5 * cos_c / d.lever, d.m_5 * sin_c / d.lever);
        let mut miss = 0.0_f64;
        let (mut dm_max, mut sum, mut n_max) = (0.0_f64, 0.0, 0.0_f64);
        let (mut area_min, mut moment_min) = (f64::INFINITY, f64::INFINITY);
        let mut ends = [0.0; 2];
        self.each(d, branch, |i, position| match position {
            Ok(Bar {
                place,
                lever,
                rod_arm,
                area,
            }) => {
                // The moment about the pivot, then the rod's force over its length.
                let about = along_m * lever[0] - across_m * lever[1];
                let force = -2.0 * about / area;
                let dm = place.m_0 + force * rod_arm;
                dm_max = dm_max.max(dm.abs());
                sum += dm.abs();
                n_max = n_max.max(force.abs());
                area_min = area_min.min(area.abs());
                moment_min = moment_min.min(-about);
                if i == 0 {
                    ends[0] = dm;
                }
                ends[1] = dm;
            }
            Err(short) => miss = miss.max(short),
        });
        if miss > 0.0 {
            return Err(miss / (d.d_1 * d.d_1));
        }
        let [from, to] = self.range;
        let step = (to - from) / (self.places.len() - 1) as f64;
        Ok(Criteria {
            dm_max,
            e_abs: step * (sum - 0.5 * (ends[0].abs() + ends[1].abs())),
            n_max: n_max * d.l_1,
            sin_gamma: area_min / (2.0 * d.l_1 * d.lever),
            ends,
            cos_psi: -moment_min / d.m_5.max(f64::MIN_POSITIVE),
        })
    }

    /// The linkage at each position, or by how much (m²) it does not close there.
    #[inline(always)]
    fn each(&self, d: &Dimensions<f64>, branch: Branch, mut use_it: impl FnMut(usize, Result<Bar, f64>)) {
        let (sin_a, cos_a) = Calc::sin_cos(d.alpha_1);
        let (sin_d, cos_d) = Calc::sin_cos(d.delta_1);
        let pivot = [d.d_1 * cos_d, d.d_1 * sin_d];
        let joint = [d.r_1 * cos_a, d.r_1 * sin_a];
        let (l, r) = (d.l_1, d.lever);
        let (outer, inner) = ((l + r) * (l + r), (l - r) * (l - r));
        let balance = (r - l) * (r + l);
        let sign = if branch == Branch::Left { 1.0 } else { -1.0 };
        for (i, &place) in self.places.iter().enumerate() {
            let k = [
                joint[0] * place.cos - joint[1] * place.sin,
                joint[1] * place.cos + joint[0] * place.sin,
            ];
            let g = [k[0] - pivot[0], k[1] - pivot[1]];
            let square = g[0] * g[0] + g[1] * g[1];
            let (stretched, folded) = (outer - square, square - inner);
            if !(stretched > 0.0 && folded > 0.0) {
                use_it(i, Err((-stretched).max(-folded).max(f64::MIN_POSITIVE)));
                continue;
            }
            let area = sign * (stretched * folded).sqrt();
            let half = 0.5 / square;
            let (of_lever, of_rod) = ((square + balance) * half, (balance - square) * half);
            let across = area * half;
            let lever = [of_lever * g[0] - across * g[1], of_lever * g[1] + across * g[0]];
            let rod = [of_rod * g[0] - across * g[1], of_rod * g[1] + across * g[0]];
            let rod_arm = k[0] * rod[1] - k[1] * rod[0];
            use_it(
                i,
                Ok(Bar {
                    place,
                    lever,
                    rod_arm,
                    area,
                }),
            );
        }
    }

    /// Smallest and greatest distance of the joint on the boom from the lever's pivot, in m.
    pub(crate) fn diagonals(&self, d: &Dimensions<f64>) -> [f64; 2] {
        let direction = d.delta_1 - d.alpha_1;
        let (sin, cos) = Calc::sin_cos(direction);
        let squares = self.places.iter().map(|place| {
            let cosine = place.cos * cos + place.sin * sin;
            d.d_1 * d.d_1 + d.r_1 * d.r_1 - 2.0 * d.d_1 * d.r_1 * cosine
        });
        squares.fold([f64::INFINITY, 0.0], |[low, high], square| {
            let length = square.max(0.0).sqrt();
            [low.min(length), high.max(length)]
        })
    }

    /// The counterweight's moment (N·m) and angle (rad) that balance this
    /// linkage best in the mean square; `None` where it does not close everywhere.
    pub(crate) fn counterweight(&self, d: &Dimensions<f64>, branch: Branch) -> Option<[f64; 2]> {
        let mut sums = [0.0; 5];
        let mut open = false;
        self.each(d, branch, |_, position| match position {
            Ok(Bar {
                place,
                lever,
                rod_arm,
                area,
                ..
            }) => {
                // dM = M_0 + p a + q b with p, q = M_5 cos, sin of chi_5.
                let ratio = -2.0 * rod_arm / (area * d.lever);
                let (a, b) = (ratio * lever[0], -ratio * lever[1]);
                for (sum, term) in sums.iter_mut().zip([a * a, a * b, b * b, a * place.m_0, b * place.m_0]) {
                    *sum += term;
                }
            }
            Err(_) => open = true,
        });
        let [aa, ab, bb, am, bm] = sums;
        let determinant = aa * bb - ab * ab;
        if open || determinant.is_nan() || determinant <= 0.0 {
            return None;
        }
        let (p, q) = ((bm * ab - am * bb) / determinant, (am * ab - bm * aa) / determinant);
        Some([(p * p + q * q).sqrt(), f64::direction(p, q)])
    }
}
