//! A slewing ring as a component: what it is given, and in which stages its equations follow from each other.

use crate::component::part::{Component, Port, ports};
use crate::component::stages::{Found, stages};
use crate::kernel::group::One;
use crate::kernel::symbol::{Symbol, listed};
use crate::parts::load_curve::LoadCurve;
use crate::supports::plan::LeftOpen;
use crate::supports::ring::capacity::{Equivalent, StaticLoad, static_loads};
use crate::supports::ring::contact::{ContactStress, Hardness, RollingContact};
use crate::supports::ring::elements::{AllCases, MomentAlone, Raceway, RollingForces, spreads};
use crate::supports::ring::friction::{ElementFriction, MakerForm, MakerFriction, by_elements, by_maker};
use crate::supports::ring::law::RollingElements;
use crate::supports::ring::load::{RingCase, RingLoad};
use crate::supports::ring::symbols as s;
use crate::supports::ring::weights::{RingArea, RingBody, RingSlope, UpperWorks};

stages! {
    /// A slewing ring under a crane.
    SlewingRing over C from {
        Coordinate psi: One<C>,
        Rate omega: One<C>,
        Parameter reach: One<C>,
        Parameter load: One<C>,
        Parameter raceway: Raceway<C>,
        Parameter bodies: Vec<RingBody<C>>,
        Parameter areas: Vec<RingArea<C>>,
        Parameter slope: Option<RingSlope<C>>,
        Parameter cases: Vec<RingCase<C>>,
        Parameter contact: Option<RollingContact<C>>,
        Parameter length: Option<One<C>>,
        Parameter equivalent: Option<Equivalent<C>>,
        Parameter friction: Option<ElementFriction<C>>,
        Parameter maker: Option<MakerFriction<C>>,
        Fixed rolling: RollingElements,
        Fixed curve: LoadCurve,
        Fixed form: MakerForm,
        Fixed open: LeftOpen,
    } find {
        alone: MomentAlone<C> = MomentAlone::new(rolling);
        upper: UpperWorks<C> = UpperWorks::new(bodies, slope, areas);
        loads[each cases]: Vec<RingLoad<C>> = RingLoad::new(psi, reach, load, slope, upper, cases[each]);
        spreads[cases]: Vec<RollingForces<C>> = spreads(psi, raceway, rolling, loads);
        all: AllCases<C> = AllCases::new(loads, spreads);
        hardness: Hardness<C> = Hardness::new(contact[!]);
        stresses[each cases]: Vec<ContactStress<C>> =
            ContactStress::new(contact[!], length, hardness, spreads[each]);
        statics[cases]: Vec<StaticLoad<C>> = static_loads(curve, equivalent[!], loads);
        turning[each cases]: Vec<C> = by_elements(raceway, friction[!], spreads[each]) => M_FN;
        makers[each cases]: Vec<C> = by_maker(raceway, form, maker[!], loads[each]) => M_FM;
    }
}

impl Component for SlewingRing {
    const INDICATORS: &'static [&'static Symbol] = listed!(s: Z_LIFT);

    const PORTS: &'static [Port] = ports! { s:
        axis "Slewing axis.": phi PSI, w OMEGA;
        head "Boom head, where the load hangs.": r R, f Q;
        ring "The ring in a load case.": fz V, fr H, tau M;
    };

    /// Without slope and wind there is nothing of them.
    fn has(given: &Given<f64>, symbol: &'static Symbol) -> bool {
        let there = |of: &[&'static Symbol]| of.contains(&symbol);
        let inclined = given.slope.is_some() || !there(listed!(s: S_U, M_GAMMA));
        let blown = !given.areas.is_empty() || !there(listed!(s: A_SUM, S_W, BETA_W, F_W, M_W));
        inclined && blown
    }

    fn is_input(given: &Given<f64>, symbol: &'static Symbol) -> bool {
        given.open.0.contains(&symbol)
    }

    fn update(known: &mut Known<f64>) -> Found<()> {
        known.spreads().map(|_| ())
    }
}
