//! Units: the one table behind scene files, FMU unit definitions, CSV headers
//! and printed numbers. Inside, every quantity is in SI; a unit other than SI
//! exists only where a person reads or writes.

/// Exponents of the SI base units; the radian counts as 1, as in the SI.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Dimension {
    pub m: i8,
    pub kg: i8,
    pub s: i8,
}

impl Dimension {
    pub const ONE: Dimension = Dimension { m: 0, kg: 0, s: 0 };

    #[must_use]
    pub fn times(self, other: Dimension) -> Dimension {
        Dimension {
            m: self.m + other.m,
            kg: self.kg + other.kg,
            s: self.s + other.s,
        }
    }

    #[must_use]
    pub fn over(self, other: Dimension) -> Dimension {
        Dimension {
            m: self.m - other.m,
            kg: self.kg - other.kg,
            s: self.s - other.s,
        }
    }

    /// The dimension of a square root; `None` where an exponent is odd.
    #[must_use]
    pub fn root(self) -> Option<Dimension> {
        let even = self.m % 2 == 0 && self.kg % 2 == 0 && self.s % 2 == 0;
        even.then_some(Dimension {
            m: self.m / 2,
            kg: self.kg / 2,
            s: self.s / 2,
        })
    }
}

impl std::fmt::Display for Dimension {
    /// `m2.kg/s2` style, `1` where there is none.
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let parts: Vec<String> = [("m", self.m), ("kg", self.kg), ("s", self.s)]
            .into_iter()
            .filter(|&(_, n)| n != 0)
            .map(|(base, n)| if n == 1 { base.to_owned() } else { format!("{base}^{n}") })
            .collect();
        f.write_str(
            if parts.is_empty() {
                "1".to_owned()
            } else {
                parts.join("·")
            }
            .as_str(),
        )
    }
}

/// A unit of measurement.
#[derive(Debug)]
pub struct Unit {
    /// As written in scene files, CSV headers and `modelDescription.xml`.
    pub name: &'static str,
    /// As printed in books; empty for a plain number.
    pub print: &'static str,
    pub dimension: Dimension,
    /// Exponent of the radian, which FMI counts as a base unit.
    pub rad: i8,
    /// Value in SI = factor × value in this unit.
    pub factor: f64,
}

impl PartialEq for Unit {
    fn eq(&self, other: &Unit) -> bool {
        self.name == other.name
    }
}

macro_rules! units {
    ($($id:ident = $name:literal $print:literal [$m:literal $kg:literal $s:literal $rad:literal] $factor:expr;)*) => {
        $(pub static $id: Unit = Unit {
            name: $name,
            print: $print,
            dimension: Dimension { m: $m, kg: $kg, s: $s },
            rad: $rad,
            factor: $factor,
        };)*
        /// Every unit that a scene may use.
        pub static ALL: &[&Unit] = &[$(&$id),*];
    };
}

const DEGREE: f64 = std::f64::consts::PI / 180.0;

