"""The names of docs/python.md beside OpenSim's own engine: each line of its table, with the same numbers.

Skipped where its wheel is not installed (``pip install opensim``). The models are those of the fixtures, and where there is a folder
of others, which the variable SOLARIS_DATA names, OpenSim's own of walking.
"""

import os
import shutil
import subprocess
from pathlib import Path
from xml.etree import ElementTree

import numpy as np
import pytest

import solaris

osim = pytest.importorskip("opensim", reason="OpenSim's wheel is not installed: pip install opensim")

# It would write its own beside the models.
osim.Logger.removeFileSink()

REPOSITORY = Path(__file__).resolve().parents[2]
DATA = Path(os.environ.get("SOLARIS_DATA", REPOSITORY.parent / "shared" / "data"))
MODELS = [
    REPOSITORY / "fixtures/subject/subject.osim",
    REPOSITORY / "fixtures/markers/leg.osim",
    DATA / "subject01_walk/gait10dof18musc_subject01.osim",
    DATA / "markers/gait2354/opensim46/subject01_simbody.osim",
    DATA / "markers/rajagopal_run/opensim46/subject_scaled_run.osim",
]


class Theirs:
    """OpenSim's model, whose forces are left out: muscles and springs are no part of the questions."""

    def __init__(self, path, figure):
        osim.Logger.setLevelString("Off")
        self.model = osim.Model(str(path))
        for force in range(self.model.getForceSet().getSize()):
            self.model.updForceSet().get(force).set_appliesForce(False)
        self.state = self.model.initSystem()
        coordinates = self.model.getCoordinateSet()
        self.coordinates = {coordinates.get(i).getName(): coordinates.get(i) for i in range(coordinates.getSize())}
        for coordinate in self.coordinates.values():
            coordinate.setLocked(self.state, False)
            coordinate.setClamped(self.state, False)
        self.matter = self.model.getMatterSubsystem()
        # Those of ours that are coordinates there: translations of a knee follow its angle, and are functions in a joint of theirs.
        self.names = [name for name in figure.v_names if name not in figure.followers]
        # Where each of them is among their speeds: found by setting one after the other.
        self.order = []
        for name in self.names:
            self.set(dict.fromkeys(self.coordinates, 0.0), {name: 1.0})
            self.order.append(int(np.flatnonzero(self.state.getU().to_numpy())[0]))

    def set(self, q, v):
        for name, coordinate in self.coordinates.items():
            coordinate.setValue(self.state, q.get(name, 0.0), False)
            coordinate.setSpeedValue(self.state, v.get(name, 0.0))
        self.model.realizeVelocity(self.state)

    def vector(self, ours):
        numbers = osim.Vector(self.state.getNU(), 0.0)
        for at, x in zip(self.order, ours):
            numbers.set(at, float(x))
        return numbers

    def inverse(self, a):
        tau = osim.InverseDynamicsSolver(self.model).solve(self.state, self.vector(a))
        return tau.to_numpy()[self.order]

    def mass_matrix(self):
        matrix = osim.Matrix()
        self.matter.calcM(self.state, matrix)
        return matrix.to_numpy()[np.ix_(self.order, self.order)]

    def body(self, name):
        return self.model.getBodySet().get(name)


def lacks(path):
    """Why a model's matrices are not those of its coordinates in OpenSim's engine."""
    text = path.read_text()
    if "<CoordinateCouplerConstraint" in text:
        return "coordinates follow others by constraints, which OpenSim's matrices leave out"
    if "<FreeJoint" in text or "<BallJoint" in text:
        return "speeds of a free joint are no rates of its coordinates there"
    return None


@pytest.fixture(params=MODELS, ids=lambda path: path.stem)
def pair(request):
    path = request.param
    if not path.exists():
        pytest.skip(f"{path.name}: there is no such model here; SOLARIS_DATA names the folder of others")
    figure = solaris.read_figure(path)
    return path, figure, Theirs(path, figure)


def states(figure, count=5):
    numbers = np.random.default_rng(0)
    return [tuple(numbers.uniform(-1.0, 1.0, figure.nv) * scale for scale in (0.3, 1.0, 3.0)) for _ in range(count)]


def same(ours, theirs):
    theirs = np.asarray(theirs)
    assert np.abs(ours - theirs).max() <= 1e-9 * max(1.0, np.abs(theirs).max())


