//! Inverse dynamics under wrenches that follow from what the motion needs, against the passes that it saves.

use crate::questions::case::Case;
use crate::support::Kernel;
use crate::support::random::Joints;
use nalgebra::Vector3;
use proptest::prelude::*;
use solaris_dynamics::{
    DynamicsError, Workspace, Wrench, center_of_mass, inverse_dynamics, inverse_dynamics_with,
};

proptest! {
    #![proptest_config(ProptestConfig::with_cases(200))]

    /// What is told and what comes of it are the same to the bit, with the way outwards gone once.
    #[test]
    fn one_way_outwards_is_as_good_as_three(seed in any::<u64>()) {
        let Case { kernel: Kernel { tree, mut workspace }, q, v, a, external, .. } = Case::with(Joints::EveryArmed, seed);
        let (mut tau, mut expected) = (vec![f64::NAN; v.len()], vec![f64::NAN; v.len()]);
        let mut told = None;
        let react = |workspace: &Workspace<f64>, com: &Vector3<f64>| {
            let links = [0, 1].map(|k: usize| external[k].0);
            told = Some((workspace.base_wrench(), *com, links.map(|link| *workspace.pose(link))));
            Ok::<[(usize, Wrench<f64>); 2], DynamicsError>([external[0], external[1]])
        };
        inverse_dynamics_with(&tree, &mut workspace, &q, &v, &a, react, &mut tau).expect("valid");
        let left = workspace.base_wrench();

        let ws = &mut workspace;
        inverse_dynamics(&tree, ws, &q, &v, &a, &[], &mut expected).expect("valid");
        let needed = ws.base_wrench();
        let com = center_of_mass(&tree, ws, &q).expect("valid");
        let poses = [0, 1].map(|k: usize| *ws.pose(external[k].0));
        inverse_dynamics(&tree, ws, &q, &v, &a, &external, &mut expected).expect("valid");
        prop_assert_eq!((tau, left, told), (expected, ws.base_wrench(), Some((needed, com, poses))));
    }
}
