//! How long a person's segments are, as pairs of markers tell.

use super::places;
use solaris_dynamics::DynamicsError;
use solaris_model::{Figure, Marker, MarkerTrial, did_you_mean};

/// How much longer a person is than a figure, from pairs of markers: the mean over the pairs of
///
/// ```text
/// (mean over the frames of |p₂ − p₁|) / |m₂ − m₁|
/// ```
///
/// with `p` where a trial saw the markers and `m` where they are on the figure.
#[doc(alias = "MeasurementSet")]
#[derive(Clone, Debug, PartialEq)]
pub struct MeasuredFactor {
    /// The mean of the pairs' ratios.
    pub factor: f64,
    /// Each pair.
    pub pairs: Vec<PairRatio>,
}

/// The distance of two markers on a person and on a figure.
#[derive(Clone, Debug, PartialEq)]
pub struct PairRatio {
    /// The markers.
    pub names: [String; 2],
    /// Their mean distance in the trial (m).
    pub seen: f64,
    /// Their distance on the figure (m).
    pub model: f64,
    /// In how many frames both were seen.
    pub frames: usize,
}

/// Why pairs of markers tell no factor.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum MeasureError {
    /// No pair at all.
    #[error("there is no pair of markers; name at least one")]
    NoPairs,
    /// A marker that is not there.
    #[error("the {whose} has no marker '{name}'{hint}")]
    Unknown {
        /// Model or trial.
        whose: &'static str,
        /// The marker.
        name: String,
        /// Which name is near, if one is.
        hint: String,
    },
    /// Two markers that no frame shows together.
    #[error("no frame shows both '{}' and '{}'; choose another time or another pair", .names[0], .names[1])]
    NeverSeen {
        /// The markers.
        names: [String; 2],
    },
    /// Two markers in one place of the figure.
    #[error("'{}' and '{}' are in one place on the model, so their distance tells no size", .names[0], .names[1])]
    OnePlace {
        /// The markers.
        names: [String; 2],
    },
    /// The figure cannot be placed.
    #[error(transparent)]
    Figure(#[from] DynamicsError),
}

/// Measures a factor by `pairs` of markers: on the figure at `q` (length `nq`; OpenSim takes the default positions), in the
/// trial over all of its frames that show both.
///
/// # Errors
///
/// [`MeasureError`] for markers that figure or trial do not have, pairs that are never seen together or in one place, and a `q`
/// that is no configuration.
#[doc(alias = "ModelScaler")]
pub fn measured_factor(
    figure: &Figure,
    markers: &[Marker],
    q: &[f64],
    trial: &MarkerTrial,
    pairs: &[[String; 2]],
) -> Result<MeasuredFactor, MeasureError> {
    let places = places(figure, markers, q)?;
    let unknown = |whose, name: &String, hint| MeasureError::Unknown { whose, name: name.clone(), hint };
    let on_model = |name: &String| {
        let names = || markers.iter().map(|marker| marker.name.as_str());
        names()
            .position(|known| known == name)
            .ok_or_else(|| unknown("model", name, did_you_mean(name, names())))
    };
    let in_trial = |name: &String| {
        let names = || trial.names().iter().map(String::as_str);
        trial.marker(name).ok_or_else(|| unknown("trial", name, did_you_mean(name, names())))
    };
    let ratio = |names: &[String; 2]| {
        let [a, b] = names;
        let model = (places[on_model(a)?] - places[on_model(b)?]).norm();
        let (a, b) = (in_trial(a)?, in_trial(b)?);
        let seen = (0..trial.len()).filter_map(|frame| Some(trial.point(frame, a)? - trial.point(frame, b)?));
        let (sum, frames) = seen.fold((0.0, 0_usize), |(sum, n), way| (sum + way.norm(), n + 1));
        if frames == 0 {
            return Err(MeasureError::NeverSeen { names: names.clone() });
        }
        if model <= 0.0 {
            return Err(MeasureError::OnePlace { names: names.clone() });
        }
        Ok(PairRatio { names: names.clone(), seen: sum / frames as f64, model, frames })
    };
    let pairs = pairs.iter().map(ratio).collect::<Result<Vec<_>, _>>()?;
    if pairs.is_empty() {
        return Err(MeasureError::NoPairs);
    }
    let factor = pairs.iter().map(|pair| pair.seen / pair.model).sum::<f64>() / pairs.len() as f64;
    Ok(MeasuredFactor { factor, pairs })
}
