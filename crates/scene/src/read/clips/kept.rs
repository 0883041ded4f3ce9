//! A clip that keeps links apart.

use crate::read::apart::{Nudge, Nudged, way};
use nalgebra::{DMatrix, Vector3};
use solaris_dynamics::{Tree, Workspace, mass_matrix};
use solaris_model::{Figure, Motion};

/// The motion of a clip, with what is added to it.
pub(super) struct Kept<'a> {
    figure: &'a Figure,
    motion: &'a Motion,
    /// What follows the clip: degrees of freedom, and their coordinates.
    moves: Vec<(usize, usize)>,
    clearance: f64,
    /// From when on something may be added (s), or from the beginning on.
    from: Option<f64>,
    tree: Tree<f64>,
    nudges: Vec<Nudge>,
    positions: Vec<Vec<f64>>,
    found: usize,
}

impl<'a> Kept<'a> {
    pub(super) fn new(
        figure: &'a Figure,
        motion: &'a Motion,
        dofs: &[usize],
        clearance: f64,
        from: Option<f64>,
    ) -> Result<Self, String> {
        let tree = Tree::new(figure, Vector3::zeros()).map_err(|error| error.to_string())?;
        let with_coordinate = |dof: &usize| Some((*dof, figure.layout().coordinate(*dof)?));
        let moves = dofs.iter().filter_map(with_coordinate).collect();
        Ok(Self {
            figure,
            motion,
            moves,
            clearance,
            from,
            tree,
            nudges: Vec::new(),
            positions: Vec::new(),
            found: 0,
        })
    }

    /// The motion with all that was added; nothing where nothing was.
    pub(super) fn finish(&self) -> Option<Result<Motion, String>> {
        if self.nudges.is_empty() {
            return None;
        }
        let times = self.motion.time();
        let (mut q, mut v, mut a) = (Vec::new(), Vec::new(), Vec::new());
        for (k, time) in times.iter().enumerate() {
            let mut own = [self.motion.q(k), self.motion.v(k), self.motion.a(k)].map(<[f64]>::to_vec);
            for nudge in &self.nudges {
                let much = nudge.at(*time);
                for ((dof, coordinate), by) in self.moves.iter().zip(&nudge.by) {
                    for (numbers, (index, much)) in
                        own.iter_mut().zip([*coordinate, *dof, *dof].into_iter().zip(much))
                    {
                        numbers[index] += much * by;
                    }
                }
            }
            let [own_q, own_v, own_a] = own;
            q.extend(own_q);
            v.extend(own_v);
            a.extend(own_a);
        }
        let found = Motion::new(self.figure, self.motion.info.clone(), times.to_vec(), [q, v, a]);
        Some(found.map_err(|error| error.to_string()))
    }

    /// Where a degree of freedom may be.
    fn limits(&self, dof: usize) -> [f64; 2] {
        let mut joints = self.figure.links().iter().zip(self.figure.layout().joints());
        let of = |(link, at): (&solaris_model::Link, &solaris_model::JointLayout)| {
            link.joint().kind().axes().get(dof.checked_sub(at.v)?).filter(|_| dof < at.v + at.nv)?.limits
        };
        let limits = joints.find_map(of);
        limits.map_or([f64::NEG_INFINITY, f64::INFINITY], |limits| [limits.lower, limits.upper])
    }
}

impl Nudged for Kept<'_> {
    fn positions(&mut self) -> Result<&[Vec<f64>], String> {
        if self.positions.is_empty() {
            self.found += 1;
            for (k, time) in self.motion.time().iter().enumerate() {
                let mut q = self.motion.q(k).to_vec();
                for nudge in &self.nudges {
                    let [much, ..] = nudge.at(*time);
                    for ((_, coordinate), by) in self.moves.iter().zip(&nudge.by) {
                        q[*coordinate] += much * by;
                    }
                }
                self.positions.push(q);
            }
        }
        Ok(&self.positions)
    }

    fn found(&self) -> usize {
        self.found
    }

    fn widest(&self) -> f64 {
        self.clearance
    }

    fn wanted(&self, _: usize, dofs: &[usize]) -> f64 {
        let is_moved = self.moves.iter().any(|(dof, _)| dofs.contains(dof));
        if is_moved { self.clearance } else { f64::NEG_INFINITY }
    }

    fn otherwise(&self, _: usize) -> Option<Vec<f64>> {
        None
    }

    fn until(&self, _: usize, _: &[usize]) -> f64 {
        f64::INFINITY
    }

    /// What weighs little gives way: `W` is one over the inertia about each axis.
    fn nudge(
        &mut self,
        frame: usize,
        slopes: &[(usize, f64)],
        by: f64,
        mut nudge: Nudge,
        detour: bool,
    ) -> Result<bool, String> {
        if detour {
            return Ok(false);
        }
        if let Some(from) = self.from {
            nudge = nudge.not_before(from);
        }
        self.positions()?;
        let q = &self.positions[frame];
        let mut matrix = DMatrix::zeros(self.tree.nv(), self.tree.nv());
        mass_matrix(&self.tree, &mut Workspace::new(&self.tree), q, &mut matrix)
            .map_err(|error| error.to_string())?;
        let slope = |dof: usize| slopes.iter().find(|(own, _)| *own == dof).map_or(0.0, |(_, slope)| *slope);
        let own: Vec<f64> = self.moves.iter().map(|(dof, _)| slope(*dof)).collect();
        // How far each may go without leaving its limits at any time that it is added.
        let frames = self.motion.time().iter().zip(&self.positions);
        let during: Vec<&Vec<f64>> =
            frames.filter(|(time, _)| nudge.at(**time)[0] > 0.0).map(|(_, q)| q).collect();
        let room = |(dof, coordinate): &(usize, usize)| {
            let [lower, upper] = self.limits(*dof);
            let most = |far: &dyn Fn(f64) -> f64| {
                during.iter().map(|q| far(q[*coordinate])).fold(f64::INFINITY, f64::min).max(0.0)
            };
            [most(&|x| x - lower), most(&|x| upper - x)]
        };
        let rooms: Vec<[f64; 2]> = self.moves.iter().map(room).collect();
        let free = self.moves.iter().zip(&rooms).zip(&own).map(|(((dof, _), [below, above]), slope)| {
            let is_stuck = if *slope < 0.0 { *below <= 0.0 } else { *above <= 0.0 };
            if is_stuck { 0.0 } else { slope / matrix[(*dof, *dof)].max(f64::MIN_POSITIVE) }
        });
        let Some(mut way) = way(&own, free.collect(), by) else { return Ok(false) };
        way.iter_mut().zip(&rooms).for_each(|(way, [below, above])| *way = way.clamp(-below, *above));
        nudge.by = way;
        self.nudges.push(nudge);
        self.positions.clear();
        Ok(true)
    }

    fn turn(&mut self, _: usize, _: &[usize], _: f64, _: Nudge) -> Result<bool, String> {
        Ok(false)
    }

    fn is_sound(&mut self) -> Result<bool, String> {
        Ok(true)
    }

    fn added(&self) -> Vec<Vec<Nudge>> {
        vec![self.nudges.clone()]
    }

    fn put_back(&mut self, added: Vec<Vec<Nudge>>) {
        self.nudges = added.into_iter().flatten().collect();
        self.positions.clear();
    }
}
