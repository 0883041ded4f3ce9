//! The errors of scaling.

/// The error of scaling: why a figure cannot be scaled so.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum ScaleError {
    /// The height is no height.
    #[error("height {height} m: a standing height is a finite number above zero")]
    Height {
        /// What was asked (m).
        height: f64,
    },
    /// The figure does not say how tall it is.
    #[error(
        "figure '{figure}' does not say how tall it stands, so it cannot be scaled to a height; give it its stature, or scale \
         it by the lengths of its segments"
    )]
    NoStature {
        /// The figure.
        figure: String,
    },
    /// The mass is no mass.
    #[error("mass {mass} kg: the mass of a figure is a finite number above zero")]
    Mass {
        /// What was asked (kg).
        mass: f64,
    },
    /// There is no mass to scale.
    #[error("figure '{figure}' has no mass that could be scaled; give its links mass")]
    Massless {
        /// The figure.
        figure: String,
    },
    /// No link has this name.
    #[error(
        "segment '{name}' is no link of this figure{}",
        .nearest.as_ref().map_or_else(String::new, |name| format!("; did you mean '{name}'?"))
    )]
    UnknownSegment {
        /// What was asked.
        name: String,
        /// The nearest name, if any is near.
        nearest: Option<String>,
    },
    /// The length is no length.
    #[error("length of segment '{name}' {length} m: it must be a finite number above zero")]
    SegmentLength {
        /// The link.
        name: String,
        /// What was asked (m).
        length: f64,
    },
    /// The link has nothing to measure its length to.
    #[error(
        "segment '{name}' has no length to scale: it carries no joint away from its own, and has no tip; give it a tip"
    )]
    NoLength {
        /// The link.
        name: String,
    },
    /// A change that is a mistake of units at best.
    #[error(
        "{what}: from {from} to {to} is a factor of {factor:.2e}; it must lie between {:e} and {:e}: check the units",
        super::RANGE.0, super::RANGE.1
    )]
    Factor {
        /// What is scaled.
        what: String,
        /// Its value (m or kg).
        from: f64,
        /// What was asked (m or kg).
        to: f64,
        /// Their ratio.
        factor: f64,
    },
    /// Not three factors for each link.
    #[error("there are factors for {factors} links, and the figure has {links}; give each link its own")]
    FactorCount {
        /// How many links there are.
        links: usize,
        /// For how many there are factors.
        factors: usize,
    },
    /// A factor that is none.
    #[error(
        "link '{name}': its factor along {axis} is {factor}; it must lie between {:e} and {:e}",
        super::RANGE.0, super::RANGE.1
    )]
    AxisFactor {
        /// The link.
        name: String,
        /// The axis.
        axis: char,
        /// What was asked.
        factor: f64,
    },
    /// Two bodies of one link.
    #[error(
        "bodies '{}' and '{}' cannot move against each other, both are parts of link '{link}', and they have different factors; \
         give them the same",
        .names[0], .names[1]
    )]
    Disagree {
        /// The link.
        link: String,
        /// The bodies.
        names: [String; 2],
    },
    /// A body whose axes are not those of its link.
    #[error(
        "body '{name}' is turned against the link '{link}' that it is part of, so it takes only one factor for all its axes"
    )]
    Turned {
        /// The body.
        name: String,
        /// The link.
        link: String,
    },
    /// A marker that is nowhere.
    #[error("marker '{marker}' is on link {link}, for which there are no factors")]
    MarkerLink {
        /// The marker.
        marker: String,
        /// The number of its link.
        link: usize,
    },
    /// Numbers that were finite are not after scaling.
    #[error("link '{link}': its numbers are too large to be scaled so; check their units")]
    NotFinite {
        /// The link.
        link: String,
    },
}
