"""Scenes that are taken further step by step, beside whole runs and beside what a pendulum does."""

import numpy as np
import pytest

import solaris

ROD = 'Link(name: "rod", joint: Joint(name: "hinge", axes: [rx]), mass: 1.0, com: (0, -0.5, 0))'
TEXT = f'Scene(version: 1, figures: {{"it": Figure(links: [{ROD}])}}, duration: 1.0, rate: 50)'


@pytest.fixture
def scene():
    return solaris.read_scene(text=TEXT)


def test_steps_are_a_run_to_the_bit(scene):
    text = TEXT.replace("rate: 50", 'rate: 50, method: RungeKutta4(step: 1e-3)')
    named = solaris.read_scene(text=text)
    whole = named.run(forces=False).motion
    running = named.start()
    running.set_state(v=[0.0])
    for time, q, v in zip(whole.time, whole.q, whole.v):
        running.advance_to(time)
        assert np.array_equal(running.q, q) and np.array_equal(running.v, v)


def test_a_pendulum_keeps_its_energy_and_falls_as_it_must(scene):
    running = scene.start(method="adaptive", tolerance=1e-10)
    running.set_state(q=[1.0])
    # A point mass at half a metre: a = -g/l sin q.
    assert running.accelerations()[0] == pytest.approx(-9.80665 / 0.5 * np.sin(1.0), rel=1e-9)
    before = running.energy()["total"]
    for _ in range(100):
        running.step(0.05)
    assert running.energy()["total"] == pytest.approx(before, abs=1e-7)
    assert running.time == pytest.approx(5.0)


def test_a_snapshot_goes_on_to_the_same_bits(scene):
    running = scene.start(step=2e-3)
    running.set_force("hinge", 1.0)
    running.step(0.3)
    snapshot = running.copy()
    running.step(0.2)
    after = running.q, running.v
    assert snapshot.time == pytest.approx(0.3)
    snapshot.step(0.2)
    assert np.array_equal(snapshot.q, after[0]) and np.array_equal(snapshot.v, after[1])


def test_drives_are_changed_between_steps(scene):
    running = scene.start()
    # A motion begins where the joint is, with the velocity that it has.
    running.drive("hinge", to=0.8, over=0.5)
    running.step(0.6)
    assert running.q[0] == pytest.approx(0.8, abs=1e-9) and running.happened()["outcomes"]
    reach = solaris.Profile("minimum-jerk", from_=0.8, to=0.2, duration=1.0)
    running.drive("hinge", follow=reach)
    running.step(0.5)
    assert running.q[0] == pytest.approx(0.5, abs=1e-9)
    running.drive("hinge", freeze=True)
    running.step(0.1)
    assert running.v[0] == 0.0 and running.happened()["events"] == []
    # A moment that holds the weight: nothing moves.
    held = running.q[0]
    weight = 9.80665 * 0.5 * np.sin(held)
    running.drive("hinge", torque=solaris.Profile("line", from_=weight, to=weight, duration=1.0))
    running.step(0.5)
    assert running.q[0] == pytest.approx(held, abs=1e-9)
    running.drive("hinge")
    running.step(0.1)
    assert running.v[0] < -0.1


def test_what_cannot_be_is_refused_and_changes_nothing(scene):
    running = scene.start()
    running.step(0.1)
    for refused in (
        lambda: running.step(0.0),
        lambda: running.step(float("nan")),
        lambda: running.advance_to(0.05),
        lambda: running.set_force("hinge", float("inf")),
        lambda: running.drive("hinge", to=1.0, freeze=True),
        lambda: running.drive("knee", freeze=True),
        lambda: running.drive("hinge", follow=solaris.Profile("line", from_=2.0, to=3.0, duration=1.0)),
        lambda: running.set_state(q=[1.0, 2.0]),
        lambda: running.set_state(q=[float("nan")]),
        lambda: scene.start(method="rk5"),
        lambda: scene.start(method="adaptive", step=1e-3),
        lambda: scene.start(step=-1.0),
    ):
        with pytest.raises(ValueError):
            refused()
    assert running.time == pytest.approx(0.1)
    with pytest.raises(ValueError, match="no degree of freedom 'hinges'"):
        running.set_force("hinges", 1.0)
    with pytest.raises(solaris.SceneError):
        solaris.read_scene(text="Scene()")
