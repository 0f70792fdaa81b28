//! A floating crane as a component: what it is given, and in which stages its equations follow from each other.

use crate::afloat::carrying::CraneAfloat;
use crate::afloat::cases::{CaseOutcome, CaseWind, NAMES, PlannedCase, PlannedCases, acting};
use crate::afloat::crane::{CraneWeights, HungPoint, LuffingMotion, TurningMass, luffed};
use crate::afloat::driving::{DriveMoments, LuffingCommand, LuffingServo, luffing};
use crate::afloat::gust::{Gust, GustGiven};
use crate::afloat::head::HeadPlace;
use crate::afloat::holding::HeldAtRest;
use crate::afloat::hull::{BoxHull, Floating, FloodedSpace, Offsets};
use crate::afloat::levers::{RightingLever, ToldHeel, levers};
use crate::afloat::loaded::Loaded;
use crate::afloat::loss::{LoadLost, LossRule, residual};
use crate::afloat::openings::{AreaEnds, FloodedOpening, Opening, flooding};
use crate::afloat::posture::Posture;
use crate::afloat::riding::{BuoyedMass, HullMotion, RidingHull, WaterForces, WettedHull, clearing};
use crate::afloat::small::SmallAngles;
use crate::afloat::swaying::{RopedLoad, SlewingCommand, SlewingServo, Swaying, SwayingRates};
use crate::afloat::symbols as s;
use crate::afloat::upright::Upright;
use crate::afloat::weights::{CranePlace, DeadLoad, HullMass, HullTow, HullWind, TankGiven, WindageArea};
use crate::component::found::{Finding, found};
use crate::component::part::{Component, Port, ports};
use crate::component::scalar::Scalar;
use crate::component::stages::{Found, Slot, Stage, Stages, absent, stages};
use crate::kernel::calc::Calc;
use crate::kernel::group::{One, group};
use crate::kernel::symbol::{Symbol, listed};
use crate::kernel::variable::Fault;
use crate::luffing::luffed::{Luffed, LuffedRates, Luffer};

