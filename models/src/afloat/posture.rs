//! Heel, trim, draft and freeboards under the load.

use crate::afloat::hull::{BoxHull, Floating};
use crate::afloat::loaded::Loaded;
use crate::afloat::rest::rest;
use crate::afloat::symbols as s;
use crate::afloat::upright::Upright;
use crate::afloat::weights::Weighed;
use crate::component::found::{Finding, found};
use crate::component::scalar::Scalar;
use crate::component::stages::results;
use crate::kernel::calc::Calc;
use crate::kernel::group::One;
use crate::kernel::symbol::{Symbol, listed};
use crate::kernel::variable::Fault;

/// Draft (m) and slopes at rest.
struct Resting;

impl Finding<3> for Resting {
    type From<C: Calc> = (Floating<C>, Weighed<C>);
    const NAMES: [&'static Symbol; 3] = *listed!(s: T, T_THETA, T_PHI);

    fn map<C: Calc, D: Calc>(
        (on, all): &(Floating<C>, Weighed<C>),
        f: &mut dyn FnMut(C) -> D,
    ) -> (Floating<D>, Weighed<D>) {
        (on.map(f), all.map(f))
    }

    fn find<C: Calc>((on, all): &(Floating<C>, Weighed<C>)) -> Result<[C; 3], Fault> {
        rest(on, all, None, None).ok_or_else(|| {
            Fault::outside(format!(
                "M_T = {} and M_L = {} at W = {}: the hull has no equilibrium under them; give less load or reach, or a greater hull",
                s::M_T.written(all.across.value()),
                s::M_L.written(all.along.value()),
                s::W.written(all.weight.value()),
            ))
        })
    }
}

/// Draft (m), slopes of the water, heel, trim and inclination (rad), freeboards (m) and the least of them.
#[derive(Clone, Copy, Debug)]
pub struct Posture<C> {
    draft: C,
    /// Along and across the hull.
    slopes: [C; 2],
    angles: [C; 3],
    ends: [[C; 3]; 2],
    corners: [C; 4],
    least: C,
}
results! { Posture as p => {
    T: p.draft;
    T_THETA: p.slopes[0];
    T_PHI: p.slopes[1];
    PHI: p.angles[0];
    THETA: p.angles[1];
    BETA: p.angles[2];
    X_C: p.ends[0][0];
    Y_C: p.ends[0][1];
    Z_C: p.ends[0][2];
    X_A: p.ends[1][0];
    Y_A: p.ends[1][1];
    Z_A: p.ends[1][2];
    F_1: p.corners[0];
    F_2: p.corners[1];
    F_3: p.corners[2];
    F_4: p.corners[3];
    F_LOW: p.least;
} }

impl<C: Calc> Posture<C> {
    /// In rad.
    pub fn heel(&self) -> C {
        self.angles[0]
    }

    /// Of the deck from the horizontal, in rad.
    pub fn inclination(&self) -> C {
        self.angles[2]
    }

    /// Draft (m), slopes of the water along and across the hull.
    pub fn lie(&self) -> [C; 3] {
        [self.draft, self.slopes[0], self.slopes[1]]
    }

    /// Draft (m) and slope of the water in the section at the origin.
    pub fn midship(&self) -> (C, C) {
        (self.draft, self.slopes[1])
    }
}

/// Corners of the deck at bow and stern, on the left.
fn ends<C: Calc>(built: &Option<BoxHull<C>>, deck: &[[C; 3]]) -> [[C; 3]; 2] {
    let names = [listed!(s: X_C, Y_C, Z_C), listed!(s: X_A, Y_A, Z_A)];
    let of = |end: usize, place: [C; 3]| {
        let named = |i: usize| match built {
            Some(_) => place[i].def(names[end][i]),
            None => C::known(names[end][i], place[i].value()).def(names[end][i]),
        };
        [0, 1, 2].map(named)
    };
    let two = C::constant(2.0);
    match built {
        Some(hull) => [
            of(0, [hull.l / two, hull.b / two, hull.d]),
            of(1, [-(hull.l / two), hull.b / two, hull.d]),
        ],
        None => [of(0, deck[deck.len() - 1]), of(1, deck[0])],
    }
}

impl<C: Scalar> Posture<C> {
    /// tan² β = tan² φ + tan² θ; f = (z − T − x tan θ − y tan φ) cos β.
    ///
    /// # Errors
    /// No equilibrium, or a deck under water.
    pub fn new(
        built: &Option<BoxHull<C>>,
        on: &Floating<C>,
        psi: &One<C>,
        load: &One<C>,
        loaded: &Loaded<C>,
        _: &Upright<C>,
    ) -> Result<Posture<C>, Fault> {
        let [draft, along, across] = found::<Resting, C, 3>(&(on.clone(), loaded.all))?;
        let one = C::constant(1.0);
        let squares = across.square() + along.square();
        let both = if squares.value() > 0.0 { squares.sqrt() } else { squares };
        let inclined = C::direction(one, both).def(&s::BETA);
        let (_, cos) = inclined.sin_cos();
        let free = |[x, y, z]: [C; 3], left: bool| {
            let level = z - draft - x * along;
            let over = if left { level - y * across } else { level + y * across };
            over * cos
        };
        let deck = on.deck();
        let [bow, stern] = ends(built, &deck);
        let corners = [
            free(bow, false).def(&s::F_1),
            free(bow, true).def(&s::F_2),
            free(stern, true).def(&s::F_3),
            free(stern, false).def(&s::F_4),
        ];
        let least = match built {
            Some(_) => corners.into_iter().reduce(C::smaller).unwrap_or(cos),
            None => {
                let all = deck.iter().flat_map(|&point| [false, true].map(|left| (point, left)));
                let low = all.min_by(|a, b| free(a.0, a.1).value().total_cmp(&free(b.0, b.1).value()));
                let (point, left) = low.unwrap_or((stern, false));
                let y = if left { point[1] } else { -point[1] };
                let names = listed!(s: X_D, Y_D, Z_D);
                let place = [point[0], y, point[2]];
                free(
                    [0, 1, 2].map(|i| C::known(names[i], place[i].value()).def(names[i])),
                    true,
                )
            }
        };
        let least = least.def(&s::F_LOW);
        let angles = [
            C::direction(one, across).def(&s::PHI),
            C::direction(one, along).def(&s::THETA),
            inclined,
        ];
        if least.value() < 0.0 {
            return Err(Fault::outside(format!(
                "psi_sl = {}: with Q = {} the deck is under water, the least freeboard is f_low = {} at phi = {} and theta = {}; give \
                 less load or reach, other ballast, or a greater hull",
                s::PSI_SL.written(psi.value()),
                s::Q.written(load.value()),
                s::F_LOW.written(least.value()),
                s::PHI.written(angles[0].value()),
                s::THETA.written(angles[1].value()),
            )));
        }
        Ok(Posture {
            draft,
            slopes: [along, across],
            angles,
            ends: [bow, stern],
            corners,
            least,
        })
    }
}
