//! What the joints transmit, against Newton's and Euler's laws of every link on its own.

use crate::questions::case::{Case, derivative};
use crate::support::Kernel;
use nalgebra::Vector3;
use proptest::prelude::*;
use solaris_dynamics::{Pose, Wrench, joint_reactions};
use solaris_model::AxisKind;

impl Case {
    fn reactions(&mut self) -> (Vec<Wrench<f64>>, Vec<f64>) {
        let mut tau = vec![f64::NAN; self.nv()];
        let Kernel { tree, workspace } = &mut self.kernel;
        joint_reactions(tree, workspace, &self.q, &self.v, &self.a, &self.external, &mut tau).expect("valid");
        ((0..self.figure.links().len()).map(|link| *workspace.reaction(link)).collect(), tau)
    }

    /// Momentum of one link: linear, and angular about the world's origin.
    fn link_momentum(&mut self, link: usize, t: f64) -> [Vector3<f64>; 2] {
        let (q, v) = self.after(t);
        self.kernel.velocities(&q, &v);
        let (body, pose) = (&self.figure.links()[link], self.kernel.workspace.pose(link));
        let twist = self.kernel.workspace.velocity(link);
        let velocity = twist.linear + twist.angular.cross(&(pose.rotation * body.com()));
        let linear = velocity * body.mass();
        let spin = pose.rotation * body.inertia() * pose.rotation.transpose() * twist.angular;
        [linear, pose.transform(body.com()).cross(&linear) + spin]
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(100))]

    /// Reaction of the joint, less those of the children's, gravity and wrenches: the rate of the link's momentum.
    #[test]
    fn every_link_is_in_balance(seed in any::<u64>(), loaded in any::<bool>()) {
        let mut case = Case::random(seed);
        if !loaded {
            case.external.clear();
        }
        let (reactions, _) = case.reactions();
        for link in 0..reactions.len() {
            let linear = derivative(|t| case.link_momentum(link, t)[0]);
            let angular = derivative(|t| case.link_momentum(link, t)[1]);
            case.kernel.place(&case.q);
            let body = &case.figure.links()[link];
            let center = case.kernel.workspace.pose(link).transform(body.com());
            let weight = Wrench::at(&center, case.gravity * body.mass(), Vector3::zeros());
            let (mut force, mut moment) = (weight.force, weight.moment);
            let mut add = |wrench: &Wrench<f64>, sign: f64| {
                force += wrench.force * sign;
                moment += wrench.moment * sign;
            };
            add(&reactions[link], 1.0);
            let children = case.figure.links().iter().zip(&reactions);
            children.filter(|(child, _)| child.parent() == Some(link)).for_each(|(_, wrench)| add(wrench, -1.0));
            case.external.iter().filter(|(on, _)| *on == link).for_each(|(_, wrench)| add(wrench, 1.0));
            let scale = 1.0 + reactions[link].force.amax() + reactions[link].moment.amax();
            prop_assert!((force - linear).amax() < 1e-8 * scale, "link {link}: {force} {linear}");
            prop_assert!((moment - angular).amax() < 1e-8 * scale, "link {link}: {moment} {angular}");
        }
    }

    /// Seen from the link, the last degree of freedom of its joint reads its own force; so does the whole of a ball or free
    /// joint.
    #[test]
    fn forces_are_components_of_reactions(seed in any::<u64>()) {
        let mut case = Case::random(seed);
        let (reactions, tau) = case.reactions();
        for (i, (link, at)) in case.figure.links().iter().zip(case.figure.layout().joints()).enumerate() {
            let kind = link.joint().kind();
            let seen = reactions[i].seen_from(case.kernel.workspace.pose(i));
            let free = [seen.force.as_slice(), seen.moment.as_slice()].concat();
            let along: Vec<(usize, f64)> = match (kind.quaternion(), kind.axes().last()) {
                (Some(_), _) => {
                    (0..at.nv).map(|k| (k, free[6 - at.nv + k])).collect()
                }
                (None, Some(dof)) => {
                    let part = if dof.axis.kind == AxisKind::Rotation { seen.moment } else { seen.force };
                    vec![(at.nv - 1, part.dot(&dof.axis.direction))]
                }
                (None, None) => Vec::new(),
            };
            for (k, component) in along {
                let armature = kind.armature(k) * case.a[at.v + k];
                let scale = 1.0 + seen.force.amax() + seen.moment.amax();
                prop_assert!((component + armature - tau[at.v + k]).abs() < 1e-11 * scale);
            }
        }
    }

    /// Power through a joint does not depend on the point or axes that its wrench is written at.
    #[test]
    fn a_wrench_means_the_same_from_every_frame(seed in any::<u64>()) {
        let mut random = crate::support::random::Random::new(seed);
        let (_, wrench) = random.wrench(1);
        let placement = random.placement();
        let pose = Pose {
            rotation: *placement.rotation.to_rotation_matrix().matrix(),
            translation: placement.translation.vector,
        };
        let (velocity, spin) = (random.vector(1.0), random.vector(1.0)); // of the world's origin
        let seen = wrench.seen_from(&pose);
        let back = pose.rotation.transpose();
        let there = back * (velocity + spin.cross(&pose.translation));
        let power = wrench.force.dot(&velocity) + wrench.moment.dot(&spin);
        prop_assert!((seen.force.dot(&there) + seen.moment.dot(&(back * spin)) - power).abs() < 1e-12 * 100.0);
        let again = Wrench::at(&pose.translation, wrench.force, wrench.moment_about(&pose.translation));
        prop_assert!((again.moment - wrench.moment).amax() < 1e-12 * 100.0);
    }
}
