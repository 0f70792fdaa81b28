//! The shape of a hull as a scene gives it: a box, or sections.

use std::sync::Arc;

use crate::afloat::hull::{BoxHull, Offsets};
use crate::afloat::symbols as s;
use crate::kernel::diagnostic::Diagnostic;
use crate::kernel::measure;
use crate::kernel::schema::{Key, Values};
use crate::kernel::sign::Sign;
use crate::kernel::symbol::Symbol;
use crate::parts::solid::{Triangle, TriangleMesh};

/// The box of a hull that has no sections; mistakes go to `found`.
pub fn built(v: &Values, found: &mut Vec<Diagnostic>) -> Option<BoxHull<f64>> {
    let has = |symbol: &Symbol| v.stands(symbol.id);
    let all = [&s::L, &s::B, &s::D];
    match (v.has("sections"), all.iter().find(|symbol| has(symbol))) {
        (true, Some(symbol)) => {
            let what = format!("`{}` of a hull with sections", symbol.id);
            found.push(v.refuse(symbol.id, what, "given twice", "remove it, or the sections"));
        }
        (false, _) if !all.iter().all(|symbol| has(symbol)) => {
            let help = "give L, B and D of a box, or [[hull.sections]]";
            found.push(v.refuse("L", "the hull has neither L, B and D nor sections", "no shape", help));
        }
        _ => {}
    }
    BoxHull::read(v).filter(|_| !v.has("sections"))
}

/// Sections as corners and faces; mistakes go to `found`.
pub fn sections(v: &Values, found: &mut Vec<Diagnostic>) -> Option<Offsets> {
    let lengths = [
        Key::quantity(&s::Y_H, Sign::NotNegative),
        Key::quantity(&s::Z_H, Sign::Any),
    ];
    let point = |text: &str| {
        let (y, z) = text.split_once(',')?;
        let [y, z] = [(y, &lengths[0]), (z, &lengths[1])].map(|(text, key)| measure::number(text, key).ok());
        Some([y?.value, z?.value])
    };
    let (before, tables) = (found.len(), v.tables("sections"));
    let (mut points, mut half, mut last) = (Vec::new(), 0, f64::NEG_INFINITY);
    for table in tables {
        let x = table.number(s::X_H.id)?;
        let mut side: Vec<[f64; 2]> = Vec::new();
        for (text, span) in table.texts("points") {
            match point(text).filter(|new| side.last().is_none_or(|last| last[1] <= new[1])) {
                Some(new) => side.push(new),
                None => found.push(
                    Diagnostic::new(span.clone(), format!("\"{text}\" is no point of a section"), "not this")
                        .help("write half breadth and height, from keel to deck: \"9 m, 0 m\", \"9 m, 4 m\""),
                ),
            }
        }
        half = if points.is_empty() { side.len() } else { half };
        if side.len() != half || half < 2 {
            let what = format!("a section with {} points, and the first has {half}", side.len());
            let help = "give two points at least, as many in each section";
            found.push(table.refuse("points", what, "not as many", help));
        }
        if x <= last {
            let what = format!("a section at x_h = {}", s::X_H.written(x));
            found.push(table.refuse(
                s::X_H.id,
                what,
                "not before the last one",
                "give sections from stern to bow",
            ));
        }
        last = x;
        points.extend(side.iter().map(|[y, z]| [x, *y, *z]));
        points.extend(side.iter().rev().map(|[y, z]| [x, -y, *z]));
    }
    if tables.len() == 1 {
        found.push(v.refuse(
            "sections",
            "a hull with one section",
            "no volume",
            "give two sections at least",
        ));
    }
    (found.len() == before && !tables.is_empty()).then(|| {
        let faces = faces(tables.len(), half);
        let mesh = Arc::new(TriangleMesh { points, faces });
        Offsets { mesh, half }
    })
}

/// Refuses flooded compartments that are not within a hull that is a box, or beyond the ends of one with sections.
pub fn within(v: &Values, found: &mut Vec<Diagnostic>) {
    let size = |symbol: &Symbol| v.number(symbol.id).map(|whole| whole / 2.0);
    let [long, broad] = [&s::L, &s::B].map(size);
    let ends: Vec<f64> = (v.tables("sections").iter())
        .filter_map(|table| table.number(s::X_H.id))
        .collect();
    let along = long
        .map(|half| [-half, half])
        .or(ends.first().copied().zip(ends.last().copied()).map(Into::into));
    let across = broad.map(|half| [-half, half]);
    let up = v.number(s::D.id).map(|deep| [0.0, deep]);
    for table in v.tables("flooded") {
        let middle = |place: &Symbol, size: &Symbol| {
            let half = table.number(size.id)? / 2.0;
            let at = table.number(place.id)?;
            Some([at - half, at + half])
        };
        let high = (table.number(s::Z_F.id).zip(table.number(s::D_F.id))).map(|(low, deep)| [low, low + deep]);
        for (own, whole, size) in [
            (middle(&s::X_F, &s::L_F), along, &s::L_F),
            (middle(&s::Y_F, &s::B_F), across, &s::B_F),
            (high, up, &s::D_F),
        ] {
            let Some((own, whole)) = own.zip(whole) else { continue };
            if own[0] < whole[0] || own[1] > whole[1] {
                let [from, to, low, high] = [own[0], own[1], whole[0], whole[1]].map(|at| size.written(at));
                let what = format!("a flooded compartment from {from} to {to}");
                let help = format!("it lies within the hull: from {low} to {high}");
                found.push(table.refuse(size.id, what, "beyond the hull", help));
            }
        }
    }
}

/// Between neighbouring sections, and at the ends: alike on both sides of the centre line.
fn faces(count: usize, half: usize) -> Vec<Triangle> {
    let ring = 2 * half;
    let at = |section: usize, point: usize| (section * ring + point % ring) as u16;
    let mut faces = Vec::new();
    for section in 0..count - 1 {
        for point in 0..ring {
            let [a, b] = [at(section, point), at(section, point + 1)];
            let [c, d] = [at(section + 1, point), at(section + 1, point + 1)];
            if point < half {
                faces.extend([[a, b, c], [b, d, c]])
            } else {
                faces.extend([[a, b, d], [a, d, c]])
            }
        }
    }
    for point in 0..half - 1 {
        let quad = |section: usize| [point, point + 1, ring - 2 - point, ring - 1 - point].map(|i| at(section, i));
        let [a, b, c, d] = quad(0);
        faces.extend([[a, c, b], [a, d, c]]);
        let [a, b, c, d] = quad(count - 1);
        faces.extend([[a, b, c], [a, c, d]]);
    }
    faces
}
