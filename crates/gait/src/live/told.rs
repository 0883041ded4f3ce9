//! Coordinates that do not follow the walk: the caller tells them, a clip is played with them, or they reach for something.

mod follow;
mod playing;
mod reaching;

use crate::body::{Body, Segment};
use crate::error::LiveError;
use follow::Follow;
use nalgebra::Vector3;
use playing::Playing;
use reaching::Reaching;
use solaris_analysis::Goal;
use solaris_model::{Figure, nearest};
use solaris_modes::RecordedMotion;
use std::sync::Arc;

/// The most clips that are played, and the most links that reach, at the same time.
const MOST: usize = 16;

/// A coordinate that can be told otherwise than the walk has it.
#[derive(Clone)]
struct Name {
    dof: String,
    joint: String,
    /// Its index among the coordinates and among the velocities.
    q: usize,
    v: usize,
    /// Whether it is the trunk's, which reaches for nothing unless it is asked to.
    is_trunk: bool,
}

/// Who says where a coordinate is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Source {
    Walk,
    Caller,
    Clip(usize),
    Reach(usize),
}

#[derive(Clone, Copy)]
struct State {
    is_freed: bool,
    /// What the caller says.
    value: f64,
    source: Source,
    follow: Follow,
}

/// Whatever is told. Of two that tell the same coordinate a reach goes before the caller's own value, and that before a clip; of two reaches, and of two clips, the later
/// one.
#[derive(Clone)]
pub(super) struct Told {
    figure: Arc<Figure>,
    names: Arc<[Name]>,
    states: Vec<State>,
    clips: Vec<Playing>,
    reaches: Vec<Reaching>,
    /// How many clips and reaches there have been.
    count: usize,
}

impl Told {
    /// Nothing is told yet; all but the coordinates of the root and of the legs can be, for the feet stand by those.
    pub(super) fn new(figure: &Figure, body: &Body) -> Self {
        // Abdomen and thorax, neck and head, arms.
        let trunk = body.middle[1..3].iter().map(|segment| (segment, true));
        let others = body.middle[3..].iter().chain(body.arms.iter().flatten());
        let upper = trunk.chain(others.map(|segment| (segment, false)));
        let layout = figure.layout();
        let name = |(q, is_trunk): (usize, bool)| {
            let index = layout.joints().partition_point(|at| at.q + at.nq <= q);
            let at = layout.joints()[index];
            let joint = figure.links()[index].joint().name().to_owned();
            Name { dof: layout.q_names()[q].clone(), joint, q, v: at.v + (q - at.q), is_trunk }
        };
        let axes =
            |(segment, is_trunk): (&Segment, bool)| (segment.q..segment.q + 3).map(move |q| (q, is_trunk));
        let names: Arc<[Name]> = upper.flat_map(axes).map(name).collect();
        let state =
            State { is_freed: false, value: 0.0, source: Source::Walk, follow: Follow::from(0.0, 0.0) };
        Self {
            figure: Arc::new(figure.clone()),
            states: vec![state; names.len()],
            names,
            clips: Vec::with_capacity(MOST),
            reaches: Vec::with_capacity(MOST),
            count: 0,
        }
    }

    /// Whose coordinates they are.
    pub(super) fn figure(&self) -> &Figure {
        &self.figure
    }

    /// Everything is where it is shown, and as fast as it moves.
    pub(super) fn begin(&mut self, q: &[f64], v: &[f64]) {
        for (name, state) in self.names.iter().zip(&mut self.states) {
            state.follow = Follow::from(q[name.q], v[name.v]);
        }
    }

    fn find(&self, dof: &str) -> Result<usize, LiveError> {
        let found = self.names.iter().position(|name| name.dof == dof);
        found.ok_or_else(|| LiveError::NotFree { dof: dof.to_owned(), nearest: self.nearest(dof) })
    }

    fn nearest(&self, name: &str) -> Option<String> {
        nearest(name, self.names.iter().flat_map(|known| [known.dof.as_str(), &known.joint]))
    }

    pub(super) fn free(&mut self, dof: &str, is_freed: bool) -> Result<(), LiveError> {
        let i = self.find(dof)?;
        self.states[i].is_freed = is_freed;
        Ok(())
    }

    pub(super) fn set(&mut self, dof: &str, value: f64) -> Result<(), LiveError> {
        let i = self.find(dof)?;
        if !value.is_finite() {
            return Err(LiveError::NotFinite { what: "value", value });
        }
        self.states[i].value = value;
        Ok(())
    }

    /// Which coordinates are meant by names of theirs or of joints; all of them by none.
    fn meant(&self, by: &[&str]) -> Result<Vec<usize>, LiveError> {
        if let Some(unknown) =
            by.iter().find(|by| !self.names.iter().any(|name| name.dof == **by || name.joint == **by))
        {
            return Err(LiveError::NotFree { dof: (*unknown).to_owned(), nearest: self.nearest(unknown) });
        }
        let is_meant =
            |name: &Name| by.is_empty() || by.iter().any(|by| name.dof == *by || name.joint == *by);
        Ok((0..self.names.len()).filter(|i| is_meant(&self.names[*i])).collect())
    }

