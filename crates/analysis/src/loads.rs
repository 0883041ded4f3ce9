//! Loads: what acts on a figure from outside, at the times of its motion.

use crate::carrier::Carrier;
use nalgebra::Vector3;
use solaris_dynamics::{Workspace, Wrench};
use solaris_model::{Contact, ContactTrack, Figure, MeasuredForce};

/// How far (s) two times may be apart and still be the same.
const SAME_TIME: f64 = 1e-9;

/// What acts on a figure from outside, at the times of its motion.
#[doc(alias = "external loads")]
#[doc(alias = "external forces")]
#[doc(alias = "wrench")]
#[derive(Clone, Debug, Default)]
pub struct Loads {
    tracks: Vec<Track>,
}

#[derive(Clone, Debug)]
struct Track {
    carrier: Carrier,
    samples: Vec<Contact>,
}

/// Why measured forces do not fit a motion.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum LoadError {
    /// A force acts on nothing.
    #[error("figure '{figure}' has no link '{link}' for a force to act on{}", near(.nearest.as_deref()))]
    UnknownLink {
        /// The figure.
        figure: String,
        /// What was asked.
        link: String,
        /// The link whose name is nearest.
        nearest: Option<String>,
    },
    /// Not one link or two.
    #[error("a force acts on {links} links; name one, or two: the foot and its toes")]
    Links {
        /// How many were named.
        links: usize,
    },
    /// The second of two links does not say where it begins.
    #[error(
        "link '{toes}' has no ball and toe tip in its sole, so it is not known from where on it carries the force on \
         '{foot}'; name one link"
    )]
    NoBall {
        /// The first link.
        foot: String,
        /// The second.
        toes: String,
    },
    /// Points that do not say where the second link begins.
    #[error(
        "the ball {ball:?} and the tip {tip:?} (m) of link '{toes}' do not say from where on it carries the force; give two \
         points that are finite and apart"
    )]
    Points {
        /// The second link.
        toes: String,
        /// Where it begins (m).
        ball: [f64; 3],
        /// Its foremost point (m).
        tip: [f64; 3],
    },
    /// The numbers are no record.
    #[error(
        "the force on '{link}' has {samples} samples at {times} times; it must have one a time, at least one"
    )]
    Length {
        /// The link.
        link: String,
        /// Samples.
        samples: usize,
        /// Times.
        times: usize,
    },
    /// A time that does not rise, or a number that is not finite.
    #[error("the force on '{link}': sample {sample} at {time} s {problem}")]
    Sample {
        /// The link.
        link: String,
        /// Its index.
        sample: usize,
        /// When (s).
        time: f64,
        /// What is wrong.
        problem: &'static str,
    },
    /// The motion goes on where the forces do not.
    #[error(
        "the motion lasts from {} s to {} s, the force on '{link}' is known from {} s to {} s; cut the motion, or give the \
         forces for all of it", .motion.0, .motion.1, .force.0, .force.1
    )]
    Range {
        /// The link.
        link: String,
        /// First and last time of the motion (s).
        motion: (f64, f64),
        /// First and last time of the force (s).
        force: (f64, f64),
    },
}

fn near(nearest: Option<&str>) -> String {
    nearest.map_or_else(String::new, |name| format!(" (is '{name}' meant?)"))
}

impl Loads {
    /// Nothing acts.
    pub fn none() -> Self {
        Self::default()
    }

    /// These and others.
    #[must_use]
    pub fn and(mut self, others: Self) -> Self {
        self.tracks.extend(others.tracks);
        self
    }

    /// `samples` on what carries them, one a time.
    pub(crate) fn of(tracks: impl IntoIterator<Item = (Carrier, Vec<Contact>)>) -> Self {
        Self { tracks: tracks.into_iter().map(|(carrier, samples)| Track { carrier, samples }).collect() }
    }

    /// The forces at each time as contacts of `figure`'s links; of two links, the first one's.
    pub fn contacts(&self, figure: &Figure) -> Vec<ContactTrack> {
        let track = |track: &Track| {
            let link = figure.links()[track.carrier.first()].name().to_owned();
            ContactTrack { link, samples: track.samples.clone() }
        };
        self.tracks.iter().map(track).collect()
    }

    /// At how many times they are known; `None` where nothing acts.
    pub(crate) fn samples(&self) -> Option<usize> {
        self.tracks.iter().map(|track| track.samples.len()).min()
    }

    /// What `records` say at the times (s) of a motion.
    ///
    /// Where a time of a record agrees to 1e-9 s its sample is used as it is; between samples force and moment (about the
    /// world's origin) run straight, and the centre of pressure is weighted by the force. Beyond a record, for less than
    /// one of its mean steps, the end's sample stays. Nothing is filtered and nothing is cut off: a force of a few
    /// newtons has a centre of pressure that means little, and its wrench is right all the same.
    ///
    /// # Errors
    ///
    /// Links that the figure does not have, a second link of which ball and tip are not known, records that are none, and a motion
    /// that goes on where a record does not.
    pub fn at_times(figure: &Figure, records: &[MeasuredForce], time: &[f64]) -> Result<Self, LoadError> {
        let tracks = records.iter().map(|record| {
            let carrier = carrier(figure, record)?;
            check(record)?;
            Ok(Track { carrier, samples: sampled(record, time)? })
        });
        Ok(Self { tracks: tracks.collect::<Result<_, _>>()? })
    }

