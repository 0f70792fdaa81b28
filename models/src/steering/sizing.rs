//! Force, bore, oil flow, pump and buckling of the steering cylinders. [Zhang2016, 5.2-6]

use crate::calc::Calc;
use crate::number::short;
use crate::steering::cylinder::Linkage;
use crate::steering::machine::{Limits, Machine, Refusal, within};
use crate::steering::mode::{Command, Mode};
use crate::steering::reach::{Reach, reach};
use crate::steering::symbols as s;
use crate::steering::wheels::rate;
use crate::symbol::quantities;

/// Bores of ISO 3320, in m. The standard itself has not been seen: eleven of the 24, from 50 to 320 mm, stand in a
/// maker's list of cylinders to ISO 6020-2, the others are not verified. Check it before use.
pub const BORES: [f64; 24] = [
    0.025, 0.032, 0.04, 0.05, 0.063, 0.08, 0.09, 0.1, 0.11, 0.125, 0.14, 0.16, 0.18, 0.2, 0.22, 0.25, 0.28, 0.32, 0.36,
    0.4, 0.45, 0.5, 0.56, 0.63,
];

quantities! {
    /// Bore and rod of a steering cylinder, in m.
    Piston { d_g: D_G, d: D }
}

quantities! {
    /// Oil supply: working pressure (Pa), speed (1/s) and volumetric efficiency of
    /// the pump, relief valve's pressure over the working pressure; Young's modulus
    /// (Pa) and safety factor of the rod against buckling.
    Hydraulics { p: P, n: N, eta: ETA, k_r: K_R, e: E, nu: NU }
}

/// Force of a cylinder, in N, against a moment (N·m) at a lever arm (m): f_g = T_g/od. [Zhang2016, 5.2]
/// The arm is not zero within a range that [`Linkage::over`] accepts.
#[inline]
pub fn force<C: Calc>(t_g: C, od: C) -> C {
    (t_g / od.abs()).def(&s::F_G)
}

/// Bore, in m, that pulls with `f_g` (N) at the pressure `p` (Pa) around a rod of
/// diameter `d` (m): D_g = √(4 f_g/(π p) + d²). [Zhang2016, 5.3]
pub fn bore<C: Calc>(f_g: C, p: C, d: C) -> Result<C, Refusal> {
    within(&s::F_G, f_g, 0.0, f64::INFINITY, false)?;
    within(&s::P, p, 0.0, 1e8, true)?;
    within(&s::D, d, 0.0, 2.0, false)?;
    Ok(
        (C::constant(4.0) * f_g / (C::constant(std::f64::consts::PI) * p) + d.square())
            .sqrt()
            .def(&s::D_G_MIN),
    )
}

/// The first of a rising series that is not below `least`, in m.
pub fn next(series: &[f64], least: f64) -> Result<f64, Refusal> {
    series.iter().copied().find(|x| *x >= least).ok_or_else(|| {
        Refusal::new(
            "D_g",
            format!("D_g = {} mm or more", short(least * 1e3)),
            format!(
                "the series ends at {} mm: take a longer arm, a higher pressure or two cylinders",
                short(series.last().copied().unwrap_or(0.0) * 1e3)
            ),
        )
    })
}

/// Oil flow to a cylinder, in m³/s, at its speed (m/s): on the bore where it
/// lengthens, on the annulus (negative) where it shortens.
pub fn flow<C: Calc>(piston: &Piston<C>, speed: C) -> C {
    let quarter = C::constant(std::f64::consts::FRAC_PI_4);
    let area = if speed.value() < 0.0 {
        quarter * (piston.d_g.square() - piston.d.square())
    } else {
        quarter * piston.d_g.square()
    };
    (area.def(&s::A_G) * speed).def(&s::Q_G)
}

