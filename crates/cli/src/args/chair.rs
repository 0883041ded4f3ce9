//! The request of `solaris chair`.

use super::value::{Number, count, within};
use super::walk::{Count, MotionFiles, WhoArgs};
use super::{HEIGHT, RATE, wrap};
use clap::Args;
use solaris::gait::CHAIR_TIMES;

const EXAMPLES: &str = "Examples:
  solaris chair -o rise.html
      a person of 1.75 m stands up from a seat of 0.45 m; open rise.html in a browser
  solaris chair --seat-height 0.38 --shank 20 --duration 2.5 -o low.html
      from a low seat, the feet well back, slowly
  solaris chair --sit -o sit.bvh
      sits down, as motion capture
  solaris chair --times 5 --report five.json
      stands up and sits down five times, and its numbers as JSON";

/// Somebody and a seat.
#[derive(Debug, Args)]
#[command(about = "A person stands up from a seat, or sits down", after_help = EXAMPLES)]
pub(crate) struct ChairArgs {
    #[command(flatten)]
    pub(crate) files: MotionFiles,
    #[command(flatten, next_help_heading = "The person")]
    pub(crate) who: WhoArgs,
    #[command(flatten, next_help_heading = "The seat")]
    pub(crate) seat: SeatArgs,
}

/// How somebody stands up or sits down.
#[derive(Debug, Args)]
pub(crate) struct SeatArgs {
    #[arg(long, value_name = "M", allow_hyphen_values = true, help = wrap(&format!(
        "Height of the seat, 0.19 to 0.36 of the standing height [default: 0.257 of it, {:.2} m at {HEIGHT} m]",
        0.45 / 1.75 * HEIGHT
    )))]
    pub(crate) seat_height: Option<Number>,
    #[arg(long, value_name = "S", allow_hyphen_values = true, help = wrap(&format!(
        "How long it takes to stand up or to sit down, 1.4 to 4 s at a height of {HEIGHT} m; others' goes with its root, and 0.4 s go by at rest before, between and after [default: 1.9]"
    )))]
    pub(crate) duration: Option<Number>,
    #[arg(long, value_name = "DEGREES", allow_hyphen_values = true, help = wrap(
        "How far the shanks lean forward in sitting, 8 to 25°: the more, the farther back the feet are [default: 15]"
    ))]
    pub(crate) shank: Option<Number>,
    #[arg(long, conflicts_with = "times", help = "Sit down instead [default: stand up]")]
    pub(crate) sit: bool,
    #[arg(long, value_name = "N", allow_hyphen_values = true, value_parser = count("times", CHAIR_TIMES.0, CHAIR_TIMES.1), help = wrap(&format!(
        "Stand up and sit down again, so many times, {} to {} [default: stand up once]", CHAIR_TIMES.0, CHAIR_TIMES.1
    )))]
    pub(crate) times: Option<Count>,
    #[arg(
        long, value_name = "FRAMES/S", allow_hyphen_values = true, value_parser = within("rate", RATE.1, RATE.2, " frames/s"),
        help = wrap(&format!("Samples a second of the motion, {} to {} [default: {}]", RATE.1, RATE.2, RATE.0))
    )]
    pub(crate) rate: Option<f64>,
}
