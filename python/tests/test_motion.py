"""Motions, walks, scenes and files."""

import json
import pickle
from pathlib import Path

import numpy as np
import pytest

import solaris

FIXTURES = Path(__file__).resolve().parents[2] / "fixtures"


@pytest.fixture(scope="module")
def walk():
    return solaris.walk(height=1.75, mass=73.0, step_frequency=110, steps=6)


def test_forces_agree_with_inverse_dynamics_state_by_state(walk):
    motion, figure = walk.motion, walk.figure
    found = solaris.inverse_dynamics(motion)
    assert np.allclose(found.tau, motion.tau, rtol=0, atol=1e-6)
    # Newton: the ground's force is mass times acceleration of the centre of mass, less gravity.
    dynamics = solaris.Dynamics(figure)
    sample, step = 300, 1.0 / motion.rate
    com = [dynamics.center_of_mass(motion.q[sample + k]) for k in (-1, 0, 1)]
    acceleration = (com[0] - 2 * com[1] + com[2]) / step**2
    force = sum(contact["force"][sample] for contact in motion.contacts.values())
    assert np.allclose(force, figure.mass * (acceleration - motion.gravity), rtol=0, atol=2.0)


def test_arrays_are_views_that_outlive_what_they_view():
    motion = solaris.walk(steps=4).motion
    q = motion.q
    first = q[0].copy()
    with pytest.raises(ValueError, match="read-only"):
        q[0, 0] = 1.0
    del motion
    __import__("gc").collect()
    assert np.array_equal(q[0], first)


def test_tables_of_others(walk):
    pandas, polars, pyarrow = (pytest.importorskip(name) for name in ("pandas", "polars", "pyarrow"))
    motion = walk.motion
    tables = motion.to_pandas(), motion.to_polars(), pyarrow.table(motion)
    assert isinstance(tables[0], pandas.DataFrame) and isinstance(tables[1], polars.DataFrame)
    for table in tables:
        assert np.array_equal(np.asarray(table["left_knee.rx.tau"]), motion.to_dict()["left_knee.rx.tau"])
    assert list(tables[0].columns) == motion.columns == tables[2].column_names


@pytest.mark.parametrize("kind", ["csv", "bvh", "mot", "sto"])
def test_files_read_back(walk, tmp_path, kind):
    path = tmp_path / f"walk.{kind}"
    walk.save(path)
    back = solaris.read_motion(walk.figure, path)
    # BVH and OpenSim's tables have degrees of some digits.
    assert np.allclose(back.q, walk.motion.q, rtol=0, atol=1e-12 if kind == "csv" else 2e-5)
    assert (back.a is None) == (kind != "csv")
    assert [file.name for file in tmp_path.iterdir()] == [path.name]


def test_other_files(walk, tmp_path):
    pyarrow = pytest.importorskip("pyarrow.parquet")
    for kind in ("html", "svg", "parquet", "glb"):
        walk.save(tmp_path / f"walk.{kind}")
    assert (tmp_path / "walk.glb").read_bytes()[:4] == b"glTF"
    assert "<html" in (tmp_path / "walk.html").read_text()[:200]
    assert pyarrow.read_table(tmp_path / "walk.parquet").column_names == walk.motion.columns
    with pytest.raises(solaris.FileError, match="its extension says nothing") as raised:
        walk.save(tmp_path / "walk.fbx")
    assert raised.value.path.endswith("walk.fbx")
    with pytest.raises(solaris.FileError):
        walk.save(tmp_path / "nowhere" / "walk.csv")


def test_loops_are_written_without_their_first_frame_a_second_time(tmp_path):
    loop = solaris.walk(loop="in_place", rate=30.0)
    frames = len(loop.motion) - 1
    for name in ("loop.bvh", "loop.csv"):
        loop.save(tmp_path / name)
    text = (tmp_path / "loop.bvh").read_text()
    assert f"Frames: {frames}\n" in text
    assert len((tmp_path / "loop.csv").read_text().splitlines()) == frames + 1
    # What does not repeat itself is written whole.
    loop.motion.save(tmp_path / "again.bvh")
    assert (tmp_path / "again.bvh").read_text() == text
    walk = solaris.walk(steps=4, rate=30.0)
    walk.save(tmp_path / "walk.bvh")
    assert f"Frames: {len(walk.motion)}\n" in (tmp_path / "walk.bvh").read_text()


