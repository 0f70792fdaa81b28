//! What a page is printed on: for tests that nothing stands in a margin or beyond.

use typst::layout::{Abs, Frame, FrameItem, Point, Transform};

use crate::embedded::pages;
use crate::typesetter::{Error, Files};

/// Where a page is printed on, in mm from its left and upper edge.
#[derive(Clone, Copy, Debug)]
pub struct Ink {
    pub size: [f64; 2],
    pub from: [f64; 2],
    pub to: [f64; 2],
}

/// What is printed on of each page.
///
/// # Errors
/// As [`Typesetter::typeset`](crate::typesetter::Typesetter::typeset).
pub fn ink(source: &str, files: &Files) -> Result<Vec<Ink>, Error> {
    let (_, document, _) = pages(source, files)?;
    let ink = document.pages().iter().map(|page| {
        let size = page.frame.size();
        let mut ink = Ink {
            size: [size.x.to_mm(), size.y.to_mm()],
            from: [f64::INFINITY; 2],
            to: [f64::NEG_INFINITY; 2],
        };
        print(&page.frame, Transform::identity(), &mut ink);
        ink
    });
    Ok(ink.collect())
}

fn print(frame: &Frame, by: Transform, ink: &mut Ink) {
    for (at, item) in frame.items() {
        let by = by.pre_concat(Transform::translate(at.x, at.y));
        let corners = match item {
            FrameItem::Group(group) => {
                print(&group.frame, by.pre_concat(group.transform), ink);
                continue;
            }
            FrameItem::Text(text) => {
                let box_ = text.bbox();
                [box_.min, box_.max]
            }
            FrameItem::Shape(shape, _) => {
                let box_ = shape.geometry.bbox(shape.stroke.as_ref());
                [box_.min, box_.max]
            }
            FrameItem::Image(_, size, _) => [Point::zero(), size.to_point()],
            _ => continue,
        };
        for corner in corners {
            let corner = corner.transform(by);
            for (axis, value) in [corner.x, corner.y].map(Abs::to_mm).into_iter().enumerate() {
                ink.from[axis] = ink.from[axis].min(value);
                ink.to[axis] = ink.to[axis].max(value);
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ink_is_measured_where_it_is() {
        let page = "#set page(width: 100mm, height: 50mm, margin: 10mm)\n";
        let place = "#place(dx: 60mm, dy: 5mm, rotate(180deg, origin: top + left, rect(width: 20mm, height: 2mm, stroke: none, fill: black)))";
        let [ink] = ink(&format!("{page}{place}"), &[]).unwrap()[..] else {
            panic!("one page");
        };
        assert_eq!(ink.size.map(f64::round), [100.0, 50.0]);
        for (value, wanted) in ink.from.into_iter().chain(ink.to).zip([50.0, 13.0, 70.0, 15.0]) {
            assert!((value - wanted).abs() < 1e-6, "{ink:?}");
        }
    }
}
