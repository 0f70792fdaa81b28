//! A load on a rope that swings in all directions from a head that J joints move, slewing the last of them.
//!
//! Everything stands in the frame that slews with the crane: x forward, y up, z to the left, where a growing slewing angle
//! turns x. The load's place is that of a point seen from the head, not two angles of the rope: no direction of the rope
//! is singular, not even straight up or sideways. While the rope is taut its length is a constraint, and the rope's force
//! the multiplier that keeps it. [Lagrange, first kind]

use nalgebra::Vector3;

use crate::kernel::calc::Calc;
use crate::kernel::diagnostic::Diagnostic;
use crate::kernel::schema::Values;
use crate::kernel::symbol::{Symbol, symbols};
use crate::parts::ground::Surroundings;
use crate::parts::hoist::RopeAction;

symbols! {
    // States, seen from the frame that slews.
    X_Q: "x_Q" "x_Q" M / M, "Load, forward of the head.", "equations of motion";
    Y_Q: "y_Q" "y_Q" M / M, "Load, above the head.", "equations of motion";
    Z_Q: "z_Q" "z_Q" M / M, "Load, to the left of the head.", "equations of motion";
    V_QX: "v_Qx" "v_(Q x)" M_PER_S / M_PER_S, "Speed of the load forward, from the head.", "equations of motion";
    V_QY: "v_Qy" "v_(Q y)" M_PER_S / M_PER_S, "Speed of the load up, from the head.", "equations of motion";
    V_QZ: "v_Qz" "v_(Q z)" M_PER_S / M_PER_S, "Speed of the load to the left, from the head.", "equations of motion";

    // Rope and load.
    PHI_R: "phi_R" "phi_R" RAD / DEG, "Angle of the rope from the vertical; positive swings the load forward.", "equations of motion";
    L_R: "l_R" "l_R" M / M [positive], "Length of the rope from the head to the load.", "equations of motion";
    S_Q: "s_Q" "s_Q" M / M, "Distance of the load from the head: the rope's length, or less where it is slack.", "equations of motion";
    S_R: "S_R" "S_R" N / KN, "Force in the rope; zero where it is slack.", "equations of motion";
    MASS_E: "mass_e" "m_e" KG / T, "Mass in the place of an empty hook's load: it cancels from the rope's equation.", "Lagrange";

    // The equations of motion.
    ALPHA_0: "alpha_0" "dot(omega)_(0)" RAD_PER_S2 / RAD_PER_S2, "Angular acceleration of the driving link without the rope's force.", "Lagrange";
    ALPHA_0SL: "alpha_0sl" "dot(omega)_(0 \"sl\")" RAD_PER_S2 / RAD_PER_S2, "Angular acceleration of slewing without the rope's force.", "Lagrange";
    N_X: "n_x" "n_x" ONE / ONE, "Direction of the rope from the head, forward component.", "derived";
    N_Y: "n_y" "n_y" ONE / ONE, "Direction of the rope from the head, upward component.", "derived";
    N_Z: "n_z" "n_z" ONE / ONE, "Direction of the rope from the head, component to the left.", "derived";
    H_1R: "h_1R" "h_(1 R)" M / M, "Travel of the head along the rope for one radian of the driving link.", "derived";
    H_2R: "h_2R" "h_(2 R)" M / M, "Travel of the head along the rope for one radian of slewing.", "derived";
    V_E: "v_e" "v_e" M_PER_S / M_PER_S, "Speed along the rope beyond that of the hoist: rounding alone.", "derived";
    W_X: "w_x" "w_x" M_PER_S / M_PER_S, "Speed of the load across its rope, forward.", "derived";
    W_Y: "w_y" "w_y" M_PER_S / M_PER_S, "Speed of the load across its rope, up.", "derived";
    W_Z: "w_z" "w_z" M_PER_S / M_PER_S, "Speed of the load across its rope, to the left.", "derived";
    R_QX: "r_Qx" "r_x" M / M, "Load, forward of the slewing axis.", "derived";
    U_X: "u_x" "u_x" M_PER_S / M_PER_S, "Speed of the load in the frame that slews, forward.", "derived";
    U_Y: "u_y" "u_y" M_PER_S / M_PER_S, "Speed of the load in the frame that slews, up.", "derived";
    B_X: "b_x" "b_x" M_PER_S2 / M_PER_S2, "Acceleration of the free load from a head whose joints keep their speeds, forward.", "Lagrange";
    B_Y: "b_y" "b_y" M_PER_S2 / M_PER_S2, "Acceleration of the free load from a head whose joints keep their speeds, up.", "Lagrange";
    B_Z: "b_z" "b_z" M_PER_S2 / M_PER_S2, "Acceleration of the free load from a head whose joints keep their speeds, to the left.", "Lagrange";
    A_N: "a_N" "a_N" M_PER_S2 / M_PER_S2, "Acceleration along the rope that its force must take from the load.", "Lagrange";
    KAPPA_R: "kappa_R" "kappa_R" ONE / ONE, "Effective-mass factor of the load along its rope: its mass over that which the rope's force feels, as the head gives way too.", "Lagrange";
    A_R: "a_R" "a_R" M_PER_S2 / M_PER_S2, "Force of the rope over the mass of the load.", "Lagrange";

    // Rates of the states, and the event.
    D_X_Q: "der(x_Q)" "dot(x)_Q" M_PER_S / M_PER_S, "Rate of the load's place forward of the head.", "state";
    D_Y_Q: "der(y_Q)" "dot(y)_Q" M_PER_S / M_PER_S, "Rate of the load's place above the head.", "state";
    D_Z_Q: "der(z_Q)" "dot(z)_Q" M_PER_S / M_PER_S, "Rate of the load's place to the left of the head.", "state";
    D_V_QX: "der(v_Qx)" "dot(v)_(Q x)" M_PER_S2 / M_PER_S2, "Acceleration of the load forward, from the head.", "equations of motion";
    D_V_QY: "der(v_Qy)" "dot(v)_(Q y)" M_PER_S2 / M_PER_S2, "Acceleration of the load up, from the head.", "equations of motion";
    D_V_QZ: "der(v_Qz)" "dot(v)_(Q z)" M_PER_S2 / M_PER_S2, "Acceleration of the load to the left, from the head.", "equations of motion";
    Z_ROPE: "z.rope" "z_5" ONE / ONE, "Falls below zero where the rope becomes slack or taut.", "event";
}

