//! Eight groups, evaluated without allocation.

use std::hint::black_box;

use lemnis_models::kernel::variable::Role;
use lemnis_models::scene::Scene;
use lemnis_models::steering::cylinder::{Linkage, Mounting};
use lemnis_models::steering::limits::Limits;
use lemnis_models::steering::load::{Tyre, force, resistance};
use lemnis_models::steering::machine::{Axis, Footprint, Machine};
use lemnis_models::steering::mode::{Command, Mode};
use lemnis_models::steering::published::Layout;
use lemnis_models::steering::wheels::{Rolling, Wheel, scale, speed};

#[path = "common/counting.rs"]
mod counting;

/// Angles, speeds, cylinder lengths, lever arms and forces of the paper's eight
/// groups, from an angle command: no allocation.
#[test]
fn eight_groups_without_allocation() {
    let layout = Layout {
        s_t: 12.0,
        l_1: 4.0,
        l_2: 9.0,
    };
    let axes = layout.groups().map(|p| Axis { x: p.x, y: p.y });
    let machine = Machine::new(&axes, &Footprint(None)).expect("apart");
    let limits = vec![Limits::new(-1.2, 1.2, Vec::new()).expect("contains straight ahead"); 8];
    let cylinder = Mounting {
        r: 0.5,
        alpha: 0.0,
        l_x: 1.6,
        l_a: 0.4,
    };
    let linkages: [Linkage<f64>; 8] = std::array::from_fn(|i| cylinder.linkage(i % 2 == 1));
    let tyre = Tyre {
        f_t: 0.7,
        p_t: 0.9e6,
        k_v: 2.5,
    };
    let loads = [900e3; 8];
    let (mut lengths, mut arms, mut forces) = ([0.0; 8], [0.0; 8], [0.0; 8]);
    let mut evaluate = |theta: f64| {
        let centre = Mode::AllWheel.centre(&machine, Command::Angle(theta)).expect("allowed");
        let rollings: [_; 8] = std::array::from_fn(|i| Rolling::new(&centre, &axes[i]));
        let wheels: [_; 8] = std::array::from_fn(|i| Wheel::new(&rollings[i], &limits[i]));
        assert!(wheels.iter().all(|wheel| wheel.placed), "within reach");
        let scale = scale(&centre, &rollings, &0.5);
        let speeds: [_; 8] = std::array::from_fn(|i| speed(&rollings[i], &wheels[i], &scale));
        for i in 0..8 {
            let pose = linkages[i].at(wheels[i].turn);
            (lengths[i], arms[i]) = (pose.l, pose.od);
            forces[i] = force(resistance(&tyre, loads[i]).standing, pose.od);
        }
        black_box((&wheels, &speeds, &lengths, &arms, &forces));
    };
    evaluate(0.3);
    let before = counting::count();
    for i in 0..1400 {
        evaluate(black_box(-0.5 + f64::from(i) * 1e-3));
    }
    assert_eq!(counting::count(), before, "allocations");
}

/// The same through the running model, in every mode, all outputs, set points on their way among them.
#[test]
fn the_model_without_allocation() {
    let scene = Scene::parse(include_str!("../scenes/boat_hoist_003.toml")).unwrap_or_else(|found| panic!("{found:?}"));
    let mut model = scene.model().expect("a machine");
    let mode = model
        .variables()
        .iter()
        .position(|v| v.symbol.id == "mode")
        .expect("there");
    let outputs: Vec<usize> = (0..model.variables().len())
        .filter(|&i| model.variables()[i].role == Role::Output)
        .collect();
    let mut time = 0.0;
    model.start().expect("a machine");
    let mut evaluate = |theta: f64, number: u32| {
        time += 0.5;
        model.set_time(time);
        for &(index, value) in &[(0, theta), (mode, f64::from(number))] {
            model.set(index, value).expect("allowed");
        }
        for &index in &outputs {
            black_box(model.get(index).expect("a value"));
        }
    };
    evaluate(0.3, 6);
    let before = counting::count();
    // Every change of mode starts while the one before is under way.
    for i in 0..900 {
        evaluate(black_box(-0.4 + f64::from(i) * 1e-3), 1 + i % 9);
    }
    assert_eq!(counting::count(), before, "allocations");
}
