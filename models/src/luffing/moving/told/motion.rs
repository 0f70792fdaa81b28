//! The mechanism in motion: the equations at one instant, from the functions that the running model solves, and
//! runs of that model through manoeuvres.

use std::panic::resume_unwind;
use std::thread::ScopedJoinHandle;

use crate::balance::symbols as b;
use crate::component::description::{Described, Description};
use crate::component::moved::Moved;
use crate::component::moving::MovingComponent;
use crate::component::running::Running;
use crate::component::series;
use crate::component::sheet::{Check, Envelope, InMotion, Manoeuvre, Section, Summary};
use crate::component::stages::Stages;
use crate::drive::symbols as d;
use crate::kernel::record::record;
use crate::kernel::symbol::{Symbol, listed};
use crate::kernel::variable::Role;
use crate::luffing::moving::carried;
use crate::luffing::moving::control::continuous::REGULATION;
use crate::luffing::moving::control::{AXES, ByAxis};
use crate::luffing::moving::given::{INPUTS, STATES};
use crate::luffing::moving::hydraulic::CREEP;
use crate::luffing::moving::luffs::Luffs;
use crate::luffing::moving::scene::Moving;
use crate::luffing::moving::start::starting;
use crate::luffing::moving::symbols as m;
use crate::luffing::moving::told::energy::integrals;
use crate::luffing::moving::told::manoeuvres::{Pilot, Planned, at_rest, designed, drawn, planned, rules};
use crate::luffing::moving::told::present::{recorded, standing};
use crate::luffing::moving::told::run::{EVENTS, Run, timed};
use crate::luffing::moving::told::shown::Shown;
use crate::luffing::moving::told::stop::Stop;
use crate::luffing::moving::weather::Weather;
use crate::parts::hydraulics::symbols as h;
use crate::parts::hydraulics::throttle::LAMINAR;

/// What the formulas of a section give; those of the assembled model stand among them. A mechanism has its own besides.
const SECTIONS: [(&str, &[&Symbol]); 16] = [
    (
        "motion_counterweight",
        &[&m::MASS_5, &b::C_5X, &b::C_5Y, &m::DX_5, &m::DY_5, &m::DDX_5, &m::DDY_5],
    ),
    (
        "motion_bodies",
        listed! { m:
            MASS_Q, DL_R, DDL_R, DY_Q, DDY_Q, I_RQ, DI_RQ, I_R5, DI_R5, I_R, DI_R, M_W, DDA_X, DDA_Y, DS_S, DDS_S, DPSI_M, DDPSI_M, I_M, DI_M, I_ALL, DI_ALL
        },
    ),
    (
        "motion_weather",
        &[
            &m::P_WI,
            &m::M_WIND,
            &m::M_SLOPE,
            &m::M_WO,
            &m::A_SLOPE_X,
            &m::A_SLOPE_Y,
            &m::G_SLOPE,
        ],
    ),
    (
        "motion_slewing",
        listed!(m: J_XIU, J_XIETAU, J_ETAU, I_UB, DI_UB, I_UL, DI_UL, I_SL, DI_SL),
    ),
    ("motion_slewed", &[&m::OMEGA_SM, &m::M_OMEGA, &m::M_WC]),
    ("motion_aside", &[&m::P_WS, &m::M_WS]),
    (
        "motion_leaning",
        listed! { m: G_S, W_SX, W_GX, M_GAMMA_L, M_GAMMA, A_GAMMA_X, G_GAMMA },
    ),
    (
        "motion_oil",
        &[
            &h::A_A,
            &h::A_B,
            &d::R_DX,
            &d::R_DY,
            &d::L_DX,
            &d::L_DY,
            &d::L_D,
            &d::H_D,
            &d::V_D,
            &h::Y_V,
            &h::DP_T,
            &h::DP_E0,
            &h::P_E0,
            &h::Q_E0,
            &h::DP_E,
            &h::P_S,
            &h::Q_1,
            &h::Q_2,
            &h::Q_0,
            &h::Y_LHA,
            &h::Y_LHB,
            &h::Q_LA,
            &h::Q_LB,
            &h::Q_ACA,
            &h::Q_ACB,
            &h::Q_T1,
            &h::Q_T2,
            &h::Q_B1,
            &h::Q_B2,
            &h::Q_R1,
            &h::Q_R2,
            &h::Q_LEAK,
        ],
    ),
    (
        "motion_pressures",
        &[&h::V_A, &h::V_B, &m::D_P_1, &m::D_P_2, &m::D_P_A, &m::D_P_B, &m::D_V_V],
    ),
    (
        "motion_air",
        listed! { m:
            DELTA_AIR, KAPPA_AIR, U_AIR_X, U_AIR_Y, U_AIR_Z, U_AIR, A_AIR_X, A_AIR_Y, A_AIR_Z
        },
    ),
    (
        "motion_pendulum",
        listed! { m:
            D_PHI, D_N, Q_A, D_L, Q_L, A_L, A_C, A_OUT, DH_R, DD_PHI, M_11, M_12, M_21, M_22, W_1, TAU_1, TAU_2
        },
    ),
    (
        "motion_load",
        listed! { m:
            S_Q, N_X, N_Y, N_Z, H_1R, H_2R, V_E, W_X, W_Y, W_Z, R_QX, U_X, U_Y, B_X, B_Y, B_Z
        },
    ),
    (
        "motion_equations",
        listed! { m:
            MASS_H, MASS_TL, V_Q, DELTA_R, D_DELTA_R, S_RD, F_C, M_BM, M_R, M_R_SL, M_NET, TAU_M, M_NET_SL, ALPHA_0, ALPHA_0SL, A_N, KAPPA_R, A_R, A_AX, A_AY, A_AR, A_QX, A_QY, A_QPHI, A_LR, D_OMEGA_SL,
            D_OMEGA_R, D_V_QX, D_V_QY, D_V_QZ, D_V_Q, S_R, D_V_R, D_DELTA_L, D_V_TL, P_ML, P_BL
        },
    ),
    ("motion_ground", &[&m::H_G]),
    (STANDING, &[&m::N_G]),
    (
        "motion_forces",
        &[
            &m::F_AX,
            &m::F_AY,
            &m::M_RC,
            &m::M_RV,
            &m::M_RS,
            &m::M_IM,
            &m::M_W1,
            &m::M_W2,
            &m::M_W3,
            &m::F_5X,
            &m::F_5Y,
            &m::M_I5,
            &m::N_5X,
            &m::N_5Y,
            &b::N_1,
            &m::E_1X,
            &m::E_1Y,
            &b::F_KX,
            &b::F_KY,
            &b::F_MX,
            &b::F_MY,
            &m::F_IBX,
            &m::F_IBY,
            &m::M_T,
            &d::S_LM,
            &d::S_LM_OUT,
            &d::S_LM_IN,
        ],
    ),
];

