//! The upright hull and its metacentric heights.

use crate::afloat::hull::Floating;
use crate::afloat::loaded::Loaded;
use crate::afloat::rest::quiet;
use crate::afloat::symbols as s;
use crate::afloat::weights::TankGiven;
use crate::component::found::{Finding, found};
use crate::component::scalar::Scalar;
use crate::component::stages::{absent, results};
use crate::kernel::calc::{Calc, sum};
use crate::kernel::group::One;
use crate::kernel::symbol::{Symbol, listed};
use crate::kernel::variable::Fault;

/// The upright hull at a volume.
struct Floated;

impl Finding<8> for Floated {
    type From<C: Calc> = (Floating<C>, C);
    const NAMES: [&'static Symbol; 8] = *listed!(s: T_0, X_B, Z_B, A_WP, I_T, I_L, PHI_D, PHI_B);

    fn map<C: Calc, D: Calc>((on, volume): &(Floating<C>, C), f: &mut dyn FnMut(C) -> D) -> (Floating<D>, D) {
        (on.map(f), f(*volume))
    }

    fn find<C: Calc>((on, volume): &(Floating<C>, C)) -> Result<[C; 8], Fault> {
        let zero = C::constant(0.0);
        let hull = on.map(&mut |x| x.value());
        let [_, top] = hull.hull.heights([0.0; 2]);
        let whole = hull.cut([top + 1.0, 0.0, 0.0]).volume;
        if volume.value() >= whole {
            return Err(Fault::outside(format!(
                "it weighs as much as nabla = {} of water, and the whole hull has {}: it sinks; give less weight or a greater hull",
                s::NABLA.written(volume.value()),
                s::NABLA.written(whole),
            )));
        }
        let level = C::constant(hull.level([0.0; 2], volume.value(), None));
        let cut = on.cut([level, zero, zero]);
        // A last step of Newton's method brings the derivatives.
        let draft = level + (*volume - cut.volume) / cut.area;
        let cut = on.cut([draft, zero, zero]);
        let [along, _, across] = cut.central();
        // Of a hull that is alike at both ends rounding alone leaves something.
        let rounding = 1e-13 * (along / cut.area).sqrt().value();
        let middle = quiet(cut.moment[0] / cut.volume, rounding);
        let least = |angles: Vec<C>| angles.into_iter().reduce(C::smaller).unwrap_or(zero);
        let deck = on.deck().into_iter().map(|[_, y, z]| C::direction(y, z - draft));
        let sides = on.sides(draft);
        let sides = (sides.iter()).flat_map(|&[y, low, high]| [draft - low, high - draft].map(|z| C::direction(y, z)));
        Ok([
            draft,
            middle,
            cut.moment[2] / cut.volume,
            cut.area,
            across,
            along,
            least(deck.collect()),
            least(sides.collect()),
        ])
    }
}

/// How far beside the centre line the upright hull bears, at a draft.
struct Aside;

impl Finding<1> for Aside {
    type From<C: Calc> = (Floating<C>, C);
    const NAMES: [&'static Symbol; 1] = *listed!(s: Y_B);

    fn map<C: Calc, D: Calc>(from: &(Floating<C>, C), f: &mut dyn FnMut(C) -> D) -> (Floating<D>, D) {
        Floated::map(from, f)
    }

    fn find<C: Calc>((on, draft): &(Floating<C>, C)) -> Result<[C; 1], Fault> {
        let zero = C::constant(0.0);
        let cut = on.cut([*draft, zero, zero]);
        Ok([cut.moment[1] / cut.volume])
    }
}

/// The upright hull: volume (m³), draft and centre of buoyancy (m), waterplane (m², m⁴), metacentric radii and heights (m), and
/// heels (rad) up to which its form holds.
#[derive(Clone, Copy, Debug)]
pub struct Upright<C> {
    volume: C,
    pub hull: [C; 8],
    /// Centre of buoyancy beside the centre line (m), of a hull with flooded compartments.
    pub aside: Option<C>,
    pub radius: [C; 2],
    lost: Option<[C; 2]>,
    pub height: [C; 2],
}
results! { Upright as u => {
    NABLA: u.volume;
    T_0: u.hull[0];
    X_B: u.hull[1];
    Z_B: u.hull[2];
    A_WP: u.hull[3];
    I_T: u.hull[4];
    I_L: u.hull[5];
    BM: u.radius[0];
    BM_L: u.radius[1];
    GG: u.lost.ok_or_else(absent)?[0];
    GG_L: u.lost.ok_or_else(absent)?[1];
    GM: u.height[0];
    GM_L: u.height[1];
    PHI_D: u.hull[6];
    PHI_B: u.hull[7];
    Y_B: u.aside.ok_or_else(absent)?;
} }

impl<C: Calc> Upright<C> {
    /// Area of the waterplane, in m².
    pub fn waterplane(&self) -> C {
        self.hull[3]
    }
}

impl<C: Scalar> Upright<C> {
    /// ∇ = W/(ρ g), BM = I/∇, GG = Σ ρ_t g i_t/W, GM = z_B + BM − z_G − GG. [Ports001, 7.3]
    ///
    /// # Errors
    /// A hull that sinks, or has no upright equilibrium.
    pub fn new(
        on: &Floating<C>,
        density: &One<C>,
        gravity: &One<C>,
        tanks: &[TankGiven<C>],
        loaded: &Loaded<C>,
    ) -> Result<Upright<C>, Fault> {
        let weight = loaded.all.weight;
        let volume = (weight / (**density * **gravity)).def(&s::NABLA);
        let hull = found::<Floated, C, 8>(&(on.clone(), volume))?;
        let aside = (on.is_open())
            .then(|| found::<Aside, C, 1>(&(on.clone(), hull[0])))
            .transpose()?
            .map(|[aside]| aside);
        let [_, _, buoyancy, _, across, along, ..] = hull;
        let radius = [(across / volume).def(&s::BM), (along / volume).def(&s::BM_L)];
        let lost = (!tanks.is_empty()).then(|| {
            let of = |i: usize| {
                let each = tanks.iter().map(|tank| tank.rho_t * **gravity * tank.seconds()[i]);
                sum(each) / weight
            };
            [of(0).def(&s::GG), of(1).def(&s::GG_L)]
        });
        let height = [(0, &s::GM), (1, &s::GM_L)].map(|(i, symbol)| {
            let own = buoyancy + radius[i] - loaded.height;
            lost.map_or(own, |lost| own - lost[i]).def(symbol)
        });
        for (height, radius, symbol, what) in [
            (height[0], radius[0], &s::GM, "lolls to a heel of about"),
            (height[1], radius[1], &s::GM_L, "trims to about"),
        ] {
            if height.value() <= 0.0 {
                let slope = (-2.0 * height.value() / radius.value()).sqrt();
                return Err(Fault::outside(format!(
                    "{} = {}: the hull has no upright equilibrium, with W = {} it {what} {}; lower the weights, or give a greater \
                     breadth or less free surface",
                    symbol.id,
                    symbol.written(height.value()),
                    s::W.written(weight.value()),
                    s::PHI.written(f64::direction(1.0, slope)),
                )));
            }
        }
        Ok(Upright {
            volume,
            hull,
            aside,
            radius,
            lost,
            height,
        })
    }
}
