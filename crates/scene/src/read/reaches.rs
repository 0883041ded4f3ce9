//! Reaching: joints that bring a point of the figure to places.

use super::SceneReader;
use super::parts::Named;
use nalgebra::Vector3;
use solaris_analysis::{REACHED, Reach};
use solaris_model::text::{Fields, Node, ReadSpatial as _};
use solaris_model::{Motion, MotionInfo};
use solaris_modes::{Drive, EndCondition, RecordedMotion, Step};
use solaris_profiles::{Curve, Profile};
use std::collections::BTreeMap;
use std::ops::Range;
use std::sync::Arc;

const EXAMPLE: &str = "[Reach(tip: \"right_hand\", by: [\"right_shoulder\", \"right_elbow\"], to: (-0.2, 1.2, 0.4), over: 0.8)]";
const FIELDS: [&str; 7] = ["tip", "at", "by", "to", "along", "over", "from"];

/// Samples a second of the motion that is followed; between them it follows curves of degree five.
const RATE: f64 = 240.0;

/// The longest that a reach may take (s).
const LONGEST: f64 = 600.0;

/// One that is asked for.
struct Asked {
    place: Range<usize>,
    name: String,
    link: usize,
    point: Vector3<f64>,
    by: Vec<usize>,
    from: f64,
    /// Times since then, and places (m): where it is to be.
    keys: Vec<(f64, Vector3<f64>)>,
}