/// Angle of each group for one radian of the command's angle.
pub fn rates(machine: &Machine<f64>, mode: Mode, theta: f64, rates: &mut [f64]) -> Result<(), Refusal> {
    let centre = mode.centre(machine, Command::Angle(theta))?;
    let slope = mode.slope(machine, theta);
    for (p, slot) in machine.groups.iter().zip(rates.iter_mut()) {
        *slot = slope.map_or(0.0, |slope| rate(&centre, &slope, *p));
    }
    Ok(())
}

/// The greatest oil flow that a mode asks for at once.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Demand {
    /// In m³/s, of all cylinders together.
    pub flow: f64,
    /// Commanded angle at which it is asked for, in rad.
    pub at: f64,
    /// Whether the commanded angle grows or falls there.
    pub rising: bool,
}

/// Greatest simultaneous flow while the commanded angle moves at `omega_s`
/// (rad/s), either way, over all reachable angles on a grid of 0.25°.
pub fn greatest_demand(
    machine: &Machine<f64>,
    limits: &[Limits],
    linkages: &[Linkage<f64>],
    piston: &Piston<f64>,
    mode: Mode,
    omega_s: f64,
) -> Result<Demand, Refusal> {
    within(&s::OMEGA_S, omega_s, 0.0, 10.0, false)?;
    let mut slopes = vec![0.0; machine.groups.len()];
    let mut worst = Demand {
        flow: 0.0,
        at: 0.0,
        rising: true,
    };
    // Beyond a right angle the axle lines repeat.
    for step in -360..=360_i32 {
        let theta = (f64::from(step) / 4.0).to_radians();
        if reach(machine, limits, mode, Command::Angle(theta))? != Reach::Reachable {
            continue;
        }
        rates(machine, mode, theta, &mut slopes)?;
        let centre = mode.centre(machine, Command::Angle(theta))?;
        for rising in [true, false] {
            let sense = if rising { omega_s } else { -omega_s };
            let mut sum = 0.0;
            for (i, p) in machine.groups.iter().enumerate() {
                let along = centre.rolling(*p);
                let heading = f64::direction(along.x, along.y);
                let placed = limits[i].equivalents(heading).next().unwrap_or(heading);
                sum += flow(piston, linkages[i].at_angle(placed).od * slopes[i] * sense).abs();
            }
            if sum > worst.flow {
                worst = Demand {
                    flow: sum,
                    at: theta,
                    rising,
                };
            }
        }
    }
    Ok(worst)
}

/// Displacement of the pump, in m³ per turn, for a flow (m³/s) at `n` turns per second with volumetric efficiency `eta`.
pub fn pump<C: Calc>(flow: C, n: C, eta: C) -> Result<C, Refusal> {
    within(&s::N, n, 0.0, 200.0, true)?;
    within(&s::ETA, eta, 0.0, 1.0, true)?;
    Ok((flow / (n * eta)).def(&s::V_P))
}

/// Pressure at which the relief valve opens, in Pa: the working pressure times a factor above 1.
pub fn relief<C: Calc>(p: C, k_r: C) -> Result<C, Refusal> {
    within(&s::K_R, k_r, 1.0, 2.0, false)?;
    Ok((p * k_r).def(&s::P_R))
}

quantities! {
    /// A rod against buckling: Young's modulus (Pa), diameter and buckling length (m), safety factor.
    Rod { e: E, d: D, l_k: L_K, nu: NU }
}

/// The push, in N, that the rod bears with its safety against buckling: π³ E d⁴/(64 ν l_k²). (Euler)
pub fn buckling<C: Calc>(rod: &Rod<C>) -> Result<C, Refusal> {
    within(&s::E, rod.e, 0.0, 1e12, true)?;
    within(&s::D, rod.d, 0.0, 2.0, true)?;
    within(&s::L_K, rod.l_k, 0.0, 100.0, true)?;
    within(&s::NU, rod.nu, 1.0, 20.0, false)?;
    let pi = C::constant(std::f64::consts::PI);
    let stiffness = pi * pi.square() * rod.e * rod.d.square().square();
    Ok((stiffness / (C::constant(64.0) * rod.nu * rod.l_k.square())).def(&s::F_K))
}
