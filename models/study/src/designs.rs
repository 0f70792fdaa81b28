//! The values of each design of a study, by the design's number.

use lemnis_models::study::{Law, Study};

use crate::sobol::Sobol;

/// All designs of a study.
#[derive(Clone, Debug)]
pub struct Designs {
    laws: Vec<Law>,
    count: usize,
    /// `None` where every combination of values is a design.
    points: Option<Sobol>,
}

impl Designs {
    /// # Panics
    /// Never for a study that was read, which has not more designs than can be counted.
    #[must_use]
    pub fn new(study: &Study) -> Designs {
        let laws: Vec<Law> = study.varied.iter().map(|varied| varied.law.clone()).collect();
        let count = match study.drawn {
            Some(drawn) => usize::try_from(drawn).expect("checked when the study was read"),
            None => laws.iter().map(|law| values(law).len()).product(),
        };
        Designs {
            points: study.drawn.map(|_| Sobol::new(laws.len(), study.seed)),
            laws,
            count,
        }
    }

    /// How many there are.
    #[must_use]
    pub fn count(&self) -> usize {
        self.count
    }

    /// Of each quantity the value in a design, in SI.
    ///
    /// # Panics
    /// Beyond the last design.
    #[must_use]
    pub fn values(&self, design: usize) -> Vec<f64> {
        assert!(design < self.count, "one of the designs");
        match &self.points {
            Some(points) => {
                let point = u32::try_from(design).expect("checked when the study was read");
                let each = self.laws.iter().enumerate();
                each.map(|(axis, law)| quantile(law, points.at(point, axis))).collect()
            }
            // The last one changes fastest.
            None => {
                let mut rest = design;
                let mut all: Vec<f64> = Vec::with_capacity(self.laws.len());
                for law in self.laws.iter().rev() {
                    let values = values(law);
                    all.push(values[rest % values.len()]);
                    rest /= values.len();
                }
                all.reverse();
                all
            }
        }
    }
}

/// The values of a law that has some.
fn values(law: &Law) -> &[f64] {
    match law {
        Law::Values(values) => values,
        _ => &[],
    }
}

/// The value below which a part of all lies.
#[must_use]
pub fn quantile(law: &Law, part: f64) -> f64 {
    match law {
        Law::Values(values) => values[((part * values.len() as f64) as usize).min(values.len() - 1)],
        Law::Even([low, high]) => low * (1.0 - part) + high * part,
        Law::Normal { mean, deviation } => mean + deviation * normal(part),
        Law::Triangular([low, likely, high]) => {
            let (whole, below) = (high - low, likely - low);
            match part * whole < below {
                true => low + (part * whole * below).sqrt(),
                false => high - ((1.0 - part) * whole * (high - likely)).sqrt(),
            }
        }
    }
}

/// Standard deviation of a law.
#[must_use]
pub fn deviation(law: &Law) -> f64 {
    match law {
        Law::Values(values) => {
            let count = values.len() as f64;
            let mean = values.iter().sum::<f64>() / count;
            let squares: f64 = values.iter().map(|value| (value - mean) * (value - mean)).sum();
            (squares / count).sqrt()
        }
        Law::Even([low, high]) => (high - low) / 12.0_f64.sqrt(),
        Law::Normal { deviation, .. } => *deviation,
        Law::Triangular([a, b, c]) => ((a * (a - b) + b * (b - c) + c * (c - a)) / 18.0).sqrt(),
    }
}