/// Shortest rope, over what the crane reaches: on a shorter one the load swings twenty times as fast as on one that long.
const SHORTEST: f64 = 2.5e-3;

/// Refuses a rope (m) in a table that is next to nothing beside a reach (m).
#[must_use]
pub fn too_short(table: &Values, rope: f64, (symbol, reach): (&Symbol, f64)) -> Option<Diagnostic> {
    let least = SHORTEST * reach;
    (rope < least).then(|| {
        let what = format!(
            "l_R = {} where {} = {}",
            L_R.written(rope),
            symbol.id,
            symbol.written(reach)
        );
        let help = format!(
            "give at least {}, or a level at which the load does not swing",
            L_R.written(least)
        );
        table.refuse(L_R.id, what, "too short", help)
    })
}

/// Components of the load's place, of its rate, and of its acceleration.
pub const PLACE: [&Symbol; 3] = [&X_Q, &Y_Q, &Z_Q];
const ACCELERATION: [&Symbol; 3] = [&D_V_QX, &D_V_QY, &D_V_QZ];

/// Travel of the head along the rope, by luffing and by slewing.
const ARMS: [&Symbol; 2] = [&H_1R, &H_2R];

/// Least mass of a load, in kg, by which an equation can be multiplied.
const LIGHTEST: f64 = 1e-99;

/// Mass (kg) by which equations are multiplied that hold for any load, so that it cancels: where the rope swings to, and
/// what keeps it taut. The rope of an empty hook moves as that of the lightest load.
pub fn cancelling<P: Calc>(mass: P) -> P {
    if mass.value() > LIGHTEST {
        mass
    } else {
        P::known(&MASS_E, 1.0)
    }
}

