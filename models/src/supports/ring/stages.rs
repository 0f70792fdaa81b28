//! A slewing ring as a component: what it is given, and in which stages its equations follow from each other.

use crate::component::fragments::composed;
use crate::component::part::{Component, Port, ports};
use crate::component::stages::Found;
use crate::component::whole::Whole;
use crate::kernel::group::One;
use crate::kernel::symbol::{Symbol, listed};
use crate::parts::load_curve::LoadCurve;
use crate::supports::drive;
use crate::supports::drive::fragments::{has_what_slews, swung, turned, turned_by};
use crate::supports::ring::bolts::{BoltForces, RingBolts};
use crate::supports::ring::capacity::{Equivalent, StaticLoad, static_loads};
use crate::supports::ring::contact::{ContactStress, Hardness, RollingContact};
use crate::supports::ring::elements::{AllCases, MomentAlone, Raceway, RollingForces, spreads};
use crate::supports::ring::friction::{ElementFriction, MakerForm, MakerFriction, by_elements, by_maker, rubbing};
use crate::supports::ring::law::RollingElements;
use crate::supports::ring::life::{DynamicCapacity, RacewayLife};
use crate::supports::ring::symbols as s;
use crate::supports::upper::fragments::{carried, luffs, reached, slews};
use crate::supports::upper::load::{SupportLoad, WorstLoad};

composed! {
    /// A slewing ring under a crane.
    SlewingRing over C from {
        ..slews(),
        Parameter raceway: Raceway<C>,
        ..carried(),
        ..luffs(),
        Parameter contact: Option<RollingContact<C>>,
        Parameter length: Option<One<C>>,
        Parameter equivalent: Option<Equivalent<C>>,
        Parameter friction: Option<ElementFriction<C>>,
        Parameter maker: Option<MakerFriction<C>>,
        Parameter bolts: Option<RingBolts<C>>,
        Parameter dynamic: Option<DynamicCapacity<C>>,
        Fixed rolling: RollingElements,
        Fixed curve: LoadCurve,
        Fixed form: MakerForm,
        ..turned_by(),
    } find {
        alone: MomentAlone<C> = MomentAlone::new(rolling);
        ..reached();
        loads[each cases]: Vec<SupportLoad<C>> = SupportLoad::new(psi, out, load, slope, upper, cases[each]);
        spreads[cases]: Vec<RollingForces<C>> = spreads(psi, raceway, rolling, loads);
        worst: WorstLoad<C> = WorstLoad::new(loads);
        all: AllCases<C> = AllCases::new(spreads);
        hardness: Hardness<C> = Hardness::new(contact[!]);
        stresses[each cases]: Vec<ContactStress<C>> =
            ContactStress::new(contact[!], length, hardness, spreads[each]);
        statics[cases]: Vec<StaticLoad<C>> = static_loads(curve, equivalent[!], loads);
        turning[each cases]: Vec<C> = by_elements(raceway, friction[!], spreads[each]) => M_FN;
        makers[each cases]: Vec<C> = by_maker(raceway, form, maker[!], loads[each]) => M_FM;
        bolted[each cases]: Vec<BoltForces<C>> = BoltForces::new(bolts[!], loads[each]);
        lives[each cases]: Vec<RacewayLife<C>> = RacewayLife::new(rolling, dynamic[!], loads[each], spreads[each]);
        ..swung();
        rubbing[works]: Vec<C> = rubbing(drive[!], turning[?], makers[?]) => M_FS;
        ..turned();
    }
}

impl Component for SlewingRing {
    const WHOLE: &'static [Whole] = &drive::outline::WHOLE;

    const INDICATORS: &'static [&'static Symbol] = listed!(s: Z_LIFT);

    const PORTS: &'static [Port] = ports! { s:
        axis "Slewing axis.": phi PSI, w OMEGA;
        head "Boom head, where the load hangs.": r R, f Q;
        ring "The ring in a load case.": fz V, fr H, tau M;
    };

    has_what_slews!();

    fn is_input(given: &Given<f64>, symbol: &'static Symbol) -> bool {
        given.open.0.contains(&symbol)
    }

    fn update(known: &mut Known<f64>) -> Found<()> {
        known.spreads().map(|_| ())
    }
}
