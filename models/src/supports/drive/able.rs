//! Whether an engine is strong enough for what resists slewing, all over the working range.

use crate::component::description::{Described, Description, possible};
use crate::component::outline::{Greatest, Most};
use crate::component::peaks::Peaks;
use crate::kernel::diagnostic::Diagnostic;
use crate::kernel::schema::Values;
use crate::kernel::symbol::Symbol;
use crate::parts::starts::way::StartWay;
use crate::supports::drive::scene::TurningScene;
use crate::supports::drive::symbols as s;

/// Refuses what is not possible all over the working range, and an engine whose greatest torque is not above what resists.
pub fn able<T: Described>(this: &Description<T>, turning: &TurningScene, v: &Values, found: &mut Vec<Diagnostic>) {
    possible(this, v, found);
    let Some(StartWay::EngineStart(engine)) = turning.start.as_ref().filter(|_| found.is_empty()) else {
        return;
    };
    let model = this.standing();
    let mut peaks = Peaks::over(&model, T::aside(this));
    peaks.look(&model, std::iter::once(&s::T_0));
    let Some(most) = peaks.most(&model, &Greatest::new(&s::T_0, Most::Greatest, &s::T_0)) else {
        return;
    };
    let (gives, resists) = (engine.most(engine.speeds.most), peaks.summary(&model, &s::T_0, most));
    if resists.value < gives {
        return;
    }
    let at = |(symbol, at): (&'static Symbol, f64)| format!(" at {} = {}", symbol.id, symbol.written(at));
    let what = format!(
        "the engine gives {} at most, where T_0 = {} resist{}{}",
        s::T_0.written(gives),
        s::T_0.written(resists.value),
        resists.at.map_or(String::new(), at),
        resists.aside.map_or(String::new(), at),
    );
    let help = "give a stronger engine, or a greater ratio between engine and crane";
    let table = v.table("slewing_drive").unwrap_or(v);
    found.push(table.refuse("start", what, "too weak", help));
}
