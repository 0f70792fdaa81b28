//! The double link as scenes describe it and books tell it.

use std::collections::BTreeSet;

use crate::balance;
use crate::balance::boom::Boom;
use crate::balance::kept::kept;
use crate::component::description::{Described, Description, Vocabulary};
use crate::component::mechanism::{Entry, Solver};
use crate::component::moved::Moved;
use crate::component::moving::MovingComponent;
use crate::component::outline::{Outline, Published};
use crate::component::sheet::{Check, Drawing, Sheet, Summary};
use crate::component::standing::Standing;
use crate::component::telling::{compared, fine, sample};
use crate::drive;
use crate::kernel::diagnostic::Diagnostic;
use crate::kernel::gravity;
use crate::kernel::group::One;
use crate::kernel::schema::Values;
use crate::kernel::symbol::Symbol;
use crate::kernel::text::Text;
use crate::kernel::variable::{Fault, Name};
use crate::luffing::at_rest::at_rest;
use crate::luffing::boom_scene::vanishing;
use crate::luffing::counterweight::chapter;
use crate::luffing::double_link::balancing::{self, boom};
use crate::luffing::double_link::drawing::drawing;
use crate::luffing::double_link::geometry::Geometry;
use crate::luffing::double_link::keys::KEYS;
use crate::luffing::double_link::leading::{JIB, hauled, rise};
use crate::luffing::double_link::outline::{OUTLINE, VOCABULARY};
use crate::luffing::double_link::parameters::{Choice, Driven, Jib};
use crate::luffing::double_link::pin_forces::PinForces;
use crate::luffing::double_link::position::Position;
use crate::luffing::double_link::range::{Rise, rise_by_integration};
use crate::luffing::double_link::scene::{Luffing, LuffingScene, search};
use crate::luffing::double_link::stages::{DoubleLink, Given};
use crate::luffing::double_link::statics::{Centres, Own};
use crate::luffing::double_link::symbols as s;
use crate::luffing::double_link::system::ByCentres;
use crate::luffing::double_link::velocity::Velocity;
use crate::luffing::moving::follows::follows;
use crate::luffing::moving::levels;
use crate::luffing::moving::outline::FOLLOWED;
use crate::luffing::moving::told::motion::moved;
use crate::luffing::moving::told::shown::running;
use crate::luffing::resistances;
use crate::luffing::with_balance::{WithBalance, agreement};
use crate::parts::motion::Motion;

/// What is told of a plain boom, for which jib and rocker only stand in: its balance, its drive and these.
const OF_BOOM: [&Symbol; 10] = [
    &s::THETA_1,
    &s::FROM,
    &s::TO,
    &s::B_X,
    &s::M_G,
    &s::M_D,
    &s::M_D_MAX,
    &s::F_O1X,
    &s::F_O1Y,
    &gravity::G,
];

/// As scenes describe it.
pub const ENTRY: Entry = Description::<LuffingScene>::entry("double_link", KEYS);

