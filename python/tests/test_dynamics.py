"""The kernel from Python: shapes, refusals, and what laws say of the numbers."""

import threading
import time

import numpy as np
import pytest

import solaris


@pytest.fixture(scope="module")
def human():
    return solaris.human(1.75, 73.0)


@pytest.fixture(scope="module")
def dynamics(human):
    return solaris.Dynamics(human)


def state(human, seed, rows=None):
    numbers = np.random.default_rng(seed)
    shape = (human.nq,) if rows is None else (rows, human.nq)
    return tuple(numbers.normal(size=shape) * scale for scale in (0.3, 1.0, 1.0))


def test_inverse_and_forward_are_each_others_inverse(human, dynamics):
    q, v, a = state(human, 1)
    tau = dynamics.inverse(q, v, a)
    assert np.allclose(dynamics.forward(q, v, tau), a, rtol=0, atol=1e-8)
    assert np.allclose(dynamics.mass_matrix(q) @ a + dynamics.inverse(q, v, 0 * a), tau, rtol=0, atol=1e-10)
    assert np.allclose(dynamics.inverse_mass_matrix(q) @ dynamics.mass_matrix(q), np.eye(human.nv), atol=1e-8)


def test_many_states_are_each_of_them(human, dynamics):
    q, v, a = state(human, 2, 37)
    tau = dynamics.inverse(q, v, a)
    assert tau.shape == (37, human.nv)
    one = np.array([dynamics.inverse(*row) for row in zip(q, v, a)])
    assert np.allclose(tau, one, rtol=0, atol=1e-10)
    threads = solaris.Dynamics(human, threads=0).inverse(q, v, a)
    assert np.array_equal(threads, tau)
    back = dynamics.forward(q, v, tau)
    assert np.allclose(back, a, rtol=0, atol=1e-7)


def test_derivatives_are_slopes(human, dynamics):
    q, v, a = state(human, 3)
    tau, by_q, by_v, by_a = dynamics.inverse_derivatives(q, v, a)
    step = 1e-6
    for k in (0, 4, 20, 65):
        e = np.zeros(human.nv)
        e[k] = step
        for slope, (ahead, behind) in (
            (by_q, ((q + e, v, a), (q - e, v, a))),
            (by_v, ((q, v + e, a), (q, v - e, a))),
            (by_a, ((q, v, a + e), (q, v, a - e))),
        ):
            found = (dynamics.inverse(*ahead) - dynamics.inverse(*behind)) / (2 * step)
            assert np.allclose(slope[:, k], found, rtol=0, atol=2e-6 * (1 + abs(found).max()))
    assert np.allclose(by_a, dynamics.mass_matrix(q), rtol=0, atol=1e-11)
    many = dynamics.inverse_derivatives(*(np.stack([x, 0.5 * x]) for x in (q, v, a)))
    for block, of_one in zip(many, (tau, by_q, by_v, by_a)):
        assert np.allclose(block[0], of_one, rtol=0, atol=1e-9)
    acceleration, *slopes = dynamics.forward_derivatives(q, v, tau)
    assert np.allclose(acceleration, a, rtol=0, atol=1e-8)
    assert np.allclose(slopes[2], dynamics.inverse_mass_matrix(q), rtol=0, atol=1e-9)


def test_a_jacobian_moves_a_point(human, dynamics):
    q, v, _ = state(human, 4)
    point = [0.01, -0.02, 0.03]
    velocity = dynamics.jacobian(q, "left_hand", point) @ v
    step = 1e-6
    ahead, behind = (dynamics.pose(q + s * step * v, "left_hand", point)[:3, 3] for s in (1, -1))
    assert np.allclose(velocity[:3], (ahead - behind) / (2 * step), rtol=0, atol=1e-7)
    link = human.links.index("left_hand")
    twist = dynamics.velocities(q, v)[link]
    assert np.allclose(dynamics.jacobian(q, "left_hand") @ v, twist, rtol=0, atol=1e-12)
    assert np.allclose(dynamics.poses(q)[link], dynamics.pose(q, "left_hand"), rtol=0, atol=1e-14)


def test_power_is_the_rate_of_energy(human, dynamics):
    q, v, a = state(human, 5)
    tau, step = dynamics.inverse(q, v, a), 1e-6

    def energy(t):
        at = q + t * v + 0.5 * t * t * a
        return dynamics.kinetic_energy(at, v + t * a) + dynamics.potential_energy(at)

    assert abs((energy(step) - energy(-step)) / (2 * step) - tau @ v) < 1e-5 * (1 + abs(tau @ v))


