//! Stepping, setting and getting allocate nothing: a simulator may call them in real time.

mod common;

use lemnis_fmu::abi::{fmi2::*, fmi3::*};
use lemnis_models::kernel::variable::Type;
use std::ptr::{null, null_mut};

#[path = "../../models/tests/common/counting.rs"]
mod counting;

#[test]
fn stepping_allocates_nothing() {
    let fmu = common::Unpacked::new();
    let resources = fmu.resources();
    let theta_1 = fmu.reference("theta_1");
    let kind = |kind| {
        let variables = fmu.model.variables().iter().zip(1..);
        variables
            .filter(|(v, _)| v.kind == kind)
            .map(|(_, reference)| reference)
            .collect::<Vec<u32>>()
    };
    let (reals, booleans) = (kind(Type::Real), kind(Type::Boolean));
    let mut values = vec![0.0; reals.len()];
    let (mut integers, mut bytes) = (vec![0; booleans.len()], vec![0; booleans.len()]);
    let (mut event, mut terminate, mut early, mut reached) = (0, 0, 0, 0.0);

    // SAFETY: the instances are freed once, and the arrays have the lengths given.
    unsafe {
        let c = fmi2Instantiate(c"a".as_ptr(), 1, fmu.token.as_ptr(), resources.as_ptr(), null(), 0, 0);
        let i = fmi3InstantiateCoSimulation(
            c"a".as_ptr(),
            fmu.token.as_ptr(),
            resources.as_ptr(),
            0,
            0,
            0,
            0,
            null(),
            0,
            null_mut(),
            None,
            null(),
        );
        assert_eq!(fmi2EnterInitializationMode(c) + fmi2ExitInitializationMode(c), 0);
        assert_eq!(
            fmi3EnterInitializationMode(i, 0, 0.0, 0.0, 0, 0.0) + fmi3ExitInitializationMode(i),
            0
        );

        // Results of the whole working range are found once, when first asked for.
        let mut failures = fmi2GetReal(c, reals.as_ptr(), reals.len(), values.as_mut_ptr())
            + fmi3GetFloat64(i, reals.as_ptr(), reals.len(), values.as_mut_ptr(), values.len());
        let before = counting::count();
        for step in 0..1000 {
            let (time, angle) = (f64::from(step), 1.2 + 1e-4 * f64::from(step));
            failures += fmi2SetReal(c, &theta_1, 1, &angle)
                + fmi2DoStep(c, time, 1.0, 1)
                + fmi2GetReal(c, reals.as_ptr(), reals.len(), values.as_mut_ptr())
                + fmi2GetBoolean(c, booleans.as_ptr(), booleans.len(), integers.as_mut_ptr())
                + fmi3SetFloat64(i, &theta_1, 1, &angle, 1)
                + fmi3DoStep(i, time, 1.0, 1, &mut event, &mut terminate, &mut early, &mut reached)
                + fmi3GetFloat64(i, reals.as_ptr(), reals.len(), values.as_mut_ptr(), values.len())
                + fmi3GetBoolean(i, booleans.as_ptr(), booleans.len(), bytes.as_mut_ptr(), bytes.len());
        }
        assert_eq!(counting::count() - before, 0, "allocations in 1000 steps");
        assert_eq!(failures, 0);
        fmi2FreeInstance(c);
        fmi3FreeInstance(i);
    }
}
