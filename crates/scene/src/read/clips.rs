//! Clips: parts of motions in files, which joints follow.

mod kept;

use super::apart::Cuts;
use super::drives::Given;
use super::reaches::stands;
use super::{SceneReader, apart};
use kept::Kept;
use solaris_analysis::{Clearance, differentiate};
use solaris_model::text::{Fields, Node};
use solaris_model::{Figure, Motion, MotionInfo};
use solaris_modes::{Drive, EndCondition, RecordedMotion, Step};
use solaris_profiles::{Curve, Quintic};
use std::sync::Arc;

const FIELDS: [&str; 7] = ["file", "from", "to", "at", "blend", "dofs", "clearance"];

impl SceneReader<'_> {
    /// Lets what has no drive of its own, and has a coordinate, follow a part of a motion in a file; what there is to say of it.
    pub(super) fn clip(&mut self, fields: &Fields<'_, '_>, given: &mut Given) -> Vec<String> {
        self.clipped_to(fields, given).unwrap_or_default()
    }

    fn clipped_to(&mut self, fields: &Fields<'_, '_>, given: &mut Given) -> Option<Vec<String>> {
        let node = fields.get("clip")?;
        let before = self.reader.count();
        let known = self.reader.fields(node, &["Clip"], &FIELDS);
        let clip = known?;
        if fields.get("walk").is_some() {
            let message = "a walk moves all that has no drive, and so does a clip; leave one of them out";
            self.reader.fault(node.place(), message);
        }
        let file = self.reader.required(&clip, "file", "\"wave.csv\"");
        let path = file.and_then(|node| Some((node, self.reader.name(node, "the path of a motion")?)));
        let mut time = |field, default| match clip.get(field) {
            None => Some(default),
            Some(node) => {
                let time = self.reader.number(node, field)?;
                if time.is_finite() && time >= 0.0 {
                    return Some(time);
                }
                self.reader.fault(
                    node.span.clone(),
                    format!("{field} is {time}; it must be a finite time, zero or more (s)"),
                );
                None
            }
        };
        let (at, blend) = (time("at", 0.0), time("blend", 0.0));
        let mut end = |field, default: f64| {
            let node = clip.get(field);
            node.map_or(Some(default), |node| self.reader.number(node, field))
        };
        let (from, to) = (end("from", f64::NEG_INFINITY), end("to", f64::INFINITY));
        let clearance = self.apart(&clip, 0.0);
        let dofs = self.clipped(&clip, given);
        let figure = self.figure().cloned()?;
        let gravity = self.simulation.as_ref().map(|simulation| *simulation.gravity()).unwrap_or_default();
        let ((file, path), at, blend, from, to) = (path?, at?, blend?, from?, to?);
        let clearance = clearance?;
        let motion = self.loader.motion(path, &figure, &gravity, &dofs);
        let motion = motion
            .and_then(|motion| differentiate(&figure, &motion, None).map_err(|error| error.to_string()));
        let motion = match motion {
            Ok(found) => found.motion,
            Err(why) => {
                self.reader.fault(file.span.clone(), format!("'{path}': {why}"));
                return None;
            }
        };
        if self.reader.count() > before || self.reader.is_asked() {
            return None;
        }
        let part = Part { from, to, at, blend };
        let start =
            self.simulation.as_ref().map(|simulation| simulation.state().0.to_vec()).unwrap_or_default();
        let begins = (at > 0.0 || blend > 0.0).then_some(at);
        let found = part.of(&figure, &motion, &start, &dofs).and_then(|motion| {
            let (motion, cuts) = self.kept_apart(&figure, motion, &dofs, clearance, begins)?;
            Ok((RecordedMotion::new(motion).map_err(|error| error.to_string())?, cuts))
        });
        let (recorded, cuts) = match found {
            Ok((recorded, cuts)) => (Arc::new(recorded), cuts),
            Err(why) => {
                self.reader.fault(node.place(), format!("'{path}': {why}"));
                return None;
            }
        };
        if at <= 0.0 && blend <= 0.0 {
            self.begin_as(node, &recorded, &dofs);
        }
        for dof in dofs {
            let mut steps: Vec<Step> = Vec::new();
            if at > 0.0 {
                steps.push(Step { drive: Drive::Frozen, until: EndCondition::Time(at) });
            }
            steps.push(Drive::Recorded(Arc::clone(&recorded)).into());
            let name = self.names.name(dof).to_owned();
            if let Some(simulation) = &mut self.simulation {
                let result = simulation.drive(&name, steps.clone());
                self.setup(&node.place(), result);
            }
            given.insert(dof, steps);
        }
        Some(self.cuts(&cuts))
    }

    /// What follows the clip from the beginning on begins as it does.
    fn begin_as(&mut self, node: &Node<'_>, recorded: &RecordedMotion, dofs: &[usize]) {
        let Some(simulation) = &mut self.simulation else { return };
        let (mut q, mut v) = (simulation.state().0.to_vec(), simulation.state().1.to_vec());
        for dof in dofs {
            if let Some(coordinate) = simulation.figure().layout().coordinate(*dof) {
                q[coordinate] = recorded.motion().q(0)[coordinate];
                v[*dof] = recorded.motion().v(0)[*dof];
            }
        }
        let result = simulation.set_start(&q, &v);
        self.setup(&node.place(), result);
    }

    /// The same motion with links that far apart (m), where that is more than nothing, and which are not; those that nothing moves but the
    /// clip.
    fn kept_apart(
        &self,
        figure: &Figure,
        motion: Motion,
        dofs: &[usize],
        clearance: f64,
        begins: Option<f64>,
    ) -> Result<(Motion, Vec<Cuts>), String> {
        if clearance <= 0.0 {
            return Ok((motion, Vec::new()));
        }
        let mut measure = Clearance::new(figure, dofs, &[]).map_err(|error| error.to_string())?;
        let stands = |dof: &usize| {
            self.simulation.as_ref().is_some_and(|simulation| stands(simulation.driven_by(*dof)))
        };
        measure.retain(|_, between| between.iter().all(|dof| dofs.contains(dof) || stands(dof)));
        let mut kept = Kept::new(figure, &motion, dofs, clearance, begins)?;
        let cuts = apart::keep(&mut measure, motion.time(), &mut kept)?;
        let found = kept.finish().transpose()?;
        Ok((found.unwrap_or(motion), cuts))
    }

    /// What follows the clip: of what is named, or of all, what has no drive and has a coordinate.
    fn clipped(&mut self, clip: &Fields<'_, '_>, given: &Given) -> Vec<usize> {
        let mut dofs: Vec<usize> = Vec::new();
        if let Some(node) = clip.get("dofs") {
            let items: &[Node<'_>] =
                self.reader.items(node, "dofs", "[\"right_*\", \"neck\"]").unwrap_or_default();
            for item in items {
                dofs.extend(
                    self.meant(item).map(|meant| self.leaders(meant)).map_or(Vec::new(), |meant| meant.dofs),
                );
            }
        } else if let Some(figure) = self.figure() {
            dofs.extend(0..figure.layout().nv());
        }
        let Some(figure) = self.figure() else { return Vec::new() };
        let follows_clip = |dof: &usize| {
            figure.layout().coordinate(*dof).is_some() && !figure.follows(*dof) && !given.contains_key(dof)
        };
        dofs.retain(follows_clip);
        dofs.sort_unstable();
        dofs.dedup();
        dofs
    }
}

