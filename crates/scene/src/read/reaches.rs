//! What reaches for places, looks at them or is held as it is: joints whose motion is found before the run, over what they would
//! otherwise do.

mod asked;
mod beforehand;
mod layer;
mod layers;
mod order;
mod samples;
mod way;

use super::{SceneReader, apart};
use asked::Asked;
pub(super) use beforehand::stands;
use beforehand::{Beforehand, carriers, is_known, leader};
use layer::{Layer, Placed};
use layers::Layers;
use nalgebra::Vector3;
use samples::Samples;
use solaris_analysis::{Clearance, REACHED, Reach};
use solaris_dynamics::{Tree, Workspace};
use solaris_model::text::{Fields, Node};
use solaris_modes::{Drive, EndCondition, RecordedMotion, Simulation, Step};
use std::ops::Range;
use std::sync::Arc;
pub(super) use way::share;

/// A fault, and its place.
type Refused = (Range<usize>, String);

/// What there is to say of what reaches, and the degrees of freedom that do.
type Found = (Vec<String>, Vec<usize>);

impl SceneReader<'_> {
    /// Finds the motions of what reaches, looks or is held, and lets its joints follow them; what there is to say of them, and which
    /// degrees of freedom do.
    pub(super) fn reaches(&mut self, fields: &Fields<'_, '_>, walked: Option<f64>) -> Found {
        let Some(node) = fields.get("reaches") else { return Default::default() };
        let before = self.reader.count();
        let items = self.reader.items(node, "reaches", asked::EXAMPLE).unwrap_or_default();
        let asked: Vec<Option<Vec<Asked>>> = items.iter().map(|item| self.asked(item)).collect();
        let mut asked: Vec<Asked> = asked.into_iter().flatten().flatten().collect();
        asked.sort_by(|a, b| a.from.total_cmp(&b.from));
        self.one_after_the_other(&asked);
        let known = self.known(&asked);
        let (Some(duration), Some(simulation)) = (self.lasts.or(walked), self.simulation.clone()) else {
            return Default::default();
        };
        // To find it takes a while, and who asks what may stand somewhere does not care.
        if self.reader.count() > before || asked.is_empty() || self.reader.is_asked() {
            return Default::default();
        }
        let found = self.clearance(&asked, &simulation, known).map_err(|why| (node.place(), why));
        let found = found.and_then(|(clearance, known)| {
            self.found(&asked, &simulation, (&known, clearance), duration, node)
        });
        let found = found.map_err(|(place, why)| self.reader.fault(place, why));
        found.unwrap_or_default()
    }

    /// Refuses what begins with a joint while that is on its way to something else.
    fn one_after_the_other(&mut self, asked: &[Asked]) {
        for (i, one) in asked.iter().enumerate() {
            let busy = asked[..i].iter().find_map(|other| {
                let end = other.from + other.over;
                let shared = one.by.iter().find(|dof| other.by.contains(dof)).filter(|_| end > one.from);
                shared.map(|dof| (*dof, end))
            });
            if let Some((dof, end)) = busy {
                let name = self.names.name(dof);
                let message =
                    format!("'{name}' is still reaching for something else until {end} s; begin later");
                self.reader.fault(one.place.clone(), message);
            }
        }
    }

    /// The degrees of freedom that are asked about whose motion is known before the run; what carries a link, does not reach for it and
    /// is not known is a fault.
    fn known(&mut self, asked: &[Asked]) -> Vec<usize> {
        let Some(simulation) = self.simulation.clone() else { return Vec::new() };
        let figure = simulation.figure();
        let mut found = Vec::new();
        for one in asked {
            let followed = one.what.followed();
            let links = std::iter::once((one.link, one.name.as_str()));
            let links = links.chain(followed.map(|link| (link, figure.links()[link].name())));
            for (i, (link, name)) in links.enumerate() {
                let carriers = carriers(figure, link);
                let moved = |dof: &&usize| asked.iter().any(|other| other.by.contains(dof));
                let (moved, others): (Vec<&usize>, Vec<&usize>) = carriers.iter().partition(moved);
                let follows = |dof: usize| {
                    let leader = leader(figure, dof);
                    leader != dof && asked.iter().any(|other| other.by.contains(&leader))
                };
                let unknown = others
                    .iter()
                    .rfind(|dof| follows(***dof) || !is_known(&simulation, ***dof, &self.sequenced));
                if let Some(dof) = unknown {
                    let message = self.unknown(**dof, name, i == 0);
                    self.reader.fault(one.place.clone(), message);
                }
                let own = carriers.iter().find(|dof| i == 1 && one.by.contains(dof));
                if let Some(dof) = own {
                    let message = format!(
                        "'{name}' is followed and moves with '{}', which is to move after it; follow something that it does not carry",
                        self.names.name(*dof)
                    );
                    self.reader.fault(one.place.clone(), message);
                }
                found.extend(others.into_iter().map(|dof| leader(figure, *dof)));
                found.extend(
                    moved.into_iter().copied().filter(|dof| is_known(&simulation, *dof, &self.sequenced)),
                );
            }
        }
        found.sort_unstable();
        found.dedup();
        found
    }

    fn unknown(&self, dof: usize, name: &str, reaches: bool) -> String {
        let dof = self.names.name(dof);
        if reaches {
            return format!(
                "'{dof}' carries '{name}' and does not stand still, so that it is not known where to reach from: freeze it, let it follow a \
                 curve, or name it in 'by'"
            );
        }
        format!(
            "'{dof}' carries '{name}', and where that is to be followed to is not known before the run: freeze it, or let it follow a curve"
        )
    }

    /// What keeps links apart, and all that has to be known beforehand: of what moves these links, too. What is not known before the run is not
    /// kept clear of, nor is one figure of another, nor a link of what it follows, which is to be touched.
    fn clearance(
        &self,
        asked: &[Asked],
        simulation: &Simulation,
        mut known: Vec<usize>,
    ) -> Result<(Clearance, Vec<usize>), String> {
        let figure = simulation.figure();
        let followed: Vec<[usize; 2]> =
            asked.iter().filter_map(|one| Some([one.link, one.what.followed()?])).collect();
        let mut moved: Vec<usize> = asked.iter().flat_map(|one| one.by.iter().copied()).collect();
        moved.sort_unstable();
        moved.dedup();
        let clearance = Clearance::new(figure, &moved, &followed);
        let mut clearance = clearance.map_err(|error| error.to_string())?;
        let member = |link: usize| {
            let name = figure.links()[link].name();
            name.split_once('.').filter(|_| !self.members.is_empty()).map(|(figure, _)| figure)
        };
        clearance.retain(|[a, b], between| {
            let is_told = |dof: &usize| moved.contains(dof) || is_known(simulation, *dof, &self.sequenced);
            let keep = member(a) == member(b) && between.iter().all(is_told);
            known.extend(between.iter().filter(|dof| keep && is_known(simulation, **dof, &self.sequenced)));
            keep
        });
        known.sort_unstable();
        known.dedup();
        Ok((clearance, known))
    }

    /// The motions of all that is asked, over what is known beforehand.
    fn found(
        &mut self,
        asked: &[Asked],
        simulation: &Simulation,
        (known, mut clearance): (&[usize], Clearance),
        duration: f64,
        node: &Node<'_>,
    ) -> Result<Found, Refused> {
        let whole = |why: String| (node.place(), why);
        let figure = simulation.figure();
        let beforehand =
            Beforehand::of(simulation, known, duration).map_err(|error| whole(error.to_string()))?;
        let order = order::of(figure, asked).map_err(|(i, why)| (asked[i].place.clone(), why))?;
        let mut layers = Vec::new();
        for i in order {
            let one = &asked[i];
            let solver = Reach::new(figure, one.link, one.point, &one.by);
            let layer = Layer::new(one, solver.map_err(|error| (one.place.clone(), error.to_string()))?);
            self.within_limits(&layer, &beforehand)?;
            layers.push(layer);
        }
        let tree = Tree::new(figure, Vector3::zeros()).map_err(|error| whole(error.to_string()))?;
        let placed = Placed { workspace: Workspace::new(&tree), tree };
        let times = samples::times(asked, duration, beforehand.is_still()).map_err(whole)?;
        let mut samples = Samples::new(&layers, times, beforehand.is_still());
        let times = samples.times.clone();
        let mut found = Layers::new(figure, &beforehand, &times, layers, placed);
        let cuts = apart::keep(&mut clearance, &times, &mut found);
        let place = |found: &Layers<'_>| found.failed.map_or_else(|| node.place(), |i| found.place(i));
        let cuts = cuts.map_err(|why| (place(&found), why))?;
        let layers;
        (samples.positions, layers) = found.finish();
        let motion = samples.motion(figure, *simulation.gravity(), &beforehand, duration).map_err(whole)?;
        let recorded = RecordedMotion::new(motion).map_err(|error| whole(error.to_string()))?;
        self.follow(&samples, &Arc::new(recorded), node)?;
        // What is followed in part is not there anyway.
        let misses = |layer: &&Layer<'_>| layer.asked.weight >= 1.0 && layer.worst.0 > REACHED;
        let mut notes: Vec<String> = layers.iter().filter(misses).map(note).collect();
        notes.extend(self.cuts(&cuts));
        Ok((notes, samples.dofs()))
    }

    /// Refuses a joint that begins outside its limits, from where there is no way on.
    fn within_limits(&self, layer: &Layer<'_>, beforehand: &Beforehand) -> Result<(), Refused> {
        for (dof, coordinate, [lower, upper]) in layer.moves() {
            let x = beforehand.at(dof, coordinate, layer.asked.from).position;
            if x < lower - REACHED || x > upper + REACHED {
                let shown = |x: f64| {
                    if self.names.turn(Some(&super::names::Meant::of(dof))) {
                        format!("{:.2}°", x.to_degrees())
                    } else {
                        format!("{x} m")
                    }
                };
                let message = format!(
                    "'{}' is at {} when this begins, outside its limits from {} to {}; begin inside",
                    self.names.name(dof),
                    shown(x),
                    shown(lower),
                    shown(upper)
                );
                return Err((layer.asked.place.clone(), message));
            }
        }
        Ok(())
    }

    /// Lets the joints follow what was found; those that begin with the run begin as that does.
    fn follow(
        &mut self,
        samples: &Samples,
        recorded: &Arc<RecordedMotion>,
        node: &Node<'_>,
    ) -> Result<(), Refused> {
        let Some(simulation) = &mut self.simulation else { return Ok(()) };
        let refused = |error: solaris_modes::SetupError| (node.place(), crate::spelled::setup(&error));
        let (mut q, mut v) = (simulation.state().0.to_vec(), simulation.state().1.to_vec());
        for moved in &samples.moved {
            let mut steps: Vec<Step> = Vec::new();
            if moved.from > 0.0 && samples.still {
                steps.push(Step { drive: Drive::Frozen, until: EndCondition::Time(moved.from) });
            }
            steps.push(Drive::Recorded(Arc::clone(recorded)).into());
            simulation.drive(self.names.name(moved.dof), steps).map_err(refused)?;
            if moved.at_once {
                let sample = recorded.at(moved.dof, moved.coordinate, 0.0);
                (q[moved.coordinate], v[moved.dof]) = (sample.position, sample.velocity);
            }
        }
        simulation.set_start(&q, &v).map_err(refused)
    }
}

/// What there is to say where something is not where it should be.
fn note(layer: &Layer<'_>) -> String {
    let (verb, unit, per) = layer.asked.what.verb();
    let (off, when) = layer.worst;
    let amount =
        if unit == "mm" { format!("{:.1} mm", per * off) } else { format!("{:.2}{unit}", per * off) };
    format!(
        "'{}' cannot {verb}: at {when:.3} s it is {amount} away, as near as its joints come",
        layer.asked.name
    )
}
