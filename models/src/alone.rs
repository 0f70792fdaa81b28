//! Quantities of a scene that are by themselves what the equations have: nothing else of the scene changes with them, so
//! that results follow them without the scene being read again.

use std::any::{Any, TypeId};
use std::ops::Range;

use crate::component::model::Model;
use crate::component::moving::MovingComponent;
use crate::component::stages::Source;
use crate::component::standing::Standing;
use crate::kernel::variable::Quantity;
use crate::scene::Scene;
use crate::vary;

/// How far a quantity is moved to see what changes with it, by parts of itself, or in SI where it is zero.
const STEPS: [f64; 4] = [1e-3, -1e-3, 1e-6, -1e-6];

/// What comes of another value.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Consequence {
    /// No scene.
    Nothing,
    /// A scene with this quantity changed, and no other.
    Alone,
    /// A scene in which that changes with it, too.
    With(&'static str),
}

/// Gives another text to a quantity of the equations, where the scene has that.
#[must_use]
pub fn moved(scene: &Scene, place: &Range<usize>, source: Source, text: &str) -> Consequence {
    let mut changed = scene.text().to_owned();
    changed.replace_range(place.clone(), text);
    let Ok(other) = Scene::parse(&changed) else {
        return Consequence::Nothing;
    };
    let [before, after] = [scene, &other].map(|scene| (scene.mechanism.standing(), *scene.mechanism.motion()));
    let sources = after.0.part().sources();
    let differs = |(of, _): &&(Source, Quantity)| {
        let [a, b] = [&before.0, &after.0].map(|model| model.part().take(*of).to_bits());
        *of != source && a != b
    };
    match sources.iter().find(differs) {
        _ if sources != before.0.part().sources() => Consequence::With("the equations"),
        Some((_, (symbol, _))) => Consequence::With(symbol.id),
        None if [after.1.from, after.1.to] != [before.1.from, before.1.to] => Consequence::With("the working range"),
        None => Consequence::Alone,
    }
}

/// Which quantity of the running model a key of the scene is, such as `luffing.X_1`: where the scene gives it, and nothing
/// else changes with it.
///
/// # Errors
/// Why it is none, in words.
pub fn alone(scene: &Scene, key: &str) -> Result<Quantity, String> {
    let known = scene.given.known(key);
    let Some((known, given)) = known.and_then(|known| Some((known, known.given.as_ref()?))) else {
        return Err(match known {
            None => format!("`{key}` is no quantity of this scene"),
            Some(known) => format!(
                "`{key}` is not given in this scene: give it a value, {}",
                known.symbol.written(known.value)
            ),
        });
    };
    if given.over_time {
        return Err(format!("`{key}` is told over time in this scene: it is no one number"));
    }
    let standing = scene.mechanism.standing();
    let source = vary::source(&standing, known).map_err(|why| format!("`{key}` does not stand by itself: {why}"))?;
    let scale = if known.value == 0.0 { 1.0 } else { known.value };
    let other = |step: f64| {
        let value = known.symbol.in_si(known.value + step * scale);
        moved(scene, &given.place, source, &format!("\"{value}\""))
    };
    match STEPS
        .into_iter()
        .map(other)
        .find(|moved| *moved != Consequence::Nothing)
    {
        Some(Consequence::Alone) => {}
        Some(Consequence::With(with)) => {
            return Err(format!("`{key}` does not stand by itself: {with} would change with it"));
        }
        _ => return Err(format!("`{key}` cannot have another value in this scene")),
    }
    // What moves by equations of another kind follows from what stands.
    if let Ok(Model::Moving(moving)) = scene.model()
        && let Some(moving) = (&*moving as &dyn Any).downcast_ref::<MovingComponent>()
        && kind(moving.standing()) != kind(&standing)
    {
        return Err(format!(
            "`{key}` does not stand by itself: the motion would change with it"
        ));
    }
    let all = standing.part().sources();
    let found = all.into_iter().find(|(of, _)| *of == source);
    Ok(found.expect("a source of these equations").1)
}

/// Of which kind the equations are.
fn kind(model: &Standing) -> TypeId {
    let part: &dyn Any = model.part();
    part.type_id()
}