/// Turned by a right angle about the slewing axis: what a point moves by when the crane slews by one.
pub fn turned<C: Calc>(v: Vector3<C>) -> Vector3<C> {
    Vector3::new(-v.z, C::constant(0.0), v.x)
}

pub fn dot<C: Calc>(a: Vector3<C>, b: Vector3<C>) -> C {
    a.x * b.x + a.y * b.y + a.z * b.z
}

pub fn squared<C: Calc>(v: Vector3<C>) -> C {
    v.x.square() + v.y.square() + v.z.square()
}

/// Names the components.
fn named<C: Calc>(v: Vector3<C>, [x, y, z]: [&'static Symbol; 3]) -> Vector3<C> {
    Vector3::new(v.x.def(x), v.y.def(y), v.z.def(z))
}

fn scaled<C: Calc>(v: Vector3<C>, by: C) -> Vector3<C> {
    v.map(|x| x * by)
}

/// Distance of the load from the head (m), and its direction.
pub fn to_load<C: Calc>(place: Vector3<C>) -> (C, Vector3<C>) {
    let length = squared(place).sqrt().def(&S_Q);
    (length, named(place.map(|x| x / length), [&N_X, &N_Y, &N_Z]))
}

/// The load at one instant: place and rate from the head, in the frame that slews.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct HangingLoad<C> {
    pub place: Vector3<C>,
    pub rate: Vector3<C>,
}

impl<C: Calc> HangingLoad<C> {
    /// Place, then rate.
    #[must_use]
    pub fn of(y: &[C; 6]) -> HangingLoad<C> {
        HangingLoad {
            place: Vector3::new(y[0], y[1], y[2]),
            rate: Vector3::new(y[3], y[4], y[5]),
        }
    }

    /// On a taut rope: away from the head exactly as fast as the rope is paid out. The rate along the rope
    /// that numbers carry besides is left alone by the equations, so that it cannot grow.
    #[must_use]
    pub fn on_rope<const J: usize>(self, rope: &HeadRope<C, J>, hoist: C) -> HangingLoad<C> {
        let excess = (dot(rope.direction, self.rate) - hoist).def(&V_E);
        let rate = self.rate - scaled(rope.direction, excess);
        HangingLoad {
            rate: named(rate, [&W_X, &W_Y, &W_Z]),
            ..self
        }
    }

    /// Angles of the rope in rad: in the plane of the mechanism from the vertical, in (−π, π], forward positive;
    /// and from that plane, in [−π/2, π/2], left positive.
    #[must_use]
    pub fn angles(&self) -> [C; 2] {
        let place = self.place;
        let quarter = C::constant(std::f64::consts::FRAC_PI_2);
        let within = (place.x.square() + place.y.square()).sqrt();
        [
            C::direction(-place.x, -place.y) - quarter,
            C::direction(within, place.z),
        ]
    }
}

impl HangingLoad<f64> {
    /// At rest at the end of a rope of a length (m), at angles (rad) from the vertical in the plane of the mechanism,
    /// forward positive, and from that plane, left positive.
    #[must_use]
    pub fn resting(length: f64, [swing, side]: [f64; 2]) -> HangingLoad<f64> {
        let ((sin, cos), (aside, within)) = (Calc::sin_cos(swing), Calc::sin_cos(side));
        HangingLoad {
            place: Vector3::new(within * sin, -within * cos, aside) * length,
            rate: Vector3::zeros(),
        }
    }

    /// At the end of a taut rope of a length (m) that is paid out at a rate (m/s), moving with it, where roundings have
    /// moved it by more than a few bits.
    #[must_use]
    pub fn straightened(mut self, length: f64, hoist: f64) -> HangingLoad<f64> {
        let distance = self.place.norm();
        let direction = self.place / distance;
        let excess = direction.dot(&self.rate) - hoist;
        let few = 16.0 * f64::EPSILON;
        if (distance - length).abs() > few * distance {
            self.place = direction * length;
        }
        if excess.abs() > few * (self.rate.norm() + hoist.abs()) {
            self.rate -= direction * excess;
        }
        self
    }