/// Which part of a motion, and when.
struct Part {
    from: f64,
    to: f64,
    /// When it begins in the run (s).
    at: f64,
    /// How long it takes from where the joints are into it (s).
    blend: f64,
}

impl Part {
    /// The samples of the part at the times of the run. While it blends in, each coordinate goes over from where it starts, at rest:
    ///
    /// ```text
    /// x = x₀ + w·(c − x₀)      v = w·ċ + ẇ·(c − x₀)      a = w·c̈ + 2ẇ·ċ + ẅ·(c − x₀)
    /// ```
    ///
    /// with a `w` from 0 to 1 of the least jerk.
    fn of(&self, figure: &Figure, motion: &Motion, start: &[f64], dofs: &[usize]) -> Result<Motion, String> {
        let times = motion.time();
        let inside: Vec<usize> =
            (0..times.len()).filter(|k| (self.from..=self.to).contains(&times[*k])).collect();
        let (Some(&first), Some(&last)) = (inside.first(), inside.last()) else {
            return Err(format!(
                "there is nothing of it from {} to {} s; it goes from {} to {} s",
                self.from,
                self.to,
                times.first().copied().unwrap_or_default(),
                times.last().copied().unwrap_or_default()
            ));
        };
        let share = if self.blend > 0.0 {
            Some(Quintic::minimum_jerk(self.blend, 0.0, 1.0).map_err(|error| error.to_string())?)
        } else {
            None
        };
        let layout = figure.layout();
        let (mut q, mut v, mut a) = (Vec::new(), Vec::new(), Vec::new());
        for k in first..=last {
            let mut own = [start.to_vec(), vec![0.0; layout.nv()], vec![0.0; layout.nv()]];
            for (dof, x) in dofs.iter().filter_map(|dof| Some((*dof, layout.coordinate(*dof)?))) {
                let (c, rate, change) = (motion.q(k)[x] - start[x], motion.v(k)[dof], motion.a(k)[dof]);
                let w = share.as_ref().map(|share| share.at(times[k] - times[first]));
                let (w, dw, ddw) = w.map_or((1.0, 0.0, 0.0), |w| (w.position, w.velocity, w.acceleration));
                own[0][x] = start[x] + w * c;
                own[1][dof] = w * rate + dw * c;
                own[2][dof] = w * change + 2.0 * dw * rate + ddw * c;
            }
            let [own_q, own_v, own_a] = own;
            q.extend(own_q);
            v.extend(own_v);
            a.extend(own_a);
        }
        let info = MotionInfo { fingerprint: figure.fingerprint(), ground: None, ..motion.info.clone() };
        let times = (first..=last).map(|k| self.at + (times[k] - times[first])).collect();
        Motion::new(figure, info, times, [q, v, a]).map_err(|error| error.to_string())
    }
}
