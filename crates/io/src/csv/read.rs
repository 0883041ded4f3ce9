//! A table to a motion.

use super::read_table;
use crate::error::IoError;
use crate::table::{CONTACT, TAU, TIME, heading};
use solaris_model::{Contact, ContactTrack, Figure, Motion, MotionInfo, Vector3};
use std::collections::HashMap;

/// How far a frame may be from `1/rate`, relative: times are often printed with few digits.
const FRAME_TOLERANCE: f64 = 0.01;

/// Reads a table that [`write`](super::write()) has written, or any other with the same columns in any order.
///
/// Every degree of freedom needs its `.q`, `.v` and `.a`; `.tau` and contacts are there whole or not at all. Times start
/// anywhere and go on by `1/info.rate`, to 1 %. What a table does not hold comes from `info`; events and planted
/// intervals of the result are empty. [`frame_rate`] finds the rate of a table.
///
/// # Errors
///
/// [`IoError`] with the line and the column, both from 1, of what is wrong; a rate that is not one; `info` with the
/// fingerprint of another figure.
pub fn read(figure: &Figure, text: &str, info: MotionInfo) -> Result<Motion, IoError> {
    if !(info.rate > 0.0 && info.rate <= MotionInfo::HIGHEST_RATE) {
        return Err(solaris_model::MotionError::Rate { rate: info.rate }.into());
    }
    let table = read_table(text)?;
    let columns = Columns::find(figure, &table.columns)?;
    let mut time = Vec::with_capacity(table.len());
    let mut parts: [Vec<f64>; 4] = Default::default();
    let mut contacts: Vec<Vec<Contact>> = vec![Vec::new(); columns.contacts.len()];
    for (index, &line) in table.lines.iter().enumerate() {
        let row = table.row(index);
        time.push(row[columns.time]);
        if let [.., before, now] = time[..]
            && ((now - before) * info.rate - 1.0).abs() > FRAME_TOLERANCE
        {
            let (column, step, rate) = (columns.time + 1, now - before, info.rate);
            return Err(IoError::Time { line, column, time: now, step, rate });
        }
        for (part, from) in parts.iter_mut().zip(&columns.parts) {
            part.extend(from.iter().map(|&column| row[column]));
        }
        for (samples, (_, from)) in contacts.iter_mut().zip(&columns.contacts) {
            let vector = |i: usize| Vector3::new(row[from[i]], row[from[i + 1]], row[from[i + 2]]);
            samples.push(Contact { force: vector(0), moment: vector(3), cop: vector(6) });
        }
    }
    let [q, v, a, tau] = parts;
    let mut motion = Motion::new(figure, info, time, [q, v, a])?;
    motion.check_figure(figure)?;
    if !columns.parts[3].is_empty() {
        motion.set_tau(tau)?;
    }
    let links = columns.contacts.into_iter().map(|(link, _)| link);
    motion.contacts = links.zip(contacts).map(|(link, samples)| ContactTrack { link, samples }).collect();
    Ok(motion)
}

/// The frames a second (1/s) of a table: its rows by the time from the first to the last; `None` for fewer than two rows
/// or times that do not rise.
///
/// # Errors
///
/// A text that is no table of numbers, or has no column `time`.
pub fn frame_rate(text: &str) -> Result<Option<f64>, IoError> {
    let table = read_table(text)?;
    let column = table.column(TIME).ok_or_else(|| missing(TIME))?;
    let [first, .., last] = &table.values_of(column).collect::<Vec<f64>>()[..] else { return Ok(None) };
    let rate = (table.len() - 1) as f64 / (last - first);
    Ok((rate.is_finite() && rate > 0.0).then_some(rate))
}

/// Where in a row each number of a motion stands.
struct Columns {
    time: usize,
    /// Of q, v, a and tau; the last is empty where the table has none.
    parts: [Vec<usize>; 4],
    contacts: Vec<(String, [usize; 9])>,
}

impl Columns {
    fn find(figure: &Figure, header: &[String]) -> Result<Self, IoError> {
        let places: HashMap<&str, usize> =
            header.iter().enumerate().map(|(column, name)| (name.as_str(), column)).collect();
        let mut used = vec![false; header.len()];
        let mut take = |column: String| match places.get(column.as_str()) {
            Some(&place) => {
                used[place] = true;
                Ok(place)
            }
            None => Err(IoError::MissingColumn { column }),
        };
        let (q, v) = (figure.layout().q_names(), figure.layout().v_names());
        let has_tau = v.iter().any(|name| places.contains_key(heading(name, TAU).as_str()));
        let tau = if has_tau { v } else { &[] };
        let time = take(TIME.to_owned())?;
        let mut part =
            |names: &[String], ending| names.iter().map(|name| take(heading(name, ending))).collect();
        let parts: [Result<Vec<usize>, IoError>; 4] =
            [part(q, "q"), part(v, "v"), part(v, "a"), part(tau, TAU)];
        let [q, v, a, tau] = parts;
        let mut contacts = Vec::new();
        for link in links_with_contacts(figure, header) {
            let mut from = [0; 9];
            for (place, ending) in from.iter_mut().zip(CONTACT) {
                *place = take(heading(&link, ending))?;
            }
            contacts.push((link, from));
        }
        let found = Self { time, parts: [q?, v?, a?, tau?], contacts };
        match used.iter().position(|used| !used) {
            None => Ok(found),
            Some(i) => {
                let (name, figure) = (header[i].clone(), figure.name().to_owned());
                Err(IoError::UnknownColumn { column: i + 1, name, figure })
            }
        }
    }
}

/// The links of the figure that some column of the header gives a contact, in the order of the header.
fn links_with_contacts(figure: &Figure, header: &[String]) -> Vec<String> {
    let mut links: Vec<String> = Vec::new();
    for name in header {
        let Some((link, ending)) = name.rsplit_once('.') else { continue };
        let is_new = !links.iter().any(|known| known == link);
        if is_new && CONTACT.contains(&ending) && figure.link_index(link).is_some() {
            links.push(link.to_owned());
        }
    }
    links
}

fn missing(column: &str) -> IoError {
    IoError::MissingColumn { column: column.to_owned() }
}
