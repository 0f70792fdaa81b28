//! Air that resists a load on its rope, still or in wind: in part with its speed, in part with the square of it.

use nalgebra::Vector3;

use crate::kernel::calc::{Calc, Over};
use crate::kernel::diagnostic::Diagnostic;
use crate::kernel::group::quantities;
use crate::kernel::keys::keys;
use crate::kernel::schema::{Key, Values};
use crate::kernel::symbol::{Symbol, symbols};
use crate::parts::air as s;

symbols! {
    // Given.
    Q_AIR: "Q_air" "Q_\"air\"" N / KN [positive], "Load that has this area and damping: another one has as much of both as it weighs of this.", "input";
    D_Q: "d_Q" "d_Q" N_S_PER_M / KN_S_PER_M [not_negative], "Damping of the load: force of the air over its speed, as far as it goes with that.", "input";
    C_WQ: "c_wQ" "c_\"wQ\"" ONE / ONE [not_negative], "Drag coefficient of the load.", "input";
    A_Q: "A_Q" "A_Q" M2 / M2 [not_negative], "Area of the load that the air meets.", "input";
    RHO_AIR: "rho_air" "rho_\"air\"" KG_PER_M3 / KG_PER_M3 [positive], "Density of the air.", "input";
    V_AIR: "v_air" "v_\"air\"" M_PER_S / M_PER_S [from_to(-70.0, 70.0)], "Speed of the wind; positive forward or, where the crane slews, in its direction.", "input";
    CHI_AIR: "chi_air" "chi_\"air\"" RAD / DEG, "Direction to which the wind blows, counted as the slewing angle.", "input";

    // The load in the air.
    DELTA_AIR: "delta_air" "delta_\"air\"" PER_S / PER_S, "Damping of a load over its mass.", "derived";
    KAPPA_AIR: "kappa_air" "kappa_\"air\"" PER_M / PER_M, "Drag of a load over its mass and the square of its speed.", "derived";
    U_AIR: "u_air" "u_\"air\"" M_PER_S / M_PER_S, "Speed of the load against the air.", "derived";
    U_AIR_X: "u_air.x" "u_(\"air\" x)" M_PER_S / M_PER_S, "Speed of the load against the air, forward.", "derived";
    U_AIR_Y: "u_air.y" "u_(\"air\" y)" M_PER_S / M_PER_S, "Speed of the load against the air, upwards.", "derived";
    U_AIR_Z: "u_air.z" "u_(\"air\" z)" M_PER_S / M_PER_S, "Speed of the load against the air, to the left.", "derived";
    A_AIR_X: "a_air.x" "a_(\"air\" x)" M_PER_S2 / M_PER_S2, "Force of the air over the mass of the load, forward.", "derived";
    A_AIR_Y: "a_air.y" "a_(\"air\" y)" M_PER_S2 / M_PER_S2, "Force of the air over the mass of the load, upwards.", "derived";
    A_AIR_Z: "a_air.z" "a_(\"air\" z)" M_PER_S2 / M_PER_S2, "Force of the air over the mass of the load, to the left.", "derived";
    F_AIR: "F_air" "F_\"air\"" N / KN [not_negative], "Force of the air on the load.", "derived";
    P_AIR: "P_air" "P_\"air\"" W / KW, "Power that the air takes from the load; negative where the wind gives it.", "derived";
    W_AIR: "W_air" "W_\"air\"" J / KJ, "Work that the air has taken from the load.", "derived";
}

quantities! {
    /// Of a load and the air around it.
    AirAround { q_air: Q_AIR, d_q: D_Q, c_wq: C_WQ, a_q: A_Q, rho_air: RHO_AIR }
}

quantities! {
    /// The wind.
    WindAround { v_air: V_AIR, chi_air: CHI_AIR }
}

/// The table of a scene that has the air around a load that swings.
pub const AIR: Key = Key::part("air", AIR_KEYS, "Air that resists a load on its rope, and the wind.");

const AIR_KEYS: &[Key] = keys! { s:
    Q_AIR > 0 [or_mass], D_Q >= 0 [usually(0.0)], C_WQ >= 0 [usually(0.0)], A_Q >= 0 [usually(0.0)],
    RHO_AIR > 0 [usually(1.225)], V_AIR [over_time, optional], CHI_AIR [over_time, optional]
};

/// The same of slewing, where the wind may act on the structure alone: what is of a load stands with that.
pub const AIR_OR_WIND: Key = Key::part(
    AIR.name,
    &WITHOUT_LOAD,
    "Air that resists a load on its rope, and the wind.",
);

static WITHOUT_LOAD: [Key; 8] = {
    let mut keys = [AIR_KEYS[0]; 8];
    let mut i = 1;
    while i < keys.len() {
        keys[i] = AIR_KEYS[i];
        if i < AROUND.len() {
            keys[i] = keys[i].only_with(AROUND[0]);
        }
        i += 1;
    }
    keys[0] = keys[0].optional();
    keys
};

/// Keys of slewing that say something of a load that swings, and those of its table of the air.
pub const SWINGING: [&str; 3] = ["l_R", "phi_R", "chi_R"];
pub const AROUND: [&str; 4] = ["Q_air", "d_Q", "c_wQ", "A_Q"];

/// Most that the air may take of the load's speed in the strongest wind, over the frequency of its swinging: beyond that
/// the load does not swing any more.
const THICKEST: f64 = 4.0;

