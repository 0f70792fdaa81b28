//! The slewing ring of a group, chosen from a maker's load curves. [Zhang2016, 4]

use crate::kernel::calc::Calc;
use crate::kernel::group::quantities;
use crate::kernel::number::short;
use crate::steering::refusal::Refusal;
use crate::steering::symbols as s;

quantities! {
    /// A group's slewing ring: greatest arm of the vertical force (m), friction, diameter of the raceway (m).
    Bearing { l_max: L_MAX, mu_r: MU_R, d_l: D_L }
}

quantities! {
    /// Safety factor of the use, and factor of the test load. The paper takes 1.25 for both.
    Safety { f_s: F_S, k_test: K_TEST }
}

/// What the curves must bear: force (N) and overturning moment (N·m).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Duty<C> {
    /// Static reference load of the ring.
    pub f: C,
    pub m: C,
    /// Load of the bolts.
    pub f_bolt: C,
    pub m_bolt: C,
}

impl<C: Calc> Duty<C> {
    /// F_a′ = 1.25 F_s F_a, M′ = F_a′ L_max; for the bolts without F_s. [Zhang2016, 4]
    pub fn new(ring: &Bearing<C>, safety: &Safety<C>, f_a: C) -> Duty<C> {
        Duty {
            f: (safety.k_test * safety.f_s * f_a).def(&s::F_A_REF),
            m: (safety.k_test * safety.f_s * f_a * ring.l_max).def(&s::M_REF),
            f_bolt: (safety.k_test * f_a).def(&s::F_BOLT),
            m_bolt: (safety.k_test * f_a * ring.l_max).def(&s::M_BOLT),
        }
    }
}

/// Friction moment of a ring under a vertical force (N) at its greatest arm, in
/// N·m. Form of makers' catalogues, without radial load.
#[inline]
pub fn friction<C: Calc>(ring: &Bearing<C>, f_a: C) -> C {
    let load = C::constant(4.4) * f_a * ring.l_max + f_a * ring.d_l;
    (ring.mu_r / C::constant(2.0) * load).def(&s::M_F)
}

/// A load curve: points (force N, moment N·m) with rising force.
#[derive(Clone, Debug, PartialEq)]
pub struct LoadCurve(pub Vec<[f64; 2]>);

impl LoadCurve {
    /// The moment that may act with a force, in N·m; `None` beyond the curve.
    #[must_use]
    pub fn limit(&self, f: f64) -> Option<f64> {
        self.0.windows(2).find_map(|pair| {
            let ([f_1, m_1], [f_2, m_2]) = (pair[0], pair[1]);
            (f >= f_1 && f <= f_2 && f_2 > f_1).then(|| m_1 + (m_2 - m_1) * (f - f_1) / (f_2 - f_1))
        })
    }
}

/// A ring of a catalogue.
#[derive(Clone, Debug, PartialEq)]
pub struct Ring {
    pub name: String,
    /// Diameter of the raceway, in m.
    pub d_l: f64,
    pub ring: LoadCurve,
    pub bolts: LoadCurve,
}

impl Ring {
    /// Moment over the moment allowed, of the ring and of its bolts; `None` where the force alone is too great.
    #[must_use]
    pub fn use_of(&self, duty: &Duty<f64>) -> Option<[f64; 2]> {
        Some([
            duty.m / self.ring.limit(duty.f)?,
            duty.m_bolt / self.bolts.limit(duty.f_bolt)?,
        ])
    }
}

/// Rings from the smallest to the greatest.
#[derive(Clone, Debug, PartialEq)]
pub struct Catalogue {
    pub rings: Vec<Ring>,
}

impl Catalogue {
    /// The first ring whose curves lie above the duty of ring and bolts.
    pub fn choose(&self, duty: &Duty<f64>) -> Result<&Ring, Refusal> {
        let fits = |ring: &&Ring| {
            ring.use_of(duty)
                .is_some_and(|parts| parts.iter().all(|part| *part <= 1.0))
        };
        self.rings.iter().find(fits).ok_or_else(|| {
            Refusal::new(
                "F_a_ref",
                format!(
                    "no ring of the catalogue bears F_a_ref = {} kN with M_ref = {} kN.m",
                    short(duty.f / 1e3),
                    short(duty.m / 1e3)
                ),
                "give a catalogue with greater rings, or less load or arm",
            )
        })
    }
}