    pub(super) fn play(&mut self, motion: &Arc<RecordedMotion>, by: &[&str]) -> Result<(), LiveError> {
        let refused = |why: String| Err(LiveError::Clip { why });
        if let Err(error) = motion.motion().check_figure(&self.figure) {
            return refused(error.to_string());
        }
        let meant = self.meant(by)?;
        let known = motion.motion().known();
        if let Some(i) = meant.iter().find(|i| !known.v[self.names[**i].v]) {
            return refused(format!(
                "the velocities of '{}' are not known, so that it would stop at every sample; solaris_analysis::differentiate finds them",
                self.names[*i].dof
            ));
        }
        if self.clips.len() == MOST {
            return refused(format!("{MOST} are played at the same time already"));
        }
        self.count += 1;
        let moves = meant.into_iter().map(|i| (i, self.names[i].q, self.names[i].v)).collect();
        self.clips.push(Playing::new(self.count, Arc::clone(motion), moves));
        Ok(())
    }

    /// Plays no clip any more.
    pub(super) fn end_clips(&mut self) {
        self.clips.clear();
    }

    pub(super) fn plays(&self) -> bool {
        !self.clips.is_empty()
    }

    fn link(&self, link: &str) -> Result<usize, LiveError> {
        self.figure.link_index(link).ok_or_else(|| {
            let names = self.figure.links().iter().map(solaris_model::Link::name);
            LiveError::NoLink { link: link.to_owned(), nearest: nearest(link, names) }
        })
    }

    /// A point of a link (m, in its frame) reaches for a goal from now on, by these coordinates or joints, from a configuration that is shown.
    pub(super) fn reach(
        &mut self,
        (link, point): (&str, Vector3<f64>),
        by: &[&str],
        goal: Goal,
        q: &[f64],
    ) -> Result<(), LiveError> {
        let link = self.link(link)?;
        let present = self.reaches.iter().position(|reach| reach.link == link);
        if let Some(i) = present.filter(|i| self.reaches[*i].is_of(link, &point, by)) {
            return self.reaches[i].aim(goal);
        }
        if present.is_none() && self.reaches.len() == MOST {
            return Err(LiveError::Reach { why: format!("{MOST} links reach at the same time already") });
        }
        let is_asked = |name: &&Name| !(by.is_empty() && name.is_trunk);
        let meant = self.meant(by)?.into_iter().map(|i| &self.names[i]).filter(is_asked);
        let dofs: Vec<usize> = meant.map(|name| name.v).collect();
        let reaching = Reaching::new(&self.figure, self.count + 1, (link, point), (by, &dofs), goal, q)?;
        self.count += 1;
        match present {
            Some(i) => self.reaches[i] = reaching,
            None => self.reaches.push(reaching),
        }
        Ok(())
    }

    /// A link reaches no more.
    pub(super) fn withdraw(&mut self, link: &str) -> Result<(), LiveError> {
        let link = self.link(link)?;
        self.reaches.retain(|reach| reach.link != link);
        Ok(())
    }

    /// What is missing to the goal of a link that reaches (m or rad).
    pub(super) fn off(&self, link: &str) -> Option<f64> {
        let link = self.figure.link_index(link)?;
        self.reaches.iter().find(|reach| reach.link == link).map(Reaching::off)
    }

    /// Whether anything is told, or on its way back to the walk.
    pub(super) fn is_told(&self) -> bool {
        let is_walk = |state: &State| state.source == Source::Walk && state.follow.is_there();
        !(self.clips.is_empty()
            && self.reaches.is_empty()
            && self.states.iter().all(|state| !state.is_freed && is_walk(state)))
    }

    /// Goes on by `dt` (s), and writes what is told into a walk's configuration.
    pub(super) fn step(&mut self, dt: f64, q: &mut [f64]) {
        let Self { names, states, clips, reaches, .. } = self;
        clips.retain_mut(|clip| clip.step(dt));
        let show = |state: &mut State, at: &Name, source: Source, law: f64, q: &mut [f64]| {
            q[at.q] = state.follow.step(dt, law, state.source != source);
            state.source = source;
        };
        for (i, (state, name)) in states.iter_mut().zip(names.iter()).enumerate() {
            let reached = reaches.iter().any(|reach| reach.moves().any(|at| at == name.q));
            if reached {
                continue;
            }
            let clip = clips.iter().rev().find_map(|clip| {
                clip.values().find(|(which, _)| *which == i).map(|(_, value)| (Source::Clip(clip.id), value))
            });
            let (source, law) = if state.is_freed {
                (Source::Caller, state.value)
            } else {
                clip.unwrap_or((Source::Walk, q[name.q]))
            };
            show(state, name, source, law, q);
        }
        for k in 0..reaches.len() {
            reaches[k].solve(q);
            for (state, name) in states.iter_mut().zip(names.iter()) {
                let moves = |reach: &Reaching| reach.moves().any(|at| at == name.q);
                if moves(&reaches[k]) && !reaches[k + 1..].iter().any(moves) {
                    let law = q[name.q];
                    show(state, name, Source::Reach(reaches[k].id), law, q);
                }
            }
        }
    }

    /// Writes velocities and accelerations of what is told (rad/s, rad/s²).
    pub(super) fn write_derivatives(&self, v: &mut [f64], a: &mut [f64]) {
        for (name, state) in self.names.iter().zip(&self.states) {
            if state.source != Source::Walk || !state.follow.is_there() {
                [v[name.v], a[name.v]] = state.follow.moves();
            }
        }
    }
}
