//! Two people and their clips in one file for a game engine: `cargo run --release -p solaris --example clips -- clips.glb`.

use solaris::analysis::ground_reactions;
use solaris::gait::FEET;
use solaris::io::glb::{self, Actor, Clip, Options};
use solaris::prelude::*;
use std::error::Error;
use std::fs::File;
use std::io::BufWriter;

/// Frames a second.
const RATE: f64 = 30.0;

fn main() -> Result<(), Box<dyn Error>> {
    let path = std::env::args().nth(1).unwrap_or_else(|| "clips.glb".to_owned());
    let (ann, bo) = (human(1.65, 58.0)?, human(1.90, 95.0)?);
    let walked = |figure: &Figure, step_frequency: f64| -> Result<_, Box<dyn Error>> {
        let request = WalkRequest {
            step_frequency: Some(step_frequency),
            extent: Extent::Steps(4),
            ..WalkRequest::default()
        };
        let plan = walk(figure, &request)?;
        let mut motion = plan.motion(figure, RATE)?;
        // With forces, so that there are arrows to show.
        ground_reactions(figure, &mut motion, FEET, &plan)?;
        Ok(motion)
    };
    let motions = [walked(&ann, 115.0)?, walked(&bo, 95.0)?, walked(&ann, 80.0)?];
    let clips = [
        Clip { name: "both", motions: vec![(0, &motions[0]), (1, &motions[1])] },
        Clip { name: "Ann strolls", motions: vec![(0, &motions[2])] },
    ];
    let actors =
        [Actor { name: "Ann", figure: &ann, skin: None }, Actor { name: "Bo", figure: &bo, skin: None }];
    let options = Options { forces: true, ..Options::default() };
    glb::write(&actors, &clips, options, &mut BufWriter::new(File::create(&path)?))?;
    Ok(())
}