/// The section of a load that stands on the ground: at an instant of its own.
const STANDING: &str = "motion_standing";

/// What is found while the model is assembled, before it moves, besides a mechanism's own.
const ASSEMBLED: [&Symbol; 6] = [&m::MASS_Q, &m::MASS_H, &m::DELTA_AIR, &m::KAPPA_AIR, &h::A_A, &h::A_B];

type Given<T> = <<T as Described>::Component as Stages>::Given<f64>;

/// What is told of a scene whose mechanism moves; `None` where the model cannot start.
pub(crate) fn moved<T: Shown>(luffing: &Description<T>) -> Option<Moved> {
    let (given, moving) = T::moves(luffing)?;
    let (rest, plans) = (at_rest(moving), planned(luffing, moving));
    let start = plans.first()?.start;
    let mut model = starting::<T::Component>(&given, luffing.motion, &rest, start).ok()?;
    let load = T::Component::luffing(&given).load;
    let [coordinate, rate] = [0, 1].map(|index| model.variables()[index].symbol);
    let instant = match (moving.oil, moving.rope) {
        (Some(_), _) => ("greatest_pressure", &m::P_A),
        (None, Some(_)) => ("greatest_rope_force", &m::S_R),
        (None, None) => ("greatest_speed", rate),
    };
    let designed = designed(T::FORCES, &model);
    let run = |plan| ran(luffing, (&given, moving), &rest, plan, instant.1, &designed);
    let ran = std::thread::scope(|scope| {
        let threads: Vec<_> = plans.iter().map(|plan| scope.spawn(|| run(plan))).collect();
        let ended = threads.into_iter().map(ScopedJoinHandle::join);
        ended
            .map(|ran| ran.unwrap_or_else(|panic| resume_unwind(panic)))
            .collect::<Option<Vec<_>>>()
    });
    let (manoeuvres, runs): (Vec<_>, Vec<_>) = ran?.into_iter().unzip();
    let (of, shown) = runs
        .iter()
        .enumerate()
        .max_by(|(_, a), (_, b)| a.most.total_cmp(&b.most))?;
    model.set_state(&shown.state);
    // A taut rope is straight: at the end of a step it is off by rounding.
    let mut states = vec![0.0; model.states()];
    model.get_states(&mut states);
    model.set_states(&states).ok()?;
    model.update().ok()?;
    let envelope = |&(symbol, index): &(&'static Symbol, usize)| {
        let weight = load.filter(|_| symbol == &m::S_R);
        Envelope {
            symbol,
            still: weight.map(|weight| [Summary::new(symbol, weight.1); 2]),
            moving: runs.iter().map(|run| run.series.stands(index)).collect(),
        }
    };
    let mut constants = match moving.oil {
        Some(_) => vec![(&h::DP_LAM, LAMINAR), (&m::OMEGA_C, CREEP)],
        None => Vec::new(),
    };
    let law = moving.controllers.and_then(|controllers| {
        let rest = Moving {
            controllers: Some(controllers),
            ..rest
        };
        let mut model = starting::<T::Component>(&given, luffing.motion, &rest, start).ok()?;
        model.set_states(&states).ok()?;
        let own = T::Component::luffing(model.standing().of::<T::Component>().given()).sources;
        constants.extend(own.latched.iter().flat_map(ByAxis::before));
        constants.extend(own.regulating.iter().flat_map(ByAxis::values));
        Some(law::<T>(&model, controllers.are_sampled()))
    });
    let chapter = InMotion {
        time: &m::T,
        coordinate,
        instant: (instant.0, manoeuvres[of].id, shown.instant),
        of: None,
        state: [state(&mut model, [coordinate, rate]), heights::<T>(&mut model)].concat(),
        constants,
        sections: sections::<T>(&model).into_iter().chain(law).collect(),
        ramp: Some((&m::T_S, moving.ramp)),
        rules: rules(moving),
        envelope: designed.iter().map(envelope).collect(),
        manoeuvres,
        integrals: integrals(moving, rate),
    };
    Some(judged(luffing, moving, chapter, &runs))
}

