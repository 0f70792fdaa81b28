//! A quantity over time, as a scene tells it: values at times, in steps or straight from one to the next.

/// How a value goes on between two times.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Between {
    /// Straight from one value to the next.
    Linear,
    /// Each value holds until the next one's time.
    Steps,
}

impl Between {
    /// By its name in scenes.
    #[must_use]
    pub fn named(name: &str) -> Option<Between> {
        match name {
            "linear" => Some(Between::Linear),
            "steps" => Some(Between::Steps),
            _ => None,
        }
    }
}

/// Values at rising times (s, SI), two at least: before the first time its value holds, after the last one its.
#[derive(Clone, Debug, PartialEq)]
pub struct Course {
    pub rows: Vec<[f64; 2]>,
    pub between: Between,
    pub shaped: Option<Shaped>,
}

/// How a command is shaped against a swing.
#[derive(Clone, Debug, PartialEq)]
pub struct Shaped {
    /// Of the swings, in s: one at least, each of which it leaves without.
    pub periods: Vec<f64>,
    /// Of each period, half of it apart: two equal ones, or three that are robust.
    pub pulses: u64,
    /// The command's rows without it.
    plain: Vec<[f64; 2]>,
}

impl Course {
    /// Value and slope at a time within the piece that has begun at another one (both in s): at the end of a piece as in
    /// it, not as in the next.
    #[must_use]
    pub fn at(&self, begun: f64, time: f64) -> [f64; 2] {
        let passed = self.rows.partition_point(|[at, _]| *at <= begun);
        let next = self.rows.get(passed);
        match (passed.checked_sub(1).map(|last| self.rows[last]), next) {
            (None, _) => [self.rows[0][1], 0.0],
            (Some([from, value]), Some([to, end])) if self.between == Between::Linear => {
                let slope = (end - value) / (to - from);
                [value + slope * (time.clamp(from, *to) - from), slope]
            }
            (Some([_, value]), _) => [value, 0.0],
        }
    }

    /// Half of itself, and half of itself half a period (s) later: of a swing of that period the second pulse takes what the
    /// first one has given. Three pulses are the same once more; against a further period all of that is so again.
    /// [Singer1990, 76–82]
    #[must_use]
    pub fn shaped(mut self, periods: &[f64], pulses: u64) -> Course {
        let plain = self.rows.clone();
        for period in periods {
            for _ in 1..pulses {
                self = self.halved(0.5 * period);
            }
        }
        self.shaped = Some(Shaped {
            periods: periods.to_vec(),
            pulses,
            plain,
        });
        self
    }

    /// Half of itself, and half of itself later by some time (s).
    fn halved(self, late: f64) -> Course {
        let both = self.rows.iter().flat_map(|[time, _]| [*time, *time + late]);
        let mut times: Vec<f64> = both.collect();
        times.sort_by(f64::total_cmp);
        times.dedup();
        let now = |time: f64| self.at(time, time)[0];
        // A late break must come in its new value, whatever the rounding of its time.
        let delayed = Course {
            rows: self.rows.iter().map(|[time, value]| [time + late, *value]).collect(),
            ..self.clone()
        };
        let rows = times
            .iter()
            .map(|&time| [time, 0.5 * (now(time) + delayed.at(time, time)[0])]);
        Course {
            rows: rows.collect(),
            ..self
        }
    }

    /// As it was before it was shaped.
    #[must_use]
    pub fn plain(&self) -> Course {
        Course {
            rows: self.shaped.as_ref().map_or(&self.rows, |shaped| &shaped.plain).clone(),
            between: self.between,
            shaped: None,
        }
    }

    /// The greatest value by amount.
    #[must_use]
    pub fn greatest(&self) -> f64 {
        let larger = |a: f64, [_, b]: &[f64; 2]| if b.abs() > a.abs() { *b } else { a };
        self.rows.iter().fold(0.0, larger)
    }

    /// The last time, in s.
    #[must_use]
    pub fn end(&self) -> f64 {
        self.rows.last().map_or(0.0, |[time, _]| *time)
    }
}