def test_figures_of_a_scene_are_nodes_and_skins_of_their_own(tmp_path):
    run = solaris.run(FIXTURES / "scenes" / "crossing.ron", duration=0.2)
    run.save(tmp_path / "crossing.glb")
    data = (tmp_path / "crossing.glb").read_bytes()
    length = int.from_bytes(data[12:16], "little")
    file = json.loads(data[20 : 20 + length])
    names = [file["nodes"][node]["name"] for node in file["scenes"][0]["nodes"]]
    assert len(file["skins"]) > 1 and len(set(names)) == len(names)
    assert [animation["name"] for animation in file["animations"]] == ["motion"]
    assert "bodies" in run._repr_html_()


def test_a_notebook_shows_a_page_that_cannot_escape(walk):
    shown = walk.motion._repr_html_()
    assert shown.startswith("<iframe srcdoc=") and shown.count("<") == 2


def test_opensims_example_of_a_walk():
    subject = FIXTURES / "subject"
    figure = solaris.read_figure(subject / "subject.osim")
    motion = solaris.read_motion(figure, subject / "walk.mot")
    plates = {"calcn_r": "", "calcn_l": "1_"}
    found = solaris.inverse_dynamics(motion, external=subject / "grf.mot", plates=plates, filter=6.0, order=3)
    assert found.motion.v is not None and np.isfinite(found.tau).all()
    weight = figure.mass * 9.80665
    assert found.residual["force_rms_n"] < 0.2 * weight
    ground = solaris.ground_forces(motion, soles=subject / "soles.ron", filter=6.0, order=3)
    total = sum(contact["force"][:, 1] for contact in ground.contacts.values())
    assert abs(np.median(total) / weight - 1.0) < 0.2
    without = solaris.inverse_dynamics(ground.motion, ground)
    assert without.residual["force_rms_n"] < 1e-6 * weight
    with pytest.raises(ValueError, match="plates="):
        solaris.inverse_dynamics(motion, external=subject / "grf.mot")


def test_markers_to_angles():
    figure = solaris.read_figure(FIXTURES / "markers" / "leg.osim")
    found = solaris.inverse_kinematics(figure, FIXTURES / "markers" / "swing.trc")
    assert found.converged == len(found.motion) and found.rms < 0.03
    assert set(found.marker_rms) and np.isfinite(found.frame_rms).all()


def test_somebody_stands_up_and_sits_down():
    rise = solaris.chair(height=1.65, mass=58.0, seat_height=0.42)
    seat = rise.motion.contacts["pelvis"]["force"][:, 1]
    weight = 58.0 * 9.80665
    assert rise.seat_height == 0.42 and 0.5 * weight < seat[0] < weight and seat[-1] == 0.0
    assert len(rise.measures["left_s"]) == 1 and rise.measures["met_s"] == []
    feet = sum(rise.motion.contacts[foot]["force"][-1, 1] for foot in ("left_foot", "right_foot"))
    assert feet == pytest.approx(weight, rel=1e-6)
    both = solaris.chair(motion="rise_and_sit", times=2, rate=60)
    assert np.allclose(both.motion.q[0], both.motion.q[-1], atol=1e-9)
    assert len(both.measures["met_s"]) == 2
    for wrong, message in [
        ({"motion": "lie"}, "'rise', 'sit' or 'rise_and_sit'"),
        ({"times": 3}, "'rise_and_sit' alone"),
        ({"seat_height": 3.0}, "0.332 to 0.63 m"),
        ({"motion": "rise_and_sit", "times": 0}, "1 to 100"),
    ]:
        with pytest.raises(ValueError) as raised:
            solaris.chair(**wrong)
        assert message in str(raised.value)


