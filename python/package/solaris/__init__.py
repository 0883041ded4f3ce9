"""Motion of people, animals and robots that obeys physics.

Describe a body, say what should move, and get every joint's position, velocity, acceleration and moment, the ground's
reaction on each foot, and how far to trust them. Lengths are in m, angles in rad, times in s, forces in N, moments in N m;
of people x is left, y up, z forward.

>>> import solaris
>>> walk = solaris.walk(height=1.75, mass=73.0, step_frequency=110, steps=10)
>>> walk.motion.to_dict()["left_knee.rx.q"].shape == walk.motion.time.shape
True
"""

from ._solaris import (
    Chair,
    Dynamics,
    Figure,
    Ground,
    Inverse,
    Kinematics,
    Motion,
    Profile,
    Run,
    Running,
    Scene,
    Subject,
    Walk,
    Walker,
    chair,
    differentiate,
    ground_forces,
    human,
    inverse_dynamics,
    inverse_kinematics,
    manners,
    people_curves,
    read_figure,
    read_motion,
    read_scene,
    run,
    run_gait,
    scale,
    style_parameters,
    walk,
)
from .errors import (
    ArgumentError,
    DynamicsError,
    Fault,
    FigureError,
    FileError,
    MotionError,
    ProfileError,
    RunError,
    SceneError,
    SolarisError,
    WalkError,
)

__version__ = "0.1.0"

__all__ = [
    "ArgumentError",
    "Chair",
    "Dynamics",
    "DynamicsError",
    "Fault",
    "Figure",
    "FigureError",
    "FileError",
    "Ground",
    "Inverse",
    "Kinematics",
    "Motion",
    "MotionError",
    "Profile",
    "ProfileError",
    "Run",
    "RunError",
    "Running",
    "Scene",
    "SceneError",
    "SolarisError",
    "Subject",
    "Walk",
    "WalkError",
    "Walker",
    "chair",
    "differentiate",
    "ground_forces",
    "human",
    "inverse_dynamics",
    "inverse_kinematics",
    "manners",
    "people_curves",
    "read_figure",
    "read_motion",
    "read_scene",
    "run",
    "run_gait",
    "scale",
    "style_parameters",
    "walk",
]


def _figure_of(text: str, gravity: list) -> Figure:
    """A figure that was pickled."""
    return Figure.from_text(text).with_gravity(gravity)
