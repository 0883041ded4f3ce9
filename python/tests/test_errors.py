"""Exceptions have fields, whatever is refused."""

import numpy as np
import pytest
import solaris


@pytest.fixture(scope="module")
def ann():
    return solaris.human(1.65, 58.0, heading_first=True)


def refused(kind, call):
    with pytest.raises(kind) as caught:
        call()
    assert isinstance(caught.value, solaris.SolarisError) and isinstance(caught.value, ValueError)
    return caught.value


@pytest.mark.parametrize(
    ("argument", "call"),
    [
        ("q", lambda ann: solaris.Dynamics(ann).mass_matrix(np.zeros(3))),
        ("external['head']", lambda ann: solaris.Dynamics(ann).inverse(*_state(ann), external={"head": np.zeros(5)})),
        ("threads", lambda ann: solaris.Dynamics(ann, threads=-1)),
        ("format", lambda ann: solaris.Figure.from_text("", "obj")),
        ("loop", lambda ann: solaris.walk(ann, loop="round")),
        ("steps", lambda ann: solaris.walk(ann, steps=-4)),
        ("seed", lambda ann: solaris.walk(ann, seed=-1)),
        ("determinants", lambda ann: solaris.walk(ann, determinants=-3)),
        ("stairs['count']", lambda ann: solaris.walk(ann, stairs={"count": -1})),
        ("then['steps']", lambda ann: solaris.walk(ann, then=[{"steps": -1}])),
        ("ground", lambda ann: solaris.walk(ann, ground=[[1.0], [2.0]])),
    ],
)
def test_arguments_are_named(ann, argument, call):
    error = refused(solaris.ArgumentError, lambda: call(ann))
    assert error.argument == argument and argument in str(error)


def test_arguments_that_do_not_go_together_have_no_name(ann):
    motion = solaris.walk(ann, steps=2).motion
    error = refused(solaris.ArgumentError, lambda: solaris.inverse_dynamics(motion, ground=solaris.ground_forces(motion), wrenches={}))
    assert error.argument == ""


def _state(ann):
    return ann.neutral(), np.zeros(ann.nv), np.zeros(ann.nv)


def test_the_kernel_names_what_it_refuses(ann):
    q, v, a = _state(ann)
    v[7] = np.nan
    error = refused(solaris.DynamicsError, lambda: solaris.Dynamics(ann).inverse(q, v, a))
    assert (error.argument, error.name, error.rows) == ("v", ann.v_names[7], [])
    call = lambda: solaris.Dynamics(ann).inverse(*_state(ann), external={"left_fot": np.zeros(6)})
    error = refused(solaris.DynamicsError, call)
    assert (error.argument, error.name) == ("external", "left_fot")


@pytest.mark.parametrize(
    ("asked", "parameter", "lower", "upper", "unit"),
    [
        ({"height": 9.0}, "height", 0.8, 2.3, "m"),
        ({"height": 1.75, "mass": 5.0}, "mass", 8 * 1.75**2, 80 * 1.75**2, "kg"),
        ({"age": 0.5}, "age", 6.0, np.inf, "years"),
        ({"mass": 70.0, "load": {"left": -1.0}}, "load", 0.0, None, "kg"),
        ({"shorter_leg": {"left": 1.0}}, "shorter_leg", 0.0, None, "m"),
    ],
)
def test_people_who_cannot_be_say_what_may_be(asked, parameter, lower, upper, unit):
    for call in [solaris.human, solaris.walk][: 2 if set(asked) <= {"height", "mass", "age"} else 1]:
        error = refused(solaris.FigureError, lambda: call(**asked))
        assert (error.parameter, error.unit, error.lower) == (parameter, unit, lower)
        assert upper is None or error.upper == pytest.approx(upper)
        assert not error.lower <= error.value <= error.upper


def test_turns_and_slopes_are_in_rad(ann):
    for asked in [{"turn": 9.0}, {"slope": 2.0}, {"then": [{"steps": 2, "turn": 9.0}]}]:
        error = refused(solaris.WalkError, lambda asked=asked: solaris.walk(ann, **asked))
        assert error.unit == "rad" and error.value > error.upper > 0


def test_motions_say_when_and_of_what(ann):
    time, q = np.arange(3.0), np.tile(ann.neutral(), (3, 1))
    error = refused(solaris.MotionError, lambda: solaris.Motion(ann, time[::-1].copy(), q))
    assert error.sample == 1
    q[2, 4] = np.inf
    error = refused(solaris.MotionError, lambda: solaris.Motion(ann, time, q))
    assert (error.time, error.dof) == (2.0, ann.q_names[4])


def test_runs_that_fail_say_when_and_what_helps():
    rod = 'Link(name: "rod", joint: Joint(name: "hinge", axes: [rx]), mass: 1.0, com: (0, -0.5, 0))'
    text = (
        'Scene(version: 1, figures: {"it": Figure(links: [%s])}, duration: 1.0, '
        'drives: {"hinge": Servo(to: 1.0, stiffness: 1e9, damping: 1e5)}, method: RungeKutta4(step: 0.01))' % rod
    )
    scene = solaris.read_scene(text=text)
    error = refused(solaris.RunError, scene.run)
    assert error.time >= 0 and error.remedies and error.dof == "hinge.rx"


def test_a_figure_that_gravity_cannot_be_given_has_its_fault():
    error = refused(solaris.FigureError, lambda: solaris.human().with_gravity([0.0, np.nan, 0.0]))
    assert [fault.line for fault in error.faults] == [0] and "gravity" in error.faults[0].message


def test_a_figure_that_cannot_move_is_integrated():
    stone = solaris.Figure.from_text(
        'Figure(version: 1, name: "stone", links: [Link(name: "stone", joint: Joint(name: "held", axes: []), mass: 1.0)])'
    )
    assert stone.nv == 0
    for q, rows in ((np.zeros(0), ()), (np.zeros((3, 0)), (3,))):
        assert stone.integrate(q, q).shape == (*rows, 0)
        assert stone.difference(q, q).shape == (*rows, 0)