impl Described for LuffingScene {
    type Component = DoubleLink;
    const ID: &'static str = "luffing";
    const TABLE: &'static str = "luffing";
    const OUTLINE: &'static Outline = &OUTLINE;
    const FOLLOWED: &'static [&'static Symbol] = FOLLOWED;
    const VOCABULARY: &'static Vocabulary = &VOCABULARY;

    fn read(v: &Values, gravity: f64, found: &mut Vec<Diagnostic>) -> Option<(LuffingScene, Motion)> {
        LuffingScene::new(v, gravity, found)
    }

    fn given(this: &Luffing) -> Given<f64> {
        let p = &this.parameters;
        at_rest! { (this.cases, this.driving) without [inertias, hoist_falls, oil, oil_parts];
            theta: One(p.driven.coordinate(), this.motion.from),
            omega: One(p.driven.rate(), this.motion.speed),
            load: this.q.map(|q| One(&s::Q, q)),
            rope: this.led.falls,
            sheaves: this.led.sheaves.clone(),
            leading: this.led.leading,
            lengths: p.lengths,
            jib: match p.jib {
                Jib::Sag(x) => One(&s::X_7, x),
                Jib::Angle(x) => One(&s::BETA_0, x),
                Jib::Axis(x) => One(&s::AC, x),
            },
            weights: p.weights,
            balance: p.balance,
            choice: Choice {
                driven: p.driven,
                branch: p.branch,
                range: this.motion,
                pins: this.has_pins(),
                crank: this.driving.branch(),
            },
        }
    }

    /// Checks that its cases exist all over the working range, and the mechanism at each published row.
    fn check(luffing: &mut Luffing, v: &Values, found: &mut Vec<Diagnostic>) {
        let mut standing = luffing.standing();
        resistances::told::check::<DoubleLink>(&standing, &luffing.cases, v, found);
        luffing.led.check(&standing, JIB, v, found);
        if luffing.moving.is_some() {
            drive::hauling::check(&mut standing, v, found);
        }
        if let Some((published, table)) = luffing.published.as_ref().zip(v.table("published")) {
            // The first line has the names.
            let places = table.texts("values").iter().skip(1);
            let compared = compared(published, &mut standing);
            for (row, (_, place)) in compared.into_iter().zip(places) {
                if let Err(fault) = row {
                    let message = format!("a published row of which there is none: {}", fault.message);
                    found.push(
                        Diagnostic::new(place.clone(), message, "not possible").help("correct the row, or remove it"),
                    );
                }
            }
        }
    }

    fn levels(&self) -> Vec<&'static str> {
        levels::levels(self.moving.as_deref())
    }

    fn set_level(&mut self, level: &str) {
        if !levels::set_level(self.moving.as_deref_mut(), level) {
            self.moving = None;
        }
    }

    fn unused(&self, level: &str) -> Vec<(&'static str, &'static [&'static str])> {
        levels::unused(level, self.moving.as_deref())
    }

    fn hangs_on(this: &Luffing) -> Option<[f64; 2]> {
        this.moving.as_ref()?.swings()
    }

    fn hang(&mut self, length: f64) {
        if let Some(rope) = self.moving.as_mut().and_then(|moving| moving.rope.as_mut()) {
            rope.length = length;
        }
    }

    fn solver(&self) -> Option<Solver> {
        levels::solver(self.moving.as_deref(), [0.17e-6, 0.20e-6])
    }

    fn moving(this: &Luffing) -> Option<Result<MovingComponent, Fault>> {
        running(this)
    }

    fn follows(model: &MovingComponent) -> Vec<BTreeSet<Name>> {
        follows::<DoubleLink>(model)
    }

    fn chapters(&self) -> Vec<&'static str> {
        let moving = self.moving.as_ref().map(|_| "motion");
        let balance = self.parameters.balance.map(|_| "balance");
        let synthesis = self.synthesis.as_ref().map(|_| "synthesis");
        let cases = self.cases.are_there().then_some("cases");
        [moving, balance, synthesis, cases].into_iter().flatten().collect()
    }

    fn searched(this: &Luffing, _: &Standing) -> Vec<Summary> {
        let found = this.analysed.as_ref();
        found.map_or(Vec::new(), |found| found.extremes(this.parameters.driven.coordinate()))
    }

    fn identities(this: &Luffing, model: &mut Standing) -> Vec<Check> {
        let (p, motion) = (&this.parameters, &this.motion);
        let led = this.led.reeved();
        let (Ok(g), Some(rise)) = (Geometry::new(p), Rise::new(p, led.as_ref(), motion)) else {
            return Vec::new();
        };
        let mut checks = Vec::new();
        let mut agree = |id, value, limit| checks.push(Check::at_most(id, &s::AGREEMENT, value, limit));
        let system = boom(p, motion);
        if let Some([work, power]) = agreement::<DoubleLink>(model, |phi| system.clone()?.0.moment_by_power(phi)) {
            agree("balance_work", work, 1e-12);
            agree("balance_power", power, 1e-12);
        }
        if this.has_pins() {
            agree("equilibrium", equilibrium(this, &g), 1e-12);
            let Check { id, value, .. } = power(this, &g, model);
            agree(id, value, 1e-12);
        }
        let cases = resistances::checks::identities::<DoubleLink>(model, &this.cases, &s::M_D);
        let Some(q) = this.q.filter(|q| *q > 0.0) else {
            checks.extend(cases);
            return checks;
        };
        // Agreement of independent ways, relative to the largest moment.
        let (integral, difference) = (rise_by_integration(&g, led.as_ref(), motion), rise.whole);
        let scale = rise.steepest.abs();
        let energy = ((integral - difference) / (scale * (motion.to - motion.from))).abs();
        agree("energy_identity", energy, 1e-9);
        let apart = |both: &[Vec<f64>]| both.iter().map(|row| (row[0] - row[1]).abs()).fold(0.0, f64::max);
        let both = sample(model, &[&s::M_Q, &s::M_Q_P], fine(motion));
        agree("moment_agreement", apart(&both) / (q * scale), 1e-12);
        checks.extend(drive::checks::by_slider(&this.driving, model, &s::AGREEMENT));
        checks.extend(cases);
        checks
    }

    fn totals(this: &Luffing) -> Vec<Summary> {
        let (p, motion) = (&this.parameters, &this.motion);
        let led = this.led.reeved();
        let (Some(q), Ok(g), Some(rise)) = (this.q, Geometry::new(p), Rise::new(p, led.as_ref(), motion)) else {
            return Vec::new();
        };
        vec![
            Summary::new(&s::W_Q, q * rise_by_integration(&g, led.as_ref(), motion)),
            Summary::new(&s::W_Y, q * rise.whole),
        ]
    }

    fn published(&self) -> Option<&Published> {
        self.published.as_ref()
    }

    /// The instantaneous centre runs to infinity: what is drawn of it ends at five times the crane's size. With boom
    /// and rocker always parallel nothing is left.
    fn pieces(&self, id: &'static str, points: Vec<[f64; 2]>) -> Vec<Vec<[f64; 2]>> {
        if id != "li2022_fig_3" {
            return vec![points];
        }
        let size = 5.0 * (self.parameters.lengths.x_1 + self.parameters.lengths.x_4);
        let drawable = |point: &[f64; 2]| point.iter().all(|x| x.abs() <= size);
        let whole = |a: &[f64; 2], b: &[f64; 2]| drawable(a) && drawable(b) && (a[1] > 0.0) == (b[1] > 0.0);
        let pieces = points.chunk_by(whole).filter(|piece| piece.len() > 1);
        pieces.map(<[_]>::to_vec).collect()
    }

    fn assumptions(this: &Luffing) -> Vec<&'static str> {
        let given = |known: bool, id: &'static str| known.then_some(id);
        // A plain boom has no reach of its own.
        let from_foot = this.parameters.lengths.x_8 == 0.0 && !this.is_plain();
        let foot = given(from_foot, "reach_from_foot");
        let Some(moving) = &this.moving else {
            let level = if this.table.is_some() {
                "level_table"
            } else {
                "level_static"
            };
            let led = given(this.led.falls.is_some(), "led_rope");
            return [Some(level), led, given(this.q.is_some(), "forces"), foot]
                .into_iter()
                .flatten()
                .collect();
        };
        let led = this.led.assumed(moving);
        let (load, led) = led.map_or(("fixed_load", Vec::new()), |led| ("rope_load", led));
        [
            Some(levels::assumed(moving)),
            foot,
            Some("bodies"),
            given(this.parameters.balance.is_some(), "counterweight"),
        ]
        .into_iter()
        .flatten()
        .chain(moving.taken(load))
        .chain(led)
        .chain(levels::solved(moving))
        .collect()
    }

    /// At rest, besides the chapter of motion where it moves by itself.
    fn uncovered(this: &Luffing) -> Vec<&'static str> {
        let all = levels::uncovered("friction", this.moving.as_deref());
        resistances::scene::left(all, &this.cases)
    }

    fn parts(this: &Luffing) -> Vec<&'static str> {
        if this.is_plain() { vec!["plain"] } else { Vec::new() }
    }

    fn drawing(this: &Luffing, at: f64) -> Drawing {
        let g = Geometry::new(&this.parameters).expect("checked when the scene was read");
        drawing(&g, this, at)
    }

    fn remarks(&self) -> Vec<&'static str> {
        let from = |source: Option<&Text>, key: &str| source.is_some_and(|source| source.english().starts_with(key));
        let mechanism = self.published.as_ref().map(|published| &published.source);
        let balance = self.published_balance.as_ref().map(|published| &published.source);
        let mut list = Vec::new();
        if from(mechanism, "[Li2022") {
            list.extend([
                "li2022_sag",
                "li2022_sign",
                "li2022_quadrants",
                "li2022_level_error",
                "li2022_drive_comparison",
            ]);
        }
        if from(balance, "[Balance004") {
            list.extend([
                "balance004_rounding",
                "balance004_nodes",
                "balance004_double_node",
                "balance004_rod",
                "balance004_chi_2",
            ]);
        }
        if from(balance, "[Ports001") {
            list.extend(["ports001_pivot", "ports001_positions", "ports001_linkage"]);
        }
        list
    }

    fn in_motion(this: &Luffing) -> Option<Moved> {
        moved(this)
    }

    fn more(this: &Luffing, model: &mut Standing, sheet: &mut Sheet) {
        let mut symbols = DoubleLink::SYMBOLS;
        if this.is_plain() {
            // The jib's head stands in too.
            symbols[1] = &s::B_X;
            let told = |symbol: &Symbol| {
                [&OF_BOOM[..], balance::symbols::ALL, drive::symbols::ALL]
                    .iter()
                    .any(|list| list.contains(&symbol))
            };
            sheet.tell_results(&told);
            if this.moving.is_none() {
                sheet.tell_formulas(&told);
            }
        }
        sheet.balance = chapter::<DoubleLink>(model, symbols, this.published_balance.as_ref());
        sheet.cases = resistances::told::chapter(this, model, &this.cases);
        if let Some(search) = search(this) {
            sheet.requirements.extend(kept(&search));
        }
    }
}

