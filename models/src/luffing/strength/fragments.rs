//! Groups and stages of what a drive with a rod, a rack or a screw is as strong as.

/// Groups of its sizes.
macro_rules! strong_parts {
    (() $($to:tt)*) => {
        $crate::component::fragments::composed! { @with {
            Parameter strut: Option<$crate::luffing::strength::given::Strut<C>>,
            Parameter profile: Option<$crate::luffing::strength::given::Profile<C>>,
            Parameter teeth: Option<$crate::luffing::strength::given::Teeth<C>>,
            Parameter nut: Option<$crate::luffing::strength::given::Nut<C>>,
        } $($to)* }
    };
}
pub(crate) use strong_parts;

/// Stages of its strength under the force of each case.
macro_rules! strong {
    (() $($to:tt)*) => {
        $crate::component::fragments::composed! { @with {
            slender: $crate::luffing::strength::strut::Slender<C> =
                $crate::luffing::strength::strut::Slender::new(strut[!], profile, nut, cylinder, drive);
            buckled[each cases]: Vec<C> = $crate::luffing::strength::strut::buckled(strut[!], slender, force[each]) => U_K;
            mesh: $crate::luffing::strength::teeth::Mesh<C> =
                $crate::luffing::strength::teeth::Mesh::new(teeth[!], gear[!], mount[!]);
            toothed[each cases]: Vec<$crate::luffing::strength::teeth::Toothed<C>> =
                $crate::luffing::strength::teeth::Toothed::new(teeth[!], mesh, force[each]);
            core: $crate::luffing::strength::nut::Core<C> =
                $crate::luffing::strength::nut::Core::new(nut[!], gear[!], gearing);
            threaded[each cases]: Vec<$crate::luffing::strength::nut::Threaded<C>> =
                $crate::luffing::strength::nut::Threaded::new(nut[!], core, force[each]);
            pressed[each cases]: Vec<C> = $crate::luffing::strength::pull::pressed(cylinder[!], force[each]) => P_C;
        } $($to)* }
    };
}
pub(crate) use strong;