units! {
    //            name       print      m kg s rad   factor
    ONE         = "1"        ""        [0 0 0 0]     1.0;
    PERCENT     = "%"        "%"       [0 0 0 0]     0.01;
    M           = "m"        "m"       [1 0 0 0]     1.0;
    L           = "L"        "L"       [3 0 0 0]     1e-3;
    MM          = "mm"       "mm"      [1 0 0 0]     1e-3;
    CM          = "cm"       "cm"      [1 0 0 0]     1e-2;
    KM          = "km"       "km"      [1 0 0 0]     1e3;
    M2          = "m2"       "m²"      [2 0 0 0]     1.0;
    M4          = "m4"       "m⁴"      [4 0 0 0]     1.0;
    RAD         = "rad"      "rad"     [0 0 0 1]     1.0;
    DEG         = "deg"      "°"       [0 0 0 1]     DEGREE;
    S           = "s"        "s"       [0 0 1 0]     1.0;
    M_RAD       = "m.rad"    "m·rad"   [1 0 0 1]     1.0;
    M_DEG       = "m.deg"    "m·°"     [1 0 0 1]     DEGREE;
    RAD_S       = "rad.s"    "rad·s"   [0 0 1 1]     1.0;
    MS          = "ms"       "ms"      [0 0 1 0]     1e-3;
    MIN         = "min"      "min"     [0 0 1 0]     60.0;
    RAD_PER_S   = "rad/s"    "rad/s"   [0 0 -1 1]    1.0;
    DEG_PER_S   = "deg/s"    "°/s"     [0 0 -1 1]    DEGREE;
    M_PER_S     = "m/s"      "m/s"     [1 0 -1 0]    1.0;
    MM_PER_S    = "mm/s"     "mm/s"    [1 0 -1 0]    1e-3;
    M_PER_MIN   = "m/min"    "m/min"   [1 0 -1 0]    1.0 / 60.0;
    KG          = "kg"       "kg"      [0 1 0 0]     1.0;
    T           = "t"        "t"       [0 1 0 0]     1e3;
    N           = "N"        "N"       [1 1 -2 0]    1.0;
    KN          = "kN"       "kN"      [1 1 -2 0]    1e3;
    MN          = "MN"       "MN"      [1 1 -2 0]    1e6;
    N_M         = "N.m"      "N·m"     [2 1 -2 0]    1.0;
    KN_M        = "kN.m"     "kN·m"    [2 1 -2 0]    1e3;
    MN_M        = "MN.m"     "MN·m"    [2 1 -2 0]    1e6;
    J           = "J"        "J"       [2 1 -2 0]    1.0;
    KJ          = "kJ"       "kJ"      [2 1 -2 0]    1e3;
    W           = "W"        "W"       [2 1 -3 0]    1.0;
    KW          = "kW"       "kW"      [2 1 -3 0]    1e3;
    PA          = "Pa"       "Pa"      [-1 1 -2 0]   1.0;
    BAR         = "bar"      "bar"     [-1 1 -2 0]   1e5;
    MPA         = "MPa"      "MPa"     [-1 1 -2 0]   1e6;
    KG_M2       = "kg.m2"    "kg·m²"   [2 1 0 0]     1.0;
    T_M2        = "t.m2"     "t·m²"    [2 1 0 0]     1e3;
    N_S         = "N.s"      "N·s"     [1 1 -1 0]    1.0;
    KN_S        = "kN.s"     "kN·s"    [1 1 -1 0]    1e3;
    N_M_S       = "N.m.s"    "N·m·s"   [2 1 -1 0]    1.0;
    KN_M_S      = "kN.m.s"   "kN·m·s"  [2 1 -1 0]    1e3;
    J_PER_KG    = "J/kg"     "J/kg"    [2 0 -2 0]    1.0;
    KG_PER_M3   = "kg/m3"    "kg/m³"   [-3 1 0 0]    1.0;
    M_PER_S2    = "m/s2"     "m/s²"    [1 0 -2 0]    1.0;
    RAD_PER_S2  = "rad/s2"   "rad/s²"  [0 0 -2 1]    1.0;
    DEG_PER_S2  = "deg/s2"   "°/s²"    [0 0 -2 1]    DEGREE;
    M3          = "m3"       "m³"      [3 0 0 0]     1.0;
    CM3         = "cm3"      "cm³"     [3 0 0 0]     1e-6;
    PER_M       = "1/m"      "1/m"     [-1 0 0 0]    1.0;
    PER_S       = "1/s"      "1/s"     [0 0 -1 0]    1.0;
    PER_S2      = "1/s2"     "1/s²"    [0 0 -2 0]    1.0;
    PA_PER_S    = "Pa/s"     "Pa/s"    [-1 1 -3 0]   1.0;
    MPA_PER_S   = "MPa/s"    "MPa/s"   [-1 1 -3 0]   1e6;
    PER_RAD     = "1/rad"    "1/rad"   [0 0 0 -1]    1.0;
    PER_RAD_S   = "1/(rad.s)" "1/(rad·s)" [0 0 -1 -1] 1.0;
    PER_MIN     = "1/min"    "r/min"   [0 0 -1 0]    1.0 / 60.0;
    M3_PER_SPA  = "m3/(s.Pa)" "m³/(s·Pa)" [4 -1 1 0] 1.0;
    L_PER_MINMPA = "L/(min.MPa)" "L/(min·MPa)" [4 -1 1 0] 1e-9 / 60.0;
    M3_PER_S    = "m3/s"     "m³/s"    [3 0 -1 0]    1.0;
    N_PER_M     = "N/m"      "N/m"     [0 1 -2 0]    1.0;
    KN_PER_M    = "kN/m"     "kN/m"    [0 1 -2 0]    1e3;
    N_S_PER_M   = "N.s/m"    "N·s/m"   [0 1 -1 0]    1.0;
    KN_S_PER_M  = "kN.s/m"   "kN·s/m"  [0 1 -1 0]    1e3;
    S_PER_M     = "s/m"      "s/m"     [-1 0 1 0]    1.0;
    KG_PER_S    = "kg/s"     "kg/s"    [0 1 -1 0]    1.0;
    T_PER_H     = "t/h"      "t/h"     [0 1 -1 0]    1e3 / 3600.0;
    L_PER_MIN   = "L/min"    "L/min"   [3 0 -1 0]    1e-3 / 60.0;
    M2_PER_KG   = "m2/kg"    "m²/kg"   [2 -1 0 0]    1.0;
    M2_PER_T    = "m2/t"     "m²/t"    [2 -1 0 0]    1e-3;
}

