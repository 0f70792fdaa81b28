//! Boom and trunk as a component: what it is given, and in which stages its equations follow from each other.

use crate::balance::analysis::Analysis;
use crate::balance::residual::Residual;
use crate::balance::scene::Form;
use crate::balance::symbols as b;
use crate::component::outline::joined;
use crate::component::part::{Component, Port, ports};
use crate::component::scalar::Scalar;
use crate::component::stages::{Found, stages};
use crate::component::whole::{How, Whole};
use crate::drive::crank::{CrankRod, Cranked, cranked};
use crate::drive::gear::Gear;
use crate::drive::line::{self, Drive, Mounted, Reaction};
use crate::drive::mount::{Bore, DriveMount, DrivenBar};
use crate::drive::shaft::{Gearing, Shaft};
use crate::kernel::group::One;
use crate::kernel::symbol::Symbol;
use crate::luffing::balancing::{Balanced, Balancing};
use crate::luffing::criteria::Criteria;
use crate::luffing::curved_trunk::balancing::{analysed, balanced, balancing, criteria, residual};
use crate::luffing::curved_trunk::contact::Contact;
use crate::luffing::curved_trunk::driving;
use crate::luffing::curved_trunk::pins::{TrunkBearing, TrunkPins, power, pressure};
use crate::luffing::curved_trunk::position::TrunkPosition;
use crate::luffing::curved_trunk::resisting::{self, TrunkPlaces};
use crate::luffing::curved_trunk::statics::{TrunkLoad, TrunkWeight, TrunkWeights};
use crate::luffing::curved_trunk::tail::{TailArc, Trunk, TrunkChoice, TrunkTail};
use crate::luffing::curved_trunk::velocity::{TrunkSpeeds, TrunkTravel, pole};
use crate::luffing::resistances::brakes::{Holding, Stopped};
use crate::luffing::resistances::friction::{Pins, Rubbed};
use crate::luffing::resistances::given::{
    Case, CaseBody, CaseBrake, CaseHold, CaseMotor, CasePin, CasesChoice, SecondBrake,
};
use crate::luffing::resistances::loads::Loads;
use crate::luffing::resistances::moments::Resisted;
use crate::luffing::resistances::motor::{Heating, Motored};
use crate::luffing::resistances::outline::WHOLE;
use crate::luffing::resistances::placed::{MovedBars, Weighty};
use crate::luffing::resistances::sums::Sums;
use crate::luffing::resistances::told::resists;
use crate::luffing::strength::given::{Nut, PinSize, Profile, Strut, Teeth};
use crate::luffing::strength::nut::{Core, Threaded};
use crate::luffing::strength::pins::Sheared;
use crate::luffing::strength::pull::pressed;
use crate::luffing::strength::strut::{Slender, buckled};
use crate::luffing::strength::teeth::{Mesh, Toothed};
use crate::luffing::with_balance::WithBalance;
use crate::parts::four_bar::FourBar;
use crate::parts::plane::Point;

/// Quantities of the mechanism and of its drive.
mod s {
    pub use crate::drive::symbols::{F_D, L_D, Q_D, T_CR, V_D};
    pub use crate::luffing::curved_trunk::symbols::*;
    pub use crate::luffing::resistances::symbols::F_R;
    pub use crate::luffing::strength::symbols::{P_C, U_K};
}

