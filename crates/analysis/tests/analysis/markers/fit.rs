//! A person's lengths, from markers on a figure whose lengths are known.

use super::{changed, markers, noise, seen, swaying};
use solaris_analysis::markers::{FitError, FitOptions, IkOptions, SubjectFit, fit_subject};
use solaris_model::{Figure, Marker, MarkerTrial, MassShares, Stretching, Vector3, human};

/// A person with long legs and short arms whose markers are not quite where the model has them.
fn person(figure: &Figure, markers: &[Marker]) -> (Figure, Vec<Marker>) {
    let factor = |name: &str| match name {
        "left_thigh" | "right_thigh" => 1.12,
        "left_shank" | "right_shank" => 1.06,
        "left_forearm" | "right_forearm" => 0.93,
        _ => 1.02,
    };
    let factors = figure.links().iter().map(|link| Vector3::repeat(factor(link.name()))).collect();
    let stretching = Stretching { factors, mass: None, shares: MassShares::Kept };
    let mut worn = stretching.markers(markers).expect("links of the figure");
    for (i, marker) in worn.iter_mut().enumerate() {
        marker.position += noise(i, 7) * 0.5;
    }
    (figure.stretched(&stretching).expect("factors"), worn)
}

fn trials(figure: &Figure, markers: &[Marker]) -> Vec<MarkerTrial> {
    let (tall, worn) = person(figure, markers);
    let standing = seen(&tall, &worn, &swaying(figure, 2, 0.0)[..1]);
    let moving = seen(&tall, &worn, &swaying(figure, 120, 1.0));
    vec![standing, changed(&moving, |frame, marker, point| point + noise(frame, marker) * 0.3)]
}

fn fit(figure: &Figure, markers: &[Marker], trials: &[MarkerTrial]) -> SubjectFit {
    let options = FitOptions { frames: 20, ..FitOptions::default() };
    fit_subject(figure, markers, trials, &IkOptions::default(), &options).expect("a person")
}

#[test]
fn lengths_are_found_within_their_errors() {
    let figure = human(1.75, 73.0).expect("a person");
    let markers = markers(&figure, 4);
    let found = fit(&figure, &markers, &trials(&figure, &markers));
    assert!(found.rms < 0.006 && found.rms < 0.2 * found.rms_before, "{} {}", found.rms, found.rms_before);
    let (tall, _) = person(&figure, &markers);
    for name in ["left_thigh", "right_shank", "right_forearm", "left_upper_arm"] {
        let length = found.lengths.iter().find(|segment| segment.link == name).expect("a segment");
        let true_length = tall.segment_length(name).expect("a length");
        let off = (length.length - true_length).abs();
        assert!(
            off < 0.01 && off < 3.0 * length.error,
            "{name}: {} for {true_length} ± {}",
            length.length,
            length.error
        );
        assert!((0.0005..0.02).contains(&length.error), "{name} ± {}", length.error);
    }
    // The figure that comes out is the one that the factors make.
    let stretched = Stretching { factors: found.factors.clone(), mass: None, shares: MassShares::Kept };
    let made = figure.stretched(&stretched).expect("factors");
    let thigh = found.lengths.iter().find(|segment| segment.link == "left_thigh").expect("a segment");
    assert!((made.segment_length("left_thigh").expect("a length") - thigh.length).abs() < 1e-12);
}

/// Labels that are exchanged for a while do not count.
#[test]
fn exchanged_labels_do_not_spoil_lengths() {
    let figure = human(1.75, 73.0).expect("a person");
    let markers = markers(&figure, 4);
    let mut trials = trials(&figure, &markers);
    let right = fit(&figure, &markers, &trials);
    trials[1].exchange([20, 45], 30..=80);
    let found = fit(&figure, &markers, &trials);
    assert!((found.rms - right.rms).abs() < 1e-9, "{} for {}", found.rms, right.rms);
}

#[test]
fn what_fits_already_stays() {
    let figure = human(1.75, 73.0).expect("a person");
    let markers = markers(&figure, 4);
    let trial = seen(&figure, &markers, &swaying(&figure, 30, 2.0));
    let found = fit(&figure, &markers, &[trial]);
    assert!(found.factors.iter().all(|factor| factor.add_scalar(-1.0).amax() < 1e-4));
    assert!(found.moved.iter().all(|(_, by)| (0.0..1e-4).contains(by)) && found.rms < 1e-4);
    assert!(found.moved.iter().map(|(name, _)| name).eq(markers.iter().map(|marker| &marker.name)));
}

#[test]
fn options_that_are_none_are_refused() {
    let figure = human(1.75, 73.0).expect("a person");
    let markers = markers(&figure, 2);
    let trial = seen(&figure, &markers, &swaying(&figure, 1, 0.0));
    let options = FitOptions { placing: 0.0, ..FitOptions::default() };
    let error = fit_subject(&figure, &markers, &[trial], &IkOptions::default(), &options);
    assert!(matches!(error, Err(FitError::Option { name: "placing", .. })));
    let none = fit_subject(&figure, &markers, &[], &IkOptions::default(), &FitOptions::default());
    assert!(matches!(none, Err(FitError::NoTrials)));
}