/// Given quantities that the scene makes inputs of.
#[derive(Clone, Debug)]
pub struct MadeInputs(pub Vec<&'static Symbol>);
group!(MadeInputs);

stages! {
    /// A crane on a hull.
    FloatingCrane over C from {
        Coordinate psi: One<C>,
        Rate omega: One<C>,
        Parameter reach: Option<One<C>>,
        Parameter load: One<C>,
        Parameter place: CranePlace<C>,
        Parameter height: One<C>,
        Parameter turning: Vec<TurningMass<C>>,
        Parameter density: One<C>,
        Parameter built: Option<BoxHull<C>>,
        Parameter masses: Vec<HullMass<C>>,
        Parameter tanks: Vec<TankGiven<C>>,
        Parameter wind: Option<HullWind<C>>,
        Parameter areas: Vec<WindageArea<C>>,
        Parameter tow: Option<HullTow<C>>,
        Parameter flooded: Vec<FloodedSpace<C>>,
        Parameter heels: Vec<ToldHeel<C>>,
        Parameter openings: Vec<Opening<C>>,
        Parameter limit: Option<One<C>>,
        Parameter rule: Option<LossRule<C>>,
        Parameter gust: Option<GustGiven<C>>,
        Parameter gravity: One<C>,
        Parameter loads: Vec<One<C>>,
        Parameter hangs: Vec<One<C>>,
        Parameter winds: Vec<CaseWind<C>>,
        Parameter gusts: Vec<One<C>>,
        Parameter pulls: Vec<One<C>>,
        Parameter buoyed: Option<BuoyedMass<C>>,
        Parameter servo: Option<SlewingServo<C>>,
        Parameter luffing_servo: Option<LuffingServo<C>>,
        Input command: Option<SlewingCommand<C>>,
        Input luffing_command: Option<LuffingCommand<C>>,
        Input held: Option<One<C>>,
        State moved: Option<HullMotion<C>>,
        State roped: Option<RopedLoad<C>>,
        State luffing: Option<LuffingMotion<C>>,
        Fixed offsets: Option<Offsets>,
        Fixed luffer: Option<Luffer>,
        Fixed planned: PlannedCases,
        Fixed inputs: MadeInputs,
    } find {
        floating: Floating<C> = Floating::new(built, offsets, tanks, flooded, planned, density, gravity) => _;
        dead: DeadLoad<C> = DeadLoad::new(masses, tanks, gravity, wind, areas, tow);
        luffed: Luffed<C> = luffed(luffer[!], held, luffing);
        luffed_rates: LuffedRates<C> = LuffedRates::new(luffed);
        hung: HungPoint<C> = HungPoint::new(reach, height, luffed[?]);
        crane: CraneWeights<C> = CraneWeights::new(psi, place, height, luffed, turning);
        loaded: Loaded<C> = Loaded::new(psi, dead, place, hung, load, crane[?]);
        upright: Upright<C> = Upright::new(floating, density, gravity, tanks, loaded);
        small: SmallAngles<C> = SmallAngles::new(loaded, upright);
        posture: Posture<C> = Posture::new(built, floating, psi, load, loaded, upright);
        holding: HeldAtRest<C> = HeldAtRest::new(psi, load, luffed, luffed_rates, crane, posture);
        levers[heels]: Vec<RightingLever<C>> = levers(floating, loaded, upright, heels);
        flooding[openings]: Vec<FloodedOpening<C>> = flooding(floating, loaded, posture, openings);
        ends: AreaEnds<C> = AreaEnds::new(limit[!], flooding) => _;
        residual: C = residual(floating, loaded, posture, ends) => A_RES;
        lost: LoadLost<C> = LoadLost::new(floating, loaded, posture, ends, rule[!]);
        struck: Gust<C> = Gust::new(floating, loaded, posture, ends, gust[!], wind[!], areas);
        bare: Given<C> = bare(
            reach, place, height, turning, density, built, masses, tanks, wind, areas, tow, flooded, openings, limit, rule,
            gust, gravity, held, offsets, luffer) => _;
        hulls: Vec<Given<C>> = hulls(bare, planned, loads, hangs, winds, gusts, pulls) => _;
        still: Vec<Option<CaseOutcome<C>>> = still(hulls, planned) => _;
        outcomes[loads]: Vec<CaseOutcome<C>> = outcomes(psi, hulls, still, planned);
        riding: RidingHull<C> = RidingHull::new(moved[!], dead);
        wetted: WettedHull<C> = WettedHull::new(floating, riding);
        clear: C = clearing(floating, riding) => F_M;
        head: HeadPlace<C> = HeadPlace::new(riding, loaded, hung, psi);
        forces: WaterForces<C> = WaterForces::new(moved[!], buoyed[!], riding, dead, wetted, density, gravity);
        carrying: CraneAfloat<C> = CraneAfloat::new(
            psi, omega, place, height, luffed, luffing[!], turning, moved[!], riding, gravity) => _;
        luffs: C = luffing(luffing_servo[!], luffing_command[!], luffing[!]) => _;
        swaying: Swaying<C> = Swaying::new(
            moved[!], buoyed[!], roped[!], servo[!], command[!], riding, head, forces, dead, load, gravity, omega, luffs[?],
            carrying[?]);
        drives: DriveMoments<C> = DriveMoments::new(carrying, swaying, luffs);
        rates: SwayingRates<C> = SwayingRates::new(omega, moved[!], swaying, luffing, luffs[?]);
    }
}

/// A load case, by all stages of the hull as it is given in that case.
struct AtCase;

impl Finding<{ NAMES.len() }> for AtCase {
    type From<C: Calc> = Given<C>;
    const NAMES: [&'static Symbol; NAMES.len()] = NAMES;

    fn map<C: Calc, D: Calc>(given: &Given<C>, f: &mut dyn FnMut(C) -> D) -> Given<D> {
        FloatingCrane::map(given, &mut |_, _, value| f(value))
    }

    fn find<C: Scalar>(given: &Given<C>) -> Result<[C; NAMES.len()], Fault> {
        at_case(given).map_err(|fault| *fault)
    }
}

/// One of the results of a hull.
fn result<C: Scalar>(known: &mut Known<C>, symbol: &'static Symbol, of: u16) -> Found<C> {
    let row = |stage: &Stage| stage.rows.iter().position(|row| *row == symbol);
    let mut all = (0..).zip(FloatingCrane::STAGES);
    let (stage, row, sources) = all
        .find_map(|(i, stage)| Some((i, row(stage)? as u8, stage.sources)))
        .ok_or_else(absent)?;
    let (slot, mut value) = (
        Slot {
            stage,
            row,
            of,
            sources,
        },
        C::constant(0.0),
    );
    FloatingCrane::result(known, &slot, &mut value)?;
    Ok(value)
}

/// What is found of a hull as it is given, in the order of [`NAMES`]; what it does not model is infinite.
/// ρ = A_II/(k_A A_I + c_A).
fn at_case<C: Scalar>(given: &Given<C>) -> Found<[C; NAMES.len()]> {
    let mut known = FloatingCrane::new(given.clone());
    let mut of = |there: bool, symbol| match there {
        true => result(&mut known, symbol, 0),
        false => Ok(C::constant(f64::INFINITY)),
    };
    let (counts, loses, struck) = (given.limit.is_some(), given.rule.is_some(), given.gust.is_some());
    let [heel, trim, freeboard, height] = [
        of(true, &s::PHI)?,
        of(true, &s::THETA)?,
        of(true, &s::F_LOW)?,
        of(true, &s::GM)?,
    ];
    let residual = of(counts, &s::A_RES)?;
    let [rolls, drives, stops] = [of(loses, &s::PHI_2)?, of(loses, &s::A_I)?, of(loses, &s::A_II)?];
    let [dynamic, safety] = [of(struck, &s::PHI_DYN)?, of(struck, &s::K_C)?];
    let asked = given.rule.map_or(C::constant(0.0), |rule| rule.k_a * drives + rule.c_a);
    let ratio = if asked.value() > 0.0 {
        stops / asked
    } else {
        C::constant(f64::INFINITY)
    };
    let mut least = |symbol| {
        let each = (0..given.openings.len() as u16).map(|of| result(&mut known, symbol, of));
        each.reduce(|one, other| Ok(one?.smaller(other?)))
            .unwrap_or(Ok(C::constant(f64::INFINITY)))
    };
    let (high, floods) = (least(&s::F_O)?, least(&s::PHI_O)?);
    Ok([
        heel, trim, freeboard, high, floods, residual, rolls, dynamic, safety, height, ratio,
    ])
}

/// The hull as it is given, at rest, without its load and without further cases.
#[expect(clippy::too_many_arguments, reason = "all that a hull at rest is given")]
fn bare<C: Calc>(
    reach: &Option<One<C>>,
    place: &CranePlace<C>,
    height: &One<C>,
    turning: &[TurningMass<C>],
    density: &One<C>,
    built: &Option<BoxHull<C>>,
    masses: &[HullMass<C>],
    tanks: &[TankGiven<C>],
    wind: &Option<HullWind<C>>,
    areas: &[WindageArea<C>],
    tow: &Option<HullTow<C>>,
    flooded: &[FloodedSpace<C>],
    openings: &[Opening<C>],
    limit: &Option<One<C>>,
    rule: &Option<LossRule<C>>,
    gust: &Option<GustGiven<C>>,
    gravity: &One<C>,
    held: &Option<One<C>>,
    offsets: &Option<Offsets>,
    luffer: &Option<Luffer>,
) -> Given<C> {
    Given {
        psi: One(&s::PSI_SL, C::constant(0.0)),
        omega: One(&s::OMEGA_SL, C::constant(0.0)),
        reach: *reach,
        load: One(&s::Q, C::constant(0.0)),
        place: *place,
        height: *height,
        turning: turning.to_vec(),
        density: *density,
        built: *built,
        masses: masses.to_vec(),
        tanks: tanks.to_vec(),
        wind: *wind,
        areas: areas.to_vec(),
        tow: *tow,
        flooded: flooded.to_vec(),
        heels: Vec::new(),
        openings: openings.to_vec(),
        limit: *limit,
        rule: *rule,
        gust: *gust,
        gravity: *gravity,
        loads: Vec::new(),
        hangs: Vec::new(),
        winds: Vec::new(),
        gusts: Vec::new(),
        pulls: Vec::new(),
        buoyed: None,
        servo: None,
        luffing_servo: None,
        command: None,
        luffing_command: None,
        held: *held,
        moved: None,
        roped: None,
        luffing: None,
        offsets: offsets.clone(),
        luffer: luffer.clone(),
        planned: PlannedCases::default(),
        inputs: MadeInputs(Vec::new()),
    }
}

/// The hull as it is given in each of the further load cases.
fn hulls<C: Calc>(
    bare: &Given<C>,
    planned: &PlannedCases,
    loads: &[One<C>],
    hangs: &[One<C>],
    winds: &[CaseWind<C>],
    gusts: &[One<C>],
    pulls: &[One<C>],
) -> Vec<Given<C>> {
    let of = |(i, case): (usize, &PlannedCase)| {
        let mut given = bare.clone();
        given.psi.1 = case.psi.map_or(given.psi.1, C::constant);
        given.load.1 = loads[i].1;
        let hung = given.held.as_mut().or(given.reach.as_mut());
        hung.into_iter()
            .zip(hangs.get(i))
            .for_each(|(own, hangs)| own.1 = hangs.1);
        if let (Some(own), Some(wind)) = (&mut given.wind, winds.get(i)) {
            (own.p_w, own.chi_w) = (wind.p_wk, wind.chi_wk);
        }
        if let (Some(own), Some(gust)) = (&mut given.gust, gusts.get(i)) {
            own.p_g = gust.1;
        }
        if let (Some(own), Some(pull)) = (&mut given.tow, pulls.get(i)) {
            own.f_p = pull.1;
        }
        given.openings = acting(&bare.openings, &case.open).copied().collect();
        given.planned.flooded.clone_from(&case.flooded);
        given
    };
    planned.further.iter().enumerate().map(of).collect()
}

/// What a load case, numbered from 0, comes to.
fn outcome<C: Scalar>(given: &Given<C>, planned: &PlannedCases, case: usize) -> Result<CaseOutcome<C>, Fault> {
    C::body(case, || {
        let found = found::<AtCase, C, { NAMES.len() }>(given)?;
        Ok(CaseOutcome::new(found, &planned.further[case], given.rule.is_some()))
    })
    .map_err(|fault: Fault| Fault {
        message: format!("load case {}: {}", case + 1, fault.message),
        ..fault
    })
}

/// The cases with a slewing angle of their own, which no other one changes.
///
/// # Errors
/// A case that cannot be, with its number.
fn still<C: Scalar>(hulls: &[Given<C>], planned: &PlannedCases) -> Result<Vec<Option<CaseOutcome<C>>>, Fault> {
    let own = |(case, given): (usize, &Given<C>)| {
        let psi = planned.further[case].psi;
        psi.map(|_| outcome(given, planned, case)).transpose()
    };
    hulls.iter().enumerate().map(own).collect()
}

/// All further load cases.
///
/// # Errors
/// As [`still`].
fn outcomes<C: Scalar>(
    psi: &One<C>,
    hulls: &[Given<C>],
    still: &[Option<CaseOutcome<C>>],
    planned: &PlannedCases,
    room: &mut Vec<CaseOutcome<C>>,
) -> Result<(), Fault> {
    room.clear();
    for (case, (given, still)) in hulls.iter().zip(still).enumerate() {
        let turned = || Given {
            psi: *psi,
            ..given.clone()
        };
        room.push(still.map_or_else(|| outcome(&turned(), planned, case), Ok)?);
    }
    Ok(())
}

impl Component for FloatingCrane {
    const STATES: [&'static [&'static Symbol]; 2] = [
        listed!(s: PSI_SL, OMEGA_SL),
        listed!(s:
            D_PSI_SL, D_OMEGA_SL, D_H_G, D_PHI_X, D_THETA_Y, D_V_G, D_OMEGA_X, D_OMEGA_Y, D_R_X, D_R_Y, D_R_Z, D_W_X, D_W_Y,
            D_W_Z, D_THETA_1, D_OMEGA_1
        ),
    ];

    const PORTS: &'static [Port] = ports! { s:
        axis "Slewing axis.": phi PSI_SL, w OMEGA_SL;
        head "Boom head, where the load hangs.": r R, z H_S, f Q;
        hull "Hull on the water.": heel PHI, trim THETA, draft T;
    };

    /// What wind, tow, tanks, flooded compartments, masses that slew and a luffing mechanism would give is no result without them.
    fn has(given: &Given<f64>, symbol: &'static Symbol) -> bool {
        let there = |of: &[&'static Symbol]| of.contains(&symbol);
        (given.wind.is_some() || !there(listed!(s: M_W)))
            && (given.tow.is_some() || !there(listed!(s: M_P)))
            && (!given.tanks.is_empty() || !there(listed!(s: GG, GG_L)))
            && (given.planned.flooded.contains(&true) || !there(listed!(s: Y_B)))
            && (!given.openings.is_empty() || !there(listed!(s: F_OK, PHI_OK)))
            && (given.limit.is_some() || !there(listed!(s: A_K)))
            && (given.rule.is_some() || !there(listed!(s: PHI_2K, RHO_K)))
            && (given.gust.is_some() || !there(listed!(s: PHI_DK, K_CK)))
            && (!given.turning.is_empty() || !there(listed!(s: M_ETA)))
            && (given.luffer.is_some() || !there(listed!(s: H_S)))
            && (given.luffing.is_some() || !there(listed!(s: D_THETA_1, D_OMEGA_1)))
    }

    fn is_input(given: &Given<f64>, symbol: &'static Symbol) -> bool {
        given.inputs.0.contains(&symbol)
    }

    fn update(known: &mut Known<f64>) -> Found<()> {
        match known.given.moved {
            Some(_) => known.swaying().map(|_| ()),
            None => known.posture().map(|_| ()),
        }
    }
}
