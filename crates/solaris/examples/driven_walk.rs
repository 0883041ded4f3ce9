//! A character under somebody's fingers: keys over time become commands, and the walker walks, turns, strafes and stops as they say.
//!
//! ```sh
//! cargo run --release -p solaris --example driven_walk
//! ```

use solaris::prelude::*;
use std::error::Error;

/// Keys that are held, from when to when (s).
const KEYS: [(f64, f64, &str); 6] = [
    (0.5, 4.0, "W"),
    (4.0, 7.5, "W right"),
    (7.5, 10.0, "W shift"),
    (12.0, 15.0, "A"),
    (15.0, 17.0, "S"),
    (18.0, 28.0, "click"),
];

/// What keys ask for, for a character that faces `heading`.
fn command(keys: &str, heading: f64) -> Command {
    match keys {
        "W" => Command::own_velocity(0.0, 1.1),
        "W right" => Command::own_velocity(0.0, 1.0).facing(heading - 0.5),
        "W shift" => Command::own_velocity(0.0, 1.6),
        "A" => Command::own_velocity(0.2, 0.0),
        "S" => Command::own_velocity(0.0, -0.4),
        "click" => Command::to_point(0.0, 2.0, 1.2),
        _ => Command::stop(),
    }
}

#[allow(clippy::print_stdout, reason = "what a game would draw")]
pub(crate) fn main() -> Result<(), Box<dyn Error>> {
    let ann = Human::new(1.65, 58.0).root(RootOrder::Yzx).build()?;
    let mut walker = Walker::new(&ann)?;
    println!("time,keys,x,z,heading,speed");
    let dt = 1.0 / 60.0;
    for frame in 0..31 * 60 {
        let time = f64::from(frame) * dt;
        let keys =
            KEYS.iter().find(|(from, to, _)| (*from..*to).contains(&time)).map_or("", |(.., keys)| keys);
        let pose = walker.step(dt, &command(keys, walker.heading()))?;
        // … here a game gives `pose` to its skeleton.
        assert!(pose.iter().all(|x| x.is_finite()));
        if frame % 30 == 0 {
            let (com, [vx, vz]) = (walker.com(), walker.velocity());
            println!(
                "{time:.1},{keys},{:.2},{:.2},{:.2},{:.2}",
                com.x,
                com.z,
                walker.heading(),
                vx.hypot(vz)
            );
        }
    }
    let [x, z] = walker.place();
    assert!(walker.is_standing() && x.hypot(z - 2.0) < 0.1, "it came to {x}, {z}");
    Ok(())
}
