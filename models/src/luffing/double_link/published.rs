//! The formulas as the publication prints them, misprints mended. They agree
//! with what the simulation runs, but lose digits near dead points (arccos) and
//! have no value where the instantaneous centre is at infinity: the book shows
//! them beside the forms that do not.

use crate::kernel::calc::Calc;
use crate::luffing::double_link::geometry::Geometry;
use crate::luffing::double_link::symbols as s;

/// Results of the publication's own formulas, boom driven, branch `left`.
#[derive(Clone, Copy, Debug)]
pub struct PublishedFormulas<C> {
    pub theta_3: C,
    pub alpha: C,
    pub alpha_1: C,
    pub o1p: C,
}

impl<C: Calc> PublishedFormulas<C> {
    /// At boom angle `theta_1` (rad). [Li2022, eq. 1, 4-7]
    pub fn new(g: &Geometry<C>, x_7: C, theta_1: C) -> PublishedFormulas<C> {
        let l = g.lengths;
        let two = C::constant(2.0);
        let pi = C::constant(std::f64::consts::PI);
        let x_56 = (l.x_5.square() + l.x_6.square()).sqrt().def(&s::X_56);
        let theta_0 = C::direction(l.x_5, l.x_6).def(&s::THETA_0);
        let diagonal = (x_56.square() + l.x_1.square() - two * x_56 * l.x_1 * (pi - theta_1 - theta_0).sin_cos().1)
            .sqrt()
            .def(&s::L_LI);
        let theta_3 = (((l.x_3.square() + diagonal.square() - l.x_2.square()) / (two * l.x_3 * diagonal)).acos()
            + ((x_56.square() + diagonal.square() - l.x_1.square()) / (two * x_56 * diagonal)).acos()
            - theta_0)
            .def(&s::THETA_3_LI);
        let y = (l.x_3.square() + x_56.square() - two * x_56 * l.x_3 * (theta_3 + theta_0).sin_cos().1)
            .sqrt()
            .def(&s::Y_LI);
        let at_b = ((l.x_1.square() + l.x_2.square() - y.square()) / (two * l.x_1 * l.x_2)).acos();
        let alpha = (pi - g.beta_0 + theta_1 - at_b).def(&s::ALPHA_LI);
        let alpha_1 = ((x_7 / l.x_2).asin() + theta_1 - at_b).def(&s::ALPHA_1_LI);
        let o1p = (x_56 * (theta_3 + theta_0).sin() / (theta_1 - theta_3).sin()).def(&s::O1P_LI);
        PublishedFormulas {
            theta_3,
            alpha,
            alpha_1,
            o1p,
        }
    }
}
