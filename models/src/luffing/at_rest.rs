//! What a scene gives of a luffing mechanism before anything moves it.

/// The groups of a luffing mechanism at rest: its own as told, those of load cases from what is read of these, those of a
/// drive and its strength where one is named, and of a motion none, the last ones besides those that every motion has.
macro_rules! at_rest {
    (($cases:expr $(, $driving:expr)?) without [$($none:ident),*]; $($own:tt)*) => {
        Given {
            cases: $cases.cases.clone(),
            bodies: $cases.bodies.clone(),
            rubbing: $cases.pins.clone(),
            air: $cases.air,
            driver: $cases.motor,
            starting: $cases.start.clone(),
            brake: $cases.brake,
            second: $cases.second,
            holds: $cases.holds.clone(),
            sizes: $cases.sizes.pins.clone(),
            chosen: $cases.choice.clone(),
            $(
                mount: $driving.mount,
                rod: $driving.rod(),
                cylinder: $driving.cylinder,
                gear: $driving.gear,
                strut: $cases.sizes.strut,
                profile: $cases.sizes.profile,
                teeth: $cases.sizes.teeth,
                nut: $cases.sizes.nut,
            )?
            states: None,
            inputs: None,
            control: None,
            commanded: None,
            latched: None,
            regulating: None,
            regime: None,
            constants: None,
            ramp: None,
            motor: None,
            give: None,
            around: None,
            ground: None,
            slewed: None,
            wound: None,
            past: None,
            fitted: $crate::luffing::moving::given::Fitted::default(),
            $($none: None,)*
            $($own)*
        }
    };
}
pub(crate) use at_rest;
