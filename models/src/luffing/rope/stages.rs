//! The boom as a component: what it is given, and in which stages its equations follow from each other.

use crate::balance::analysis::{Analysis, Residual};
use crate::balance::boom::Plain;
use crate::balance::scene::Form;
use crate::component::part::{Component, Port};
use crate::component::stages::{Found, stages};
use crate::component::whole::{How, Whole};
use crate::kernel::group::One;
use crate::kernel::symbol::Symbol;
use crate::luffing::balancing::{Balanced, Balancing, Criteria};
use crate::luffing::rope::balancing::{analysed, balanced, balancing, criteria, residual};
use crate::luffing::rope::losses::Losses;
use crate::luffing::rope::position::{BoomChoice, BoomPosition, Falls, LoadLevel, Path, Rig, Stretch};
use crate::luffing::rope::statics::{Hanging, OwnMoment, Pull, RopePulls, power};
use crate::luffing::rope::symbols as s;
use crate::luffing::rope::velocity::{RopeTravel, Speeds};

stages! {
    /// A plain boom on a luffing rope.
    RopeBoom over C from {
        Coordinate phi: One<C>,
        Rate omega: One<C>,
        Load load: Option<One<C>>,
        Parameter rig: Rig<C>,
        Parameter weights: Option<Plain<C>>,
        Parameter balance: Option<Form<C>>,
        Fixed choice: BoomChoice,
    } find {
        level: LoadLevel<C> = LoadLevel::new(rig, choice);
        position: BoomPosition<C> = BoomPosition::new(rig, phi);
        falls: Falls<C> = Falls::new(rig, position, phi);
        stretch: Stretch<C> = Stretch::new(rig, position);
        path: Path<C> = Path::new(rig, level, position, stretch);
        travel: RopeTravel<C> = RopeTravel::new(rig, position, stretch) => _;
        speeds: Speeds<C> = Speeds::new(rig, travel, falls, omega);
        hanging: Hanging<C> = Hanging::new(rig, load[!], travel);
        own: OwnMoment<C> = OwnMoment::new(weights[!], phi);
        balancing: Balancing<C> = balancing(weights[!], balance[!], choice) => _;
        residual: Residual<C> = residual(balancing, own, phi);
        balanced: Balanced<C> = balanced(residual, hanging, own);
        carried: RopePulls<C> = RopePulls::new(position, load[!], own[?], residual[?]) => _;
        pull: Pull<C> = Pull::new(carried, hanging, position, falls, stretch);
        power: C = power(rig, pull, speeds) => P_L;
        losses: Losses<C> = Losses::new(rig, load[!], carried, falls, stretch);
        analysed: Analysis = analysed(weights[!], balance[!], choice) => _, plain;
        criteria: Criteria<C> = criteria(balancing, weights[!], analysed, choice);
    }
}

impl Component for RopeBoom {
    const WHOLE: &'static [Whole] = &[
        Whole::new(&s::R_MAX, How::Greatest, &s::R),
        Whole::new(&s::R_MIN, How::Least, &s::R),
        Whole::new(&s::DELTA_Y, How::Swing, &s::Y_Q),
        Whole::new(&s::EPSILON_Y, How::Ratio(&s::R), &s::Y_Q),
        Whole::new(&s::STROKE, How::Swing, &s::L_T),
        Whole::new(&s::L_LD, How::Swing, &s::L_L),
        Whole::new(&s::PHI_T, How::Vanishes(None), &s::M_D),
        Whole::new(&s::PHI_T0, How::Vanishes(Some((&s::Q, 0.0))), &s::M_D),
    ];

    const PORTS: &'static [Port] = &[
        Port {
            name: "head",
            text: "Head A of the boom, where the load hangs.",
            members: &[
                (&s::A_X, "x"),
                (&s::A_Y, "y"),
                (&s::V_AX, "v_x"),
                (&s::V_AY, "v_y"),
                (&s::Q, "f"),
            ],
            driven: &[],
        },
        Port {
            name: "drum",
            text: "Drum of the luffing rope.",
            members: &[(&s::V_L, "v"), (&s::S_L_UP, "f"), (&s::P_L, "p")],
            driven: &[],
        },
    ];

    /// A balance has what its kind has, and the tackle's force is told otherwise.
    fn has(given: &Given<f64>, symbol: &'static Symbol) -> bool {
        symbol != &crate::balance::symbols::F_D_0 && given.balance.as_ref().is_none_or(|form| form.has(symbol))
    }

    fn update(known: &mut Known<f64>) -> Found<()> {
        known.falls().map(|_| ())
    }
}
