//! The summary of a scene.

use crate::args::CheckArgs;
use crate::error::CliError;
use crate::findings::list;
use crate::input::{self, extension};
use crate::print::{print, write_json};
use crate::run::{LoadedScene, load, refuse};
use crate::words::{rounded, some};
use serde::Serialize;
use solaris::dynamics::denavit_hartenberg::Summary;
use solaris::model::{Figure, FindingKind, JointKind};
use solaris::modes::{
    ContactLaw, ContactPoint, EndCondition, GroundPlane, LimitLaw, Method, Simulation, Step,
};
use solaris::scene::{Scene, is_scene};
use std::collections::BTreeSet;
use std::io::Write;
use std::path::Path;

/// Whether a file is meant to be a scene. What cannot be read is said by whoever reads it as a figure.
pub(crate) fn is_one(path: &Path) -> bool {
    extension(path) == "ron" && input::text(path).is_ok_and(|text| is_scene(&text))
}

pub(super) fn run(args: &CheckArgs) -> Result<(), CliError> {
    let path = args.file.as_path();
    let LoadedScene { scene, .. } = load(path)?;
    scene.check().map_err(|error| refuse(path, &error, scene.notes()))?;
    let findings = scene.figure().lint();
    let suspects = findings.iter().filter(|finding| finding.kind == FindingKind::Suspect).count();
    let facts = Facts::of(&scene);
    let chains =
        if args.dh { Some(Summary::of(scene.figure()).map_err(CliError::other)?.to_string()) } else { None };
    print(|out| {
        if args.json {
            return write_json(out, &facts);
        }
        facts.write(out)?;
        if let Some(chains) = chains {
            writeln!(out, "\n{}", chains.trim_end())?;
        }
        list(out, &findings)
    })?;
    if args.strict && suspects > 0 {
        return Err(CliError::Strict { path: path.to_owned(), count: suspects });
    }
    Ok(())
}

/// What a scene is, in numbers and words.
#[derive(Serialize)]
struct Facts {
    name: String,
    figure: String,
    links: usize,
    dofs: usize,
    mass_kg: f64,
    gravity_m_s2: [f64; 3],
    duration_s: f64,
    rate_per_s: f64,
    method: String,
    walk_dofs: usize,
    springs: usize,
    #[serde(skip_serializing_if = "Option::is_none")]
    loops: Option<usize>,
    #[serde(skip_serializing_if = "Option::is_none")]
    ground: Option<Ground>,
    #[serde(skip_serializing_if = "Option::is_none")]
    collisions: Option<Collided>,
    drives: Vec<Driven>,
    limits: Vec<Limited>,
}

/// What bodies touch.
#[derive(Serialize)]
struct Ground {
    up: [f64; 3],
    height_m: f64,
    friction: f64,
    contact: String,
    /// How many spheres can touch it.
    touches: usize,
    /// Of how many links.
    links: usize,
}

/// Links that can touch each other.
#[derive(Serialize)]
struct Collided {
    pairs: usize,
    friction: f64,
}

/// Degrees of freedom with the same drives.
#[derive(Serialize)]
struct Driven {
    drives: String,
    dofs: Vec<String>,
}

/// Degrees of freedom whose limits do the same.
#[derive(Serialize)]
struct Limited {
    limits: String,
    dofs: Vec<String>,
}

impl Facts {
    fn of(scene: &Scene) -> Self {
        let (figure, simulation, settings) = (scene.figure(), scene.simulation(), scene.settings());
        let layout = figure.layout();
        let names = |dofs: Vec<usize>| dofs.into_iter().map(|dof| layout.v_names()[dof].clone()).collect();
        let drives = grouped(layout.nv(), |dof| told(simulation.driven_by(dof)));
        let limited = limited(figure);
        let has_limit = |dof: &usize| limited[*dof];
        let limits = grouped(layout.nv(), |dof| law(simulation.limit_of(dof)));
        Self {
            name: scene.name().to_owned(),
            figure: figure.name().to_owned(),
            links: figure.links().len(),
            dofs: layout.nv(),
            mass_kg: figure.mass(),
            gravity_m_s2: (*simulation.gravity()).into(),
            duration_s: settings.duration,
            rate_per_s: settings.rate,
            method: method(simulation, settings.method),
            walk_dofs: scene.walked(),
            springs: simulation.springs().len(),
            loops: Some(simulation.loops().len()).filter(|count| *count > 0),
            collisions: simulation
                .collisions()
                .map(|collisions| Collided { pairs: collisions.pairs.len(), friction: collisions.friction }),
            ground: simulation.grounded().map(|(plane, touches)| Ground::of(plane, touches)),
            drives: drives.into_iter().map(|(drives, dofs)| Driven { drives, dofs: names(dofs) }).collect(),
            limits: limits
                .into_iter()
                .map(|(limits, dofs)| (limits, dofs.into_iter().filter(has_limit).collect::<Vec<_>>()))
                .filter(|(_, dofs)| !dofs.is_empty())
                .map(|(limits, dofs)| Limited { limits, dofs: names(dofs) })
                .collect(),
        }
    }

