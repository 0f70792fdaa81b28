//! What a scene says about the mechanism in motion.

use crate::diagnostic::Diagnostic;
use crate::lemniscate::motion::Commands;
use crate::lemniscate::moving::symbols as s;
use crate::schema::{Key, Sign, Values};
use crate::symbol::{Symbol, quantities};

/// How deep the mechanism is modelled.
pub const FIDELITIES: &[&str] = &["static", "rigid", "swing"];

/// Keys of `[luffing.dynamics]`.
pub static KEYS: &[Key] = &[
    Key::quantity(&s::J_1, Sign::NotNegative),
    Key::quantity(&s::J_2, Sign::NotNegative),
    Key::quantity(&s::J_3, Sign::NotNegative),
    Key::quantity(&s::C_V, Sign::NotNegative).optional(),
    Key::quantity(&s::M_C, Sign::NotNegative).optional(),
    Key::quantity(&s::G, Sign::Positive).optional(),
    Key::quantity(&s::M_A, Sign::Any).optional(),
    Key::quantity(&s::M_B, Sign::NotNegative).optional(),
    Key::quantity(&s::L_R, Sign::Positive).optional(),
    Key::quantity(&s::PHI, Sign::Any).optional(),
    Key::quantity(&s::V_H, Sign::Any).optional(),
    Key::quantity(&s::STEP, Sign::Positive).optional(),
    Key::text(
        "source",
        "Where the quantities of this table come from: a drawing, a publication, an assumption.",
    ),
];

quantities! {
    /// What is constant in motion, besides geometry and weights.
    Constants { j_1: J_1, j_2: J_2, j_3: J_3, c_v: C_V, m_c: M_C, g: G, step: STEP }
}

/// The load's rope at the start.
#[derive(Clone, Copy, Debug)]
pub struct Rope {
    /// In m.
    pub length: f64,
    /// From the vertical, in rad.
    pub swing: f64,
}

/// A mechanism in motion as the scene describes it; SI.
#[derive(Clone, Copy, Debug)]
pub struct Moving {
    pub constants: Constants<f64>,
    /// Of the inputs, until an importer sets others.
    pub commands: Commands,
    /// With level `swing`.
    pub rope: Option<Rope>,
}

impl Moving {
    /// The checked table `[luffing]`; `None` at the static level, and where there are mistakes, which go to `found`.
    pub fn new(v: &Values, loaded: bool, found: &mut Vec<Diagnostic>) -> Option<Moving> {
        let fidelity = v.text("fidelity").unwrap_or("static");
        let mut mistake = |key: &str, what: String, label: &str, help: &str| {
            found.push(Diagnostic::new(v.place(key), what, label).help(help));
        };
        let table = match (fidelity, v.table("dynamics")) {
            ("static", None) => return None,
            ("static", Some(_)) => {
                mistake(
                    "dynamics",
                    "inertias and drive of a mechanism that does not move by itself".to_owned(),
                    "not used",
                    "add fidelity = \"rigid\" or \"swing\" to [luffing], or remove this table",
                );
                return None;
            }
            (_, None) => {
                mistake(
                    "fidelity",
                    format!("fidelity = \"{fidelity}\" without inertias"),
                    "needs [luffing.dynamics]",
                    "add [luffing.dynamics] with J_1, J_2 and J_3 (kg.m2)",
                );
                return None;
            }
            (_, Some(table)) => table,
        };
        if v.table("weights").is_none() || !loaded {
            mistake(
                "fidelity",
                format!("fidelity = \"{fidelity}\" without weights and load"),
                "what moves must weigh something",
                "add Q to [luffing] and a table [luffing.weights]; their masses are weights over g",
            );
            return None;
        }
        let n = |symbol: &Symbol| table.number(symbol.id);
        let rope = match (fidelity, n(&s::L_R)) {
            ("swing", Some(length)) => Some(Rope {
                length,
                swing: n(&s::PHI).unwrap_or(0.0),
            }),
            ("swing", None) => {
                found.push(
                    Diagnostic::new(
                        table.span.clone(),
                        "a swinging load without a rope",
                        "l_R is needed here",
                    )
                    .help("add l_R = \"... m\", the length of the rope at the start"),
                );
                return None;
            }
            _ => {
                let unused = [&s::L_R, &s::PHI, &s::V_H]
                    .into_iter()
                    .find(|symbol| n(symbol).is_some());
                if let Some(symbol) = unused {
                    found.push(
                        Diagnostic::new(
                            table.place(symbol.id),
                            format!("{} without a swinging load", symbol.id),
                            "not used",
                        )
                        .help("remove it, or set fidelity = \"swing\""),
                    );
                    return None;
                }
                None
            }
        };
        Some(Moving {
            constants: Constants {
                j_1: n(&s::J_1)?,
                j_2: n(&s::J_2)?,
                j_3: n(&s::J_3)?,
                c_v: n(&s::C_V).unwrap_or(0.0),
                m_c: n(&s::M_C).unwrap_or(0.0),
                g: n(&s::G).unwrap_or(9.81),
                step: n(&s::STEP).unwrap_or(0.01),
            },
            commands: Commands {
                moment: n(&s::M_A).unwrap_or(0.0),
                brake: n(&s::M_B).unwrap_or(0.0),
                hoist: n(&s::V_H).unwrap_or(0.0),
            },
            rope,
        })
    }
}
