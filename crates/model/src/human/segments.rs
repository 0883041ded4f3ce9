//! The numbers of the human figure, for a man of 1.741 m (de Leva 1996); see [`crate::human()`].

/// Height for which the lengths below hold (m).
pub(super) const REFERENCE_HEIGHT: f64 = 1.741;

/// Mass for which the damping below holds (kg).
pub(super) const REFERENCE_MASS: f64 = 73.0;

/// One segment, of the left side where there are two. Vectors are x left, y up, z forward (m).
pub(super) struct Segment {
    /// Name, without the side.
    pub(super) name: &'static str,
    /// Parent segment, without the side; empty for the root.
    pub(super) parent: &'static str,
    /// Name of its joint, without the side.
    pub(super) joint: &'static str,
    /// Whether there is a left and a right one.
    pub(super) paired: bool,
    /// Joint centre in the parent's frame.
    pub(super) offset: [f64; 3],
    /// Share of the body's mass.
    pub(super) mass: f64,
    /// Centre of mass.
    pub(super) com: [f64; 3],
    /// Length (m); the radii of gyration are fractions of it.
    pub(super) length: f64,
    /// Radii of gyration about the left, up and forward axes.
    pub(super) gyration: [f64; 3],
    /// Density of its tissue (kg/m³), which says how thick it is drawn.
    pub(super) density: f64,
    /// How it is drawn.
    pub(super) drawn: Drawn,
}

/// How a segment is drawn (m, for the reference height and mass).
pub(super) enum Drawn {
    /// A capsule between two points, as thick as the mass asks for.
    Limb { from: [f64; 3], to: [f64; 3] },
    /// An ellipsoid at `centre` with these semi-axes: upright, and as broad and deep as the mass asks for.
    Trunk { centre: [f64; 3], radii: [f64; 3] },
    /// An ellipsoid that goes with the height alone.
    Bony { centre: [f64; 3], radii: [f64; 3] },
}

use Drawn::{Bony, Limb, Trunk};

/// Densities of living tissue by segment (kg/m³): Dempster (1955), as Winter (2005, table 4.1) has them.
mod density {
    pub(super) const HEAD: f64 = 1110.0;
    pub(super) const TRUNK: f64 = 1030.0;
    pub(super) const UPPER_ARM: f64 = 1070.0;
    pub(super) const FOREARM: f64 = 1130.0;
    pub(super) const HAND: f64 = 1160.0;
    pub(super) const THIGH: f64 = 1050.0;
    pub(super) const SHANK: f64 = 1090.0;
    pub(super) const FOOT: f64 = 1100.0;
}

#[rustfmt::skip]
#[allow(clippy::too_many_arguments, reason = "a row of the table below")]
const fn row(
    name: &'static str, parent: &'static str, joint: &'static str, paired: bool, offset: [f64; 3], mass: f64,
    com: [f64; 3], length: f64, gyration: [f64; 3], density: f64, drawn: Drawn,
) -> Segment {
    Segment { name, parent, joint, paired, offset, mass, com, length, gyration, density, drawn }
}

/// Heights (m) from the sole to the pelvis' origin: the ankle's, of shank and thigh, of the origin above the hips.
pub(super) const FOOT: f64 = 0.078;
pub(super) const SHANK: f64 = 0.434;
pub(super) const THIGH: f64 = 0.422;
pub(super) const HIP: f64 = 0.076;

/// Published lengths (m) from the pelvis' origin to the vertex: they overlap when they are stacked.
pub(super) const LUMBAR: f64 = 0.070;
pub(super) const ABDOMEN: f64 = 0.215;
pub(super) const THORAX: f64 = 0.242;
pub(super) const NECK: f64 = 0.110;
pub(super) const HEAD: f64 = 0.203;

/// What lengths of trunk, neck and head are taken of the published ones, so that the vertex stands at the height: 0.87.
pub(super) const STACK: f64 =
    (REFERENCE_HEIGHT - (FOOT + SHANK + THIGH + HIP)) / (LUMBAR + ABDOMEN + THORAX + NECK + HEAD);

/// The clavicle's joint above the thorax' (m), before it is stacked.
const CLAVICLE: f64 = 0.215;

/// The shoulder above the clavicle's joint (m): it lies at 0.818 of the height (Drillis & Contini 1966).
const SHOULDER: f64 =
    0.818 * REFERENCE_HEIGHT - (FOOT + SHANK + THIGH + HIP) - STACK * (LUMBAR + ABDOMEN + CLAVICLE);

/// Radii of gyration of a segment that is stacked shorter: as long as published, in metres.
const fn published(gyration: [f64; 3]) -> [f64; 3] {
    [gyration[0] / STACK, gyration[1] / STACK, gyration[2] / STACK]
}

