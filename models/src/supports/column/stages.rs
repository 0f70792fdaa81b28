//! A column as a component: what it is given, and in which stages its equations follow from each other.

use crate::component::part::{Component, Port, ports};
use crate::component::stages::{Found, stages};
use crate::kernel::group::One;
use crate::kernel::symbol::Symbol;
use crate::supports::column::bearings::{ColumnForces, WorstBearings};
use crate::supports::column::counterweight::{Evened, EvenedAt};
use crate::supports::column::friction::{ColumnFriction, ColumnTurning, pivot_radius};
use crate::supports::column::pressure::{BearingPressure, Bearings};
use crate::supports::column::symbols as s;
use crate::supports::plan::LeftOpen;
use crate::supports::upper;
use crate::supports::upper::load::{SupportCase, SupportLoad, WorstLoad};
use crate::supports::upper::weights::{UpperArea, UpperSlope, UpperWeight, UpperWorks};

stages! {
    /// A column under a crane.
    SlewingColumn over C from {
        Coordinate psi: One<C>,
        Rate omega: One<C>,
        Parameter reach: One<C>,
        Parameter load: One<C>,
        Parameter height: One<C>,
        Parameter bodies: Vec<UpperWeight<C>>,
        Parameter areas: Vec<UpperArea<C>>,
        Parameter slope: Option<UpperSlope<C>>,
        Parameter cases: Vec<SupportCase<C>>,
        Parameter bearings: Option<Bearings<C>>,
        Parameter friction: Option<ColumnFriction<C>>,
        Parameter balancing: Option<EvenedAt<C>>,
        Fixed open: LeftOpen,
    } find {
        upper: UpperWorks<C> = UpperWorks::new(bodies, slope, areas);
        loads[each cases]: Vec<SupportLoad<C>> = SupportLoad::new(psi, reach, load, slope, upper, cases[each]);
        worst: WorstLoad<C> = WorstLoad::new(loads);
        forces[each cases]: Vec<ColumnForces<C>> = ColumnForces::new(height, loads[each]);
        most: WorstBearings<C> = WorstBearings::new(forces);
        pivot: C = pivot_radius(bearings[!], friction[!]) => R_P;
        turning[each cases]: Vec<ColumnTurning<C>> =
            ColumnTurning::new(bearings[!], friction[!], pivot, loads[each], forces[each]);
        pressures[each cases]: Vec<BearingPressure<C>> =
            BearingPressure::new(bearings[!], loads[each], forces[each]);
        evened: Evened<C> = Evened::new(balancing[!], upper, load, reach);
    }
}

impl Component for SlewingColumn {
    const PORTS: &'static [Port] = ports! { s:
        axis "Slewing axis.": phi PSI, w OMEGA;
        head "Boom head, where the load hangs.": r R, f Q;
        bearing "The upper bearing in a load case.": fr H_U;
        foot "Foot bearing and pivot in a load case.": fz V, fr H_F;
    };

    fn has(given: &Given<f64>, symbol: &'static Symbol) -> bool {
        upper::keys::has(symbol, [given.slope.is_some(), !given.areas.is_empty()])
    }

    fn is_input(given: &Given<f64>, symbol: &'static Symbol) -> bool {
        given.open.0.contains(&symbol)
    }

    fn update(known: &mut Known<f64>) -> Found<()> {
        known.upper().map(|_| ())
    }
}
