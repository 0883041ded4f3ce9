//! Loops of files: what a scene closes of them, and what it leaves open and says so.

use solaris_model::text::read as read_figure;
use solaris_model::{Figure, Tie, TieEnd, TieLaw, Vector3};
use solaris_modes::LoopKind;
use solaris_scene::{Loader, Scene, read};

/// Two rods on hinges beside each other, and what a file holds together of them.
struct Rods;

impl Loader for Rods {
    fn figure(&mut self, _path: &str) -> Result<Figure, String> {
        let rod = |name: &str, x: f64| {
            format!(
                "Link(name: \"{name}\", parent: \"post\", joint: Joint(name: \"{name}\", at: ({x}, 0, 0), axes: [rz]), mass: 1, com: (0, -0.2, 0), inertia: (0.02, 0.01, 0.02))"
            )
        };
        let text = format!(
            "Figure(version: 1, name: \"rods\", links: [Link(name: \"post\", joint: Joint(name: \"floor\")), {}, {}])",
            rod("one", 0.0),
            rod("two", 0.3)
        );
        read_figure(&text).map_err(|error| error.to_string())
    }

    fn ties(&mut self, path: &str) -> Result<Vec<Tie>, String> {
        if path == "none.urdf" {
            return Err("loops are read of MuJoCo models and of SDF".to_owned());
        }
        let end =
            |link: &str, x: f64| TieEnd { link: Some(link.to_owned()), point: Vector3::new(x, -0.4, 0.0) };
        let tie = |name: &str, between, law| Tie { name: name.to_owned(), between, law };
        let world = || TieEnd { link: None, point: Vector3::new(0.0, -0.4, 0.0) };
        Ok(vec![
            tie("hold", [end("one", 0.3), end("two", 0.0)], TieLaw::Axes),
            tie("gear", [TieEnd::default(), TieEnd::default()], TieLaw::Other("<joint>".to_owned())),
            tie("lost", [end("three", 0.0), end("two", 0.0)], TieLaw::Points),
            tie("nailed", [end("one", 0.0), world()], TieLaw::Points),
        ])
    }
}

fn scene(figures: &str) -> Result<Scene, String> {
    let text = format!("Scene(version: 1, figures: {{{figures}}}, duration: 0.1)");
    read(&text, &mut Rods).map_err(|error| error.to_string())
}

#[test]
fn loops_of_a_file_are_closed_where_a_scene_asks_for_them() {
    let loops = |text: &str| scene(text).expect("valid").simulation().loops().to_vec();
    assert_eq!(loops("\"rods\": File(\"rods.xml\")"), []);
    assert_eq!(loops("\"rods\": File(path: \"rods.xml\", loops: false)"), []);
    let found = loops("\"rods\": File(path: \"rods.xml\", loops: true)");
    assert_eq!(found.iter().map(|one| one.kind).collect::<Vec<_>>(), [LoopKind::Weld, LoopKind::Connect]);
    assert_eq!(found[0].between.map(|anchor| anchor.link), [Some(1), Some(2)]);
    assert_eq!((found[1].between[1].link, found[1].between[1].point.y), (None, -0.4));
}

#[test]
fn loops_that_stay_open_are_told() {
    let said = |figures: &str| scene(figures).expect("valid").notes().join("\n");
    let own = "the loop 'gear' of 'rods' is left open: it is <joint>, not two points that are held together\n\
               the loop 'lost' of 'rods' is left open: there is no link 'three'";
    assert_eq!(said("\"rods\": File(path: \"rods.xml\", loops: true)"), own);
    // Beside another figure the file's world is not the scene's.
    let beside =
        said("\"rods\": File(path: \"rods.xml\", loops: true), \"ann\": Human(height: 1.7, mass: 60)");
    assert!(
        beside.starts_with(own)
            && beside.ends_with(
                "it holds a link to the world, and figures beside each other have places of their own"
            ),
        "{beside}"
    );
    let none = scene("\"rods\": File(path: \"none.urdf\", loops: true)").expect_err("refused");
    assert!(none.contains("'none.urdf': loops are read of MuJoCo models and of SDF"), "{none}");
}