/// Parents before children.
#[rustfmt::skip]
pub(super) const SEGMENTS: [Segment; 13] = [
    row("pelvis", "", "root", false, [0.0, 0.0, 0.0], 0.1117, [0.0, -0.010, -0.010], 0.146, [0.615, 0.587, 0.551],
        density::TRUNK, Trunk { centre: [0.0, -0.015, -0.008], radii: [0.150, 0.110, 0.114] }),
    row("abdomen", "pelvis", "lumbar", false, [0.0, STACK * LUMBAR, -0.020], 0.1633, [0.0, STACK * 0.105, 0.006], STACK * ABDOMEN,
        published([0.482, 0.468, 0.383]), density::TRUNK, Trunk { centre: [0.0, STACK * 0.100, 0.010], radii: [0.138, 0.165, 0.120] }),
    row("thorax", "abdomen", "thorax", false, [0.0, STACK * ABDOMEN, 0.005], 0.1436, [0.0, STACK * 0.130, 0.004], STACK * THORAX,
        published([0.320, 0.465, 0.505]), density::TRUNK, Trunk { centre: [0.0, STACK * 0.110, 0.005], radii: [0.155, STACK * 0.172, 0.105] }),
    row("neck", "thorax", "neck", false, [0.0, STACK * THORAX, -0.015], 0.0120, [0.0, STACK * 0.055, 0.008], STACK * NECK,
        published([0.320, 0.280, 0.320]), density::HEAD, Limb { from: [0.0, 0.0, 0.0], to: [0.0, STACK * 0.060, 0.010] }),
    row("head", "neck", "head", false, [0.0, STACK * NECK, 0.010], 0.0574, [0.0, STACK * 0.090, 0.018], STACK * HEAD,
        published([0.376, 0.312, 0.362]), density::HEAD, Bony { centre: [0.0, STACK * (HEAD - 0.125), 0.022], radii: [0.080, STACK * 0.125, 0.100] }),
    row("clavicle", "thorax", "clavicle", true, [0.025, STACK * CLAVICLE, 0.020], 0.0080, [0.075, 0.006, -0.010], 0.150, [0.120, 0.300, 0.300],
        density::TRUNK, Limb { from: [0.0, 0.0, 0.0], to: [0.150, SHOULDER, -0.029] }),
    row("upper_arm", "clavicle", "shoulder", true, [0.155, SHOULDER, -0.030], 0.0271, [0.003, -0.163, 0.004], 0.282, [0.269, 0.158, 0.285],
        density::UPPER_ARM, Limb { from: [0.0, 0.0, 0.0], to: [0.002, -0.282, 0.003] }),
    row("forearm", "upper_arm", "elbow", true, [0.002, -0.282, 0.003], 0.0162, [-0.004, -0.123, 0.003], 0.269, [0.265, 0.121, 0.276],
        density::FOREARM, Limb { from: [0.0, 0.0, 0.0], to: [0.001, -0.269, 0.001] }),
    row("hand", "forearm", "wrist", true, [0.001, -0.269, 0.001], 0.0061, [0.002, -0.068, 0.006], 0.086, [0.513, 0.401, 0.628],
        density::HAND, Bony { centre: [0.0, -0.085, 0.005], radii: [0.022, 0.095, 0.042] }),
    row("thigh", "pelvis", "hip", true, [0.085, -0.076, 0.006], 0.1416, [0.007, -0.173, 0.005], 0.422, [0.329, 0.149, 0.329],
        density::THIGH, Limb { from: [0.002, 0.060, 0.005], to: [0.002, -0.422, 0.001] }), // buttock and hip are the thigh's, too
    row("shank", "thigh", "knee", true, [0.0, -0.422, -0.004], 0.0433, [0.003, -0.193, -0.006], 0.434, [0.246, 0.102, 0.251],
        density::SHANK, Limb { from: [0.0, 0.0, 0.0], to: [0.0, -0.434, -0.010] }),
    row("foot", "shank", "ankle", true, [0.0, -0.434, -0.010], 0.0115, [0.004, -0.038, 0.055], 0.200, [0.245, 0.257, 0.124],
        density::FOOT, Bony { centre: [0.0, -0.040, 0.045], radii: [0.040, 0.038, 0.105] }),
    row("toes", "foot", "toes", true, [0.0, -0.060, 0.140], 0.0022, [0.002, -0.004, 0.025], 0.070, [0.300, 0.320, 0.250],
        density::FOOT, Bony { centre: [0.0, -0.002, 0.030], radii: [0.042, 0.016, 0.042] }),
];

