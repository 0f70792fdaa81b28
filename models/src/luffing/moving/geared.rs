//! The motor of a luffing drive in motion: its shaft turns with the driving link, by a ratio that changes with its angle.
//! What is between has no losses here; dry and viscous friction stand at the driving link. [virtual work; Lagrange]

use num_dual::{Dual2, Dual64};

use crate::component::scalar::{EachScalar, Scalar};
use crate::drive::way::DriveWay;
use crate::kernel::calc::{Calc, Over, Takes};
use crate::kernel::record::Rec;
use crate::luffing::moving::reduced::{MotorShaft, Renewed};
use crate::luffing::resistances::given::CaseMotor;
use crate::luffing::resistances::symbols as s;

/// A motor on the way of its drive, at no particular angle.
#[derive(Clone)]
pub struct Geared<P> {
    way: DriveWay<P>,
    motor: CaseMotor<P>,
    /// For two and for three derivatives.
    twice: DriveWay<Dual2<f64>>,
    thrice: DriveWay<Dual2<Dual64>>,
    travel: Travel<P>,
}

/// Travel of a drive for one radian of the coordinate (rad), and its change, in m.
type Travel<P> = fn(&Geared<P>, P) -> Option<[P; 2]>;

impl<P: Calc> Geared<P>
where
    Dual64: Over<P>,
{
    fn new(way: &DriveWay<P>, motor: &CaseMotor<P>, travel: Travel<P>) -> Geared<P> {
        Geared {
            way: *way,
            motor: *motor,
            twice: way.map(|x| Dual2::from_re(x.value())),
            thrice: way.map(|x| Dual2::from_re(Dual64::of(x))),
            travel,
        }
    }
}

impl<P: Calc> Geared<P> {
    /// At a coordinate (rad); `None` where a crank does not meet the link.
    pub fn turned(&self, at: P) -> Option<MotorShaft<P>> {
        let travel = (self.travel)(self, at)?;
        Some(MotorShaft::new(travel, self.motor.j, self.motor.arm()))
    }
}

impl Geared<f64> {
    /// The same with one more derivative by the coordinate.
    pub fn with_slope(&self, at: Dual64) -> Option<MotorShaft<Dual64>> {
        let [inertia, arm] = [self.motor.j, self.motor.arm()].map(Dual64::of);
        Some(MotorShaft::new(self.thrice.travel(at)?, inertia, arm))
    }
}

/// For the book: what derivatives give has names.
fn named(of: &Geared<Rec>, at: Rec) -> Option<[Rec; 2]> {
    let [travel, bend] = of.twice.travel(at.value())?;
    let way = Rec::body(usize::MAX, || of.way.at(at))?;
    let travel = way.derivative(at, travel).def(&s::DS_S);
    Some([travel, travel.derivative(at, bend).def(&s::DDS_S)])
}

/// Each scalar has derivatives by the driven angle in its own way.
struct Turning;

impl EachScalar for Turning {
    type For<C: Calc> = fn(&DriveWay<C>, &CaseMotor<C>) -> Geared<C>;
    fn plain() -> fn(&DriveWay<f64>, &CaseMotor<f64>) -> Geared<f64> {
        |way, motor| Geared::new(way, motor, |of, at| of.twice.travel(at))
    }
    fn dual() -> fn(&DriveWay<Dual64>, &CaseMotor<Dual64>) -> Geared<Dual64> {
        |way, motor| Geared::new(way, motor, |of, at| of.thrice.travel(at))
    }
    fn recorded() -> fn(&DriveWay<Rec>, &CaseMotor<Rec>) -> Geared<Rec> {
        |way, motor| Geared::new(way, motor, named)
    }
}

/// The motor on its drive, where the scene has both, into the room for it.
pub fn geared<C: Scalar>(way: Option<&DriveWay<C>>, motor: &Option<CaseMotor<C>>, room: &mut Vec<Renewed<Geared<C>>>) {
    match way.zip(motor.as_ref()) {
        Some((way, motor)) => Renewed::renew(room, C::own::<Turning>()(way, motor)),
        None => room.clear(),
    }
}
