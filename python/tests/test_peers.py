"""The names of docs/python.md beside Pinocchio and MuJoCo: each line of its table, with the same numbers.

Skipped where their wheels are not installed: ``pip install pin mujoco``.
"""

import numpy as np
import pytest

import solaris


def placement(pose):
    return pose[:3, :3], pose[:3, 3]


@pytest.fixture(scope="module")
def human():
    return solaris.human(1.75, 73.0)


@pytest.fixture(scope="module")
def states(human):
    numbers = np.random.default_rng(0)
    return [tuple(numbers.normal(size=human.nv) * scale for scale in (0.4, 1.0, 2.0)) for _ in range(5)]


@pytest.fixture(scope="module")
def pinocchio_human(human):
    """The same human for Pinocchio: a one-dof joint for each degree of freedom, the mass on the last of a link."""
    pin = pytest.importorskip("pinocchio")
    dynamics, q = solaris.Dynamics(human), human.neutral()
    poses, model = dynamics.poses(q), pin.Model()
    last, index = {}, {}
    # Pinocchio's matrices need what hangs on a joint to come right after it: depth first.
    def below(link):
        return [link] + [other for child in range(len(human.links)) if human.parents[child] == link for other in below(child)]

    for link in below(0):
        parent, joint = human.parents[link], human.joints[link]
        own = pin.SE3(*placement(poses[link]))
        above = pin.SE3(*placement(poses[parent])) if parent >= 0 else pin.SE3.Identity()
        holder, place = (last[parent] if parent >= 0 else 0), above.actInv(own)
        columns = dynamics.jacobian(q, human.links[link], axes="frame")
        for dof, name in enumerate(human.v_names):
            if name != joint and not name.startswith(joint + "."):
                continue
            axis, slides = (columns[3:, dof], False) if abs(columns[3:, dof]).max() > 0 else (columns[:3, dof], True)
            kind = pin.JointModelPrismaticUnaligned(axis) if slides else pin.JointModelRevoluteUnaligned(axis)
            holder = model.addJoint(holder, kind, place, name)
            index[dof], place = holder, pin.SE3.Identity()
        inertia = pin.Inertia(human.masses[link], human.coms[link], human.inertias[link])
        model.appendBodyToJoint(holder, inertia, place)
        frame = pin.Frame(human.links[link], holder, 0, place, pin.FrameType.BODY)
        model.addFrame(frame)
        last[link] = holder
    model.gravity.linear = human.gravity
    order = np.array([model.joints[index[dof]].idx_v for dof in range(human.nv)])
    assert sorted(order) == list(range(human.nv))
    return pin, model, model.createData(), order


def test_pinocchio(human, states, pinocchio_human):
    pin, model, data, order = pinocchio_human
    dynamics = solaris.Dynamics(human)

    def same(ours, theirs, scale=1.0):
        assert np.allclose(ours, theirs, rtol=0, atol=1e-9 * max(scale, 1.0, np.abs(theirs).max()))

    square = np.ix_(order, order)
    for ours in states:
        # Their order of the same numbers.
        q, v, a = (np.empty(human.nv) for _ in range(3))
        q[order], v[order], a[order] = ours
        tau = pin.rnea(model, data, q, v, a)
        same(dynamics.inverse(*ours), tau[order])
        same(dynamics.forward(ours[0], ours[1], tau[order]), pin.aba(model, data, q, v, tau)[order])
        upper = pin.crba(model, data, q)
        same(dynamics.mass_matrix(ours[0]), (np.triu(upper) + np.triu(upper, 1).T)[square])
        inverse = pin.computeMinverse(model, data, q)
        same(dynamics.inverse_mass_matrix(ours[0]), (np.triu(inverse) + np.triu(inverse, 1).T)[square])
        same(dynamics.gravity_torques(ours[0]), pin.computeGeneralizedGravity(model, data, q)[order])
        coriolis = pin.computeCoriolisMatrix(model, data, q, v) @ v
        same(dynamics.coriolis_matrix(ours[0], ours[1]) @ ours[1], coriolis[order])
        frame = model.getFrameId("left_hand")
        pin.computeJointJacobians(model, data, q)
        pin.updateFramePlacements(model, data)
        for axes, theirs in (("world", pin.LOCAL_WORLD_ALIGNED), ("frame", pin.LOCAL)):
            same(
                dynamics.jacobian(ours[0], "left_hand", axes=axes),
                pin.getFrameJacobian(model, data, frame, theirs)[:, order],
            )
        same(dynamics.pose(ours[0], "left_hand"), data.oMf[frame].homogeneous)
        same(dynamics.center_of_mass(ours[0]), pin.centerOfMass(model, data, q))
        same(dynamics.momentum(ours[0], ours[1]), pin.computeCentroidalMomentum(model, data, q, v).vector)
        same(dynamics.kinetic_energy(ours[0], ours[1]), pin.computeKineticEnergy(model, data, q, v))
        same(dynamics.potential_energy(ours[0]), pin.computePotentialEnergy(model, data, q))
        found = dynamics.inverse_derivatives(*ours)
        for block, theirs in zip(found[1:3], pin.computeRNEADerivatives(model, data, q, v, a)):
            same(block, theirs[square])
        found = dynamics.forward_derivatives(ours[0], ours[1], tau[order])
        by_q, by_v, by_tau = (block.copy() for block in pin.computeABADerivatives(model, data, q, v, tau))
        by_tau = np.triu(by_tau) + np.triu(by_tau, 1).T
        for block, theirs in zip(found[1:], (by_q, by_v, by_tau)):
            same(block, theirs[square])


