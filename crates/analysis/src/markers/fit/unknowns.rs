//! What a fit looks for: the logarithms of factors, and how far markers are off.

use super::{FitError, FitOptions, SegmentFit};
use nalgebra::{Cholesky, DMatrix, DVector, Vector3};
use solaris_model::{Figure, Marker, MassShares, Stretching};

/// Degrees of freedom of how markers' places are spread: few, since some are put on soft parts wherever there is room.
const FREEDOM: f64 = 2.0;

/// The unknowns of a fit: three logarithms a group of links, then three lengths a marker (m, in its stretched link's frame).
pub(super) struct Unknowns {
    /// The group of each link.
    pub(super) groups: Vec<usize>,
    count: usize,
    markers: usize,
    /// The prior's matrix `C⁻¹` of the logarithms, and `1/σ_d²` of each marker.
    scale_prior: DMatrix<f64>,
    marker_prior: Vec<f64>,
}

impl Unknowns {
    pub(super) fn of(figure: &Figure, markers: &[Marker], options: &FitOptions) -> Self {
        let (groups, count) = groups(figure);
        let n = 3 * count;
        let covariance = DMatrix::from_fn(n, n, |i, j| {
            let together = options.size.powi(2);
            let segment = if i / 3 == j / 3 { options.segment.powi(2) } else { 0.0 };
            let axis = if i == j { options.axis.powi(2) } else { 0.0 };
            together + segment + axis
        });
        let scale_prior =
            Cholesky::new(covariance).map_or_else(|| DMatrix::identity(n, n), |factors| factors.inverse());
        let spread = |marker: &Marker| if marker.is_fixed { options.placing / 4.0 } else { options.placing };
        let marker_prior = markers.iter().map(|marker| spread(marker).powi(-2)).collect();
        Self { groups, count, markers: markers.len(), scale_prior, marker_prior }
    }

    pub(super) fn len(&self) -> usize {
        3 * (self.count + self.markers)
    }

    /// The first unknown of a link's factors.
    pub(super) fn scale(&self, link: usize) -> usize {
        3 * self.groups[link]
    }

    /// The first unknown of a marker.
    pub(super) fn marker(&self, marker: usize) -> usize {
        3 * (self.count + marker)
    }

    /// Nothing is known: factors of one, markers where they are.
    pub(super) fn start(&self) -> DVector<f64> {
        DVector::zeros(self.len())
    }

    pub(super) fn factors(&self, state: &DVector<f64>) -> Vec<Vector3<f64>> {
        let of = |group: &usize| Vector3::from_fn(|k, _| state[3 * group + k].exp());
        self.groups.iter().map(of).collect()
    }

    /// The figure and its markers, as the unknowns have them.
    pub(super) fn apply(
        &self,
        figure: &Figure,
        markers: &[Marker],
        state: &DVector<f64>,
    ) -> Result<(Figure, Vec<Marker>), FitError> {
        let stretching = Stretching { factors: self.factors(state), mass: None, shares: MassShares::Kept };
        let mut placed = stretching.markers(markers)?;
        for (i, marker) in placed.iter_mut().enumerate() {
            marker.position += self.offset(state, i);
        }
        Ok((figure.stretched(&stretching)?, placed))
    }

    /// Adds what is known beforehand: the cost, its gradient and its matrix.
    pub(super) fn add_prior(
        &self,
        state: &DVector<f64>,
        matrix: &mut DMatrix<f64>,
        gradient: &mut DVector<f64>,
    ) -> f64 {
        let n = 3 * self.count;
        let logarithms = state.rows(0, n);
        let pull = &self.scale_prior * logarithms;
        let mut cost = 0.5 * logarithms.dot(&pull);
        let mut rows = gradient.rows_mut(0, n);
        rows += &pull;
        let mut block = matrix.view_mut((0, 0), (n, n));
        block += &self.scale_prior;
        for (i, prior) in self.marker_prior.iter().enumerate() {
            // Student's t: one that is worn elsewhere does not pull the others along.
            let far = prior * self.offset(state, i).norm_squared();
            let weight = prior * (FREEDOM + 3.0) / (FREEDOM + far);
            cost += 0.5 * (FREEDOM + 3.0) * (far / FREEDOM).ln_1p();
            for at in self.marker(i)..self.marker(i) + 3 {
                matrix[(at, at)] += weight;
                gradient[at] += weight * state[at];
            }
        }
        cost
    }

    /// How far a marker is off where its stretched link would have it (m, the link's frame).
    pub(super) fn offset(&self, state: &DVector<f64>, marker: usize) -> Vector3<f64> {
        let at = self.marker(marker);
        Vector3::from_fn(|k, _| state[at + k])
    }

    /// How far each marker was moved (m).
    pub(super) fn moved(&self, markers: &[Marker], state: &DVector<f64>) -> Vec<(String, f64)> {
        markers
            .iter()
            .enumerate()
            .map(|(i, marker)| (marker.name.clone(), self.offset(state, i).norm()))
            .collect()
    }