/// Virtual work of load and weights against the power of each link about its instantaneous centre.
fn power(luffing: &Luffing, g: &Geometry<f64>, model: &mut Standing) -> Check {
    let weights = luffing.parameters.weights.as_ref();
    let mut symbols = vec![g.driven.coordinate(), &s::M_Q];
    symbols.extend(weights.map(|_| &s::M_G));
    let led = luffing.led.reeved();
    vanishing(model, ("power", &s::AGREEMENT), &symbols, |row| {
        let p = Position::new(g, row[0]).expect("the range was checked");
        let centres = weights.map(|w| Centres::new(&p, &g.lengths, w));
        let (by_centres, q) = (ByCentres::new(g, &p), luffing.q.unwrap_or(0.0));
        let links = by_centres.power(&p, q, weights.zip(centres.as_ref()));
        let rope = led.as_ref().and_then(|led| hauled(g, led, &p, q));
        let rope = rope.map_or([0.0; 3], |rope| by_centres.hauled(&p, &rope.on));
        // Apart, as a centre below the load leaves nothing of great moments.
        let of_centre = (q + weights.map_or(0.0, |w| w.g_2)) * by_centres.lever();
        let work = row[1] + row.get(2).copied().unwrap_or(0.0);
        [
            work,
            rope[0] - links[0],
            rope[1] - (links[1] + of_centre),
            of_centre,
            rope[2] - links[2],
        ]
    })
}