    /// As the head's rate changes under it by that of the joints (rad/s), and its own by `own` (m/s).
    #[must_use]
    pub fn shifted<const J: usize>(
        mut self,
        head: &[Vector3<f64>; J],
        change: [f64; J],
        own: Vector3<f64>,
    ) -> HangingLoad<f64> {
        let place = self.place + Vector3::new(head[J - 1].z, 0.0, 0.0);
        let mut rate = own;
        for (by, change) in head[..J - 1].iter().zip(change) {
            rate -= by * change;
        }
        self.rate += rate - turned(place) * change[J - 1];
        self
    }
}

/// Where the rope points, and what it moves: the head's displacement by each joint, and how much of it
/// goes along the rope.
#[derive(Clone, Copy, Debug)]
pub struct HeadRope<C, const J: usize> {
    pub length: C,
    pub direction: Vector3<C>,
    pub arms: [C; J],
}

impl<C: Calc, const J: usize> HeadRope<C, J> {
    pub fn new(place: Vector3<C>, head: &[Vector3<C>; J]) -> HeadRope<C, J> {
        let (length, direction) = to_load(place);
        let names = &ARMS[2 - J..];
        HeadRope {
            length,
            direction,
            arms: std::array::from_fn(|i| dot(direction, head[i]).def(names[i])),
        }
    }

    /// Of a rope that luffing adds to besides, for one radian of that joint (m).
    #[must_use]
    pub fn led(mut self, lead: Option<C>) -> HeadRope<C, J> {
        if let Some(lead) = lead {
            self.arms[0] += lead;
        }
        self
    }

    /// Force over the load's mass (m/s²) that keeps it at the rope's end: it moves at a rate (m/s), and would fall with
    /// `fall` (m/s²) from joints which accelerate so without the rope, each with one over its inertia where it is free.
    fn keeping(
        &self,
        line: RopeAction<C>,
        rate: Vector3<C>,
        fall: Vector3<C>,
        mass: C,
        joints: &HeadJoints<C, J>,
    ) -> C {
        let mut need = dot(self.direction, fall);
        let mut give = C::constant(1.0);
        if let RopeAction::Taut {
            rate: hoist,
            gain,
            drum,
        } = line
        {
            // Away from the head by the speed across the rope; the joints give way to the rope's force.
            let speed = squared(rate) - hoist.square();
            need += speed / self.length;
            if let Some(gain) = gain {
                need -= gain;
            }
            if let Some([drum, pull]) = drum {
                need += pull / drum;
                give += mass / drum;
            }
        }
        for i in 0..J {
            need -= self.arms[i] * joints.alone[i];
            give += mass * self.arms[i].square() * joints.ease[i];
        }
        need.def(&A_N) / give.def(&KAPPA_R)
    }
}

impl<const J: usize> HeadRope<f64, J> {
    /// How much easier a load of a mass (kg) gives way along the rope than by itself, as joints and drum do too, each by
    /// one over what moves.
    #[must_use]
    pub fn giving(&self, ease: [f64; J], mass: f64, drum: f64) -> f64 {
        let joints = self.arms.iter().zip(ease).map(|(arm, ease)| arm.powi(2) * ease);
        1.0 + mass * (joints.sum::<f64>() + drum)
    }
}

