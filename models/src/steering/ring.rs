//! The slewing ring of a group, chosen from a maker's load curves. [Zhang2016, 4]

use crate::component::sheet::{Curve, Table};
use crate::kernel::calc::Calc;
use crate::kernel::group::quantities;
use crate::kernel::number::short;
use crate::kernel::symbol::Symbol;
use crate::parts::load_curve::{LoadCurve, corner};
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
/// N·m. A maker's formula for ball bearings, without radial load. [Rothe Erde]
#[inline]
pub fn friction<C: Calc>(ring: &Bearing<C>, f_a: C) -> C {
    let load = C::constant(4.4) * f_a * ring.l_max + f_a * ring.d_l;
    (ring.mu_r / C::constant(2.0) * load).def(&s::M_F)
}

/// What a point of a load curve is called.
const POINT_NAMES: [&Symbol; 2] = [&s::F_CURVE, &s::M_CURVE];

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
    pub fn use_of<C: Calc>(&self, duty: &Duty<C>) -> Option<[C; 2]> {
        let ring = self.ring.limit(duty.f, 0, POINT_NAMES)?.def(&s::M_RING);
        let bolts = self
            .bolts
            .limit(duty.f_bolt, self.ring.0.len() as u16, POINT_NAMES)?
            .def(&s::M_BOLTS);
        Some([
            (duty.m / ring).def(&s::RING_USE),
            (duty.m_bolt / bolts).def(&s::BOLT_USE),
        ])
    }

    /// The points of both curves, numbered one after the other.
    #[must_use]
    pub fn points(&self) -> Table {
        let all = self.ring.0.iter().chain(&self.bolts.0);
        Table {
            columns: vec![&s::POINT, &s::F_CURVE, &s::M_CURVE],
            rows: (1..).zip(all).map(|(i, [f, m])| vec![f64::from(i), *f, *m]).collect(),
        }
    }

    /// The curves of ring and bolts, 1 and 2, and the duty of both, the corners of 3 and 4.
    #[must_use]
    pub fn curves(&self, duty: &Duty<f64>) -> Curve {
        Curve {
            id: "ring",
            x: &s::F_CURVE,
            y: &s::M_CURVE,
            pieces: vec![
                self.ring.0.clone(),
                self.bolts.0.clone(),
                corner([duty.f, duty.m]),
                corner([duty.f_bolt, duty.m_bolt]),
            ],
            numbers: vec![1, 2, 3, 4],
        }
    }
}

/// Rings from the smallest to the greatest.
#[derive(Clone, Debug, PartialEq)]
pub struct Catalogue {
    pub rings: Vec<Ring>,
}

impl Catalogue {
    /// The ring with the raceway of a bearing; the first that bears the duty where none has it.
    #[must_use]
    pub fn chosen(&self, bearing: &Bearing<f64>, duty: &Duty<f64>) -> Option<&Ring> {
        let same = self.rings.iter().find(|ring| ring.d_l == bearing.d_l);
        same.or_else(|| self.choose(duty).ok()).or(self.rings.last())
    }

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