def test_the_same_numbers(pair):
    path, figure, theirs = pair
    dynamics = solaris.Dynamics(figure)
    assert figure.mass == pytest.approx(theirs.model.getTotalMass(theirs.state), rel=1e-12)
    ours = [figure.v_names.index(name) for name in theirs.names]
    for given in states(figure):
        q, v, a = figure.follow(*given)
        theirs.set(dict(zip(figure.q_names, q)), dict(zip(figure.v_names, v)))
        same(dynamics.center_of_mass(q), theirs.model.calcMassCenterPosition(theirs.state).to_numpy())
        bodies = theirs.model.getBodySet()
        both = [body for body in (bodies.get(i) for i in range(bodies.getSize())) if body.getName() in figure.links]
        assert len(both) > 1
        for body in both:
            same(dynamics.pose(q, body.getName())[:3, 3], body.getPositionInGround(theirs.state).to_numpy())
        if lacks(path):
            continue
        assert dynamics.kinetic_energy(q, v) == pytest.approx(theirs.model.calcKineticEnergy(theirs.state), rel=1e-9)
        same(figure.fold_forces(q, dynamics.inverse(q, v, a))[ours], theirs.inverse(a[ours]))
        matrix, folded = dynamics.mass_matrix(q), []
        for dof in ours:
            _, way, _ = figure.follow(q, np.eye(figure.nv)[dof])
            folded.append(figure.fold_forces(q, matrix @ way)[ours])
        same(np.array(folded), theirs.mass_matrix())
    if lacks(path):
        pytest.skip(f"{path.name}: places are the same; {lacks(path)}")


def columns(path):
    """A table of OpenSim's tools: its columns by their names."""
    lines = path.read_text().splitlines()
    end = lines.index("endheader")
    rows = np.array([[float(cell) for cell in line.split()] for line in lines[end + 2 :] if line.strip()])
    return dict(zip(lines[end + 1].split(), rows.T))


def test_forces_of_a_motion_and_plates_are_those_of_the_tool(tmp_path):
    subject = REPOSITORY / "fixtures/subject"
    osim.Logger.setLevelString("Off")
    tool = osim.InverseDynamicsTool()
    tool.setModelFileName(str(subject / "subject.osim"))
    tool.setCoordinatesFileName(str(subject / "walk.mot"))
    tool.setExternalLoadsFileName(str(subject / "loads.xml"))
    tool.setStartTime(0.0)
    tool.setEndTime(10.0)
    tool.setResultsDir(str(tmp_path))
    tool.setOutputGenForceFileName("forces.sto")
    assert tool.run()
    theirs = columns(tmp_path / "forces.sto")

    figure = solaris.read_figure(subject / "subject.osim")
    motion = solaris.read_motion(figure, subject / "walk.mot")
    found = solaris.inverse_dynamics(motion, external_loads=subject / "loads.xml", contacts=False).motion
    names = [name for name in figure.v_names if name not in figure.followers]
    assert len(names) == 10 and np.allclose(theirs["time"], found.time, rtol=0.0, atol=1e-9)
    for name in names:
        force = theirs[f"{name}_force" if f"{name}_force" in theirs else f"{name}_moment"]
        same(found.tau[:, figure.v_names.index(name)], force)