def test_mujoco():
    """An arm of six joints, as MuJoCo's own text: the same numbers from its reader and from ours."""
    mujoco = pytest.importorskip("mujoco")
    numbers, text = np.random.default_rng(1), ""
    for joint in range(6):
        axis = " ".join(str(x) for x in numbers.normal(size=3).round(3))
        text += (
            f'<body name="b{joint}" pos="0.1 0 0.25"><joint name="j{joint}" type="hinge" axis="{axis}"/>'
            f'<inertial pos="0.02 0.01 0.1" mass="{1 + joint / 10}" fullinertia="0.02 0.025 0.015 0.001 0.002 -0.001"/>'
        )
    text = f'<mujoco><compiler angle="radian"/><worldbody>{text}{"</body>" * 6}</worldbody></mujoco>'
    model = mujoco.MjModel.from_xml_string(text)
    model.opt.enableflags |= mujoco.mjtEnableBit.mjENBL_ENERGY
    data = mujoco.MjData(model)
    arm = solaris.Figure.from_text(text, "mjcf")
    dynamics = solaris.Dynamics(arm)
    assert arm.nv == model.nv == 6
    for _ in range(5):
        q, v, a = (numbers.normal(size=6) for _ in range(3))
        tau = dynamics.inverse(q, v, a)
        data.qpos[:], data.qvel[:], data.qfrc_applied[:] = q, v, tau
        mujoco.mj_forward(model, data)
        # Of a random state the accelerations come back to what the matrix' condition leaves of them.
        assert np.allclose(data.qacc, a, rtol=0, atol=1e-7)
        assert np.allclose(dynamics.forward(q, v, tau), data.qacc, rtol=0, atol=1e-9 * max(1.0, abs(a).max()))
        energies = [dynamics.potential_energy(q), dynamics.kinetic_energy(q, v)]
        assert np.allclose(energies, data.energy, rtol=0, atol=1e-9)
        inverse = np.zeros((6, 6))
        mujoco.mj_solveM(model, data, inverse, np.eye(6))
        assert np.allclose(dynamics.inverse_mass_matrix(q), inverse, rtol=0, atol=1e-9 * abs(inverse).max())
        data.qacc[:] = a
        mujoco.mj_inverse(model, data)
        assert np.allclose(dynamics.inverse(q, v, a), data.qfrc_inverse, rtol=0, atol=1e-9)
        full = np.zeros((6, 6))
        try:
            mujoco.mj_fullM(model, data, full)
        except TypeError:  # before its version 3.4
            mujoco.mj_fullM(model, full, data.qM)
        assert np.allclose(dynamics.mass_matrix(q), full, rtol=0, atol=1e-9)
        assert np.allclose(dynamics.inverse(q, v, 0 * a), data.qfrc_bias, rtol=0, atol=1e-9)
        linear, angular = np.zeros((3, 6)), np.zeros((3, 6))
        body = model.body("b5").id
        mujoco.mj_jacBody(model, data, linear, angular, body)
        assert np.allclose(dynamics.jacobian(q, "b5"), np.vstack([linear, angular]), rtol=0, atol=1e-9)
        pose = dynamics.pose(q, "b5")
        assert np.allclose(pose[:3, 3], data.xpos[body], rtol=0, atol=1e-9)
        assert np.allclose(pose[:3, :3].ravel(), data.xmat[body], rtol=0, atol=1e-9)
        assert np.allclose(dynamics.center_of_mass(q), data.subtree_com[0], rtol=0, atol=1e-9)
        # By differences, and transposed; what it leaves in `data` is a state beside this one.
        by_q, by_v, by_a = (np.zeros((6, 6)) for _ in range(3))
        mujoco.mjd_inverseFD(model, data, 1e-6, False, by_q, by_v, by_a, None, None, None, None)
        for ours, theirs in zip(dynamics.inverse_derivatives(q, v, a)[1:], (by_q, by_v, by_a)):
            assert np.allclose(ours, theirs.T, rtol=0, atol=1e-4 * max(1.0, abs(ours).max()))


def best(run, rounds=5, calls=2000):
    import timeit

    return min(timeit.repeat(run, number=calls, repeat=rounds)) / calls


def test_calls_cost_less_than_pinocchios(human, states, pinocchio_human):
    """Ratios of the same run; what this machine was doing besides is in both."""
    pin, model, data, _ = pinocchio_human
    dynamics, (q, v, a) = solaris.Dynamics(human), states[0]
    ours = best(lambda: dynamics.inverse(q, v, a))
    theirs = best(lambda: pin.rnea(model, data, q, v, a))
    rows = [np.tile(x, (1000, 1)) for x in (q, v, a)]
    of_many = best(lambda: dynamics.inverse(*rows), calls=5) / 1000
    print(f"\none state {theirs / ours:.1f}, of many {theirs / of_many:.1f} times as fast as Pinocchio from Python")
    assert theirs / ours > 3.0 and theirs / of_many > 10.0


def test_a_call_costs_no_more_than_numpys_own():
    """What a call costs beside the kernel: of one hinge, whose kernel takes some dozens of nanoseconds, against a small product of NumPy."""
    hinge = solaris.Figure.from_text(
        '<mujoco><worldbody><body name="b"><joint name="j" type="hinge"/><inertial pos="0 0 1" mass="1" diaginertia="1 1 1"/></body></worldbody></mujoco>',
        "mjcf",
    )
    dynamics, one, many = solaris.Dynamics(hinge), np.ones(1), np.eye(6) + 1.0
    ours, theirs = (best(run) for run in (lambda: dynamics.inverse(one, one, one), lambda: np.linalg.inv(many)))
    print(f"\na call {1e6 * ours:.2f} µs, NumPy's inverse of six rows {1e6 * theirs:.2f}")
    assert ours < theirs
