//! Calls that a program gets wrong: an answer, and nothing lost.

use solaris_ffi::*;
use std::ffi::CStr;
use std::ptr;

fn said() -> String {
    unsafe { CStr::from_ptr(solaris_last_error()) }.to_str().expect("a text").to_owned()
}

fn human() -> *mut Figure {
    let mut figure = ptr::null_mut();
    assert_eq!(unsafe { solaris_figure_human(1.75, 73.0, &raw mut figure) }, Status::Ok);
    figure
}

#[test]
fn null_is_refused_by_name_everywhere() {
    unsafe {
        let none = ptr::null_mut::<f64>();
        let figure = human();
        let mut dynamics = ptr::null_mut();
        assert_eq!(solaris_dynamics_new(figure, ptr::null(), &raw mut dynamics), Status::Ok);
        let calls: [(&str, Status); 8] = [
            ("out is NULL", solaris_figure_human(1.75, 73.0, ptr::null_mut())),
            ("path is NULL", solaris_figure_read(ptr::null(), ptr::null_mut())),
            ("figure is NULL", solaris_walker_new(ptr::null(), ptr::null_mut())),
            ("dynamics is NULL", solaris_mass_matrix(ptr::null_mut(), none, 0, none, 0)),
            ("q is NULL", solaris_mass_matrix(dynamics, none, 66, none, 66 * 66)),
            ("q has 3 numbers; it must have 66", solaris_mass_matrix(dynamics, none, 3, none, 9)),
            ("walker is NULL", solaris_walker_step(ptr::null_mut(), 0.1, ptr::null(), none, 0)),
            ("simulation is NULL", solaris_simulation_step(ptr::null_mut(), 0.1)),
        ];
        for (expected, status) in calls {
            assert_eq!(status, Status::BadArgument, "{expected}");
        }
        solaris_mass_matrix(dynamics, none, 66, none, 66 * 66);
        assert_eq!(said(), "q is NULL");
        assert!(solaris_figure_name(ptr::null()).is_null() && solaris_figure_link_name(figure, 21).is_null());
        assert_eq!((solaris_figure_nq(ptr::null()), solaris_figure_link_parent(figure, 99)), (0, -1));
        solaris_dynamics_free(dynamics);
        solaris_dynamics_free(ptr::null_mut());
        solaris_figure_free(figure);
    }
}

#[test]
fn an_output_may_not_overlap_an_input() {
    unsafe {
        let figure = human();
        let mut dynamics = ptr::null_mut();
        assert_eq!(solaris_dynamics_new(figure, ptr::null(), &raw mut dynamics), Status::Ok);
        let (q, v, mut a) = ([0.0; 66], [0.0; 66], [0.0; 66]);
        let shared = a.as_mut_ptr();
        let status = solaris_inverse_dynamics(dynamics, q.as_ptr(), 66, v.as_ptr(), shared, shared, 66);
        assert_eq!(
            (status, said().as_str()),
            (Status::BadArgument, "tau overlaps an argument; give it an array of its own")
        );
        solaris_dynamics_free(dynamics);
        solaris_figure_free(figure);
    }
}

#[test]
fn what_cannot_be_is_refused_and_the_walker_stays() {
    unsafe {
        let figure = human();
        let mut walker = ptr::null_mut();
        assert_eq!(solaris_walker_new(figure, &raw mut walker), Status::Ok);
        let mut q = [0.0; 66];
        let go = Command { go: GO_VELOCITY, z: 1.2, ..Command::default() };
        for _ in 0..60 {
            assert_eq!(
                solaris_walker_step(walker, 1.0 / 60.0, &raw const go, q.as_mut_ptr(), 66),
                Status::Ok
            );
        }
        let before = q;
        for (wrong, expected) in [
            (Command { go: 9, ..go }, "go is 9; it must be one of SOLARIS_GO_…"),
            (Command { face: 7, ..go }, "face is 7; it must be one of SOLARIS_FACE_…"),
        ] {
            assert_eq!(
                solaris_walker_step(walker, 0.01, &raw const wrong, q.as_mut_ptr(), 66),
                Status::BadArgument
            );
            assert_eq!(said(), expected);
        }
        let wrong = Command { z: f64::NAN, ..go };
        assert_eq!(solaris_walker_step(walker, 0.01, &raw const wrong, q.as_mut_ptr(), 66), Status::Refused);
        assert_eq!(q.map(f64::to_bits), before.map(f64::to_bits));
        let mut twin = ptr::null_mut();
        assert_eq!(solaris_walker_copy(walker, &raw mut twin), Status::Ok);
        let mut other = [0.0; 66];
        for (walker, q) in [(walker, &mut q), (twin, &mut other)] {
            assert_eq!(solaris_walker_step(walker, 0.02, &raw const go, q.as_mut_ptr(), 66), Status::Ok);
        }
        assert_eq!(q.map(f64::to_bits), other.map(f64::to_bits));
        solaris_walker_free(twin);
        solaris_walker_free(walker);
        solaris_figure_free(figure);
    }
}