/// The joints that move the head, luffing first where there is one, slewing last.
#[derive(Clone, Copy, Debug)]
pub struct HeadJoints<C, const J: usize> {
    /// In rad/s.
    pub rates: [C; J],
    /// Acceleration without the rope's force (rad/s²), and one over the inertia where the joint is free.
    pub alone: [C; J],
    pub ease: [C; J],
    /// How the head moves with each, in the frame that slews, in m.
    pub head: [Vector3<C>; J],
    /// How its travel by luffing changes with that angle, in m.
    pub bend: Option<Vector3<C>>,
    /// Rope that one radian of luffing adds between head and load (m), where it adds any.
    pub lead: Option<C>,
    /// What their accelerations are called.
    pub names: [&'static Symbol; J],
}

/// Accelerations of the joints (rad/s²) and of the load from the head in the frame that slews (m/s²), the rate (m/s) at which
/// it moves there, and the force of the rope (N) with its arms about the joints (m); `slackening` has its sign, that of an
/// empty hook too.
#[derive(Clone, Copy, Debug)]
pub struct Accelerations<C, const J: usize> {
    pub joints: [C; J],
    pub load: Vector3<C>,
    pub rate: Vector3<C>,
    pub rope: C,
    pub arms: [C; J],
    pub slackening: C,
}

impl<C: Calc, const J: usize> HeadJoints<C, J> {
    /// With a load of a mass (kg), and the mass that [cancels](cancelling), on a rope which acts on it as a line, and what
    /// else acts on it.
    pub fn hung(
        &self,
        load: HangingLoad<C>,
        [mass, any]: [C; 2],
        line: RopeAction<C>,
        around: Surroundings<'_, C>,
    ) -> Accelerations<C, J> {
        let (zero, two, last) = (C::constant(0.0), C::constant(2.0), J - 1);
        let (head, turning) = (&self.head, self.rates[last]);
        let rope = match line {
            RopeAction::Slack => None,
            RopeAction::Taut { .. } | RopeAction::Force(_) => Some(HeadRope::new(load.place, head).led(self.lead)),
        };
        let load = match (&rope, line) {
            (Some(rope), RopeAction::Taut { rate, .. }) => load.on_rope(rope, rate),
            _ => load,
        };
        // From the slewing axis; how high does not matter to what slewing does.
        let from_axis = load.place + Vector3::new(head[last].z, zero, zero);
        let from_axis = Vector3::new(from_axis.x.def(&R_QX), from_axis.y, from_axis.z);
        let mut rate = load.rate;
        // Of the free load, seen from a head whose joints keep their rates.
        let (mut fall, air) = match around {
            Surroundings::Free { gravity, air } => (gravity, air),
            Surroundings::Ground => (Vector3::new(zero, zero, zero), None),
        };
        if let Some(bend) = self.bend {
            rate += scaled(head[0], self.rates[0]);
            rate = Vector3::new(rate.x.def(&U_X), rate.y.def(&U_Y), rate.z);
            fall -= scaled(bend, self.rates[0].square());
        }
        if let Some(air) = air {
            fall += air.on(rate + scaled(turned(from_axis), turning));
        }
        let coriolis = scaled(turned(rate), two * turning);
        let centripetal = scaled(turned(turned(from_axis)), turning.square());
        let fall = named(fall - coriolis - centripetal, [&B_X, &B_Y, &B_Z]);
        let (joints, pull) = match &rope {
            None => (self.alone, zero),
            Some(rope) => {
                let pull = match line {
                    RopeAction::Force(force) => force / mass,
                    _ => rope.keeping(line, load.rate, fall, mass, self),
                };
                let pull = pull.def(&A_R);
                let joint = |i: usize| (self.alone[i] + mass * pull * rope.arms[i] * self.ease[i]).def(self.names[i]);
                (std::array::from_fn(joint), pull)
            }
        };
        let mut relative = fall;
        for (by, joint) in head[..last].iter().zip(&joints) {
            relative -= scaled(*by, *joint);
        }
        relative -= scaled(turned(from_axis), joints[last]);
        if let (Some(rope), Surroundings::Free { .. }) = (&rope, around) {
            relative -= scaled(rope.direction, pull);
        }
        Accelerations {
            joints,
            load: named(relative, ACCELERATION),
            rate: load.rate,
            arms: rope.map_or([zero; J], |rope| rope.arms),
            rope: match line {
                RopeAction::Force(force) => force,
                _ => (mass * pull).def(&S_R),
            },
            slackening: any * pull,
        }
    }
}
