//! Lengths and masses without measure, in every format of figures.

use solaris_io::{mjcf, opensim, sdf, urdf};
use solaris_model::Figure;

/// One body with its centre of mass `far` from its origin, and a solid of this mass, in each format.
fn texts(far: f64, mass: f64) -> [(&'static str, String); 4] {
    let urdf = format!(
        "<robot name='r'><link name='a'/><link name='b'><inertial><origin xyz='0 {far} 0'/><mass value='{mass}'/><inertia ixx='1' ixy='0' \
         ixz='0' iyy='1' iyz='0' izz='1'/></inertial></link><joint name='j' type='revolute'><parent link='a'/><child link='b'/><axis \
         xyz='1 0 0'/><limit effort='1' velocity='1' lower='-1' upper='1'/></joint></robot>"
    );
    let mjcf = format!(
        "<mujoco><worldbody><body name='b'><joint axis='1 0 0'/><inertial pos='0 {far} 0' mass='{mass}' diaginertia='1 1 1'/></body>\
         </worldbody></mujoco>"
    );
    let sdf = format!(
        "<sdf version='1.9'><model name='m'><link name='b'><inertial><pose>0 {far} 0 0 0 0</pose><mass>{mass}</mass><inertia><ixx>1</ixx>\
         <iyy>1</iyy><izz>1</izz></inertia></inertial></link></model></sdf>"
    );
    let opensim = format!(
        "<OpenSimDocument Version='40000'><Model name='m'><BodySet><objects><Body name='b'><mass>{mass}</mass><mass_center>0 {far} 0\
         </mass_center><inertia>1 1 1 0 0 0</inertia></Body></objects></BodySet><JointSet><objects><PinJoint name='j'>\
         <socket_parent_frame>/ground</socket_parent_frame><socket_child_frame>/bodyset/b</socket_child_frame><coordinates><Coordinate \
         name='q'/></coordinates></PinJoint></objects></JointSet></Model></OpenSimDocument>"
    );
    [("urdf", urdf), ("mjcf", mjcf), ("sdf", sdf), ("opensim", opensim)]
}

fn read(format: &str, text: &str) -> Result<Figure, String> {
    let read = match format {
        "urdf" => urdf::read(text),
        "mjcf" => mjcf::read(text),
        "sdf" => sdf::read(text),
        _ => opensim::read(text),
    };
    read.map(|import| import.figure).map_err(|error| error.to_string())
}

#[test]
fn lengths_and_masses_are_taken_up_to_their_measure_and_not_beyond_in_every_format() {
    let (far, heavy) = (Figure::LONGEST, Figure::HEAVIEST);
    for (format, text) in texts(far, heavy) {
        let figure = read(format, &text).unwrap_or_else(|error| panic!("{format}: {error}"));
        assert!(figure.mass() >= heavy, "{format}");
    }
    for (format, text) in texts(far * 1.000_001, 1.0) {
        let error = read(format, &text).expect_err(format);
        assert!(error.contains("it must be at most 1e9"), "{format}: {error}");
    }
    for (format, text) in texts(1.0, heavy * 1.000_001) {
        let error = read(format, &text).expect_err(format);
        assert!(error.contains("it must be at most 1e20"), "{format}: {error}");
    }
}
