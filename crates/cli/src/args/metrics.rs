//! The options of `solaris metrics`.

use super::{given, ground, input, json, path, walk, wrap};
use clap::builder::ValueParser;
use clap::{Arg, ArgAction, Command};

const EXAMPLES: &str = "Examples:
  solaris metrics walk.csv
      a walk of `solaris walk`, with the forces that stand in its file
  solaris metrics walk.csv --height 1.75 --stances feet --ground -o metrics.json -o metrics.csv
      the same from its positions alone: stances from how the feet move, forces predicted; both files
  solaris metrics walk.mot --figure subject.osim --soles soles.ron --filter 6Hz --ground
      a measured walk of any figure";

pub(super) fn command() -> Command {
    let ground = ground::options().map(|option| match option.get_id().as_str() {
        "split" => option.requires("ground"),
        "belt" => option.help(wrap(
            "How the ground itself moves, on a treadmill: its speed in m/s, along the feet on it; still; or as the feet on \
             it tell (auto) [default: still, unless the feet on it are faster than --stance-speed]",
        )),
        _ => option,
    });
    Command::new("metrics")
        .about("Foot slide, sink, steps, force peaks, smoothness: numbers of any motion of any figure with feet")
        .after_help(EXAMPLES)
        .arg(input("motion", "MOTION", given::MOTION))
        .arg(path("output").short('o').action(ArgAction::Append).help(wrap(
            "Write the numbers: .json, or .csv with a metric a row; several are allowed [default: none]",
        )))
        .arg(json("Print the numbers as JSON instead of a table"))
        .next_help_heading("The figure")
        .arg(path("figure").conflicts_with_all(["height", "mass"]).help(wrap(&format!(
            "Who moves: {} [default: a human of this height and mass]",
            given::FIGURE.replacen('A', "a", 1)
        ))))
        .args(walk::person())
        .args(given::figure())
        .next_help_heading("The ground")
        .arg(
            Arg::new("ground")
                .long("ground")
                .action(ArgAction::SetTrue)
                .help(wrap("Predict the ground's forces from the motion, as `solaris ground` does, for their peaks")),
        )
        .arg(
            Arg::new("stances")
                .long("stances")
                .value_name("contacts|feet")
                .value_parser(["contacts", "feet"])
                .hide_possible_values(true)
                .help(wrap(
                    "What tells which foot stands: the forces in the motion's own file (NAME.fx … of each sole), or how the feet \
                     move [default: contacts where the file has them]",
                )),
        )
        .arg(
            Arg::new("level")
                .long("level")
                .value_name("M|feet")
                .allow_hyphen_values(true)
                .value_parser(ValueParser::new(parse_level))
                .help(wrap(
                    "Height of the ground along up in m, or where the soles are lowest (feet), which hides that all of the motion \
                     sinks [default: 0 where the figure has soles of its own, else feet]",
                )),
        )
        .args(ground)
        .next_help_heading("The motion")
        .args(given::motion())
}

/// How high the ground is.
#[derive(Clone, Copy, Debug)]
pub(crate) enum AskedLevel {
    Feet,
    /// Height along up (m).
    At(f64),
}

fn parse_level(text: &str) -> Result<AskedLevel, String> {
    match text.parse::<f64>() {
        _ if text == "feet" => Ok(AskedLevel::Feet),
        Ok(level) if level.is_finite() => Ok(AskedLevel::At(level)),
        _ => Err("it must be a height in m, such as 0 or -0.012, or feet".to_owned()),
    }
}