/// One of them, with what is told of it; `lead` says which instant is shown.
fn ran<T: Shown>(
    luffing: &Description<T>,
    (given, moving): (&Given<T>, &Moving),
    rest: &Moving,
    plan: &Planned,
    lead: &Symbol,
    designed: &[(&'static Symbol, usize)],
) -> Option<(Manoeuvre, Run)> {
    let mut model = starting::<T::Component>(given, luffing.motion, rest, plan.start).ok()?;
    let mut pilot = Pilot::new(plan, luffing, moving, &model)?;
    let drawn = drawn::<T>(plan, &model);
    let lead = model.variables().iter().position(|variable| variable.symbol == lead)?;
    let drawn_indices = drawn.iter().map(|(_, index)| *index);
    let frames = series::seen(&model);
    let looked = drawn_indices.chain(designed.iter().map(|(_, index)| *index));
    let looked = looked.chain(frames.iter().copied());
    let run = Run::new(luffing, rest, &mut model, (lead, looked), &mut pilot)?;
    let symbol = |index: usize| model.variables()[index].symbol;
    let manoeuvre = Manoeuvre {
        id: plan.id,
        start: plan.start,
        commands: pilot
            .told
            .into_iter()
            .map(|(index, table)| (symbol(index), table))
            .collect(),
        run: [run.series.duration(), run.series.sample],
        curves: drawn
            .iter()
            .filter_map(|&(id, index)| run.series.curve(id, [&m::T, symbol(index)], index))
            .collect(),
        seen: run.series.frames(&model, &frames),
        events: run.listed(),
        stop: run.stop.iter().flat_map(Stop::told).collect(),
        more_events: run.events.len().saturating_sub(EVENTS),
        energy: run.energy.list(moving),
    };
    Some((manoeuvre, run))
}

/// States and commands as they are now, without those of the position alone.
fn state(model: &mut MovingComponent, bar: [&'static Symbol; 2]) -> Vec<(&'static Symbol, f64)> {
    let indices = |role: Role| {
        let all = model.variables().iter().enumerate();
        let of = all.filter(move |(_, variable)| variable.role == role);
        of.map(|(index, variable)| (index, variable.symbol)).collect::<Vec<_>>()
    };
    let listed: Vec<_> = indices(Role::State).into_iter().chain(indices(Role::Input)).collect();
    listed
        .into_iter()
        .filter_map(|(index, symbol)| Some((symbol, model.get(index).ok()?)))
        .filter(|(symbol, _)| [&STATES[..], &INPUTS, &bar].iter().any(|list| list.contains(symbol)))
        .collect()
}

/// What the wind's moments have of each bar as it is now, where it blows.
fn heights<T: Shown>(model: &mut MovingComponent) -> Vec<(&'static Symbol, f64)> {
    let known = carried::known::<T::Component>(model.parts().0);
    let Ok((level, at)) = T::Component::in_motion(known) else {
        return Vec::new();
    };
    let one = Weather {
        wind: [1.0, 0.0],
        ..Weather::calm()
    };
    let outdoors = level.dynamics().weather();
    let moments = outdoors.and_then(|outdoors| outdoors.to.pushes(at.y[0], &one));
    let moments = moments.iter().flatten().map(|[_, moment]| *moment);
    let of = m::OF_AREAS.into_iter().zip(moments);
    of.filter(|(_, moment)| *moment != 0.0).collect()
}

/// The equations at the model's instant. Each section is recorded from the start and shows its own steps.
fn sections<T: Shown>(model: &MovingComponent) -> Vec<Section> {
    let standing = standing::<T::Component>(model);
    let section = |(id, symbols): (&'static str, &[&Symbol])| {
        let model = standing.as_ref().filter(|_| id == STANDING).unwrap_or(model);
        let own = T::SECTIONS.iter().find(|(of, ..)| *of == id);
        let (id, own) = own.map_or((id, &[][..]), |(_, id, own)| (*id, *own));
        let (mut trace, assembled) = record(|| recorded::<T>(model, T::STAGES));
        let mut seen: Vec<&Symbol> = Vec::new();
        let mut index = 0;
        trace.steps.retain(|step| {
            let early = index < assembled;
            index += 1;
            let ready = || ASSEMBLED.contains(&step.symbol) || T::ASSEMBLED.contains(&step.symbol);
            let listed = symbols.contains(&step.symbol) || own.contains(&step.symbol);
            let wanted = listed && (!early || ready());
            let first = wanted && !seen.contains(&step.symbol);
            if first {
                seen.push(step.symbol);
            }
            first
        });
        Section {
            id,
            trace,
            ..Section::default()
        }
    };
    // Nothing is recorded for ground where there is none.
    let grounds = ["motion_ground", STANDING];
    SECTIONS
        .into_iter()
        .filter(|(id, _)| standing.is_some() || !grounds.contains(id))
        .map(section)
        .filter(|section| !section.trace.steps.is_empty())
        .collect()
}

/// One sample of the controllers, or what they give where they are continuous, where the model is.
fn law<T: Shown>(model: &MovingComponent, sampled: bool) -> Section {
    let (id, stage) = match sampled {
        true => ("motion_control", "sampled"),
        false => ("motion_regulation", "regulated"),
    };
    let (mut trace, assembled) = record(|| recorded::<T>(model, &[stage]));
    trace.steps.drain(..assembled);
    // Those of the crane stand in sections of their own.
    let mut seen = Vec::new();
    trace.steps.retain(|step| {
        let first = !seen.contains(&step.symbol);
        seen.push(step.symbol);
        let approaches = || AXES.iter().any(|axis| axis.sample[..2].contains(&step.symbol));
        sampled || (first && (REGULATION.contains(&step.symbol) || approaches()))
    });
    Section {
        id,
        trace,
        ..Section::default()
    }
}

/// The chapter of all runs, each of a manoeuvre, with what is judged in them and warned of.
fn judged<T: Shown>(luffing: &Description<T>, moving: &Moving, chapter: InMotion, runs: &[Run]) -> Moved {
    let most = |of: fn(&Run) -> [f64; 2]| {
        runs.iter()
            .map(of)
            .fold([0.0; 2], |a, b| if b[0] > a[0] { b } else { a })
    };
    let swing = moving.rope.map(|_| timed(&m::PHI_MAX, most(|run| run.greatest_swing)));
    let allowed = luffing.limit(&m::PHI_MAX);
    let pressure = timed(&m::P_MAX, most(|run| run.greatest_pressure));
    let asked = [
        swing.zip(allowed).map(|(swing, most)| ("motion_swing", swing, most)),
        moving.oil.map(|oil| ("motion_pressure", pressure, oil.p_r)),
    ];
    let checked = asked.iter().flatten();
    let named = runs.iter().zip(&chapter.manoeuvres);
    let apart = |i: usize| runs.iter().map(|run| run.apart()[i]).fold(0.0, f64::max);
    let agree = |id, i, limit| Check::at_most(id, T::AGREEMENT, apart(i), limit);
    Moved {
        requirements: checked
            .map(|(id, found, limit)| Check::of(id, found, *limit, true))
            .collect(),
        unjudged: swing
            .filter(|_| allowed.is_none())
            .map(|swing| swing.symbol)
            .into_iter()
            .collect(),
        identities: (T::APART.map(|_| agree("motion_forces", 0, 1e-9)).into_iter())
            .chain([agree("motion_energy", 1, 1e-3)])
            .collect(),
        warnings: named.flat_map(|(run, manoeuvre)| run.warnings(manoeuvre.id)).collect(),
        chapter,
    }
}
