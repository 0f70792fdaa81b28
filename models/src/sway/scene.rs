//! What scenes and books of trolleys with a swaying load have in common.

use crate::component::sheet::Input;
use crate::kernel::diagnostic::Diagnostic;
use crate::kernel::schema::Values;
use crate::kernel::symbol::Symbol;
use crate::sway::pendulum::Feedback;

/// Refuses keys that say something of a motion, and what is told over time, of a trolley that has none.
pub fn unmoved<'a>(v: &Values, own: impl Iterator<Item = &'a str>, set: &str, found: &mut Vec<Diagnostic>) {
    let Some(key) = own.into_iter().find(|key| v.has(key)) else {
        return;
    };
    let what = match v.course(key) {
        Some(_) => format!("`{key}` over time of a trolley whose {set} is set"),
        None => format!("`{key}` of a trolley whose {set} is set"),
    };
    found.push(v.refuse(key, what, "not used", "set fidelity = \"swing\", or remove it"));
}

/// What hangs there at the start, each with its value, and the feedback, stand in the book where the scene does not give them.
pub fn arrange(inputs: &mut Vec<Input>, start: &[(&'static Symbol, f64)], feedback: &Feedback<f64>) {
    let mut stand = |symbol, value| {
        if inputs.iter().all(|input| input.symbol != symbol) {
            inputs.push(Input {
                symbol,
                value,
                number: None,
                chapter: "hook",
                given: None,
                on: None,
                usual: true,
            });
        }
    };
    for (symbol, value) in start {
        stand(*symbol, *value);
    }
    feedback.map(&mut stand);
}