def test_walks_of_all_kinds():
    assert solaris.walk(slope=np.radians(5.0), steps=4).motion.q[-1, 1] > 0.1
    assert solaris.walk(stairs={"count": 3}).motion.q[-1, 1] > 0.3 + 0.3
    turned = solaris.walk(turn=np.radians(20.0), steps=10)
    assert turned.duration > 5.0
    sad = solaris.walk(manner="sad", steps=4, variability=1.0, seed=3)
    again = solaris.walk(manner="sad", steps=4, variability=1.0, seed=3)
    assert np.array_equal(sad.motion.q, again.motion.q)
    loop = solaris.walk(loop="in_place", rate=30)
    assert abs(np.ptp(loop.motion.q[:, 2])) < 0.1
    run = solaris.run_gait(speed=3.0, steps=4, end="running")
    assert run.measures["run"] is not None
    fore = solaris.run_gait(speed=3.0, steps=4, forefoot=True)
    assert fore.measures["run"]["knee_contact_deg"] > run.measures["run"]["knee_contact_deg"]
    soft = solaris.run_gait(speed=3.0, steps=4, give=0.012)
    assert soft.measures["run"]["knee_stance_deg"] < run.measures["run"]["knee_stance_deg"] - 2.0
    with pytest.raises(ValueError, match="give 0.02 m: it must be 0 to 0.015 m"):
        solaris.run_gait(speed=3.0, give=0.02)
    walk = {"steps": 4, "speed": 1.5}
    joined = solaris.run_gait(speed=2.2, steps=6, start=walk, end="walking")
    lands = [event for event in joined.motion.events if event[1] == "touch_down"]
    # One step of the run lands in the walk, whose last one closes beside the other foot.
    assert len(lands) == 4 + 6 + 1 + 6 + 1
    stood = solaris.run_gait(speed=2.2, steps=8, start="standing", end=walk)
    assert stood.motion.q[0, 2] == pytest.approx(stood.motion.q[1, 2], abs=1e-4)
    for wrong, message in [("flying", "'walking'"), ({"stepps": 4}, "start has no 'stepps'"), ({"steps": 1}, "3 to 30")]:
        with pytest.raises(ValueError) as raised:
            solaris.run_gait(speed=2.2, start=wrong)
        assert message in str(raised.value)
    thesis = solaris.walk(determinants=3, step_frequency=95, steps=4)
    assert thesis.step_frequency == pytest.approx(95)
    joined = solaris.walk(steps=4, step_frequency=100, then=[{"steps": 4, "step_frequency": 110}, {"stand": 1.0}])
    assert joined.duration > 4.0


@pytest.mark.parametrize(
    "wrong, message",
    [
        ({"steps": 4, "distance": 3.0}, "steps and distance are both given"),
        ({"population": "giant"}, "older"),
        ({"then": [{"step": 4}]}, "then has no 'step'"),
        ({"stairs": {"hight": 1}}, "stairs has no 'hight'"),
        ({"slope": 0.1, "stairs": {}}, "slope and stairs are both given"),
        ({"path": [[1.0, 2.0, 3.0]]}, "rows of 2"),
        ({"loop": "yes"}, "'in_place'"),
        ({"speed": float("nan")}, "NaN"),
        ({"height": 9.0}, "height 9 m"),
        ({"manner": "sadd"}, "sad"),
        ({"determinants": 4}, "3 or 5"),
        ({"rate": 0.0}, "rate 0"),
    ],
)
def test_what_cannot_be_walked_says_why(wrong, message):
    with pytest.raises(ValueError) as raised:
        solaris.walk(**wrong)
    assert message in str(raised.value)


def test_the_range_of_an_angle_is_in_its_argument_s_unit():
    with pytest.raises(solaris.WalkError, match="-15 to 15") as raised:
        solaris.walk(slope=1.0)
    error = raised.value
    assert (error.parameter, error.unit) == ("slope", "rad") and error.lower == -error.upper
    assert error.value == pytest.approx(1.0) and error.upper == pytest.approx(np.radians(15.0))


def test_a_walker_is_steered():
    walker = solaris.Walker()
    for _ in range(900):
        q = walker.step(1 / 60, to=(2.0, 3.0), speed=1.2, facing=(0.0, 10.0))
        assert np.isfinite(q).all()
    assert np.allclose(walker.place, (2.0, 3.0), atol=0.05) and walker.is_standing
    twin = walker.copy()
    ways = [other.step(1 / 60, velocity=(0.0, 1.0)) for other in (walker, twin)]
    assert np.array_equal(*ways)
    with pytest.raises(solaris.WalkError):
        walker.step(10.0)
    with pytest.raises(solaris.WalkError):
        walker.step(1 / 60, velocity=(0.0, float("nan")))
    with pytest.raises(solaris.WalkError):
        solaris.Walker(solaris.human())