def test_an_external_wrench_does_work_through_the_jacobian(human, dynamics):
    q, v, a = state(human, 6)
    force = np.array([1.0, -2.0, 3.0, 0.4, 0.5, -0.6])
    arm = dynamics.jacobian(q, "right_foot")
    origin = dynamics.pose(q, "right_foot")[:3, 3]
    about_origin = np.concatenate([force[:3], force[3:] + np.cross(origin, force[:3])])
    without, pushed = dynamics.inverse(q, v, a), dynamics.inverse(q, v, a, {"right_foot": about_origin})
    assert np.allclose(pushed, without - arm.T @ force, rtol=0, atol=1e-11)
    rows = dynamics.inverse(np.stack([q, q]), np.stack([v, v]), np.stack([a, a]), {"right_foot": np.stack([about_origin, 0 * force])})
    assert np.allclose(rows, [pushed, without], rtol=0, atol=1e-10)


def test_out_is_written_to(human, dynamics):
    q, v, a = state(human, 7)
    out = np.empty(human.nv)
    assert dynamics.inverse(q, v, a, out=out) is out
    assert np.array_equal(out, dynamics.inverse(q, v, a))
    with pytest.raises(ValueError, match="out overlaps"):
        dynamics.inverse(q, v, a, out=a)
    with pytest.raises(ValueError, match=r"out has the shape \(3,\); it must be \(66,\)"):
        dynamics.inverse(q, v, a, out=np.empty(3))


@pytest.mark.parametrize("given", [list, lambda x: x.astype(np.float32), lambda x: np.repeat(x, 2)[::2]])
def test_other_arrays_are_taken(human, dynamics, given):
    q, v, a = state(human, 8)
    assert np.allclose(dynamics.inverse(given(q), given(v), given(a)), dynamics.inverse(q, v, a), rtol=1e-4, atol=1e-2)


def test_what_is_wrong_is_named(human, dynamics):
    q, v, a = state(human, 9)
    with pytest.raises(ValueError, match=r"q has the shape \(65,\); it must be \(66,\), or \(states, 66\)"):
        dynamics.inverse(q[:-1], v, a)
    with pytest.raises(ValueError, match="v holds 2 states"):
        dynamics.inverse(q, np.stack([v, v]), a)
    with pytest.raises(TypeError, match="q cannot be an array of numbers"):
        dynamics.inverse("nothing", v, a)
    with pytest.raises(solaris.DynamicsError, match="did you mean 'left_foot'"):
        dynamics.inverse(q, v, a, {"left_fot": np.zeros(6)})
    bad = np.stack([a, a, a])
    bad[1, 3] = np.nan
    with pytest.raises(solaris.DynamicsError) as raised:
        dynamics.inverse(*(np.stack([x] * 3) for x in (q, v)), bad)
    assert raised.value.rows == [1]


def test_threads_share_one_object(human, dynamics):
    from concurrent.futures import ThreadPoolExecutor

    states = [state(human, seed, 200) for seed in range(8)]
    expected = [dynamics.inverse(*one) for one in states]
    with ThreadPoolExecutor(4) as pool:
        for found, known in zip(pool.map(lambda one: dynamics.inverse(*one), states * 4), expected * 4):
            assert np.array_equal(found, known)


def test_quaternions_integrate():
    ball = solaris.Figure.from_text(
        'Figure(version: 1, links: [Link(name: "top", joint: Ball(name: "pivot"), mass: 1.0, inertia: (0.1, 0.1, 0.2))])'
    )
    assert (ball.nq, ball.nv) == (4, 3)
    q = ball.integrate(ball.neutral(), np.array([0.0, 0.0, np.pi / 2]))
    assert np.allclose(q, [0, 0, np.sqrt(0.5), np.sqrt(0.5)])
    assert np.allclose(ball.difference(ball.neutral(), q), [0, 0, np.pi / 2])


def test_other_threads_go_on_while_a_long_chain_is_computed(tmp_path):
    """Mass matrices of a chain of 1500 joints take milliseconds, in which Python is let go."""
    links = "".join(f'<link name="l{i}"><inertial><mass value="1"/><inertia ixx="1" iyy="1" izz="1" ixy="0" ixz="0" iyz="0"/></inertial></link>' for i in range(1501))
    joint = '<joint name="j{0}" type="continuous"><parent link="l{0}"/><child link="l{1}"/><origin xyz="0 0 0.1"/><axis xyz="1 0 0"/></joint>'
    path = tmp_path / "chain.urdf"
    path.write_text(f'<robot name="chain">{links}{"".join(joint.format(i, i + 1) for i in range(1500))}</robot>')
    figure = solaris.read_figure(path)
    dynamics, q = solaris.Dynamics(figure), np.zeros(figure.nq)
    dynamics.mass_matrix(q)
    ticks, done = 0, threading.Event()

    def tick():
        nonlocal ticks
        while not done.wait(2e-4):
            ticks += 1

    ticker = threading.Thread(target=tick)
    ticker.start()
    start = time.monotonic()
    calls = 0
    while time.monotonic() - start < 0.5:
        dynamics.inverse_mass_matrix(q)
        calls += 1
    done.set()
    ticker.join()
    # Held, there would be one or two a call.
    assert ticks > 4 * calls, (ticks, calls)
