//! The recursions run over any scalar: here over one that counts its operations.

use crate::support::Kernel;
use crate::support::random::Random;
use nalgebra::Vector3;
use solaris_dynamics::scalar::Counted;
use solaris_model::human;

#[test]
fn a_counting_scalar_gets_the_same_digits_and_stays_within_the_budget() {
    let (figure, gravity) = (human(1.75, 73.0).expect("within range"), Vector3::new(0.0, -9.806_65, 0.0));
    let mut random = Random::new(17);
    let state = [random.slice(66, 1.0), random.slice(66, 2.0), random.slice(66, 5.0)];
    let counted = state.each_ref().map(|slice| slice.iter().map(|x| Counted::new(*x)).collect::<Vec<_>>());
    let mut plain = Kernel::<f64>::new(&figure, gravity);
    let mut counting = Kernel::<Counted>::new(&figure, gravity);
    let (tau, operations) =
        Counted::measure(|| counting.inverse(&counted[0], &counted[1], &counted[2], &[]).expect("valid"));
    let expected = plain.inverse(&state[0], &state[1], &state[2], &[]).expect("valid");
    assert_eq!(tau.into_iter().map(|tau| tau.value().to_bits()).collect::<Vec<_>>(), {
        expected.into_iter().map(f64::to_bits).collect::<Vec<_>>()
    });
    // 63 turns, 3 slides, 21 links; without the sines. More is a step back.
    let multiplications = operations.multiplications + operations.divisions;
    assert!(multiplications <= 2700 && operations.additions <= 2300, "{operations:?}");
    assert_eq!(operations.sines, 66);
}