def test_a_walker_reaches_plays_is_pushed_and_tells_its_forces():
    walker = solaris.Walker()
    weight = 9.80665 * walker.figure.mass
    for k in range(120):
        walker.reach("right_hand", to=(-0.4, 1.0, 1.0 * k / 60 + 0.2), at=(0, -0.08, 0))
        walker.step(1 / 60, velocity=(0.0, 1.0))
    assert walker.reached("right_hand") is not None and walker.reached("left_hand") is None
    walker.withdraw("right_hand")
    walker.reach("head", look=(2.0, 1.5, 9.0), by=["neck", "head"])
    walker.reach("left_hand", turned=(0, 0, 0, 1))
    walker.push("thorax", (30.0, 0.0, 0.0))
    walker.loosen("right_elbow")
    walker.step(1 / 60, velocity=(0.0, 1.0))
    walker.tighten("right_elbow")
    walker.let_go()
    # A motion of the same figure, of which no more than the positions are known.
    time, dof = np.linspace(0.0, 1.0, 61), walker.figure.q_names.index("left_elbow.rx")
    q = np.zeros((61, walker.figure.nq))
    q[:, dof] = -1.0 - 0.3 * np.sin(6 * time)
    walker.withdraw("left_hand")
    walker.play(solaris.Motion(walker.figure, time, q), by=["left_elbow"])
    for k in range(30):
        played = walker.step(1 / 60, velocity=(0.0, 1.0))
    assert walker.plays and abs(played[dof] - (-1.0 - 0.3 * np.sin(6 * 0.5))) < 1e-3
    walker.end_clips()
    for _ in range(300):
        walker.step(1 / 60)
    forces = walker.forces()
    total = forces["left_foot"]["force"] + forces["right_foot"]["force"]
    assert np.allclose(total, (0, weight, 0), atol=0.02 * weight) and np.abs(forces["tau"][:6]).max() < 1e-6
    for wrong in (dict(), dict(to=(0, 1, 0), look=(0, 1, 0)), dict(look=(0, 1, 0), axis=(0, 0, 0))):
        with pytest.raises(ValueError):
            walker.reach("right_hand", **wrong)
    with pytest.raises(solaris.WalkError, match="did you mean 'right_hand'"):
        walker.reach("right_hnd", to=(0, 1, 0))
    with pytest.raises(solaris.WalkError):
        walker.push("thorax", (1e6, 0.0, 0.0))


def test_a_scene_runs_and_its_faults_have_places(tmp_path):
    run = solaris.run(FIXTURES / "scenes" / "pendulum.ron", duration=2.0, rate=200.0)
    assert len(run.motion) == 401 and run.report["energy"]
    assert run.report["error"] is not None and "adaptive" in run.report["method"]
    path = tmp_path / "scene.ron"
    path.write_text('Scene(\n  version: 1,\n  figurs: {},\n)')
    with pytest.raises(solaris.SceneError) as raised:
        solaris.run(path)
    fault = next(fault for fault in raised.value.faults if fault.line == 3)
    assert fault.file == str(path) and "figures" in fault.message
    with pytest.raises(solaris.FileError, match="it is a figure"):
        solaris.run(FIXTURES / "figures" / "arm.urdf")


def test_figures_from_files_and_texts(tmp_path):
    arm = solaris.read_figure(FIXTURES / "figures" / "arm.urdf")
    text = (FIXTURES / "figures" / "arm.urdf").read_text()
    assert solaris.Figure.from_text(text, "urdf") == arm
    assert arm.language == "URDF" and arm.parents[0] == -1 and len(arm.parents) == len(arm.links)
    assert pickle.loads(pickle.dumps(arm)) == arm
    assert np.array_equal(pickle.loads(pickle.dumps(arm)).gravity, arm.gravity)
    lower, upper = arm.limits
    assert (lower < upper).all()
    moon, q = arm.with_gravity(arm.gravity / 6), np.full(arm.nq, 0.4)
    on_earth, there = (solaris.Dynamics(figure).gravity_torques(q) for figure in (arm, moon))
    assert abs(on_earth).max() > 0.1 and np.allclose(there, on_earth / 6, rtol=1e-12, atol=0)
    broken = tmp_path / "broken.urdf"
    broken.write_text(text.replace("<inertial>", "<inertia>", 1))
    with pytest.raises(solaris.FigureError) as raised:
        solaris.read_figure(broken)
    assert raised.value.faults and raised.value.faults[0].file == str(broken)
    with pytest.raises(solaris.FileError, match="there is no such file"):
        solaris.read_figure(tmp_path / "none.osim")


