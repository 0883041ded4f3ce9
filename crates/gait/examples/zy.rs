use solaris_dynamics::*;
use solaris_gait::*;
use solaris_model::*;
fn main() {
    let h = 1.75;
    let f = human(h, 23.8 * h * h).unwrap();
    let plan = walk(&f, &WalkRequest { step_frequency: Some(118.0), ..Default::default() }).unwrap();
    let m = plan.motion(&f, 120.0).unwrap();
    let tree = Tree::<f64>::new(&f, m.info.gravity).unwrap();
    let mut ws = Workspace::new(&tree);
    let mut tau = vec![0.0; 66];
    let com: Vec<_> = (0..m.len()).map(|i| center_of_mass(&tree, &mut ws, m.q(i)).unwrap()).collect();
    let mut sum = Vector3::zeros();
    for i in 3..m.len() - 3 {
        inverse_dynamics(&tree, &mut ws, m.q(i), m.v(i), m.a(i), &[], &mut tau).unwrap();
        let a = ws.base_wrench().force / f.mass() + m.info.gravity;
        let d2 = (com[i - 3] * 2.0 - com[i - 2] * 27.0 + com[i - 1] * 270.0 - com[i] * 490.0
            + com[i + 1] * 270.0
            - com[i + 2] * 27.0
            + com[i + 3] * 2.0)
            / 180.0
            * 120.0
            * 120.0;
        let d = a - d2;
        sum += d;
        if d.norm() > 0.02 {
            println!("{:.3} u={:.3} {:.4?}", m.time()[i], plan.clock_at(m.time()[i]), d.as_slice());
        }
    }
    println!("{sum:?}");
}
