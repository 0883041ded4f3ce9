//! Evidence about a motion's feet: soles, stances, forces, and who says so.

use crate::args::{AskedLevel, MetricsArgs, StancesFrom};
use crate::error::CliError;
use crate::given::Given;
use crate::ground::{Ground, SolesFrom, find_soles, known_soles, refused, standing};
use solaris::analysis::PreparedMotion;
use solaris::analysis::ground::{GroundOptions, Sole, StanceOptions, Stances, ground_forces};
use solaris::gait::metrics::{MetricsInput, stances_of_contacts};
use solaris::io::record::{force_prefixes, forces};
use solaris::model::ContactTrack;

/// Feet, stances, forces.
pub(super) struct Evidence {
    pub(super) soles: Vec<Sole>,
    pub(super) soles_from: String,
    pub(super) stances: Option<Stances>,
    pub(super) belt_from: &'static str,
    pub(super) level_from: &'static str,
    pub(super) contacts: Option<Vec<ContactTrack>>,
    pub(super) forces_from: &'static str,
}

impl Evidence {
    pub(super) fn find(args: &MetricsArgs, given: &Given) -> Result<Self, CliError> {
        let (feet, how) = (&args.feet, &args.how);
        // Who asks for forces or stances of feet that nobody knows is told what to do.
        let needs_feet = feet.ground || feet.stances.is_some();
        let file = how.soles.as_deref();
        let found = if needs_feet { Some(find_soles(file, given)?) } else { known_soles(file, given)? };
        let Some((soles, from)) = found else { return Ok(Self::of_no_feet()) };
        let default = StanceOptions::default().speed;
        let speed = how.stance_speed.as_ref().map_or(default, |speed| speed.value);
        let asked = Ground { how, frame: &args.frame };
        let (mut stances, stance, belt_from) = standing(asked, given, &soles, &from, speed)?;
        let level_from = match (feet.level, &from) {
            (Some(AskedLevel::At(level)), _) => {
                stances.level = level;
                "as asked"
            }
            (None, SolesFrom::Figure) => {
                stances.level = 0.0;
                "where figures with soles of their own stand"
            }
            _ => "where the soles are lowest",
        };
        let own = own_contacts(given, &soles)?;
        match (&own, feet.stances) {
            (None, Some(StancesFrom::Contacts)) => return Err(no_contacts(&soles)),
            (Some(own), None | Some(StancesFrom::Contacts)) => {
                let (figure, gravity) = (&given.body.figure, given.body.gravity);
                stances = stances_of_contacts(figure, gravity, given.motion().time(), own, &stances);
            }
            _ => {}
        }
        let (contacts, forces_from) = if feet.ground {
            let split = how.split.unwrap_or_default();
            let options = GroundOptions { split, stance, stances: Some(stances.clone()) };
            let found = ground_forces(&given.prepared()?, &soles, &options)
                .map_err(|error| refused(&error, asked, given, &from))?;
            (Some(found.contacts), "predicted from the motion")
        } else if own.is_some() {
            (own, "of the motion's file")
        } else {
            (None, "none; --ground predicts them")
        };
        Ok(Self {
            soles,
            soles_from: from.describe(),
            stances: Some(stances),
            belt_from,
            level_from,
            contacts,
            forces_from,
        })
    }

    fn of_no_feet() -> Self {
        Self {
            soles: Vec::new(),
            soles_from: "none; --soles says where its feet meet the ground".to_owned(),
            stances: None,
            belt_from: "",
            level_from: "",
            contacts: None,
            forces_from: "none",
        }
    }

    /// All of it as the library takes it.
    pub(super) fn input<'a>(&'a self, motion: &'a PreparedMotion<'a>) -> MetricsInput<'a> {
        MetricsInput {
            motion,
            soles: &self.soles,
            stances: self.stances.as_ref(),
            contacts: self.contacts.as_deref(),
        }
    }
}

/// The forces on each sole that stand in the motion's own table; none where one is missing.
fn own_contacts(given: &Given, soles: &[Sole]) -> Result<Option<Vec<ContactTrack>>, CliError> {
    let prefixes = force_prefixes(&given.table);
    if !soles.iter().all(|sole| prefixes.contains(&sole.name)) {
        return Ok(None);
    }
    let track = |sole: &Sole| {
        let record = forces(&given.table, std::slice::from_ref(&sole.name), &sole.name);
        let record = record.map_err(|error| CliError::input(&given.from, &error))?;
        Ok(ContactTrack { link: sole.name.clone(), samples: record.samples })
    };
    soles.iter().map(track).collect::<Result<_, _>>().map(Some)
}

fn no_contacts(soles: &[Sole]) -> CliError {
    let names: Vec<String> = soles.iter().map(|sole| format!("{}.fx", sole.name)).collect();
    let why = format!("the motion's file has no forces on its soles ({} …); leave it out", names.join(", "));
    CliError::option("stances", "contacts", why)
}
