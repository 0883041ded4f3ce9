//! Words of other programs, and of other parts of a scene, that people write where they are not known.

const COLLISIONS: &str = "links touch each other with collisions: Collisions(friction: 0.5)";
const GROUND: &str = "write ground: Flat(friction: 0.8)";
const METHOD: &str = "write method: RungeKutta4(step: 1e-3), or tolerance: 1e-6 and no method";
const SERVO: &str = "write Servo(to: deg(-60), stiffness: 30, damping: 3)";
const LOOPS: &str = "write loops: [Connect(between: …)], or Weld(…)";
const GRASP: &str = "write loops: [Weld(between: …, from: 1.0, until: 3.0)]";
const LET_GO: &str =
    "what holds for a time has until: 2.0, as Connect, Weld, Carry and Reach have, and is let go then";

/// Each with what it is sought in, or beside, and what to write instead.
pub(super) const OF_OTHERS: [(&str, &str, &str); 38] = [
    ("Scene", "self_contact", COLLISIONS),
    ("Scene", "self_contacts", COLLISIONS),
    ("Scene", "self_collision", COLLISIONS),
    ("Scene", "self_collisions", COLLISIONS),
    (
        "Scene",
        "contact",
        "write ground: Flat(friction: 0.8), or collisions: Collisions(friction: 0.5) for links that touch each other",
    ),
    (
        "Scene",
        "contacts",
        "write ground: Flat(friction: 0.8), or collisions: Collisions(friction: 0.5) for links that touch each other",
    ),
    ("Scene", "floor", GROUND),
    ("Scene", "plane", GROUND),
    ("Scene", "step", METHOD),
    ("Scene", "dt", METHOD),
    ("Scene", "timestep", METHOD),
    ("Scene", "integrator", METHOD),
    ("Scene", "fps", "write rate: 60"),
    ("Scene", "time", "write duration: 3.0"),
    ("Scene", "actuators", "write drives: {\"left_elbow.rx\": Servo(…)}"),
    ("Scene", "motors", "write drives: {\"left_elbow.rx\": Torque(…)}"),
    ("Scene", "joints", "where joints begin is start: {…}, and what moves them drives: {…}"),
    ("Scene", "constraints", LOOPS),
    ("Scene", "equality", LOOPS),
    ("Servo", "PD", SERVO),
    ("Servo", "Position", SERVO),
    ("Servo", "Motor", "write Torque(2.0)"),
    ("Servo", "Force", "write Torque(2.0) for a joint, and pushes: [Push(…)] for a link"),
    ("Servo", "Impulse", "write pushes: [Push(link: …, impulse: (0, 0, 10), …)]"),
    ("Servo", "Passive", "write Free"),
    ("Servo", "Dynamic", "write Free"),
    ("Servo", "Lock", "write Frozen"),
    ("Servo", "Locked", "write Frozen"),
    ("Servo", "Fixed", "write Frozen"),
    ("Servo", "LetGo", LET_GO),
    ("Servo", "Release", LET_GO),
    ("Servo", "Grab", GRASP),
    ("Servo", "Grasp", GRASP),
    ("Servo", "Sequence", "a list of drives is one after the other: [Move(…), Wait(0.5), …]"),
    ("Together", "Sequence", "the list is the sequence: [Together({…}), Wait(0.5), …]"),
    ("Together", "LetGo", LET_GO),
    ("Together", "Parallel", "write Together({…})"),
    // Which drives and sequences have.
    ("Stand", "Wait", "who walks waits with Stand(time: 1.0)"),
];
