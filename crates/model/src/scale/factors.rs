//! Factors by the names of bodies.

use super::ScaleError;
use super::contents::alike;
use crate::figure::Figure;
use nalgebra::Vector3;

impl Figure {
    /// The factors of every link, along its x, y and z, from those of bodies by name: see [`crate::Stretching`].
    ///
    /// A body is a link or a frame that a link carries ([`locate`](Self::locate)). Links that are not named have factors of
    /// one; a massless link that carries nothing but one joint stands between two joints of one child, and has the child's.
    /// Names that are no body's are passed over where their factors are one (`ground`, and what else a `ScaleSet` lists).
    ///
    /// # Errors
    ///
    /// [`ScaleError`] for names that are no body's, and for bodies of one link that are scaled differently: bodies that
    /// cannot move against each other, and such as are turned against the link that carries them.
    #[doc(alias = "ScaleSet")]
    pub fn stretch_factors(
        &self,
        bodies: &[(String, Vector3<f64>)],
    ) -> Result<Vec<Vector3<f64>>, ScaleError> {
        let one = Vector3::repeat(1.0);
        let mut named: Vec<Option<(&str, Vector3<f64>)>> = vec![None; self.links.len()];
        for (name, s) in bodies {
            let Some((link, placement)) = self.locate(name) else {
                if *s == one {
                    continue;
                }
                let frames = self.links.iter().flat_map(|link| &link.frames).map(|frame| frame.name.as_str());
                let known = self.links.iter().map(|link| link.name.as_str()).chain(frames);
                let nearest = crate::nearest(name, known);
                return Err(ScaleError::UnknownSegment { name: name.clone(), nearest });
            };
            let carrier = &self.links[link].name;
            if alike(s).is_none() && placement.rotation.angle() > 1e-9 {
                return Err(ScaleError::Turned { name: name.clone(), link: carrier.clone() });
            }
            match named[link] {
                Some((other, factors)) if factors != *s && other != name => {
                    let (link, names) = (carrier.clone(), [other.to_owned(), name.clone()]);
                    return Err(ScaleError::Disagree { link, names });
                }
                _ => named[link] = Some((name, *s)),
            }
        }
        let mut factors: Vec<Vector3<f64>> =
            named.iter().map(|named| named.map_or(one, |(_, s)| s)).collect();
        // Children come after their parents, so from the last link on each child has its own by then.
        for link in (0..factors.len()).rev().filter(|&link| named[link].is_none()) {
            if let Some(child) = self.only_child(link) {
                factors[link] = factors[child];
            }
        }
        Ok(factors)
    }

    /// The child of a link that has nothing else.
    fn only_child(&self, link: usize) -> Option<usize> {
        let at = &self.links[link];
        let is_bare = at.mass <= 0.0
            && at.parent.is_some()
            && at.shape.is_none()
            && at.tip.is_none()
            && at.sole.is_empty()
            && at.frames.is_empty();
        let mut children =
            (link + 1..self.links.len()).filter(|&child| self.links[child].parent == Some(link));
        let child = children.next().filter(|_| is_bare)?;
        children.next().is_none().then_some(child)
    }
}