stages! {
    /// A boom with a trunk whose curved tail a tie holds.
    CurvedTrunkBoom over C from {
        Coordinate phi: One<C>,
        Rate omega: One<C>,
        Load load: Option<One<C>>,
        Parameter trunk: Trunk<C>,
        Parameter arc: Option<TailArc<C>>,
        Parameter width: Option<One<C>>,
        Parameter weights: Option<TrunkWeights<C>>,
        Parameter mount: Option<DriveMount<C>>,
        Parameter rod: Option<CrankRod<C>>,
        Parameter cylinder: Option<Bore<C>>,
        Parameter gear: Option<Gear<C>>,
        Parameter balance: Option<Form<C>>,
        Parameter cases: Vec<Case<C>>,
        Parameter bodies: Vec<CaseBody<C>>,
        Parameter rubbing: Vec<CasePin<C>>,
        Parameter air: Option<One<C>>,
        Parameter driver: Option<CaseMotor<C>>,
        Parameter brake: Option<CaseBrake<C>>,
        Parameter second: Option<SecondBrake<C>>,
        Parameter holds: Vec<CaseHold<C>>,
        Parameter strut: Option<Strut<C>>,
        Parameter profile: Option<Profile<C>>,
        Parameter teeth: Option<Teeth<C>>,
        Parameter nut: Option<Nut<C>>,
        Parameter sizes: Option<Vec<PinSize<C>>>,
        Fixed chosen: Option<CasesChoice>,
        Fixed choice: TrunkChoice,
    } find {
        tail: TrunkTail<C> = TrunkTail::new(trunk, arc, choice), lifted;
        contact: Contact<C> = Contact::new(tail, choice, phi);
        position: TrunkPosition<C> = TrunkPosition::new(tail, contact);
        travel: TrunkTravel<C> = TrunkTravel::new(position);
        pole: Point<C> = pole(position, travel) => [P_X, P_Y];
        speeds: TrunkSpeeds<C> = TrunkSpeeds::new(travel, omega);
        bar: DrivenBar<C> = driving::bar(position, trunk, phi) => _;
        crank: FourBar<C> = driving::crank(rod[!], mount[!], choice) => _, lifted;
        cranked: Cranked<C> = cranked(crank, rod[!], mount[!], bar);
        drive: Drive<C> = Drive::of(bar, mount[!], rod, cranked[?]);
        stroke: C = line::speed(drive, omega) => V_D;
        flow: C = line::flow(cylinder[!], stroke) => Q_D;
        hanging: TrunkLoad<C> = TrunkLoad::new(position, travel, pole, load[!]);
        own: TrunkWeight<C> = TrunkWeight::new(weights[!], phi, position, travel);
        balancing: Balancing<C> = balancing(tail, choice, weights[!], balance[!]) => _;
        residual: Residual<C> = residual(balancing, own, phi);
        balanced: Balanced<C> = balanced(residual, hanging, own, drive[?]);
        pins: TrunkPins<C> = TrunkPins::new(position, load[!], own[?], residual[?]);
        push: Reaction<C> = driving::push(drive, pins);
        bearing: TrunkBearing<C> = TrunkBearing::new(contact, pins, own[?], residual[?], push[?]);
        pressure: C = pressure(bearing, width[!]) => P_T;
        power: C = power(pins, omega) => P_D;
        gearing: Gearing<C> = Gearing::new(gear[!]);
        shaft: Shaft<C> = line::shaft(gearing, push, stroke, cranked[?]);
        by_slider: C = line::by_slider(cranked, rod[!], mount[!], push) => T_CR;
        analysed: Analysis = analysed(tail, choice, weights[!], balance[!]) => _, plain;
        criteria: Criteria<C> = criteria(balancing, tail, choice, weights[!], analysed);
        mounted: Mounted<C> = Mounted::new(mount[!], rod, crank[?]) => _;
        places: TrunkPlaces<C> = TrunkPlaces::new(tail, choice, weights[!], balancing[?], mounted) => _;
        weighty: Weighty<C> = resisting::weighty(places, bodies, chosen[!]) => _;
        moved: MovedBars<C> = resisting::moved(places, weighty, residual[?], phi) => _;
        sums: Sums<C> = Sums::new(moved, bodies, cases, chosen[!]);
        resisted[each cases]: Vec<Resisted<C>> = Resisted::new(sums, load[!], air[!], cases[each]);
        loads[each cases]: Vec<Loads<C>> = Loads::new(moved, bodies, chosen[!], load[!], cases[each], resisted[each]) => _;
        pinned[each cases]: Vec<Pins<C>> = resisting::pins(position, drive, residual[?], moved, loads[each], resisted[each]) => _;
        rubbed[each cases]: Vec<Rubbed<C>> = Rubbed::new(resisted[each], pinned[each], rubbing, chosen[!]);
        force[each cases]: Vec<C> = resisting::force(drive, rubbed[each]) => F_R;
        motored[each cases]: Vec<Motored<C>> = Motored::new(
            driver[!], sums, cases[each], resisted[each], rubbed[each], force[each]
        );
        heating: Heating<C> = Heating::new(driver[!], sums, resisted, motored, chosen[!]);
        holding[each holds]: Vec<Holding<C>> = Holding::new(driver[!], brake[!], second, sums, holds[each], resisted[each]);
        stopped[each holds]: Vec<Stopped<C>> = Stopped::new(driver[!], brake[!], second, sums, cases[each], motored[each]);
        slender: Slender<C> = Slender::new(strut[!], profile, nut, cylinder, drive);
        buckled[each cases]: Vec<C> = buckled(strut[!], slender, force[each]) => U_K;
        mesh: Mesh<C> = Mesh::new(teeth[!], gear[!], mount[!]);
        toothed[each cases]: Vec<Toothed<C>> = Toothed::new(teeth[!], mesh, force[each]);
        core: Core<C> = Core::new(nut[!], gear[!], gearing);
        threaded[each cases]: Vec<Threaded<C>> = Threaded::new(nut[!], core, force[each]);
        pressed[each cases]: Vec<C> = pressed(cylinder[!], force[each]) => P_C;
        sheared[each cases]: Vec<Sheared<C>> = Sheared::new(sizes[!], chosen[!], pinned[each]);
    }
}