/// The drive's moment by equilibrium of the bodies against virtual work of load
/// and weights: largest difference over the range, relative to the largest moment.
fn equilibrium(luffing: &Luffing, g: &Geometry<f64>) -> f64 {
    let (lengths, weights) = (&g.lengths, &luffing.parameters.weights);
    let q = luffing.q.unwrap_or(0.0);
    let balancing = balancing::new(&luffing.parameters, &luffing.motion).ok().flatten();
    let led = luffing.led.reeved();
    let (mut worst, mut scale) = (0.0_f64, f64::MIN_POSITIVE);
    for theta in fine(&luffing.motion) {
        let Some(p) = Position::new(g, theta) else { continue };
        let v = Velocity::new(&p);
        let own = weights.as_ref().map(|w| Own::new(&p, &v, lengths, w));
        let with = balancing.as_ref().zip(weights.as_ref()).zip(own.as_ref());
        let residual = with.and_then(|((balancing, w), own)| balancing::at(balancing, g, &p, &v, w, own, &theta).ok());
        let turn = if p.driven == Driven::Boom { 1.0 } else { v.i_follower };
        let carried = residual.as_ref().map_or(0.0, |residual| residual.action.m_b * turn);
        let risen = rise(g, led.as_ref(), &p).unwrap_or(f64::NAN);
        let work = q * risen + own.as_ref().map_or(0.0, |own| own.m_g) - carried;
        let pulled = led.as_ref().and_then(|led| hauled(g, led, &p, q));
        let m_d = PinForces::new(&p, &q, weights, own.as_ref(), residual.as_ref(), pulled.as_ref()).m_d;
        worst = worst.max((m_d - work).abs());
        // What is left of great moments may be nothing.
        scale = scale.max(work.abs()).max(carried.abs());
    }
    worst / scale
}
