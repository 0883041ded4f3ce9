//! A motion as a table: its headings, and the numbers below them.

use crate::table::{CONTACT, TAU, TIME, heading};
use solaris_model::{Contact, Figure, Motion};

/// The headings of a motion's table: `time`, all `.q`, all `.v`, all `.a`, all `.tau` where they are known, and nine for each contact.
pub fn headings(figure: &Figure, motion: &Motion) -> Vec<String> {
    let (q, v) = (figure.layout().q_names(), figure.layout().v_names());
    let tau = if motion.is_empty() || motion.tau(0).is_none() { &[] } else { v };
    let dofs = [(q, "q"), (v, "v"), (v, "a"), (tau, TAU)];
    let dofs =
        dofs.into_iter().flat_map(|(names, ending)| names.iter().map(move |name| heading(name, ending)));
    let contacts =
        motion.contacts.iter().flat_map(|track| CONTACT.map(|ending| heading(&track.link, ending)));
    std::iter::once(TIME.to_owned()).chain(dofs).chain(contacts).collect()
}

/// The numbers of one sample, in the order of the [`headings`].
pub fn row(motion: &Motion, sample: usize) -> impl Iterator<Item = f64> {
    let dofs = [motion.q(sample), motion.v(sample), motion.a(sample), motion.tau(sample).unwrap_or_default()];
    let contacts = motion.contacts.iter().flat_map(move |track| {
        let Contact { force: f, moment: m, cop: p } = track.samples[sample];
        [f.x, f.y, f.z, m.x, m.y, m.z, p.x, p.y, p.z]
    });
    std::iter::once(motion.time()[sample]).chain(dofs.into_iter().flatten().copied()).chain(contacts)
}
