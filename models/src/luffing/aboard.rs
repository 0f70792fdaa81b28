//! A luffing mechanism as what carries it sees it: its head and its masses over its coordinate.

use std::fmt;

use num_dual::Dual64;

use crate::component::description::Vocabulary;
use crate::kernel::calc::Calc;
use crate::kernel::schema::{Key, SOURCE};
use crate::kernel::sign::Sign;
use crate::kernel::symbol::symbols;
use crate::luffing::moving::bodies::Body;
use crate::luffing::moving::weighed::Weight;
use crate::parts::motion::Motion;
use crate::parts::plane::Point;

symbols! {
    THETA_1: "theta_1" "theta_1" RAD / DEG, "Luffing angle: that of the luffing mechanism's driving link above the horizontal.", "input";
    OMEGA_1: "omega_1" "omega_1" RAD_PER_S / DEG_PER_S, "Angular velocity of luffing.", "input";
    R: "R" "R" M / M, "Reach: distance of the load from the slewing axis.", "input";
    THETA_A: "theta_a" "theta_a" RAD / DEG, "Luffing angle at the start of its working range.", "input";
    THETA_E: "theta_e" "theta_e" RAD / DEG, "Luffing angle at the end of its working range.", "input";
    H_A: "h_A" "h_A" M / M, "Height of the head above the luffing mechanism's foot.", "derived";
    DR: "dR" "R'" M / M, "Travel of the head away from the slewing axis for one radian of luffing.", "dual numbers";
    DH_A: "dh_A" "h'_A" M / M, "Rise of the head for one radian of luffing.", "dual numbers";
    W_1: "W_1" "W_1" N / KN, "Weight of the luffing mechanism, with its counterweight.", "derived";
    M_R1: "M_r1" "M_(r 1)" N_M / KN_M, "Moment of the luffing mechanism's weights about the slewing axis, toward the load.", "equilibrium";
    M_H1: "M_h1" "M_(h 1)" N_M / KN_M, "Moment of the luffing mechanism's weights by their heights above its foot.", "equilibrium";
    DM_R1: "dM_r1" "M'_(r 1)" N_M / KN_M, "Change of the moment about the slewing axis for one radian of luffing.", "dual numbers";
    DM_H1: "dM_h1" "M'_(h 1)" N_M / KN_M, "Change of the moment by heights for one radian of luffing.", "dual numbers";
    J_LM: "J_lm" "J_\"lm\"" KG_M2 / T_M2, "Inertia of the luffing mechanism about the slewing axis.", "derived";
}

/// What carries a luffing mechanism has these words for it.
pub static VOCABULARY: Vocabulary = Vocabulary {
    words: "carried_symbol",
    own: &[ALL],
    shared: &[],
};

/// Working range of the coordinate, by its own names.
pub const MOTION: &[Key] = &[
    Key::named("from", &THETA_A, Sign::Any, THETA_A.text),
    Key::named("to", &THETA_E, Sign::Any, THETA_E.text),
    Key::named("step", &THETA_1, Sign::Positive, "Step of tables."),
    Key::named("speed", &OMEGA_1, Sign::Positive, "Angular velocity of luffing."),
    SOURCE,
];

/// Where head and weights (N) are, each with two derivatives by the coordinate, in m from the mechanism's foot: weights of the
/// same moments and inertia as those of the mechanism's bodies.
#[derive(Clone, Debug)]
pub struct Posed<C> {
    pub head: [Point<C>; 3],
    pub weights: Vec<Weight<C>>,
}

impl<C: Calc> Posed<C> {
    /// The same over another scalar: places (m), and weights (N).
    pub fn map<D>(&self, far: &dyn Fn(C) -> D, heavy: &dyn Fn(C) -> D) -> Posed<D> {
        let each = |places: &[Point<C>; 3]| places.map(|place| Point::new(far(place.x), far(place.y)));
        Posed {
            head: each(&self.head),
            weights: (self.weights.iter())
                .map(|(weight, places)| (heavy(*weight), each(places)))
                .collect(),
        }
    }
}

/// A luffing mechanism on something that moves.
pub trait Aboard: fmt::Debug + Send + Sync {
    fn range(&self) -> &Motion;

    /// How far its foot is in front of the slewing axis, in m.
    fn offset(&self) -> f64;

    /// Acceleration of gravity under which its bodies weigh what they do, in m/s².
    fn gravity(&self) -> f64;

    /// At a value of its coordinate (rad), with one more derivative by what that follows from; `None` where it does not close, or
    /// its balance cannot be.
    fn posed(&self, theta: Dual64) -> Option<Posed<Dual64>>;

    /// Its bars, each from joint to joint, in m from its foot.
    fn bars(&self, theta: f64) -> Vec<Vec<Point<f64>>>;
}

impl Body {
    /// A slender body as two masses (kg) of the same weight and inertia, in the frame of its bar (m).
    pub(crate) fn halves(&self) -> [(f64, Point<f64>); 2] {
        let [xx, xy, yy] = self.spread.map(|x| if self.mass > 0.0 { x / self.mass } else { 0.0 });
        let apart = Point::new(xx.sqrt(), if xy < 0.0 { -yy.sqrt() } else { yy.sqrt() });
        [self.centre + apart, self.centre - apart].map(|at| (self.mass / 2.0, at))
    }
}