def test_positions_from_markers_miss_less_than_those_of_the_tool(tmp_path):
    markers = REPOSITORY / "fixtures/markers"
    osim.Logger.setLevelString("Off")
    tool = osim.InverseKinematicsTool(str(markers / "ik.xml"), False)
    tool.set_model_file(str(markers / "leg.osim"))
    tool.set_marker_file(str(markers / "swing.trc"))
    tool.setStartTime(0.0)
    tool.setEndTime(10.0)
    tool.set_results_directory(str(tmp_path))
    tool.setOutputMotionFileName(str(tmp_path / "found.mot"))
    assert tool.run()
    theirs = columns(tmp_path / "found.mot")

    figure = solaris.read_figure(markers / "leg.osim")
    tasks = ElementTree.parse(markers / "ik.xml").iter("IKMarkerTask")
    weights = {task.get("name"): float(task.findtext("weight")) for task in tasks}
    found = solaris.inverse_kinematics(figure, markers / "swing.trc", weights=weights).motion
    assert len(weights) == 12 and np.allclose(theirs.pop("time"), found.time, rtol=0.0, atol=1e-9)
    assert set(theirs) == set(figure.q_names)
    theirs = [column if name[-3:] in ("_tx", "_ty", "_tz") else np.radians(column) for name, column in theirs.items()]
    theirs = np.transpose(theirs)
    ours = found.q[:, [figure.q_names.index(name) for name in columns(tmp_path / "found.mot") if name != "time"]]

    model = osim.Model(str(markers / "leg.osim"))
    state = model.initSystem()
    coordinates = [model.getCoordinateSet().get(i) for i in range(model.getCoordinateSet().getSize())]
    seen = osim.TimeSeriesTableVec3(str(markers / "swing.trc"))
    labels = list(seen.getColumnLabels())

    def missed(frame, q):
        """The weighted squares of what is missed (m²), by their engine; NaN where a marker is not seen."""
        for coordinate, value in zip(coordinates, q):
            coordinate.setClamped(state, False)
            coordinate.setValue(state, value, False)
        model.realizePosition(state)
        row, total = seen.getRowAtIndex(frame), 0.0
        for name, weight in weights.items():
            marker = model.getMarkerSet().get(name).getLocationInGround(state).to_numpy()
            total += weight * np.sum((marker - row[labels.index(name)].to_numpy() / 1000.0) ** 2)
        return total

    compared = 0
    for frame in range(len(ours)):
        least, reached = (missed(frame, q) for q in (ours[frame], theirs[frame]))
        # Where two markers have changed places theirs goes between them, and ours leaves them out.
        if not reached < 0.1:
            continue
        compared += 1
        # Their search ends early, a hundredth of a radian off where the sum is flat.
        assert least <= reached and np.abs(ours[frame] - theirs[frame]).max() < 0.025
    assert compared == 24


def test_a_model_of_a_person_s_size_is_that_of_the_tool(tmp_path):
    """The program's, which takes the tool's own setup: `cargo build -p solaris-cli` makes it."""
    builds = [REPOSITORY / "target" / build / "solaris" for build in ("release", "debug")]
    program = next((str(build) for build in builds if build.exists()), shutil.which("solaris"))
    if program is None:
        pytest.skip("the program is not built")
    for name in ("leg.osim", "static.trc", "scale.xml"):
        shutil.copy(REPOSITORY / "fixtures/markers" / name, tmp_path)
    osim.Logger.setLevelString("Off")
    tool = osim.ScaleTool(str(tmp_path / "scale.xml"))
    tool.getModelScaler().setOutputModelFileName("scaled.osim")
    tool.getMarkerPlacer().setOutputModelFileName("theirs.osim")
    assert tool.run()
    # Its markers lie where the static trial has them, as those of `--static` do.
    command = [program, "scale", tmp_path / "leg.osim", "--static", tmp_path / "static.trc"]
    command += ["--scale-setup", tmp_path / "scale.xml", "-o", tmp_path / "ours.osim"]
    subprocess.run(command, check=True, capture_output=True)

    ours, theirs = (solaris.read_figure(tmp_path / f"{who}.osim") for who in ("ours", "theirs"))
    assert ours.links == theirs.links and ours.mass == pytest.approx(25.0, abs=1e-9)
    numbers = np.random.default_rng(1)
    dynamics = [solaris.Dynamics(figure) for figure in (ours, theirs)]
    for _ in range(5):
        q, v, a = (numbers.uniform(-0.5, 0.5, count) for count in (ours.nq, ours.nv, ours.nv))
        for link in ours.links:
            places = [one.pose(q, link) for one in dynamics]
            assert np.abs(places[0] - places[1]).max() < 1e-9
        # The masses of its file have fifteen digits.
        same(*(one.inverse(q, v, a) for one in dynamics))
    models = [osim.Model(str(tmp_path / f"{who}.osim")) for who in ("ours", "theirs")]
    markers = [model.getMarkerSet() for model in models]
    assert markers[0].getSize() == markers[1].getSize() == 12
    for index in range(12):
        name = markers[1].get(index).getName()
        places = [both.get(name).get_location().to_numpy() for both in markers]
        assert np.abs(places[0] - places[1]).max() < 1e-3, name