#[test]
fn a_walker_reaches_is_pushed_and_tells_its_forces() {
    unsafe {
        let figure = human();
        let mut walker = ptr::null_mut();
        assert_eq!(solaris_walker_new(figure, &raw mut walker), Status::Ok);
        let (mut q, mut tau, mut feet) = ([0.0; 66], [0.0; 66], [Contact::default(); 2]);
        let stand = Command::default();
        let (palm, place) = ([0.0, -0.08, 0.0], [-0.3, 1.1, 0.35]);
        assert_eq!(
            solaris_walker_reach(walker, c"right_hand".as_ptr(), palm.as_ptr(), place.as_ptr()),
            Status::Ok
        );
        let eyes = [0.0, 0.1, 0.08];
        assert_eq!(solaris_walker_look(walker, c"head".as_ptr(), eyes.as_ptr(), place.as_ptr()), Status::Ok);
        assert_eq!(solaris_walker_set(walker, c"left_elbow.rx".as_ptr(), -1.2), Status::Ok);
        let force = [0.0, -20.0, 0.0];
        assert_eq!(
            solaris_walker_push(walker, c"thorax".as_ptr(), palm.as_ptr(), force.as_ptr()),
            Status::Ok
        );
        for _ in 0..120 {
            let step = solaris_walker_step(walker, 1.0 / 60.0, &raw const stand, q.as_mut_ptr(), 66);
            assert_eq!(step, Status::Ok);
        }
        let mut dynamics = ptr::null_mut();
        assert_eq!(solaris_dynamics_new(figure, ptr::null(), &raw mut dynamics), Status::Ok);
        assert_eq!(solaris_walker_forces(walker, feet.as_mut_ptr(), tau.as_mut_ptr(), 66), Status::Ok);
        // They bear the weight and what is pushed down.
        let borne = feet[0].force[1] + feet[1].force[1];
        let ann = solaris::model::Human::new(1.75, 73.0).build().expect("a person");
        assert!((borne - (ann.mass() * 9.80665 + 20.0)).abs() < 0.1, "{borne}");
        let refused = |call: Status, why: &str| {
            assert_eq!(call, Status::Refused);
            assert!(said().starts_with(why), "{}", said());
        };
        let paw = solaris_walker_reach(walker, c"right_paw".as_ptr(), palm.as_ptr(), place.as_ptr());
        refused(paw, "there is no link 'right_paw'");
        let knee = solaris_walker_set(walker, c"left_knee.rx".as_ptr(), 0.3);
        refused(knee, "there is no coordinate 'left_knee.rx'");
        let loose = solaris_walker_loosen(walker, c"left_knee".as_ptr(), true);
        refused(loose, "there is no joint 'left_knee'");
        for call in [
            solaris_walker_reach(walker, ptr::null(), palm.as_ptr(), place.as_ptr()),
            solaris_walker_push(walker, c"thorax".as_ptr(), ptr::null(), force.as_ptr()),
            solaris_walker_forces(walker, ptr::null_mut(), tau.as_mut_ptr(), 66),
            solaris_walker_forces(walker, feet.as_mut_ptr(), tau.as_mut_ptr(), 6),
        ] {
            assert_eq!(call, Status::BadArgument);
        }
        assert_eq!(solaris_walker_withdraw(walker, c"right_hand".as_ptr()), Status::Ok);
        assert_eq!(solaris_walker_hold(walker, c"left_elbow.rx".as_ptr()), Status::Ok);
        assert_eq!(solaris_walker_let_go(walker), Status::Ok);
        assert_eq!(solaris_walker_loosen(walker, c"left_elbow".as_ptr(), true), Status::Ok);
        assert_eq!(solaris_walker_step(walker, 1.0 / 60.0, &raw const stand, q.as_mut_ptr(), 66), Status::Ok);
        solaris_dynamics_free(dynamics);
        solaris_walker_free(walker);
        solaris_figure_free(figure);
    }
}

#[test]
fn poses_are_those_of_the_kernel() {
    unsafe {
        let figure = human();
        let mut dynamics = ptr::null_mut();
        assert_eq!(solaris_dynamics_new(figure, ptr::null(), &raw mut dynamics), Status::Ok);
        let mut q = [0.0; 66];
        assert_eq!(solaris_figure_neutral(figure, q.as_mut_ptr(), 66), Status::Ok);
        // The root's turns come after its slides: a quarter about y.
        (q[1], q[3]) = (0.9, std::f64::consts::FRAC_PI_2);
        let mut poses = [0.0; 21 * POSE_NUMBERS];
        assert_eq!(solaris_link_poses(dynamics, q.as_ptr(), 66, poses.as_mut_ptr(), poses.len()), Status::Ok);
        let half = std::f64::consts::FRAC_1_SQRT_2;
        let expected = [0.0, 0.9, 0.0, 0.0, half, 0.0, half];
        assert!(
            poses[..7].iter().zip(expected).all(|(found, x)| (found - x).abs() < 1e-12),
            "{:?}",
            &poses[..7]
        );
        solaris_dynamics_free(dynamics);
        solaris_figure_free(figure);
    }
}

#[test]
fn texts_and_files_that_are_none_say_why() {
    unsafe {
        let mut figure = ptr::null_mut();
        let status = solaris_figure_read(c"/nowhere/arm.urdf".as_ptr(), &raw mut figure);
        assert_eq!(
            (status, said().as_str()),
            (Status::Unreadable, "/nowhere/arm.urdf: there is no such file")
        );
        let bytes = b"Figure(\xff)\0";
        let status = solaris_figure_from_text(bytes.as_ptr().cast(), &raw mut figure);
        assert_eq!(status, Status::BadArgument);
        assert!(said().starts_with("source is no UTF-8"), "{}", said());
        assert_eq!(solaris_figure_human(9.0, 73.0, &raw mut figure), Status::Refused);
        assert!(figure.is_null());
    }
}
