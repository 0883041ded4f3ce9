//! Figures that are put on the ground.

use crate::body::Body;
use crate::failure::SetupError;
use crate::simulation::Simulation;

impl Simulation {
    /// Moves the figure along the ground's normal until its lowest point, of those that can touch the ground, is on it; how far (m).
    ///
    /// Of several figures that a root without mass carries, which stands still, each is moved; the answer is the way of the first.
    ///
    /// # Errors
    ///
    /// [`SetupError::NoWayDown`] where the root does not slide that way, or nothing can touch a ground.
    pub fn stand(&mut self) -> Result<f64, SetupError> {
        let mut first = None;
        for root in self.roots() {
            let way = self.stand_on(root)?;
            first = first.or(Some(way));
        }
        Ok(first.unwrap_or(0.0))
    }

    /// Of some links (indices) the one that begins deepest in the ground, and how deep (m); none where none begins in it.
    ///
    /// # Errors
    ///
    /// [`SetupError::Dynamics`] for a figure or a start that the kernel refuses.
    pub fn begins_in_ground(&self, links: &[usize]) -> Result<Option<(usize, f64)>, SetupError> {
        let Some(surface) = &self.surface else { return Ok(None) };
        let mut body = Body::<f64>::new(&self.figure, self.gravity, &[], &self.limits)?.on(Some(surface));
        let mut q = self.q.clone();
        let rates = || vec![0.0; self.v.len()];
        self.figure.follow(&mut q, &mut rates(), &mut rates());
        body.place(&q)?;
        let touches = surface.contact_points.iter().enumerate();
        let depths = touches.map(|(i, touch)| (touch.link, -body.gap(i)));
        Ok(depths
            .filter(|(link, depth)| *depth > 0.0 && links.contains(link))
            .max_by(|a, b| a.1.total_cmp(&b.1)))
    }

    /// The root; or the roots of several figures as one, those that move.
    fn roots(&self) -> Vec<usize> {
        let links = self.figure.links();
        let moves = |link: &usize| links[*link].joint().kind().nv() > 0;
        let carried: Vec<usize> =
            (0..links.len()).filter(|link| links[*link].parent() == Some(0)).filter(moves).collect();
        let is_world = links[0].joint().kind().nv() == 0 && links[0].mass() <= 0.0;
        if is_world && !carried.is_empty() { carried } else { vec![0] }
    }

    /// Moves what a link carries along the ground's normal until its lowest point is on it.
    fn stand_on(&mut self, root: usize) -> Result<f64, SetupError> {
        let none = || SetupError::NoWayDown { joint: self.figure.links()[root].joint().name().to_owned() };
        let surface = self.surface.as_ref().ok_or_else(none)?;
        let at = self.figure.layout().joints()[root];
        // Parents come before their children.
        let mut own = vec![false; self.figure.links().len()];
        own[root] = true;
        for (i, link) in self.figure.links().iter().enumerate() {
            own[i] |= link.parent().is_some_and(|parent| own[parent]);
        }
        let touches = &surface.contact_points;
        let own: Vec<usize> = (0..touches.len()).filter(|touch| own[touches[*touch].link]).collect();
        let mut body = Body::<f64>::new(&self.figure, self.gravity, &[], &self.limits)?.on(Some(surface));
        let mut lowest = |q: &[f64]| {
            body.place(q)?;
            let gaps = own.iter().map(|touch| body.gap(*touch));
            Ok::<_, SetupError>(gaps.min_by(f64::total_cmp))
        };
        let gap = lowest(&self.q)?.ok_or_else(none)?;
        // Slides are linear: how far each one lifts.
        let mut lifts = Vec::new();
        let slides = self.figure.links()[root].joint().kind().slides();
        for coordinate in slides.map(|i| at.q + i) {
            let mut moved = self.q.clone();
            moved[coordinate] += 1.0;
            lifts.push((coordinate, lowest(&moved)?.unwrap_or(gap) - gap));
        }
        let squares: f64 = lifts.iter().map(|(_, lift)| lift * lift).sum();
        if squares < 1e-12 {
            return Err(none());
        }
        for (coordinate, lift) in lifts {
            self.q[coordinate] -= gap * lift / squares;
        }
        Ok(-gap)
    }
}