/// Height of the joint between foot and toes above the sole (m).
pub(super) const BALL_HEIGHT: f64 = 0.018;
/// Distance of the heel behind the ankle (m).
pub(super) const HEEL_BEHIND: f64 = 0.050;

/// Ranges of the angles (degrees), by joint and axis: about the middle of what is published for adults.
#[rustfmt::skip]
pub(super) const LIMITS: &[(&str, &str, f64, f64)] = &[
    ("lumbar", "rz", -30.0, 30.0), ("lumbar", "ry", -15.0, 15.0), ("lumbar", "rx", -25.0, 60.0),
    ("thorax", "rz", -25.0, 25.0), ("thorax", "ry", -35.0, 35.0), ("thorax", "rx", -25.0, 40.0),
    ("neck", "rz", -30.0, 30.0), ("neck", "ry", -45.0, 45.0), ("neck", "rx", -35.0, 30.0),
    ("head", "rz", -20.0, 20.0), ("head", "ry", -45.0, 45.0), ("head", "rx", -25.0, 25.0),
    ("clavicle", "rz", -10.0, 45.0), ("clavicle", "ry", -30.0, 30.0), ("clavicle", "rx", -30.0, 30.0),
    ("shoulder", "rz", -45.0, 180.0), ("shoulder", "ry", -90.0, 90.0), ("shoulder", "rx", -180.0, 60.0),
    ("elbow", "rz", -10.0, 15.0), ("elbow", "ry", -90.0, 90.0), ("elbow", "rx", -150.0, 5.0),
    ("wrist", "rz", -35.0, 35.0), ("wrist", "ry", -10.0, 10.0), ("wrist", "rx", -80.0, 75.0),
    ("hip", "rz", -30.0, 45.0), ("hip", "ry", -45.0, 45.0), ("hip", "rx", -125.0, 35.0),
    ("knee", "rz", -5.0, 5.0), ("knee", "ry", -30.0, 30.0), ("knee", "rx", -10.0, 150.0),
    ("ankle", "rz", -35.0, 20.0), ("ankle", "ry", -30.0, 30.0), ("ankle", "rx", -30.0, 55.0),
    ("toes", "rz", -10.0, 10.0), ("toes", "ry", -10.0, 10.0), ("toes", "rx", -75.0, 40.0),
];

/// Damping of a limp body's joints (N m s/rad): [`crate::Human::limp`].
#[rustfmt::skip]
pub(super) const DAMPING: &[(&str, f64)] = &[
    ("lumbar", 2.0), ("thorax", 2.0), ("neck", 0.5), ("head", 0.5), ("clavicle", 0.5), ("shoulder", 0.5), ("elbow", 0.2),
    ("wrist", 0.03), ("hip", 1.0), ("knee", 0.5), ("ankle", 0.2), ("toes", 0.01),
];

/// Anatomical angles: name, joint, axis, sign on the left, sign on the right (equal where there is one only).
#[rustfmt::skip]
pub(super) const ANGLES: &[(&str, &str, &str, f64, f64)] = &[
    ("pelvis.tilt", "root", "rx", 1.0, 1.0),
    ("pelvis.obliquity", "root", "rz", 1.0, 1.0),
    ("pelvis.rotation", "root", "ry", -1.0, -1.0),
    ("lumbar.flexion", "lumbar", "rx", 1.0, 1.0),
    ("lumbar.bend", "lumbar", "rz", -1.0, -1.0),
    ("lumbar.rotation", "lumbar", "ry", 1.0, 1.0),
    ("thorax.flexion", "thorax", "rx", 1.0, 1.0),
    ("thorax.bend", "thorax", "rz", -1.0, -1.0),
    ("thorax.rotation", "thorax", "ry", 1.0, 1.0),
    ("neck.flexion", "neck", "rx", 1.0, 1.0),
    ("head.flexion", "head", "rx", 1.0, 1.0),
    ("shoulder.flexion", "shoulder", "rx", -1.0, -1.0),
    ("shoulder.abduction", "shoulder", "rz", 1.0, -1.0),
    ("shoulder.rotation", "shoulder", "ry", -1.0, 1.0),
    ("elbow.flexion", "elbow", "rx", -1.0, -1.0),
    ("wrist.flexion", "wrist", "rx", -1.0, -1.0),
    ("hip.flexion", "hip", "rx", -1.0, -1.0),
    ("hip.abduction", "hip", "rz", 1.0, -1.0),
    ("hip.rotation", "hip", "ry", -1.0, 1.0),
    ("knee.flexion", "knee", "rx", 1.0, 1.0),
    ("ankle.dorsiflexion", "ankle", "rx", -1.0, -1.0),
    ("ankle.inversion", "ankle", "rz", -1.0, 1.0),
    ("toes.extension", "toes", "rx", -1.0, -1.0),
];
