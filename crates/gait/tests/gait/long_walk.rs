//! Long walks, whose middle stride is planned once and repeated.

use solaris_gait::{Extent, WalkPlan, WalkRequest, walk};
use solaris_model::{EventKind, Figure, Trajectory, human};

fn plan(figure: &Figure, step_frequency: f64, steps: usize) -> WalkPlan {
    let request = WalkRequest {
        step_frequency: Some(step_frequency),
        extent: Extent::Steps(steps),
        ..WalkRequest::default()
    };
    walk(figure, &request).expect("it can be walked")
}

/// The greatest difference of two configurations, the second `back` (m) nearer.
fn off(a: &[f64], b: &[f64], back: f64) -> f64 {
    let shifted = |i: usize| if i == 2 { b[i] - back } else { b[i] };
    (0..a.len()).map(|i| (a[i] - shifted(i)).abs()).fold(0.0, f64::max)
}

#[test]
fn the_seams_of_a_long_walk_do_not_show() {
    let figure = human(1.75, 73.0).expect("a person");
    for step_frequency in [70.0, 110.0, 118.0] {
        let (long, short) = (plan(&figure, step_frequency, 101), plan(&figure, step_frequency, 41));
        let step = long.style().step_length;
        let (mut a, mut b) = (vec![0.0; figure.layout().nq()], vec![0.0; figure.layout().nq()]);
        let span = short.clock_at(short.duration());
        for k in 0..400 {
            // From the beginning, and from the end: 30 strides more.
            let u = -1.0 + 9.0 * f64::from(k) / 400.0;
            long.configuration_at(u, &mut a);
            short.configuration_at(u, &mut b);
            assert!(off(&a, &b, 0.0) < 1e-9, "{step_frequency} {u}");
            let u = span - 9.0 * f64::from(k) / 400.0;
            short.configuration_at(u, &mut a);
            long.configuration_at(u + 30.0, &mut b);
            assert!(off(&a, &b, 60.0 * step) < 1e-9, "{step_frequency} {u}");
        }
        // Over every seam, forces too.
        for seam in 0..=31 {
            let u = 10.3 + f64::from(seam);
            long.configuration_at(u - 1e-9, &mut a);
            long.configuration_at(u + 1e-9, &mut b);
            assert!(off(&a, &b, 0.0) < 1e-6, "{step_frequency} {u}: {}", off(&a, &b, 0.0));
            let [before, after] = [u - 1e-9, u + 1e-9].map(|u| long.support(u)[0].cop);
            let moved = (before - after).norm();
            let force = long.force(u - 1e-9) - long.force(u + 1e-9);
            assert!(moved < 1e-6 && force.norm() < 1e-3, "{step_frequency} {u}");
        }
    }
}

#[test]
fn a_long_fast_walk_slows_down_at_its_end_only() {
    let figure = human(1.75, 73.0).expect("a person");
    let times = |steps: usize| -> Vec<f64> {
        let events = plan(&figure, 130.0, steps).events();
        let touch = events.iter().filter(|event| matches!(event.kind, EventKind::TouchDown { .. }));
        touch.map(|event| event.time).collect()
    };
    let (short, long) = (times(42), times(100));
    assert_eq!((short.len(), long.len()), (43, 101));
    // The first and the last steps are as those of the short walk, and what lies between has its pace.
    let step = 60.0 / 130.0;
    for k in 0..42 {
        let (a, b) = (short[k + 1] - short[k], long[k + 1] - long[k]);
        assert!(k > 35 || (a - b).abs() < 1e-12, "{k}: {a} {b}");
        let (a, b) = (short[42 - k] - short[41 - k], long[100 - k] - long[99 - k]);
        assert!(k > 35 || (a - b).abs() < 1e-12, "{k} from the end: {a} {b}");
    }
    assert!((long[90] - long[10] - 80.0 * step).abs() < 1e-11);
}

#[test]
fn a_long_walk_ends_where_and_when_its_steps_say() {
    let figure = human(1.75, 73.0).expect("a person");
    let long = plan(&figure, 110.0, 1000);
    assert_eq!((long.steps(), long.prints().len()), (1000, 1002));
    let touch = |event: &&solaris_model::Event| matches!(event.kind, EventKind::TouchDown { .. });
    let events = long.events();
    assert_eq!(events.iter().filter(touch).count(), 1001);
    // Contacts are half a stride apart.
    let times: Vec<f64> = events.iter().filter(touch).map(|event| event.time).collect();
    assert!(times.windows(2).all(|pair| (pair[1] - pair[0] - 60.0 / 110.0).abs() < 1e-9));
    let (mut start, mut end) = (vec![0.0; figure.layout().nq()], vec![0.0; figure.layout().nq()]);
    long.configuration(0.0, &mut start);
    long.configuration(long.duration(), &mut end);
    let way = long.prints()[1001];
    assert!(off(&start, &end, way) < 1e-8, "{}", off(&start, &end, way));
    // Feet that stand stay: the heel of every print while it is planted.
    let planted = long.planted(&figure);
    assert!(planted.windows(2).all(|pair| pair[0].start <= pair[1].start));
    assert!(planted.iter().all(|interval| interval.start < interval.end));
}
