//! How the parts of the steering are chosen, in the book. [Zhang2016, 4-6]

use crate::component::sheet::{Changes, Section, Summary};
use crate::kernel::calc::{Among, Calc};
use crate::kernel::record::{Rec, record};
use crate::kernel::symbol::Symbol;
use crate::steering::built::Built;
use crate::steering::demand::{Demand, greatest_demand};
use crate::steering::load::resistance;
use crate::steering::mode::Mode;
use crate::steering::ring::{Duty, friction};
use crate::steering::scene::Steering;
use crate::steering::sizing::{
    BORES, EXAMPLE_STROKES, Rod, bore, buckling, choose_stroke, next, power, pump, relief, slenderness,
};
use crate::steering::symbols as s;

/// What the parts are chosen by.
pub struct Parts {
    /// The greatest simultaneous oil flow of each mode that an angle commands.
    pub demands: Vec<(Mode, Demand)>,
    /// Formulas of what is chosen.
    pub sections: Vec<Section>,
    /// Whether the scene has load curves of rings.
    pub ring: bool,
}

impl Parts {
    #[must_use]
    pub fn new(steering: &Steering, built: &Built, changes: Option<&Changes>) -> Parts {
        let mut parts = Parts {
            demands: demands(steering, built),
            sections: Vec::new(),
            ring: false,
        };
        let pumped = parts.pumped(changes);
        parts.choose(steering, built, pumped);
        parts
    }

    /// The greatest of all modes.
    #[must_use]
    pub fn greatest(&self) -> Option<&(Mode, Demand)> {
        self.demands.iter().max_by(|(_, a), (_, b)| a.flow.total_cmp(&b.flow))
    }