/// The air that a table has around a load that swings with a frequency (rad/s) under gravity (m/s²), where the crane slews or
/// does not; mistakes go to `found`.
pub fn around(
    table: &Values,
    [swings, gravity]: [f64; 2],
    slews: bool,
    found: &mut Vec<Diagnostic>,
) -> Option<AirAround<f64>> {
    let before = found.len();
    if !slews && table.has(CHI_AIR.id) {
        let what = "chi_air of a crane that does not slew";
        found.push(table.refuse(
            CHI_AIR.id,
            what,
            "not used",
            "remove it: the wind blows forward, or backward where v_air is negative",
        ));
    }
    let air = AirAround {
        q_air: table.of(&Q_AIR)?,
        d_q: table.of(&D_Q)?,
        c_wq: table.of(&C_WQ)?,
        a_q: table.of(&A_Q)?,
        rho_air: table.of(&RHO_AIR)?,
    };
    let drag = AirDrag::new(&air, gravity);
    let takes = drag.linear + drag.square * V_AIR.range.most;
    if found.len() == before && takes > THICKEST * swings {
        let what = format!(
            "the air takes {} of the speed of a load that swings with {}",
            DELTA_AIR.written(takes),
            DELTA_AIR.written(swings)
        );
        let symbol = if drag.linear > drag.square * V_AIR.range.most {
            &D_Q
        } else {
            &A_Q
        };
        found.push(table.refuse(
            symbol.id,
            what,
            "too much for so light a load",
            "give less of it, or a heavier load Q_air",
        ));
    }
    (found.len() == before).then_some(air)
}

/// What the air does to any load over its mass: by its speed (1/s), and by the square of that (1/m).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct AirDrag<C> {
    pub linear: C,
    pub square: C,
}

impl<C: Calc> AirDrag<C> {
    /// δ = d_Q g/Q_air, κ = ½ ρ_air c_wQ A_Q g/Q_air, gravity in m/s².
    pub fn new(around: &AirAround<C>, gravity: C) -> AirDrag<C> {
        let mass = around.q_air / gravity;
        let area = C::constant(0.5) * around.rho_air * around.c_wq * around.a_q;
        AirDrag {
            linear: (around.d_q / mass).def(&DELTA_AIR),
            square: (area / mass).def(&KAPPA_AIR),
        }
    }

    /// Over a scalar that has derivatives besides.
    pub fn over<D: Over<C>>(self) -> AirDrag<D> {
        AirDrag {
            linear: D::of(self.linear),
            square: D::of(self.square),
        }
    }

    /// δ + κ u in 1/s, and |u| in m/s, at a speed against the air (m/s).
    fn strength<const N: usize>(&self, against: &[C; N]) -> [C; 2] {
        let squares = against.iter().fold(C::constant(0.0), |sum, part| sum + part.square());
        // Where it does not move against the air the square has no slope.
        let speed = match squares.value() {
            0.0 => C::constant(0.0).over(squares),
            _ => squares.sqrt(),
        };
        let speed = speed.def(&U_AIR);
        [self.linear + self.square * speed, speed]
    }

    /// a = −(δ + κ u) u, in m/s², of a load at a speed against the air (m/s).
    pub fn on<const N: usize>(&self, against: [C; N]) -> [C; N] {
        let [strength, _] = self.strength(&against);
        let parts = against.map(|part| -(strength * part));
        named(parts, std::array::from_fn(|i| [&A_AIR_X, &A_AIR_Y, &A_AIR_Z][i]))
    }

    /// Force over mass (m/s²), and the power over mass that the air takes (W/kg) from a load at a speed against the ground and
    /// against the air (m/s).
    pub fn felt<const N: usize>(&self, speed: [C; N], against: [C; N]) -> [C; 2] {
        let [strength, amount] = self.strength(&against);
        let along = speed.iter().zip(&against);
        let along = along.fold(C::constant(0.0), |sum, (speed, against)| sum + *speed * *against);
        [strength * amount, strength * along]
    }
}

/// Names the components.
fn named<C: Calc, const N: usize>(of: [C; N], names: [&'static Symbol; N]) -> [C; N] {
    std::array::from_fn(|i| of[i].def(names[i]))
}

/// The air as a load meets it whose head slews: its drag, and the wind in the frame that slews (m/s).
#[derive(Clone, Copy, Debug)]
pub struct Stream<C> {
    pub drag: AirDrag<C>,
    pub wind: Vector3<C>,
}

impl<C: Calc> Stream<C> {
    /// At a slewing angle (rad), with the speed (m/s) and the direction (rad) of the wind.
    pub fn new(drag: AirDrag<C>, [speed, to]: [C; 2], psi: C) -> Stream<C> {
        let (aside, ahead) = (to - psi).sin_cos();
        Stream {
            drag,
            wind: Vector3::new(speed * ahead, C::constant(0.0), speed * aside),
        }
    }

    /// Of a load at a speed against the ground, in m/s.
    fn against(&self, speed: Vector3<C>) -> [C; 3] {
        named((speed - self.wind).into(), [&U_AIR_X, &U_AIR_Y, &U_AIR_Z])
    }

    /// In m/s², of a load at a speed against the ground (m/s).
    pub fn on(&self, speed: Vector3<C>) -> Vector3<C> {
        self.drag.on(self.against(speed)).into()
    }

    /// As [`AirDrag::felt`].
    pub fn felt(&self, speed: Vector3<C>) -> [C; 2] {
        self.drag.felt(speed.into(), self.against(speed))
    }
}