resists!(CurvedTrunkBoom with resisting::PARTS);

impl Component for CurvedTrunkBoom {
    const WHOLE: &'static [Whole] = &joined::<_, 5, 4, 9>(
        [
            Whole::new(&s::R_MAX, How::Greatest, &s::R),
            Whole::new(&s::R_MIN, How::Least, &s::R),
            Whole::new(&s::DELTA_Y, How::Swing, &s::A_Y),
            Whole::new(&s::EPSILON_Y, How::Ratio(&s::R), &s::A_Y),
            Whole::new(&s::MU_MIN, How::Least, &s::MU),
        ],
        WHOLE,
    );

    const PORTS: &'static [Port] = ports! { s:
        head "Head A of the trunk, where the load hangs.": x A_X, y A_Y, v_x V_AX, v_y V_AY, f Q;
        tie "Tie on the tail.": w W, f N_T;
        drive "Cylinder, rack, screw, sector or crank between frame and boom.": s L_D, v V_D, f F_D, q Q_D;
    };

    /// A balance has what its kind has, and so has a drive.
    fn has(given: &Given<f64>, symbol: &'static Symbol) -> bool {
        (symbol != &b::F_D_0 || given.mount.is_some())
            && given.balance.as_ref().is_none_or(|form| form.has(symbol))
            && line::has(given.mount.as_ref(), given.rod.is_some(), given.gear.as_ref(), symbol)
    }

    fn update(known: &mut Known<f64>) -> Found<()> {
        known.position().map(|_| ())
    }
}

impl WithBalance for CurvedTrunkBoom {
    const SYMBOLS: [&'static Symbol; 3] = [&b::PHI, &s::R, &s::M_D];

    fn form(given: &Given<f64>) -> Option<Form<f64>> {
        given.balance
    }

    fn balance(known: &mut Known<f64>) -> Found<(Balancing<f64>, Analysis)> {
        Ok((*known.balancing()?, known.analysed()?.clone()))
    }

    /// That of the boom, which the balance raises.
    fn head(known: &mut Known<f64>) -> Found<Point<f64>> {
        Ok(known.position()?.b)
    }

    fn residual<C: Scalar>(known: &mut Known<C>) -> Found<Residual<C>> {
        known.residual().copied()
    }
}
