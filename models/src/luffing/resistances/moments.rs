//! The moments of a case by virtual work.

use std::f64::consts::TAU;

use crate::component::stages::results;
use crate::kernel::calc::Calc;
use crate::kernel::group::One;
use crate::kernel::symbol::Symbol;
use crate::luffing::resistances::given::Case;
use crate::luffing::resistances::sums::Sums;
use crate::luffing::resistances::symbols as s;
use crate::parts::plane::Point;

/// A case but for friction. Moments in N·m, positive where they raise the boom.
#[derive(Clone, Copy, Debug)]
pub struct Resisted<C> {
    /// Wind pressure, in Pa; of slewing, in rad/s; of the luffing angle in rad/s and rad/s².
    pub pressure: C,
    pub slewing: C,
    pub rate: C,
    pub bend: C,
    load: C,
    sway: C,
    wind: C,
    centrifugal: C,
    points: C,
    pub inertia: C,
    slope: C,
    /// Of all of them and of the own weights.
    pub sum: C,
}
results! { each Resisted as r => {
    P_I: r.pressure;
    OMEGA_S: r.slewing;
    OMEGA_R: r.rate;
    DOMEGA_R: r.bend;
    M_R_LOAD: r.load;
    M_R_SWAY: r.sway;
    M_R_WIND: r.wind;
    M_R_CENTRIFUGAL: r.centrifugal;
    M_R_POINTS: r.points;
    M_R_INERTIA: r.inertia;
    M_R_SLOPE: r.slope;
} }

impl Resisted<f64> {
    pub fn load(&self) -> f64 {
        self.load
    }

    /// All but inertia: what has an energy at each position, in N·m.
    pub fn of_energy(&self) -> f64 {
        self.sum - self.inertia
    }

    /// Greatest moment by amount, in N·m.
    pub fn greatest(&self) -> f64 {
        let all = [
            self.load,
            self.sway,
            self.wind,
            self.centrifugal,
            self.inertia,
            self.slope,
            self.sum,
        ];
        all.iter().fold(0.0, |most, part| most.max(part.abs()))
    }
}

impl<C: Calc> Resisted<C> {
    /// With the whole load (N) and the pressure of the wind over the square of its speed (kg/m³). [Ports001, 5.5]
    pub fn new(sums: &Sums<C>, load: &One<C>, air: &One<C>, case: &Case<C>) -> Resisted<C> {
        let (q, half) = ((case.k_q * load.1), C::constant(0.5));
        let [rate, bend] = rates(sums.way, case);
        let slewing = (C::constant(TAU) * case.n).def(&s::OMEGA_S);
        let pressure = pressure(air.1, [case.p, case.v_w], &s::P_I);
        let (sin, cos) = case.alpha.sin_cos();
        let own = sums.own;
        let load = (-(q * sums.load)).def(&s::M_R_LOAD);
        let sway = (q * sin / cos * sums.head.x).def(&s::M_R_SWAY);
        let wind = (pressure * sums.swept).def(&s::M_R_WIND);
        let centrifugal = (half * slewing.square() * sums.about_axis).def(&s::M_R_CENTRIFUGAL);
        let points = (slewing.square() * sums.points).def(&s::M_R_POINTS);
        let inertia = (-(sums.inertia[0] * bend + half * sums.inertia[1] * rate.square())).def(&s::M_R_INERTIA);
        let slope = slope(sums, q, case.sigma);
        Resisted {
            pressure,
            slewing,
            rate,
            bend,
            load,
            sway,
            wind,
            centrifugal,
            points,
            inertia,
            slope,
            sum: own + load + sway + wind + centrifugal + inertia + slope,
        }
    }
}

/// ω = v / s′, ω̇ = (a − s″ ω²) / s′; nothing moves where the drive points at the foot of its bar. [Ports001, 5.5.5]
fn rates<C: Calc>([way, change]: [C; 2], case: &Case<C>) -> [C; 2] {
    if way.value().abs() <= f64::EPSILON {
        return [C::constant(0.0); 2];
    }
    let rate = (case.v / way).def(&s::OMEGA_R);
    [rate, ((case.a - change * rate.square()) / way).def(&s::DOMEGA_R)]
}

/// p = p_w + c v |v|. [Ports001, 5.5.4]
pub fn pressure<C: Calc>(air: C, [given, speed]: [C; 2], name: &'static Symbol) -> C {
    if speed.value() == 0.0 {
        return given.over(air * speed);
    }
    (given + air * speed * speed.abs()).def(name)
}

/// Weights and load lean by the slope: forward by its sine, and are lighter by what its cosine lacks.
fn slope<C: Calc>(sums: &Sums<C>, q: C, sigma: C) -> C {
    let at = Point::new(sums.weighed.x + q * sums.head.x, sums.weighed.y + q * sums.head.y);
    leaning(at, sigma).def(&s::M_R_SLOPE)
}

/// Of weights times their places, or their travels, forward and up, what a slope (rad) makes of them.
pub fn leaning<C: Calc>(weighed: Point<C>, sigma: C) -> C {
    let (sin, cos) = sigma.sin_cos();
    weighed.x * sin + weighed.y * (C::constant(1.0) - cos)
}