/// The standard normal value below which a part of all lies, to a rounding or two.
///
/// M. J. Wichura, Algorithm AS 241, Applied Statistics 37 (1988).
fn normal(part: f64) -> f64 {
    const MIDDLE: [[f64; 8]; 2] = [
        [
            3.387_132_872_796_366_5,
            133.141_667_891_784_38,
            1_971.590_950_306_551_3,
            13_731.693_765_509_46,
            45_921.953_931_549_87,
            67_265.770_927_008_7,
            33_430.575_583_588_13,
            2_509.080_928_730_122_7,
        ],
        [
            1.0,
            42.313_330_701_600_91,
            687.187_007_492_057_9,
            5_394.196_021_424_751,
            21_213.794_301_586_597,
            39_307.895_800_092_71,
            28_729.085_735_721_943,
            5_226.495_278_852_854,
        ],
    ];
    const BESIDE: [[f64; 8]; 2] = [
        [
            1.423_437_110_749_683_5,
            4.630_337_846_156_546,
            5.769_497_221_460_691,
            3.647_848_324_763_204_5,
            1.270_458_252_452_368_4,
            0.241_780_725_177_450_6,
            0.022_723_844_989_269_184,
            7.745_450_142_783_414e-4,
        ],
        [
            1.0,
            2.053_191_626_637_759,
            1.676_384_830_183_803_8,
            0.689_767_334_985_1,
            0.148_103_976_427_480_08,
            0.015_198_666_563_616_457,
            5.475_938_084_995_345e-4,
            1.050_750_071_644_416_9e-9,
        ],
    ];
    const FAR: [[f64; 8]; 2] = [
        [
            6.657_904_643_501_103,
            5.463_784_911_164_114,
            1.784_826_539_917_291_3,
            0.296_560_571_828_504_87,
            0.026_532_189_526_576_124,
            0.001_242_660_947_388_078_4,
            2.711_555_568_743_487_6e-5,
            2.010_334_399_292_288_1e-7,
        ],
        [
            1.0,
            0.599_832_206_555_888,
            0.136_929_880_922_735_8,
            0.014_875_361_290_850_615,
            7.868_691_311_456_133e-4,
            1.846_318_317_510_054_8e-5,
            1.421_511_758_316_446e-7,
            2.044_263_103_389_939_8e-15,
        ],
    ];
    let over = |[above, below]: &[[f64; 8]; 2], x: f64| {
        let at = |all: &[f64; 8]| all.iter().rev().fold(0.0, |sum, one| sum * x + one);
        at(above) / at(below)
    };
    let from_middle = part - 0.5;
    if from_middle.abs() <= 0.425 {
        return from_middle * over(&MIDDLE, 0.425 * 0.425 - from_middle * from_middle);
    }
    let tail = (-libm::log(part.min(1.0 - part))).sqrt();
    let size = match tail <= 5.0 {
        true => over(&BESIDE, tail - 1.6),
        false => over(&FAR, tail - 5.0),
    };
    size.copysign(from_middle)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Values of the normal distribution with fifty digits, rounded.
    #[test]
    fn normal_values_are_those_of_the_tables() {
        for (part, value) in [
            (0.5, 0.0),
            (0.841_344_746_068_542_9, 1.0),
            (0.975, 1.959_963_984_540_054_2),
            (0.05, -1.644_853_626_951_472_7),
            (1e-3, -3.090_232_306_167_813_5),
            (1e-9, -5.997_807_015_007_687),
            (1e-13, -7.348_796_102_800_676_5),
        ] {
            let found = normal(part);
            assert!(
                (found - value).abs() <= 4e-16 * f64::max(1.0, value.abs()),
                "{part}: {found} for {value}"
            );
        }
    }

    /// Mean and variance of each law are those of its quantiles.
    #[test]
    fn deviations_are_those_of_the_quantiles() {
        let laws = [
            Law::Values(vec![1.0, 2.0, 6.0]),
            Law::Even([-1.0, 5.0]),
            Law::Triangular([1.0, 2.0, 6.0]),
            Law::Triangular([0.0, 0.0, 1.0]),
            Law::Normal {
                mean: 3.0,
                deviation: 0.5,
            },
        ];
        for law in laws {
            let count = 300_000;
            let all: Vec<f64> = (0..count)
                .map(|i| quantile(&law, (f64::from(i) + 0.5) / f64::from(count)))
                .collect();
            let mean = all.iter().sum::<f64>() / f64::from(count);
            let variance = all.iter().map(|value| (value - mean).powi(2)).sum::<f64>() / f64::from(count);
            assert!((variance.sqrt() / deviation(&law) - 1.0).abs() < 1e-4, "{law:?}");
        }
    }
}
