//! Evidence about a motion's feet: soles, stances, forces, and who says so.

use crate::args::{AskedLevel, MetricsArgs, StancesFrom};
use crate::error::CliError;
use crate::given::Given;
use crate::ground::{Ground, SolesFrom, Standing, find_soles, known_soles};
use solaris::analysis::PreparedMotion;
use solaris::analysis::ground::{PlacedFeet, Sole, StanceOptions, Stances};
use solaris::gait::metrics::{MetricsInput, stances_of_contacts};
use solaris::io::record::{force_prefixes, forces};
use solaris::model::ContactTrack;

/// Feet, stances, forces.
pub(super) struct Evidence<'a> {
    prepared: &'a PreparedMotion<'a>,
    /// None where nobody knows them.
    feet: Option<PlacedFeet<'a>>,
    pub(super) soles_from: String,
    pub(super) stances: Option<Stances>,
    pub(super) belt_from: &'static str,
    pub(super) level_from: &'static str,
    pub(super) contacts: Option<Vec<ContactTrack>>,
    pub(super) forces_from: &'static str,
}

impl<'a> Evidence<'a> {
    pub(super) fn find(
        args: &MetricsArgs,
        given: &Given,
        prepared: &'a PreparedMotion<'a>,
    ) -> Result<Self, CliError> {
        let (feet, how) = (&args.feet, &args.how);
        // Who asks for forces or stances of feet that nobody knows is told what to do.
        let needs_feet = feet.ground || feet.stances.is_some();
        let file = how.soles.as_deref();
        let found = if needs_feet { Some(find_soles(file, given)?) } else { known_soles(file, given)? };
        let Some((soles, from)) = found else { return Ok(Self::of_no_feet(prepared)) };
        let speed = how.stance_speed.as_ref().map_or(StanceOptions::SPEED, |speed| speed.value);
        let ground = Ground { how, frame: &args.frame, told: None, soles, from };
        let placed = ground.feet(given, prepared)?;
        let Standing { mut stances, belt_from } = ground.standing(given, &placed, speed)?;
        let soles = placed.soles();
        let level_from = match (feet.level, &ground.from) {
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
        let own = own_contacts(given, soles)?;
        match (&own, feet.stances) {
            (None, Some(StancesFrom::Contacts)) => return Err(no_contacts(soles)),
            (Some(own), None | Some(StancesFrom::Contacts)) => {
                let (figure, gravity) = (&given.body.figure, given.body.gravity);
                stances = stances_of_contacts(figure, gravity, given.motion().time(), own, &stances);
                stances.footings = placed.footings(&stances.list, &stances.belt);
            }
            _ => {}
        }
        let (contacts, forces_from) = if feet.ground {
            let found = ground.forces(given, &placed, stances.clone())?;
            (Some(found.contacts), "predicted from the motion")
        } else if own.is_some() {
            (own, "of the motion's file")
        } else {
            (None, "none; --ground predicts them")
        };
        Ok(Self {
            prepared,
            feet: Some(placed),
            soles_from: ground.from.describe(),
            stances: Some(stances),
            belt_from,
            level_from,
            contacts,
            forces_from,
        })
    }

    fn of_no_feet(prepared: &'a PreparedMotion<'a>) -> Self {
        Self {
            prepared,
            feet: None,
            soles_from: "none; --soles says where its feet meet the ground".to_owned(),
            stances: None,
            belt_from: "",
            level_from: "",
            contacts: None,
            forces_from: "none",
        }
    }

    /// The soles of the feet.
    pub(super) fn soles(&self) -> &[Sole] {
        self.feet.as_ref().map_or(&[], PlacedFeet::soles)
    }

    /// All of it as the library takes it.
    pub(super) fn input(&self) -> MetricsInput<'_> {
        MetricsInput {
            motion: self.prepared,
            feet: self.feet.as_ref(),
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
