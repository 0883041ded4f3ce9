//! What is done with a figure.

use crate::{refused, said};
use solaris_dynamics::denavit_hartenberg::Summary;
use solaris_dynamics::{Tree, Workspace, inverse_dynamics};
use solaris_io::Import;
use solaris_model::{Chains, Figure, TextError, Vector3, text};

/// The most links of a figure whose chains are listed, each of which may be as long as there are links.
const MOST_LISTED: usize = 50;

/// Does with the result of a reader what `solaris check` does.
pub fn import(source: &str, read: Result<Import, TextError>) {
    match read {
        Ok(Import { figure: found, findings, gravity, .. }) => {
            findings.iter().for_each(|finding| said(source, &finding.message));
            assert!(gravity.iter().all(|x| x.is_finite()), "gravity is {gravity}");
            figure(source, &found.with_gravity(gravity).expect("finite numbers"));
        }
        Err(error) => refused(&error),
    }
}

/// Looks at a figure as `solaris check` does, writes and reads it, and asks which forces hold it.
pub fn figure(source: &str, figure: &Figure) {
    let gravity = figure.gravity().copied().unwrap_or_else(|| Vector3::new(0.0, -9.806_65, 0.0));
    figure.lint().iter().for_each(|finding| said(source, &finding.message));
    let height = figure.extent(&-gravity).height;
    assert!(!height.is_nan() && !figure.mass().is_nan(), "{height} m, {} kg", figure.mass());
    if figure.links().len() <= MOST_LISTED {
        said(source, &Chains::of(figure).to_string());
        if let Ok(summary) = Summary::of(figure) {
            said(source, &summary.to_string());
        }
    }
    let written = text::write(figure);
    match text::read(&written) {
        Ok(again) => assert_eq!(again.fingerprint(), figure.fingerprint(), "written and read:\n{written}"),
        Err(error) => panic!("what was written is not read: {error}\n{written}"),
    }
    held(figure, gravity);
}

/// The forces that hold a figure at its zero pose: numbers, or a refusal.
fn held(figure: &Figure, gravity: Vector3<f64>) {
    let Ok(tree) = Tree::<f64>::new(figure, gravity) else { return };
    let (mut q, mut v) = (vec![0.0; tree.nq()], vec![0.0; tree.nv()]);
    let (mut a, mut tau) = (v.clone(), v.clone());
    figure.neutral(&mut q).expect("the figure's own length");
    figure.follow(&mut q, &mut v, &mut a);
    if inverse_dynamics(&tree, &mut Workspace::new(&tree), &q, &v, &a, &[], &mut tau).is_ok() {
        figure.fold_forces(&q, &mut tau);
        assert!(!tau.iter().any(|x| x.is_nan()), "forces {tau:?} at {q:?}");
    }
}