def test_motions_from_numbers():
    human = solaris.human()
    time = np.linspace(0.0, 1.0, 61)
    q = np.zeros((61, human.nq))
    motion = solaris.Motion(human, time, q)
    assert motion.v is None and motion.a is None and motion.tau is None and len(motion) == 61
    complete = solaris.differentiate(motion)
    assert np.array_equal(complete.v, 0 * q)
    with pytest.raises(solaris.MotionError, match="times must be finite and rise"):
        solaris.differentiate(solaris.Motion(human, time[::-1], q))
    with pytest.raises(ValueError, match="a row for each of the 61 times"):
        solaris.Motion(human, time, q[:60])


def test_plots(walk):
    matplotlib = pytest.importorskip("matplotlib")
    matplotlib.use("Agg")
    axes = walk.motion.plot("*knee.rx", of="tau")
    assert len(axes.lines) == 2
    with pytest.raises(ValueError, match="did you mean 'left_knee.rx'"):
        walk.motion.plot("left_kne.rx")
    with pytest.raises(ValueError, match="it must be 'q', 'v', 'a' or 'tau'"):
        walk.motion.plot(of="x")


def test_a_model_is_scaled_to_markers(tmp_path):
    fixtures = FIXTURES / "markers"
    subject = solaris.scale(fixtures / "leg.osim", [fixtures / "static.trc", fixtures / "swing.trc"], mass=26.0)
    assert subject.figure.mass == pytest.approx(26.0) and subject.rms < 0.5 * subject.rms_before
    assert all(length["standard_error"] > 0 for length in subject.lengths) and subject.moved
    before = solaris.inverse_kinematics(solaris.read_figure(fixtures / "leg.osim"), fixtures / "swing.trc")
    after = solaris.inverse_kinematics(subject.figure, fixtures / "swing.trc")
    assert after.rms < before.rms
    # What is written is what it is, and so does the program write it.
    subject.save(tmp_path / "leg.osim")
    again = solaris.read_figure(tmp_path / "leg.osim")
    assert again.mass == pytest.approx(26.0) and again.masses == pytest.approx(subject.figure.masses)
    assert solaris.inverse_kinematics(again, fixtures / "swing.trc").rms == pytest.approx(after.rms, rel=1e-6)
    subject.save(tmp_path / "leg.ron")
    assert solaris.read_figure(tmp_path / "leg.ron").mass == pytest.approx(26.0)
    for refused in (
        lambda: solaris.scale(fixtures / "leg.osim", []),
        lambda: solaris.scale(fixtures / "leg.osim", [fixtures / "static.trc"], mass=float("nan")),
        lambda: solaris.scale(fixtures / "leg.osim", [fixtures / "nobody.trc"]),
        lambda: solaris.scale(FIXTURES / "figures/arm.urdf", [fixtures / "static.trc"]),
        lambda: subject.save(tmp_path / "leg.txt"),
    ):
        with pytest.raises(ValueError):
            refused()


def test_people_bear_their_weight_at_every_pace_and_other_paces_are_named():
    for pace in ("very slow", "slow", "free", "fast", "very fast"):
        curves = solaris.people_curves(pace)
        force = curves["Vertical force"]["mean"]
        assert len(curves) == 15
        # Two feet bear the weight, and the body neither rises nor sinks over a stride.
        assert abs(np.mean((force[1:] + force[:-1]) / 2) - 50.0) < 1.5
    with pytest.raises(ValueError, match="pace is 'brisk'; it must be one of 'very slow', 'slow'"):
        solaris.people_curves("brisk")


def test_a_cane_bears_what_it_is_asked_to():
    figure = solaris.human(1.75, 73.0, cane="right")
    motion = solaris.walk(figure, step_frequency=85, steps=6, cane_load=0.2).motion
    assert sorted(motion.contacts) == ["cane", "left_foot", "right_foot"]
    bears = motion.contacts["cane"]["force"][:, 1] / sum(track["force"][:, 1] for track in motion.contacts.values())
    assert np.max(bears) == pytest.approx(0.2, abs=5e-3)
    with pytest.raises(solaris.WalkError, match="holds no cane"):
        solaris.walk(cane_load=0.2)
    with pytest.raises(solaris.FigureError, match="'middle' hand"):
        solaris.human(cane="middle")
