//! What a mechanism in motion is given besides its algebraic model: inputs, and what is constant.

use crate::kernel::group::quantities;
use crate::kernel::symbol::Symbol;
use crate::luffing::double_link::crane::Commands;
use crate::luffing::double_link::moving::hoisting::{HoistKind, RopeGive};
use crate::luffing::double_link::moving::symbols as s;
use crate::parts::hoist::HoistCommand;
use crate::parts::joint::JointDrive;
use crate::parts::turntable::Turning;

quantities! {
    /// A luffing cylinder with its oil and valve, besides bore and rod.
    CylinderOil {
        l_min: L_MIN, l_max: L_MAX, v_0: V_0, v_1: V_1, q_n: Q_N, dp_n: DP_N, dp_l: DP_L, beta_e: BETA_E,
        p_r: P_R, k_r: K_R, k_l: K_L, omega_v: OMEGA_V, zeta_v: ZETA_V, tol: TOL
    }
}

quantities! {
    /// What is constant in motion, besides geometry and weights.
    Constants { j_1: J_1, j_2: J_2, j_3: J_3, c_v: C_V, m_f: M_F, g: G, step: STEP }
}

/// Inputs, constant over a step.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Inputs<P = f64> {
    /// Of luffing and of slewing.
    pub drives: [JointDrive<P>; 2],
    pub hoist: HoistCommand<P>,
    /// Command of the valve in [−1, 1], and pressure of the pump in Pa.
    pub valve: P,
    pub supply: P,
}

impl<P: Copy> Inputs<P> {
    /// Of a crane of J joints.
    #[must_use]
    pub fn of<const J: usize>(&self) -> Commands<J, P> {
        Commands {
            drives: std::array::from_fn(|i| self.drives[i]),
            hoist: self.hoist,
        }
    }

    /// Over another scalar.
    pub fn map<C>(&self, of: &mut dyn FnMut(&'static Symbol, P) -> C) -> Inputs<C> {
        let mut drive = |[moment, brake]: [&'static Symbol; 2], drive: &JointDrive<P>| JointDrive {
            moment: of(moment, drive.moment),
            brake: of(brake, drive.brake),
        };
        let drives = [
            drive([&s::M_A, &s::M_S], &self.drives[0]),
            drive([&s::M_SL, &s::M_B_SL], &self.drives[1]),
        ];
        let drum = drive([&s::M_M_H, &s::M_B_H], &self.hoist.drive);
        Inputs {
            drives,
            hoist: HoistCommand {
                speed: of(&s::V_H, self.hoist.speed),
                drive: drum,
            },
            valve: of(&s::U_V, self.valve),
            supply: of(&s::P_P, self.supply),
        }
    }
}

/// All that is given; parts of the crane that the scene does not have are `None`.
#[derive(Clone, Copy, Debug)]
pub struct Given<P = f64> {
    pub inputs: Inputs<P>,
    pub constants: Constants<P>,
    pub hoist: HoistKind<P>,
    pub give: Option<RopeGive<P>>,
    pub turning: Option<Turning<P>>,
    pub oil: Option<CylinderOil<P>>,
}

impl<P: Copy> Given<P> {
    /// Over another scalar: `of` is told each number with its symbol.
    pub fn map<C>(&self, of: &mut dyn FnMut(&'static Symbol, P) -> C) -> Given<C> {
        Given {
            inputs: self.inputs.map(of),
            constants: self.constants.map(of),
            hoist: self.hoist.map(of),
            give: self.give.map(|give| give.map(of)),
            turning: self.turning.map(|turning| turning.map(of)),
            oil: self.oil.map(|oil| oil.map(of)),
        }
    }
}
