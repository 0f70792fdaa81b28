//! Boom and trunk as a component: what it is given, and in which stages its equations follow from each other.

use crate::balance::analysis::Analysis;
use crate::balance::residual::Residual;
use crate::balance::scene::Form;
use crate::balance::symbols as b;
use crate::component::part::{Component, Port, ports};
use crate::component::scalar::Scalar;
use crate::component::stages::{Found, stages};
use crate::component::whole::{How, Whole};
use crate::kernel::group::One;
use crate::kernel::symbol::Symbol;
use crate::luffing::balancing::{Balanced, Balancing};
use crate::luffing::criteria::Criteria;
use crate::luffing::curved_trunk::balancing::{analysed, balanced, balancing, criteria, residual};
use crate::luffing::curved_trunk::contact::Contact;
use crate::luffing::curved_trunk::pins::{TrunkPins, power, pressure};
use crate::luffing::curved_trunk::position::TrunkPosition;
use crate::luffing::curved_trunk::statics::{TrunkLoad, TrunkWeight, TrunkWeights};
use crate::luffing::curved_trunk::symbols as s;
use crate::luffing::curved_trunk::tail::{TailArc, Trunk, TrunkChoice, TrunkTail};
use crate::luffing::curved_trunk::velocity::{TrunkSpeeds, TrunkTravel, pole};
use crate::luffing::with_balance::WithBalance;
use crate::parts::plane::Point;

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
        Parameter balance: Option<Form<C>>,
        Fixed choice: TrunkChoice,
    } find {
        tail: TrunkTail<C> = TrunkTail::new(trunk, arc, choice), lifted;
        contact: Contact<C> = Contact::new(tail, choice, phi);
        position: TrunkPosition<C> = TrunkPosition::new(tail, contact);
        travel: TrunkTravel<C> = TrunkTravel::new(position);
        pole: Point<C> = pole(position, travel) => [P_X, P_Y];
        speeds: TrunkSpeeds<C> = TrunkSpeeds::new(travel, omega);
        hanging: TrunkLoad<C> = TrunkLoad::new(position, travel, pole, load[!]);
        own: TrunkWeight<C> = TrunkWeight::new(weights[!], phi, position, travel);
        balancing: Balancing<C> = balancing(tail, choice, weights[!], balance[!]) => _;
        residual: Residual<C> = residual(balancing, own, phi);
        balanced: Balanced<C> = balanced(residual, hanging, own);
        pins: TrunkPins<C> = TrunkPins::new(contact, position, load[!], own[?], residual[?]);
        pressure: C = pressure(pins, width[!]) => P_T;
        power: C = power(pins, omega) => P_D;
        analysed: Analysis = analysed(tail, choice, weights[!], balance[!]) => _, plain;
        criteria: Criteria<C> = criteria(balancing, tail, choice, weights[!], analysed);
    }
}

impl Component for CurvedTrunkBoom {
    const WHOLE: &'static [Whole] = &[
        Whole::new(&s::R_MAX, How::Greatest, &s::R),
        Whole::new(&s::R_MIN, How::Least, &s::R),
        Whole::new(&s::DELTA_Y, How::Swing, &s::A_Y),
        Whole::new(&s::EPSILON_Y, How::Ratio(&s::R), &s::A_Y),
        Whole::new(&s::MU_MIN, How::Least, &s::MU),
    ];

    const PORTS: &'static [Port] = ports! { s:
        head "Head A of the trunk, where the load hangs.": x A_X, y A_Y, v_x V_AX, v_y V_AY, f Q;
        tie "Tie on the tail.": w W, f N_T;
    };

    /// A balance has what its kind has, and no force moves this boom.
    fn has(given: &Given<f64>, symbol: &'static Symbol) -> bool {
        symbol != &b::F_D_0 && given.balance.as_ref().is_none_or(|form| form.has(symbol))
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
