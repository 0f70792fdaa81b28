//! The load moment limiter: how much of the rated load is used.

use crate::component::stages::{absent, results};
use crate::kernel::calc::Calc;
use crate::supports::mobile::boom::HeadPose;
use crate::supports::mobile::chart::LoadChart;
use crate::supports::mobile::rating::{Permission, Rated};
use crate::supports::mobile::symbols as s;
use crate::supports::mobile::weights::Payload;

/// What is more by rounding alone is not too much: at the rated load itself nothing stops.
const ROUNDING: f64 = 1e-9;

/// How much of it is used.
#[derive(Clone, Copy, Debug)]
pub struct Utilised<C> {
    part: C,
    chart: Option<[C; 2]>,
    warns: C,
    stops: C,
}
results! { Utilised as u => {
    ETA: u.part;
    Q_CH: u.chart.ok_or_else(absent)?[0];
    ETA_CH: u.chart.ok_or_else(absent)?[1];
    WARNS: C::constant(f64::from(u.warns.value() <= 0.0));
    STOPS: C::constant(f64::from(u.stops.value() <= 0.0));
    Z_WARN: u.warns;
    Z_STOP: u.stops;
} }

impl<C: Calc> Utilised<C> {
    /// η = Q_g / Q_rat, and of the load chart.
    pub fn new(
        permission: &Permission<C>,
        payload: &Payload<C>,
        rated: &Rated<C>,
        chart: &Option<LoadChart>,
        pose: &HeadPose<C>,
        length: &C,
    ) -> Utilised<C> {
        let of = |load: C, symbol| match load.value() {
            0.0 => C::known(symbol, f64::INFINITY).over(load).over(payload.counted),
            f64::INFINITY => C::constant(0.0).over(load).over(payload.counted),
            _ => (payload.counted / load).def(symbol),
        };
        let part = of(rated.load, &s::ETA);
        let chart = chart.as_ref().map(|chart| {
            let load = C::known(&s::Q_CH, chart.at(length.value(), pose.reach.value()));
            let load = load.over(pose.reach).over(*length);
            [load, of(load, &s::ETA_CH)]
        });
        // A limiter goes by its chart, and by what that does not know.
        let decides = chart.map_or(part, |[_, charted]| part.greater(charted));
        let left = |most: C| match decides.value() {
            f64::INFINITY => C::constant(-1.0).over(decides),
            _ => most - decides,
        };
        Utilised {
            part,
            chart,
            warns: left(permission.k_w),
            stops: left(C::constant(1.0 + ROUNDING)),
        }
    }
}
