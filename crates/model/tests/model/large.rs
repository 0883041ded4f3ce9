//! Figures of ten thousand links, and of a hundred thousand: nothing recurses, and what is built takes time in proportion.

use solaris_model::{
    Base, Fault, Figure, FigureBuilder, FigureError, Inertia, Joint, LinkSpec, MassDoubt, RootAt, Scaling,
    Vector3,
};
use std::time::{Duration, Instant};

/// Links of every run, and of the long one.
const MANY: usize = 10_000;
const VERY_MANY: usize = 100_000;
/// Fifty times what a slow machine takes for what is linear; what is quadratic takes minutes.
const BOUND: Duration = Duration::from_mins(1);

/// So many links: `parent` names that of each but the first, and `change` is what is wrong with them.
fn build(
    count: usize,
    parent: impl Fn(usize) -> String,
    change: impl Fn(usize, LinkSpec) -> LinkSpec,
) -> Result<Figure, FigureError> {
    let links = (0..count).map(|i| {
        let joint = Joint::new(format!("joint{i}")).at(Vector3::new(0.0, -0.01, 0.0));
        let link = match i {
            0 => LinkSpec::root("link0", joint),
            _ => LinkSpec::child(format!("link{i}"), parent(i), joint.rx()),
        };
        change(i, link.mass(1.0).inertia(Inertia::diagonal(1e-5, 1e-5, 1e-5)))
    });
    links.fold(FigureBuilder::new("large"), FigureBuilder::link).build()
}

fn before(i: usize) -> String {
    format!("link{}", i - 1)
}

fn hub(_: usize) -> String {
    "link0".to_owned()
}

/// What `work` gives, if it takes no longer than it may.
fn in_time<T>(what: &str, work: impl FnOnce() -> T) -> T {
    let start = Instant::now();
    let result = work();
    let took = start.elapsed();
    assert!(took < BOUND, "{what} took {took:?}");
    result
}

fn faults(what: &str, result: impl FnOnce() -> Result<Figure, FigureError>) -> Vec<Fault> {
    in_time(what, result).expect_err("faults").faults
}

fn build_and_change(count: usize) {
    for (what, parent) in [("a chain", before as fn(usize) -> String), ("a star", hub)] {
        let figure = in_time(what, || build(count, parent, |_, link| link)).expect("valid");
        assert_eq!((figure.links().len(), figure.layout().nv()), (count, count - 1));
        in_time("linting", || figure.lint());
        in_time("measuring", || figure.extent(&Vector3::y()));
        let floating = in_time("a base", || figure.on_base(Base::Floating)).expect("welded");
        assert_eq!(floating.layout().nv(), count + 5);
        let scaling = Scaling { mass: Some(79.0), ..Scaling::default() };
        let light = in_time("scaling", || figure.scaled(&scaling)).expect("in range");
        assert_eq!(light.mass().to_bits(), 79.0_f64.to_bits());
        let dofs: Vec<usize> = (0..count - 1).collect();
        let q = vec![0.1; count - 1];
        let fused = in_time("fusing", || figure.fuse_at(&dofs, &q)).expect("dofs of the figure");
        assert_eq!(fused.figure().links().len(), 1);
        assert!(in_time("another root", || figure.reroot(1, RootAt::Joint)).is_ok());
    }
}

#[test]
fn long_chains_and_wide_stars_are_built_and_changed() {
    build_and_change(MANY);
}

#[test]
#[ignore = "a hundred thousand links, some seconds: cargo xtask nightly"]
fn very_long_chains_and_wide_stars_are_built_and_changed() {
    build_and_change(VERY_MANY);
}

/// The links of two arms, in turns.
fn name(i: usize) -> String {
    let side = if i % 2 == 1 { "left" } else { "right" };
    format!("{side}_{}", i.div_ceil(2))
}

fn find_pairs(count: usize) {
    // Two long arms, whose links stand nowhere as mirror images: the slowest way through.
    let parent = |i: usize| if i <= 2 { "link0".to_owned() } else { name(i - 2) };
    let links = (1..count).map(|i| {
        let joint = Joint::new(format!("joint{i}")).at(Vector3::new(0.01, -0.01, 0.02 * (i % 2) as f64)).rx();
        LinkSpec::child(name(i), parent(i), joint).mass(1.0)
    });
    let root = FigureBuilder::new("arms").link(LinkSpec::root("link0", Joint::new("root")));
    let figure = links.fold(root, FigureBuilder::link).build().expect("valid");
    let findings = in_time("comparing", || figure.lint());
    assert_eq!(findings.len(), count / 2);
}

#[test]
fn pairs_are_found_and_compared_in_any_number() {
    find_pairs(MANY);
}

#[test]
#[ignore = "a hundred thousand links, some seconds: cargo xtask nightly"]
fn very_many_pairs_are_found_and_compared() {
    find_pairs(VERY_MANY);
}

fn find_faults(count: usize) {
    for (what, parent) in [("a chain", before as fn(usize) -> String), ("a star", hub)] {
        let massless =
            build(count, parent, |_, link| link.mass(0.0).inertia(Inertia::Point)).expect("a tree");
        let links = |doubt: &MassDoubt| match doubt {
            MassDoubt::MovesNothing { links, .. } => links.len(),
            other => panic!("{other:?}"),
        };
        let doubts = in_time(what, || massless.mass_doubts());
        assert_eq!(doubts.iter().map(links).sum::<usize>(), count - 1);
        let wrong = |_: usize, link: LinkSpec| link.mass(-1.0).com(Vector3::new(f64::NAN, 0.0, 0.0));
        assert_eq!(faults(what, || build(count, parent, wrong)).len(), 2 * count);
    }
    let orphans = faults("unknown parents", || build(count, |i| format!("lnk{i}"), |_, link| link));
    assert_eq!(orphans.len(), count - 1);
    let hints = orphans.iter().filter(|fault| fault.to_string().contains("did you mean 'link")).count();
    // A million names are compared for hints, and no more.
    assert!((1..=1_000_000 / count).contains(&hints), "{hints} hints");
    // All in one circle but the root.
    let circle = |i: usize| format!("link{}", if i == 1 { count - 1 } else { i - 1 });
    let found = faults("a circle", || build(count, circle, |_, link| link));
    assert!(matches!(&found[..], [Fault::Cycle { links }] if links.len() == count - 1));
}

#[test]
fn every_fault_of_ten_thousand_is_found_in_time() {
    find_faults(MANY);
}

#[test]
#[ignore = "a hundred thousand links, some seconds: cargo xtask nightly"]
fn every_fault_of_a_hundred_thousand_is_found_in_time() {
    find_faults(VERY_MANY);
}
