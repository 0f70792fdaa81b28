//! What a page is printed on: for tests of margins, of empty pages and of what stands alone.

use typst::layout::{Abs, Frame, FrameItem, Point, Transform};

use crate::embedded::{InWork, pages};
use crate::typesetter::{Error, Files};

/// Where a page is printed on, in mm from its left and upper edge.
#[derive(Clone, Debug)]
pub struct Ink {
    pub size: [f64; 2],
    pub from: [f64; 2],
    pub to: [f64; 2],
    pub marks: Vec<Mark>,
}

/// A text, a line or a picture on a page.
#[derive(Clone, Debug)]
pub struct Mark {
    pub from: [f64; 2],
    pub to: [f64; 2],
    /// With the size of its type in pt.
    pub text: Option<(String, f64)>,
}

/// What is printed on of each page.
///
/// # Errors
/// As [`Typesetter::typeset`](crate::typesetter::Typesetter::typeset).
pub fn ink(source: &str, files: &Files) -> Result<Vec<Ink>, Error> {
    let _in_work = InWork::begin();
    let (_, document, _) = pages(source, files)?;
    let ink = document.pages().iter().map(|page| {
        let size = page.frame.size();
        let mut ink = Ink {
            size: [size.x.to_mm(), size.y.to_mm()],
            from: [f64::INFINITY; 2],
            to: [f64::NEG_INFINITY; 2],
            marks: Vec::new(),
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
        let corners = corners.map(|corner| corner.transform(by));
        let corners = corners.map(|corner| [corner.x, corner.y].map(Abs::to_mm));
        let ends = |end: fn(f64, f64) -> f64| [0, 1].map(|axis| end(corners[0][axis], corners[1][axis]));
        let mark = Mark {
            from: ends(f64::min),
            to: ends(f64::max),
            text: match item {
                FrameItem::Text(text) => Some((text.text.to_string(), text.size.to_pt())),
                _ => None,
            },
        };
        for axis in 0..2 {
            ink.from[axis] = ink.from[axis].min(mark.from[axis]);
            ink.to[axis] = ink.to[axis].max(mark.to[axis]);
        }
        ink.marks.push(mark);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ink_is_measured_where_it_is() {
        let page = "#set page(width: 100mm, height: 50mm, margin: 10mm)\n";
        let place = "#place(dx: 60mm, dy: 5mm, rotate(180deg, origin: top + left, rect(width: 20mm, height: 2mm, stroke: none, fill: black)))";
        let pages = ink(&format!("{page}{place}"), &[]).unwrap();
        let [ink] = pages.as_slice() else {
            panic!("one page");
        };
        assert_eq!(ink.size.map(f64::round), [100.0, 50.0]);
        for (value, wanted) in ink.from.iter().chain(&ink.to).zip([50.0, 13.0, 70.0, 15.0]) {
            assert!((value - wanted).abs() < 1e-6, "{ink:?}");
        }
    }
}