    /// Whether a link depends on where the figure is.
    pub(crate) fn move_over_links(&self) -> bool {
        self.tracks.iter().any(|track| track.carrier.moves())
    }

    /// What acts at a time of the motion, by link, with the links placed by `workspace`.
    pub(crate) fn wrenches(
        &self,
        workspace: &Workspace<f64>,
        sample: usize,
        out: &mut Vec<(usize, Wrench<f64>)>,
    ) {
        out.clear();
        out.extend(self.tracks.iter().map(|track| {
            let Contact { force, moment, cop } = track.samples[sample];
            (track.carrier.link(workspace, &cop), Wrench { force, moment })
        }));
    }
}

fn carrier(figure: &Figure, record: &MeasuredForce) -> Result<Carrier, LoadError> {
    let find = |name: &String| {
        figure.link_index(name).ok_or_else(|| LoadError::UnknownLink {
            figure: figure.name().to_owned(),
            link: name.clone(),
            nearest: solaris_model::nearest(name, figure.links().iter().map(solaris_model::Link::name)),
        })
    };
    match (&record.links[..], record.ball_and_tip) {
        ([link], _) => Ok(Carrier::of_one(find(link)?)),
        ([foot, toes], None) => Carrier::of_two(figure, find(foot)?, find(toes)?)
            .ok_or_else(|| LoadError::NoBall { foot: foot.clone(), toes: toes.clone() }),
        ([foot, toes], Some(points)) => {
            let apart = points[1] - points[0];
            if !(apart.norm_squared().is_finite() && apart.norm_squared() > 0.0) {
                let [ball, tip] = points.map(Into::into);
                return Err(LoadError::Points { toes: toes.clone(), ball, tip });
            }
            Ok(Carrier::of_points(find(foot)?, find(toes)?, points))
        }
        (links, _) => Err(LoadError::Links { links: links.len() }),
    }
}

fn check(record: &MeasuredForce) -> Result<(), LoadError> {
    let (link, samples, times) = (record.links[0].clone(), record.samples.len(), record.time.len());
    if samples != times || times == 0 {
        return Err(LoadError::Length { link, samples, times });
    }
    for (sample, (&time, contact)) in record.time.iter().zip(&record.samples).enumerate() {
        let problem = if !(time.is_finite() && (sample == 0 || time > record.time[sample - 1])) {
            "does not come after the one before it"
        } else if !numbers(contact).all(f64::is_finite) {
            "holds a number that is not finite"
        } else {
            continue;
        };
        return Err(LoadError::Sample { link, sample, time, problem });
    }
    Ok(())
}

fn numbers(contact: &Contact) -> impl Iterator<Item = f64> {
    [contact.force, contact.moment, contact.cop].into_iter().flat_map(|v| [v.x, v.y, v.z])
}

/// The record at the motion's times.
fn sampled(record: &MeasuredForce, time: &[f64]) -> Result<Vec<Contact>, LoadError> {
    let (first, last) = (record.time[0], record.time[record.time.len() - 1]);
    let step = (last - first) / (record.time.len() - 1).max(1) as f64;
    let margin = step.max(SAME_TIME);
    if let Some((begin, end)) = range(time)
        && (begin < first - margin || end > last + margin)
    {
        let (link, motion) = (record.links[0].clone(), (begin, end));
        return Err(LoadError::Range { link, motion, force: (first, last) });
    }
    Ok(time.iter().map(|&t| at(record, t)).collect())
}

/// What a record says at a time (s); `None` beyond it by more than one of its mean steps.
pub(crate) fn known_at(record: &MeasuredForce, t: f64) -> Option<Contact> {
    let (first, last) = (record.time.first()?, record.time.last()?);
    let step = (last - first) / (record.time.len() - 1).max(1) as f64;
    let margin = step.max(SAME_TIME);
    (first - margin..=last + margin).contains(&t).then(|| at(record, t))
}

fn range(time: &[f64]) -> Option<(f64, f64)> {
    let (least, greatest) =
        time.iter().fold((f64::INFINITY, f64::NEG_INFINITY), |(a, b), &t| (a.min(t), b.max(t)));
    (least <= greatest).then_some((least, greatest))
}

/// One time, inside the record or by its end.
fn at(record: &MeasuredForce, t: f64) -> Contact {
    let (times, samples) = (&record.time, &record.samples);
    let after = times.partition_point(|time| *time < t - SAME_TIME);
    let Some(&next) = times.get(after) else { return samples[times.len() - 1] };
    if after == 0 || next <= t + SAME_TIME {
        return samples[after];
    }
    let (a, b) = (&samples[after - 1], &samples[after]);
    let s = (t - times[after - 1]) / (next - times[after - 1]);
    let between = |a: &Vector3<f64>, b: &Vector3<f64>| a * (1.0 - s) + b * s;
    let (weight, other) = ((1.0 - s) * a.force.norm(), s * b.force.norm());
    let cop = if weight + other > 0.0 {
        (a.cop * weight + b.cop * other) / (weight + other)
    } else {
        Vector3::zeros()
    };
    Contact { force: between(&a.force, &b.force), moment: between(&a.moment, &b.moment), cop }
}