    /// What the pump must deliver: the greatest flow of steering or, where that is more, of a change of mode.
    fn pumped(&self, changes: Option<&Changes>) -> Option<([&'static Symbol; 2], f64)> {
        let changing = changes.into_iter().flat_map(|changes| &changes.rows);
        let changing = changing.filter_map(|change| Some((FLOWS[1], change.flow?)));
        let steering = self.greatest().map(|(_, demand)| (FLOWS[0], demand.flow));
        let all = steering.into_iter().chain(changing);
        all.reduce(|a, b| if b.1 > a.1 { b } else { a })
    }

    fn section(&mut self, id: &'static str, equations: impl FnOnce()) {
        let (trace, ()) = record(equations);
        self.sections.push(Section {
            id,
            trace,
            ..Section::default()
        });
    }

    /// The value that the formulas find.
    #[must_use]
    pub fn found(&self, symbol: &'static Symbol) -> Option<f64> {
        let mut steps = self
            .sections
            .iter()
            .rev()
            .flat_map(|section| section.trace.steps.iter().rev());
        steps.find(|step| step.symbol == symbol).map(|step| step.value)
    }

    /// The ring, if the scene has one, and the point of its duty on its load curves.
    fn bear(&mut self, steering: &Steering, load: f64) {
        let Some((bearing, safety)) = steering.given.bearing.zip(steering.safety) else {
            return;
        };
        let duty = Duty::new(&bearing, &safety, load);
        let catalogue = steering.catalogue.as_ref();
        let ring = catalogue.and_then(|catalogue| catalogue.chosen(&bearing, &duty));
        self.section("ring", || {
            let of = &mut Rec::given;
            let load = among(&s::G, load, Among::Greatest).def(&s::G_MAX);
            let duty = Duty::new(&bearing.map(of), &safety.map(of), load);
            let _ = ring.map(|ring| ring.use_of(&duty));
        });
        if let (Some(ring), Some(section)) = (ring, self.sections.last_mut()) {
            (section.table, section.curve) = (Some(ring.points()), Some(ring.curves(&duty)));
            self.ring = true;
        }
    }

    fn choose(&mut self, steering: &Steering, built: &Built, pumped: Option<([&'static Symbol; 2], f64)>) {
        let of = Rec::given;
        let given = &steering.given;
        let load = heaviest(steering);
        if let Some(load) = load {
            self.bear(steering, load);
        }
        let Some(([longest, shortest, od_min], cylinder)) = extremes(built).zip(given.cylinder) else {
            return;
        };
        self.section("stroke", || {
            let cylinder = cylinder.map(&mut { of });
            let longest = among(&s::R, longest, Among::Greatest).def(&s::R_MAX);
            let shortest = among(&s::R, shortest, Among::Least).def(&s::R_MIN);
            let _ = cylinder.stroke_margins(longest, shortest);
        });
        let Some((load, tyre)) = load.zip(given.tyre) else {
            return;
        };
        let told = self.found(&s::G_MAX).is_some();
        self.section("force", || {
            let load = if told {
                of(&s::G_MAX, load)
            } else {
                among(&s::G, load, Among::Greatest).def(&s::G_MAX)
            };
            let standing = resistance(&tyre.map(&mut { of }), load).standing;
            let moment = match given.bearing {
                Some(bearing) => standing + friction(&bearing.map(&mut { of }), load),
                None => standing,
            };
            let arm = of(&s::OD, od_min);
            let least = arm.among(Among::Least, arm.abs()).def(&s::OD_MIN);
            let _ = (moment.def(&s::T_G_MAX) / least).def(&s::F_G_MAX);
        });
        let force = self.found(&s::F_G_MAX).unwrap_or(0.0);
        let Some((h, piston)) = steering.hydraulics.zip(given.piston) else {
            return;
        };
        self.section("bore", || {
            let _ = bore(of(&s::F_G_MAX, force), of(&s::P, h.p), of(&s::D, piston.d));
        });
        if let Some(([each, most], flow)) = pumped {
            self.section("pump", || {
                let flow = among(each, flow, Among::Greatest).def(most);
                let _ = power(flow, of(&s::P, h.p));
                let _ = pump(flow, of(&s::N, h.n), of(&s::ETA_V, h.eta));
                let _ = relief(of(&s::P, h.p), of(&s::K_R, h.k_r));
            });
        }
        self.section("buckling", || {
            let rod = Rod {
                e: of(&s::E, h.e),
                d: of(&s::D, piston.d),
                l_k: of(&s::R_MAX, longest),
                nu: of(&s::NU, h.nu),
            };
            let _ = slenderness(&rod);
            let _ = buckling(&rod);
        });
    }

    /// What the choice comes to.
    #[must_use]
    pub fn summary(&self, steering: &Steering, built: &Built) -> Vec<Summary> {
        let bore = self.found(&s::D_G_MIN).and_then(|least| next(&BORES, least).ok());
        let stroke = steering.given.cylinder.and_then(|cylinder| {
            let groups = built.limits.iter().zip(&steering.given.mounts);
            let needed =
                groups.map(|(limits, mount)| choose_stroke(&cylinder, mount.mirrored, limits, &EXAMPLE_STROKES).ok());
            needed.reduce(|a, b| Some(a?.max(b?)))?
        });
        let found = [&s::D_G_MIN, &s::V_P, &s::P_H, &s::P_R, &s::F_K, &s::LAMBDA, &s::SIGMA_E]
            .map(|symbol| (symbol, self.found(symbol)));
        let found = found.into_iter().chain([(&s::D_G_NEXT, bore), (&s::L_X_NEXT, stroke)]);
        let summary = found.filter_map(|(symbol, value)| Some(Summary::new(symbol, value?)));
        summary.collect()
    }
}

/// Oil flow of steering and of a change of mode, and the greatest of each.
const FLOWS: [[&Symbol; 2]; 2] = [[&s::Q_MODE, &s::Q_MAX], [&s::Q_SUM, &s::Q_X_MAX]];

/// A value found among those of all bodies, for the book.
fn among(each: &'static Symbol, value: f64, which: Among) -> Rec {
    let each = Rec::given(each, value);
    each.among(which, each)
}

/// A flow with the commanded angle at which it is asked for.
#[must_use]
pub fn demanded(symbol: &'static Symbol, demand: &Demand) -> Summary {
    Summary {
        at: Some((&s::THETA_B, demand.at)),
        ..Summary::new(symbol, demand.flow)
    }
}

fn demands(steering: &Steering, built: &Built) -> Vec<(Mode, Demand)> {
    let Some(piston) = steering.given.piston else {
        return Vec::new();
    };
    let modes = [Mode::Crab, Mode::FrontAxle, Mode::RearAxle, Mode::AllWheel];
    let found = modes.into_iter().filter_map(|mode| {
        let demand = greatest_demand(built, &piston, mode, steering.motion.speed);
        Some((mode, demand.ok().filter(|demand| demand.flow > 0.0)?))
    });
    found.collect()
}

/// Ends and smallest lever arm of all cylinders over their groups' ranges.
fn extremes(built: &Built) -> Option<[f64; 3]> {
    let each = built.linkages.iter().zip(&built.limits);
    let each = each.map(|(linkage, limits)| linkage.over(limits).expect("checked when the scene was read"));
    each.map(|e| [e.longest, e.shortest, e.od_min])
        .reduce(|[a, b, c], [d, e, f]| [a.max(d), b.min(e), c.min(f)])
}

/// Greatest load of a group, in N.
#[must_use]
pub fn heaviest(steering: &Steering) -> Option<f64> {
    steering.given.loads.iter().map(|load| load.g).reduce(f64::max)
}
