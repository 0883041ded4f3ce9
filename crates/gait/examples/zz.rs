use solaris_gait::*;
use solaris_model::human;
use solaris_modes::ground_reactions;
fn main() {
    let nodes: usize = std::env::args().nth(1).unwrap().parse().unwrap();
    let rate = 120.0;
    for sf in [60.0, 80.0, 95.0, 110.0, 118.0] {
        for h in [1.2, 1.5, 1.75, 2.0] {
            for n in [1usize, 2, 3, 10] {
                let f = human(h, 23.8 * h * h).unwrap();
                let r = Resolution { nodes, ..Default::default() };
                let plan = match walk(
                    &f,
                    &WalkRequest {
                        step_frequency: Some(sf),
                        extent: Extent::Steps(n),
                        resolution: r,
                        ..Default::default()
                    },
                ) {
                    Ok(p) => p,
                    Err(e) => {
                        println!("{sf} {nodes} {e}");
                        continue;
                    }
                };
                let mut m = plan.motion(&f, rate).unwrap();
                let rep = match ground_reactions(&f, &mut m, FEET, &plan) {
                    Ok(r) => r,
                    Err(e) => {
                        println!("{sf} {h} {n} {e}");
                        continue;
                    }
                };
                let w = measure(&f, &m).unwrap();
                let k = m.len();
                let mut imp = [0.0f64; 3];
                for i in 0..k {
                    let c = if i == 0 || i == k - 1 { 0.5 } else { 1.0 };
                    let t = m.contacts[0].samples[i].force
                        + m.contacts[1].samples[i].force
                        + m.info.gravity * f.mass();
                    for a in 0..3 {
                        imp[a] += c * t[a] / rate;
                    }
                }
                let q = f.mass() * 9.80665 * w.duration;
                let i = imp.iter().fold(0.0f64, |a, b| a.max(b.abs())) / q;
                println!(
                    "{sf} {h} {n}: from {:.1} at {:.2} copn {:.1} fric {:.2} {:.2} imp {:.1e} clear {:.1} cop {:.1}@{:.2} sink {:.3} slide {:.4} knee {:.1} mean {:.3}",
                    rep.from_prescribed.unwrap().0 / f.mass() / 9.81 * 100.0,
                    rep.from_prescribed.unwrap().1,
                    rep.cop_from_nominal.0 * 1e3,
                    w.friction.value,
                    w.foot_friction.value,
                    i,
                    w.clearance.value * 1e3,
                    w.cop_outside.value * 1e3,
                    w.cop_outside.time,
                    w.sink.value * 1e3,
                    w.slide.value * 1e3,
                    w.least_knee.value.to_degrees(),
                    w.steady.map_or(0.0, |s| s.mean_vertical)
                );
            }
        }
    }
}