    /// The lengths of segments with their errors, of links that have one.
    ///
    /// ```text
    /// l = |s∘r|      σ_l² = gᵀ·Σ·g,  g_k = (s_k·r_k)² / l
    /// ```
    pub(super) fn lengths(
        &self,
        figure: &Figure,
        state: &DVector<f64>,
        covariance: &DMatrix<f64>,
    ) -> Vec<SegmentFit> {
        let factors = self.factors(state);
        let of = |(link, it): (usize, &solaris_model::Link)| {
            let children = figure.links().iter().filter(|child| child.parent() == Some(link));
            let reach = children.map(|child| child.joint().placement().translation.vector);
            let reach =
                reach.max_by(|a, b| a.norm().total_cmp(&b.norm())).filter(|reach| reach.norm() > 0.0)?;
            let way = factors[link].component_mul(&reach);
            let (length, at) = (way.norm(), self.scale(link));
            let slope = way.component_mul(&way) / length;
            let block = covariance.fixed_view::<3, 3>(at, at);
            let error = (slope.transpose() * block * slope)[0].max(0.0).sqrt();
            Some(SegmentFit { link: it.name().to_owned(), before: reach.norm(), length, error })
        };
        figure.links().iter().enumerate().filter_map(of).collect()
    }
}

/// The links that are scaled alike: a left and a right one, and a massless one with the only child that it carries.
fn groups(figure: &Figure) -> (Vec<usize>, usize) {
    let links = figure.links();
    let mut first: Vec<usize> = (0..links.len()).collect();
    for [left, right] in figure.mates() {
        first[right.max(left)] = right.min(left);
    }
    for link in (0..links.len()).rev() {
        let mut children = (0..links.len()).filter(|child| links[*child].parent() == Some(link));
        if let (Some(child), None) = (children.next(), children.next())
            && links[link].mass() <= 0.0
        {
            // Its group is its child's, which comes later: the two change places.
            let (link, child) = (root(&first, link), root(&first, child));
            first[link.max(child)] = link.min(child);
        }
    }
    let mut numbers = vec![None; links.len()];
    let mut count = 0;
    let groups = (0..links.len()).map(|link| {
        let of = root(&first, link);
        *numbers[of].get_or_insert_with(|| {
            count += 1;
            count - 1
        })
    });
    let groups = groups.collect();
    (groups, count)
}

fn root(first: &[usize], mut link: usize) -> usize {
    while first[link] != link {
        link = first[link];
    }
    link
}

#[cfg(test)]
mod tests {
    use super::*;
    use approx::assert_relative_eq;
    use solaris_model::{FigureBuilder, Joint, LinkSpec};

    /// Two links and two markers, the second of which is fixed: `1/σ_d²` of 2500 and of 40 000.
    fn unknowns() -> Unknowns {
        let figure = FigureBuilder::new("arm")
            .link(LinkSpec::root("upper", Joint::new("shoulder").rx()).mass(2.0))
            .link(LinkSpec::child("lower", "upper", Joint::new("elbow").rx()).mass(1.0))
            .build()
            .expect("valid");
        let marker = |name: &str, link, is_fixed| Marker {
            name: name.to_owned(),
            link,
            position: Vector3::zeros(),
            is_fixed,
        };
        let markers = [marker("soft", 0, false), marker("bone", 1, true)];
        Unknowns::of(&figure, &markers, &FitOptions { placing: 0.02, ..FitOptions::default() })
    }

    fn prior(unknowns: &Unknowns, state: &DVector<f64>) -> (f64, DVector<f64>, DMatrix<f64>) {
        let n = unknowns.len();
        let (mut matrix, mut gradient) = (DMatrix::zeros(n, n), DVector::zeros(n));
        let cost = unknowns.add_prior(state, &mut matrix, &mut gradient);
        (cost, gradient, matrix)
    }

    /// `5/2·ln(1 + d²/(2·σ²))`, whose slope is `5·d/(2·σ² + d²)`.
    #[test]
    fn a_marker_that_is_off_is_pulled_back_less_the_farther_it_is() {
        let unknowns = unknowns();
        for (marker, sigma) in [(0, 0.02_f64), (1, 0.005)] {
            let at = unknowns.marker(marker);
            for times in [0.0, 0.5, 1.0, 2.0_f64.sqrt(), 10.0] {
                let mut state = unknowns.start();
                state[at + 1] = times * sigma;
                let (cost, gradient, matrix) = prior(&unknowns, &state);
                let weight = 5.0 / (2.0 + times * times) / (sigma * sigma);
                assert_relative_eq!(cost, 2.5 * (1.0 + times * times / 2.0).ln(), max_relative = 1e-12);
                assert_relative_eq!(gradient[at + 1], weight * times * sigma, max_relative = 1e-12);
                for k in 0..3 {
                    assert_relative_eq!(matrix[(at + k, at + k)], weight, max_relative = 1e-12);
                }
            }
        }
    }

    #[test]
    fn the_slope_of_what_is_known_beforehand_is_that_of_its_cost() {
        let unknowns = unknowns();
        let lengths = unknowns.marker(0);
        let state = DVector::from_fn(unknowns.len(), |i, _| {
            let size = if i < lengths { 0.1 } else { 0.01 };
            size * (1.0 + i as f64).sin()
        });
        let (_, gradient, _) = prior(&unknowns, &state);
        for i in 0..unknowns.len() {
            let moved = |by: f64| {
                let mut moved = state.clone();
                moved[i] += by;
                prior(&unknowns, &moved).0
            };
            let slope = (moved(1e-6) - moved(-1e-6)) / 2e-6;
            assert_relative_eq!(gradient[i], slope, epsilon = 1e-5, max_relative = 1e-5);
        }
    }
}