    fn write(&self, out: &mut dyn Write) -> std::io::Result<()> {
        writeln!(out, "Scene '{}'\n", self.name)?;
        let mut row = |what: &str, value: String| writeln!(out, "  {what:<24}{value}");
        row("figure", self.figure.clone())?;
        row("links", self.links.to_string())?;
        row("degrees of freedom", self.dofs.to_string())?;
        row("mass", format!("{} kg", rounded(self.mass_kg)))?;
        let [x, y, z] = self.gravity_m_s2;
        row("gravity", format!("({x}, {y}, {z}) m/s²"))?;
        row("lasts", format!("{} s, {} frames a second", rounded(self.duration_s), self.rate_per_s))?;
        row("method", self.method.clone())?;
        if self.springs > 0 {
            row("springs between points", self.springs.to_string())?;
        }
        if let Some(loops) = self.loops {
            row("closed loops", loops.to_string())?;
        }
        if let Some(ground) = &self.ground {
            row("ground", format!("height {} m, friction {}", ground.height_m, ground.friction))?;
            row("contact", ground.contact.clone())?;
            row("can touch it", format!("{} spheres of {} links", ground.touches, ground.links))?;
        }
        if let Some(Collided { pairs, friction }) = self.collisions {
            row("can touch each other", format!("{pairs} pairs of links, friction {friction}"))?;
        }
        writeln!(out, "\nDrives\n")?;
        for Driven { drives, dofs } in &self.drives {
            writeln!(out, "  {drives:<24}{:>4}  {}", dofs.len(), some(dofs))?;
        }
        if !self.limits.is_empty() {
            writeln!(out, "\nLimits of joints, where dynamics move them\n")?;
            for Limited { limits, dofs } in &self.limits {
                writeln!(out, "  {limits:<24}{:>4}  {}", dofs.len(), some(dofs))?;
            }
        }
        Ok(())
    }
}

impl Ground {
    fn of(plane: &GroundPlane, touches: &[ContactPoint]) -> Self {
        let links: BTreeSet<usize> = touches.iter().map(|touch| touch.link).collect();
        let contact = match plane.law {
            ContactLaw::Compliant { stiffness, damping, slip } => {
                format!("spring {stiffness:.4e} N/m, damping {damping} s/m, slip {slip} m/s")
            }
            ContactLaw::Rigid => "rigid: what touches stays until the ground would pull".to_owned(),
            _ => "another".to_owned(),
        };
        Self {
            up: plane.up.into_inner().into(),
            height_m: plane.height,
            friction: plane.friction,
            contact,
            touches: touches.len(),
            links: links.len(),
        }
    }
}

/// Of each degree of freedom, whether it has limits.
fn limited(figure: &Figure) -> Vec<bool> {
    let links = figure.links().iter();
    let limited = links.flat_map(|link| match link.joint().kind() {
        JointKind::Axes(dofs) => dofs.iter().map(|dof| dof.limits.is_some()).collect(),
        kind => vec![false; kind.nv()],
    });
    limited.collect()
}

/// What each text is said of, in the order of their first.
fn grouped(count: usize, text: impl Fn(usize) -> String) -> Vec<(String, Vec<usize>)> {
    let mut groups: Vec<(String, Vec<usize>)> = Vec::new();
    for dof in 0..count {
        let text = text(dof);
        match groups.iter_mut().find(|(other, _)| *other == text) {
            Some((_, dofs)) => dofs.push(dof),
            None => groups.push((text, vec![dof])),
        }
    }
    groups
}

/// Drives one after the other.
fn told(steps: &[Step]) -> String {
    let step = |Step { drive, until }: &Step| {
        let until = match until {
            EndCondition::Time(time) => format!(" until {time} s"),
            EndCondition::Lasting(time) => format!(" for {time} s"),
            EndCondition::Position { dof, .. } => format!(" until {dof} passes"),
            EndCondition::Velocity { dof, .. } => format!(" until the speed of {dof} passes"),
            EndCondition::TouchDown { link } => format!(" until {link} touches the ground"),
            EndCondition::LiftOff { link } => format!(" until {link} leaves the ground"),
            _ => String::new(),
        };
        format!("{}{until}", drive.name())
    };
    steps.iter().map(step).collect::<Vec<_>>().join(", ")
}

fn law(law: LimitLaw) -> String {
    match law {
        LimitLaw::Hard { restitution } => format!("hard, restitution {restitution}"),
        LimitLaw::Spring { stiffness, damping } => format!("spring {stiffness}, damper {damping}"),
        _ => "ignored".to_owned(),
    }
}

fn method(simulation: &Simulation, method: Method) -> String {
    match method {
        Method::Usual => self::method(simulation, simulation.usual_method()),
        Method::Fixed { rule, step } => format!("{rule}, step at most {step} s"),
        Method::Impulses { step } => format!("impulses, step at most {step} s"),
        Method::Adaptive { tolerance } => format!("adaptive explicit, tolerance {tolerance:e}"),
        Method::Stiff { tolerance } => format!("stiff implicit, tolerance {tolerance:e}"),
        Method::Automatic { tolerance } => format!("whichever meets the tolerance {tolerance:e} rad or m"),
        _ => "another".to_owned(),
    }
}
