//! A way from rest to rest.

/// From rest to rest: the speed rises evenly, stays, and falls as it rose.
#[derive(Clone, Copy)]
pub(super) struct Travel {
    pub from: f64,
    way: f64,
    speed: f64,
    /// In s; infinite where there is no way.
    ramp: f64,
}

impl Travel {
    /// At most at a speed that is reached in a time (s).
    pub(super) fn new([from, to]: [f64; 2], speed: f64, ramp: f64) -> Travel {
        let way = to - from;
        let most = (way.abs() * speed / ramp).sqrt().min(speed);
        Travel {
            from,
            way,
            speed: most,
            ramp: ramp * most / speed,
        }
    }

    pub(super) fn duration(&self) -> f64 {
        if self.way == 0.0 {
            0.0
        } else {
            self.way.abs() / self.speed + self.ramp
        }
    }

    /// Place and rate at a time (s).
    pub(super) fn at(&self, time: f64) -> [f64; 2] {
        let whole = self.duration();
        if time >= whole {
            return [self.from + self.way, 0.0];
        }
        let sign = self.way.signum();
        let begun = |time: f64| {
            let risen = time.clamp(0.0, self.ramp);
            let rate = self.speed * risen / self.ramp;
            [0.5 * rate * risen + self.speed * (time - risen), rate]
        };
        if time <= 0.5 * whole {
            let [gone, rate] = begun(time);
            return [self.from + sign * gone, sign * rate];
        }
        let [left, rate] = begun(whole - time);
        [self.from + self.way - sign * left, sign * rate]
    }
}