impl Unit {
    /// What is measured in this unit, in the words of ISO 80000.
    #[must_use]
    pub fn quantity(&self) -> &'static str {
        match self.measured().0 {
            "Torque" if self.name.ends_with('J') => "Energy",
            "TranslationalDampingConstant" if !self.name.contains('N') => "MassFlowRate",
            name => name,
        }
    }

    /// The least positive amount and the greatest one (SI) that a scene may give of what is measured in this unit.
    #[must_use]
    pub fn limits(&self) -> [f64; 2] {
        self.measured().1
    }

    /// What is measured in this unit, and the limits of its amount in a scene: wider than any machine, and narrow
    /// enough for a slip of the unit, and for every number that follows to stay finite.
    fn measured(&self) -> (&'static str, [f64; 2]) {
        match (self.dimension, self.rad) {
            (d, 0) if d == M.dimension => ("Length", [1e-4, 1e6]),
            (d, 1) if d == M.dimension => ("LeverAngle", [1e-9 * DEGREE, 1e6]),
            (d, _) if d == M4.dimension => ("SecondMomentOfArea", [1e-16, 1e24]),
            (d, _) if d == M2.dimension => ("Area", [1e-8, 1e12]),
            (d, 1) if d == RAD.dimension => ("Angle", [1e-9 * DEGREE, 1e6 * DEGREE]),
            (d, _) if d == M3.dimension => ("Volume", [1e-12, 1e9]),
            (d, _) if d == S.dimension => ("Time", [1e-9, 1e9]),
            (d, 0) if d == PER_S.dimension => ("Frequency", [1e-6, 1e6]),
            (_, -1) => ("ControlGain", [1e-9, 1e9]),
            (d, 1) if d == RAD_PER_S.dimension => ("AngularVelocity", [1e-9 * DEGREE, 1e6 * DEGREE]),
            (d, _) if d == M_PER_S.dimension => ("Velocity", [1e-9, 1e6]),
            (d, _) if d == KG.dimension => ("Mass", [1e-6, 1e11]),
            (d, _) if d == N.dimension => ("Force", [1e-6, 1e12]),
            (d, _) if d == N_M.dimension => ("Torque", [1e-6, 1e18]),
            (d, _) if d == W.dimension => ("Power", [1e-6, 1e15]),
            (d, _) if d == PA.dimension => ("Pressure", [1.0, 1e12]),
            (d, _) if d == M3_PER_SPA.dimension => ("HydraulicConductance", [1e-20, 1.0]),
            (d, 0) if d == PER_S2.dimension => ("SpoolAcceleration", [1e-6, 1e12]),
            (d, _) if d == PA_PER_S.dimension => ("PressureRate", [1.0, 1e18]),
            (d, _) if d == KG_M2.dimension => ("MomentOfInertia", [1e-9, 1e18]),
            (d, _) if d == N_S.dimension => ("Impulse", [1e-6, 1e15]),
            (d, _) if d == N_M_S.dimension => ("RotationalDampingConstant", [1e-6, 1e18]),
            (d, _) if d == M_PER_S2.dimension => ("Acceleration", [1e-3, 1e3]),
            (d, _) if d == J_PER_KG.dimension => ("SpecificEnergy", [1e-9, 1e12]),
            (d, _) if d == RAD_PER_S2.dimension => ("AngularAcceleration", [1e-9, 1e9]),
            (d, _) if d == N_PER_M.dimension => ("TranslationalSpringConstant", [1e-9, 1e15]),
            (d, _) if d == N_S_PER_M.dimension => ("TranslationalDampingConstant", [1e-6, 1e15]),
            (d, _) if d == M3_PER_S.dimension => ("VolumeFlowRate", [1e-12, 1e6]),
            (d, _) if d == PER_M.dimension => ("InverseLength", [1e-9, 1e6]),
            (d, _) if d == KG_PER_M3.dimension => ("Density", [1e-9, 1e6]),
            (d, _) if d == M2_PER_KG.dimension => ("SpecificArea", [1e-9, 1e3]),
            (d, _) if d == S_PER_M.dimension => ("InverseVelocity", [1e-9, 1e6]),
            _ => ("Ratio", [1e-9, 1e6]),
        }
    }

    /// Whether it measures the same as another one.
    #[must_use]
    pub fn is_like(&self, other: &Unit) -> bool {
        self.dimension == other.dimension && self.rad == other.rad
    }
}

/// The unit of a scene's text: `kN m`, `kN·m`, `kN*m` and `kN.m` are one; `°` is `deg`.
#[must_use]
pub fn find(text: &str) -> Option<&'static Unit> {
    let plain = text
        .replace(['·', '*', ' '], ".")
        .replace('°', "deg")
        .replace('⁴', "4")
        .replace('³', "3")
        .replace('²', "2");
    ALL.iter().copied().find(|unit| unit.name == plain)
}
