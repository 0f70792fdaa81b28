//! Why there is no mechanism with a scene's parameters, and what the scene's author is told of it.

use crate::kernel::number::short;
use crate::luffing::double_link::parameters::{Driven, Jib, Parameters};
use crate::luffing::double_link::symbols as s;
use crate::parts::plane;

/// Why there is no such mechanism.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Misfit {
    /// The jib's triangle does not close.
    Jib,
    /// Both feet are one point.
    Frame,
    /// The linkage closes at no angle.
    Linkage,
}

/// A misfit in words.
#[derive(Clone, Debug)]
pub struct Words {
    /// The quantity to blame.
    pub key: &'static str,
    pub what: String,
    /// What is allowed.
    pub help: String,
}

impl Parameters<f64> {
    /// Why there is no mechanism with these parameters, with values and allowed ranges.
    #[must_use]
    pub fn describe(&self, misfit: Misfit) -> Words {
        let l = &self.lengths;
        match misfit {
            Misfit::Jib => {
                let (key, value, limit) = match self.jib {
                    Jib::Sag(x) => (
                        "X_7",
                        s::X_7.written(x),
                        format!("between -{0} m and {0} m, the shorter arm", short(l.x_2.min(l.x_4))),
                    ),
                    Jib::Axis(x) => (
                        "AC",
                        s::X_7.written(x),
                        format!(
                            "between {} m and {} m, difference and sum of the arms",
                            short((l.x_2 - l.x_4).abs()),
                            short(l.x_2 + l.x_4)
                        ),
                    ),
                    Jib::Angle(x) => ("beta_0", s::BETA_0.written(x), "between 0 and 360 deg".to_owned()),
                };
                Words {
                    key,
                    what: format!("the jib's triangle does not close: {key} = {value}"),
                    help: format!(
                        "with X_2 = {} m and X_4 = {} m it must lie {limit}",
                        short(l.x_2),
                        short(l.x_4)
                    ),
                }
            }
            Misfit::Frame => Words {
                key: "X_5",
                what: "the feet O1 and O3 are one point: boom, jib and rocker turn about it as one body".to_owned(),
                help: "X_5 and X_6 must not both be zero".to_owned(),
            },
            Misfit::Linkage => {
                let frame = plane::length(l.o3());
                let (bar, other) = match self.driven {
                    Driven::Boom => (("X_1", l.x_1), ("X_3", l.x_3)),
                    Driven::Rocker => (("X_3", l.x_3), ("X_1", l.x_1)),
                };
                Words {
                    key: other.0,
                    what: "the linkage closes at no angle of the driving link".to_owned(),
                    help: format!(
                        "the diagonal opposite this bar lies between {} m and {} m ({} = {} m, distance of the feet {} m), \
                         X_2 and {} reach from {} m to {} m: change the lengths so that the two ranges overlap",
                        short((bar.1 - frame).abs()),
                        short(bar.1 + frame),
                        bar.0,
                        short(bar.1),
                        short(frame),
                        other.0,
                        short((l.x_2 - other.1).abs()),
                        short(l.x_2 + other.1),
                    ),
                }
            }
        }
    }
}