impl SceneReader<'_> {
    /// Finds the motions of what reaches, and lets its joints follow them; what there is to say of them.
    pub(super) fn reaches(&mut self, fields: &Fields<'_, '_>, named: &Named) -> Vec<String> {
        let Some(node) = fields.get("reaches") else { return Vec::new() };
        let before = self.reader.count();
        let items = self.reader.items(node, "reaches", EXAMPLE).unwrap_or_default();
        let asked: Vec<Option<Asked>> = items.iter().map(|item| self.asked(item, named)).collect();
        let mut asked: Vec<Asked> = asked.into_iter().flatten().collect();
        if fields.get("walk").is_some() {
            let message = "what reaches has to stand still otherwise, and a walk moves all of it; leave one of them out";
            self.reader.fault(node.place(), message);
        }
        if self.reader.count() > before || self.simulation.is_none() {
            return Vec::new();
        }
        asked.sort_by(|a, b| a.from.total_cmp(&b.from));
        self.found(&asked)
    }

    /// The motions, one after the other.
    fn found(&mut self, asked: &[Asked]) -> Vec<String> {
        let Some(simulation) = self.simulation.as_ref() else { return Vec::new() };
        let mut q = simulation.state().0.to_vec();
        let mut notes = Vec::new();
        // By degree of freedom: what it does, and until when (s).
        let mut drives: BTreeMap<usize, (Vec<Step>, f64)> = BTreeMap::new();
        for one in asked {
            if !self.stands_still(one, asked) {
                continue;
            }
            let busy = one.by.iter().find(|dof| drives.get(dof).is_some_and(|(_, end)| *end > one.from));
            if let Some(dof) = busy {
                let (name, end) = (self.names.name(*dof), drives[dof].1);
                let message =
                    format!("'{name}' is still reaching for something else until {end} s; begin later");
                self.reader.fault(one.place.clone(), message);
                continue;
            }
            let Some((recorded, note)) = self.reach(one, &mut q) else { continue };
            notes.extend(note);
            let end = recorded.span().1;
            let recorded = Arc::new(recorded);
            for dof in &one.by {
                let (steps, until) = drives.entry(*dof).or_default();
                if one.from > 0.0 {
                    steps.push(Step { drive: Drive::Frozen, until: EndCondition::Time(one.from) });
                }
                steps.push(Drive::Recorded(Arc::clone(&recorded)).into());
                *until = end;
            }
        }
        for (dof, (steps, _)) in drives {
            let name = self.names.name(dof).to_owned();
            if let (Some(simulation), Some(one)) = (&mut self.simulation, asked.first()) {
                let result = simulation.drive(&name, steps);
                self.setup(&one.place, result);
            }
        }
        notes
    }

    /// Whether all that carries the point and does not reach for it stands still; what does not is a fault.
    fn stands_still(&mut self, one: &Asked, asked: &[Asked]) -> bool {
        let Some(simulation) = self.simulation.as_ref() else { return false };
        let figure = simulation.figure();
        let (mut at, mut moving) = (Some(one.link), None);
        while let Some(link) = at {
            let joint = figure.layout().joints()[link];
            let moves = |dof: &usize| {
                let frozen = matches!(simulation.driven_by(*dof), [step] if step.drive == Drive::Frozen);
                let reaches = asked.iter().any(|other| other.by.contains(dof));
                !one.by.contains(dof) && (!frozen || reaches)
            };
            moving = (joint.v..joint.v + joint.nv).find(moves).or(moving);
            at = figure.links()[link].parent();
        }
        let Some(dof) = moving else { return true };
        let message = format!(
            "'{}' carries '{}' and does not stand still, so that it is not known where to reach from: freeze it, or name it in 'by'",
            self.names.name(dof),
            one.name
        );
        self.reader.fault(one.place.clone(), message);
        false
    }

    /// The motion that reaches, from `q` on, which then is where it ends; and what there is to say where it does not get there.
    fn reach(&mut self, one: &Asked, q: &mut [f64]) -> Option<(RecordedMotion, Option<String>)> {
        let simulation = self.simulation.as_ref()?;
        let (figure, gravity) = (simulation.figure().clone(), *simulation.gravity());
        let solver = Reach::new(&figure, one.link, one.point, &one.by);
        let mut solver =
            solver.map_err(|error| self.reader.fault(one.place.clone(), error.to_string())).ok()?;
        let begin =
            solver.place(q).map_err(|error| self.reader.fault(one.place.clone(), error.to_string())).ok()?;
        let way = Way::through(begin, &one.keys);
        let way = way.map_err(|error| self.reader.fault(one.place.clone(), error)).ok()?;
        if way.duration > LONGEST {
            let message = format!("a reach takes {LONGEST} s at most; this takes {} s", way.duration);
            self.reader.fault(one.place.clone(), message);
            return None;
        }
        let count = ((way.duration * RATE).ceil() as usize).max(4);
        let times: Vec<f64> = (0..=count).map(|k| way.duration * k as f64 / count as f64).collect();
        let (mut samples, mut worst) = (vec![q.to_vec()], (0.0, 0.0));
        for &time in &times[1..] {
            let solved = solver.solve(q, &way.at(time));
            let reached =
                solved.map_err(|error| self.reader.fault(one.place.clone(), error.to_string())).ok()?;
            if reached.off > worst.0 {
                worst = (reached.off, one.from + time);
            }
            samples.push(q.to_vec());
        }
        let motion = self
            .sampled(one, &times, &samples)
            .map_err(|error| self.reader.fault(one.place.clone(), error))
            .ok()?;
        let info = MotionInfo { fingerprint: figure.fingerprint(), gravity, ground: None, rate: RATE };
        let times = times.iter().map(|time| one.from + time).collect();
        let motion = Motion::new(&figure, info, times, motion);
        let motion = motion.map_err(|error| self.reader.fault(one.place.clone(), error.to_string())).ok()?;
        let note = (worst.0 > REACHED).then(|| {
            format!(
                "'{}' cannot reach all of its way: at {:.3} s it is {:.1} mm away, as near as its joints come",
                one.name,
                worst.1,
                1e3 * worst.0
            )
        });
        Some((self.setup(&one.place, RecordedMotion::new(motion))?, note))
    }

    /// Positions, velocities and accelerations through the samples, from rest to rest.
    fn sampled(&self, one: &Asked, times: &[f64], samples: &[Vec<f64>]) -> Result<[Vec<f64>; 3], String> {
        let Some(layout) = self.figure().map(|figure| figure.layout().clone()) else {
            return Err(String::new());
        };
        let (nq, nv) = (layout.nq(), layout.nv());
        let mut q: Vec<f64> = samples.concat();
        let (mut v, mut a) = (vec![0.0; times.len() * nv], vec![0.0; times.len() * nv]);
        for &dof in &one.by {
            let Some(coordinate) = layout.coordinate(dof) else { continue };
            let keys = times.iter().zip(samples).map(|(time, sample)| (*time, sample[coordinate])).collect();
            let spline = Profile::ClampedSpline { keys, start_velocity: 0.0, end_velocity: 0.0 };
            let spline = spline.curve::<f64>().map_err(|error| error.to_string())?;
            for (k, time) in times.iter().enumerate() {
                let sample = spline.at(*time);
                q[k * nq + coordinate] = samples[k][coordinate];
                (v[k * nv + dof], a[k * nv + dof]) = (sample.velocity, sample.acceleration);
            }
        }
        Ok([q, v, a])
    }

    /// `Reach(tip: "right_hand", at: (0, -0.08, 0), by: ["right_shoulder", …], to: (x, y, z), over: 0.8, from: 0)`
    fn asked(&mut self, node: &Node<'_>, named: &Named) -> Option<Asked> {
        let before = self.reader.count();
        let fields = self.reader.fields(node, &["Reach"], &FIELDS)?;
        let tip = self.reader.required(&fields, "tip", "\"right_hand\"");
        let tip = tip.and_then(|node| {
            let name = self.reader.name(node, "the name of a link")?;
            Some((name.to_owned(), self.link(node, name, None)?))
        });
        let at = fields
            .get("at")
            .map_or(Some(Vector3::zeros()), |node| self.reader.vector(node, "the point that reaches"));
        let by = self.reader.required(&fields, "by", "[\"right_shoulder\", \"right_elbow\"]");
        let mut dofs = Vec::new();
        for item in
            by.and_then(|node| self.reader.items(node, "by", "[\"right_shoulder\", …]")).unwrap_or_default()
        {
            let Some(meant) = self.meant(item).map(|meant| self.leaders(meant)) else { continue };
            if let Some(dof) = meant.dofs.iter().find(|dof| named.contains_key(dof)) {
                let name = self.names.name(*dof).to_owned();
                let message = format!("'{name}' reaches, and has drives of its own; keep one of them");
                self.reader.fault(item.span.clone(), message);
            }
            dofs.extend(meant.dofs);
        }
        dofs.sort_unstable();
        dofs.dedup();
        let from = self.time_of(fields.get("from"), "from");
        let keys = self.keys_of(&fields);
        if self.reader.count() > before {
            return None;
        }
        let ((name, link), from) = (tip?, from?);
        Some(Asked { place: node.place(), name, link, point: at?, by: dofs, from, keys: keys? })
    }

    /// A time of the run (s), zero unless given.
    fn time_of(&mut self, node: Option<&Node<'_>>, what: &str) -> Option<f64> {
        let Some(node) = node else { return Some(0.0) };
        let time = self.reader.number(node, what)?;
        if time.is_finite() && time >= 0.0 {
            return Some(time);
        }
        self.reader.fault(
            node.span.clone(),
            format!("{what} is {time}; it must be a finite time, zero or more (s)"),
        );
        None
    }

    /// `to: (x, y, z), over: 0.8`, or `along: [(0.4, (x, y, z)), (0.8, (x, y, z)), …]`
    fn keys_of(&mut self, fields: &Fields<'_, '_>) -> Option<Vec<(f64, Vector3<f64>)>> {
        match (fields.get("to"), fields.get("along")) {
            (Some(to), None) => {
                let over = self.reader.required(fields, "over", "0.8");
                let over = over.and_then(|node| self.reader.positive(node, "the time to reach", "s"));
                let to = self.reader.vector(to, "the place to reach");
                Some(vec![(over?, to?)])
            }
            (None, Some(along)) => {
                let example = "[(0.4, (0, 1, 0.3)), (0.8, (0.2, 1, 0.3))]";
                let mut keys: Vec<(f64, Vector3<f64>)> = Vec::new();
                for item in self.reader.items(along, "along", example)? {
                    let Some([time, place]) = item.items() else {
                        let message =
                            format!("a place on the way is (time, (x, y, z)), not {}", item.describe());
                        self.reader.fault(item.place(), message);
                        continue;
                    };
                    let read = self.reader.number(time, "the time of a place");
                    let place = self.reader.vector(place, "a place on the way");
                    let (Some(at), Some(place)) = (read, place) else { continue };
                    let last = keys.last().map_or(0.0, |(time, _)| *time);
                    if !(at.is_finite() && at > last) {
                        let message = format!("times of places rise from 0 on; {at} comes after {last}");
                        self.reader.fault(time.span.clone(), message);
                    }
                    keys.push((at, place));
                }
                if keys.is_empty() {
                    self.reader
                        .fault(along.place(), format!("there is no place on the way; write {example}"));
                }
                Some(keys)
            }
            (to, _) => {
                let what = if to.is_some() { "both; keep one of them" } else { "neither" };
                let message = format!(
                    "a reach goes to a place, to: (x, y, z), over: 0.8, or along: [(0.4, (x, y, z)), …]; this has {what}"
                );
                self.reader.fault(to.map_or(fields.at.clone(), Node::place), message);
                None
            }
        }
    }
}

/// Where the point is to be, over the time since it began.
struct Way {
    duration: f64,
    axes: [solaris_profiles::ProfileCurve; 3],
}

impl Way {
    /// From a place at rest, through others, to the last, where it rests: to one place along a straight line with the least jerk, through
    /// several along a spline.
    fn through(begin: Vector3<f64>, keys: &[(f64, Vector3<f64>)]) -> Result<Self, String> {
        let duration = keys.last().map_or(0.0, |(time, _)| *time);
        let axis = |i: usize| {
            let profile = if let [(duration, to)] = keys {
                Profile::MinimumJerk { from: begin[i], to: to[i], duration: *duration }
            } else {
                let keys = keys.iter().map(|(time, place)| (*time, place[i]));
                let keys = std::iter::once((0.0, begin[i])).chain(keys).collect();
                Profile::ClampedSpline { keys, start_velocity: 0.0, end_velocity: 0.0 }
            };
            profile.curve::<f64>().map_err(|error| error.to_string())
        };
        Ok(Self { duration, axes: [axis(0)?, axis(1)?, axis(2)?] })
    }

    fn at(&self, time: f64) -> Vector3<f64> {
        Vector3::from_fn(|i, _| self.axes[i].at(time).position)
    }
}
