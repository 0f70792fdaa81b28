//! A column as a component: what it is given, and in which stages its equations follow from each other.

use crate::component::fragments::composed;
use crate::component::part::{Component, Port, ports};
use crate::component::stages::Found;
use crate::component::whole::Whole;
use crate::kernel::group::One;
use crate::kernel::symbol::Symbol;
use crate::supports::column::bearings::{ColumnForces, WorstBearings};
use crate::supports::column::counterweight::{Evened, EvenedAt};
use crate::supports::column::friction::{ColumnFriction, ColumnTurning, pivot_radius, rubbing};
use crate::supports::column::pressure::{BearingPressure, Bearings};
use crate::supports::column::symbols as s;
use crate::supports::drive;
use crate::supports::drive::fragments::{has_what_slews, swung, turned, turned_by};
use crate::supports::upper::fragments::{carried, luffs, reached, slews};
use crate::supports::upper::load::{SupportLoad, WorstLoad};

composed! {
    /// A column under a crane.
    SlewingColumn over C from {
        ..slews(),
        Parameter height: One<C>,
        ..carried(),
        ..luffs(),
        Parameter bearings: Option<Bearings<C>>,
        Parameter friction: Option<ColumnFriction<C>>,
        Parameter balancing: Option<EvenedAt<C>>,
        ..turned_by(),
    } find {
        ..reached();
        loads[each cases]: Vec<SupportLoad<C>> = SupportLoad::new(psi, out, load, slope, upper, cases[each]);
        worst: WorstLoad<C> = WorstLoad::new(loads);
        forces[each cases]: Vec<ColumnForces<C>> = ColumnForces::new(height, loads[each]);
        most: WorstBearings<C> = WorstBearings::new(forces);
        pivot: C = pivot_radius(bearings[!], friction[!]) => R_P;
        turning[each cases]: Vec<ColumnTurning<C>> =
            ColumnTurning::new(bearings[!], friction[!], pivot, loads[each], forces[each]);
        pressures[each cases]: Vec<BearingPressure<C>> =
            BearingPressure::new(bearings[!], loads[each], forces[each]);
        evened: Evened<C> = Evened::new(balancing[!], upper, load, out);
        ..swung();
        rubbing[each works]: Vec<C> = rubbing(drive[!], turning[each]) => M_FS;
        ..turned();
    }
}

impl Component for SlewingColumn {
    const WHOLE: &'static [Whole] = &drive::outline::WHOLE;

    const PORTS: &'static [Port] = ports! { s:
        axis "Slewing axis.": phi PSI, w OMEGA;
        head "Boom head, where the load hangs.": r R, f Q;
        bearing "The upper bearing in a load case.": fr H_U;
        foot "Foot bearing and pivot in a load case.": fz V, fr H_F;
    };

    has_what_slews!();

    fn is_input(given: &Given<f64>, symbol: &'static Symbol) -> bool {
        given.open.0.contains(&symbol)
    }

    fn update(known: &mut Known<f64>) -> Found<()> {
        known.upper().map(|_| ())
    }
}
