"""Batches of recorded motions: pure, resumed, by any number of workers the same, and what cannot be solved said."""

import csv
import hashlib
import json
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest

import solaris
from solaris import plot, trials

pyarrow = pytest.importorskip("pyarrow.parquet")

SUBJECT = Path(__file__).resolve().parents[2] / "fixtures" / "subject"
MARKERS = SUBJECT.parent / "markers"

TABLE = f"""trial,model,motion,markers,external,plates,external_loads,soles,filter,order
plates,{SUBJECT}/subject.osim,{SUBJECT}/walk.mot,,{SUBJECT}/grf.mot,calcn_r= calcn_l=1_,,,6,3
loads,{SUBJECT}/subject.osim,{SUBJECT}/walk.mot,,,,{SUBJECT}/loads.xml,,6,3
without,{SUBJECT}/subject.osim,{SUBJECT}/walk.mot,,,,,{SUBJECT}/soles.ron,6,3
markers,{MARKERS}/leg.osim,,{MARKERS}/swing.trc,,,,,6,
missing,{SUBJECT}/subject.osim,nowhere.mot,,,,,,,
wrong,{SUBJECT}/subject.osim,{SUBJECT}/walk.mot,,,,,,six,
"""


@pytest.fixture
def table(tmp_path):
    path = tmp_path / "trials.csv"
    path.write_text(TABLE)
    return path


def digests(folder):
    return {path.name: hashlib.sha256(path.read_bytes()).hexdigest() for path in sorted(folder.iterdir())}


def test_each_is_what_it_is_alone(table, tmp_path):
    index = trials.make(trials.read(table), tmp_path / "out")
    rows = {row["trial"]: row for row in csv.DictReader(index.open())}
    assert [bool(row["error"]) for row in rows.values()] == [False, False, False, False, True, True]
    assert "nowhere.mot" in rows["missing"]["error"] and "'six'" in rows["wrong"]["error"]
    figure = solaris.read_figure(SUBJECT / "subject.osim")
    motion = solaris.read_motion(figure, SUBJECT / "walk.mot")
    alone = solaris.inverse_dynamics(
        motion, external=SUBJECT / "grf.mot", plates={"calcn_r": "", "calcn_l": "1_"}, filter=6.0, order=3
    )
    written = pyarrow.read_table(tmp_path / "out" / rows["plates"]["file"])
    for name, column in alone.motion.to_dict().items():
        assert np.array_equal(written[name].to_numpy(), column), name
    assert float(rows["plates"]["residual_force_rms_n"]) == alone.residual["force_rms_n"]
    assert float(rows["without"]["residual_force_rms_n"]) < 1.0
    found = solaris.inverse_kinematics(solaris.read_figure(MARKERS / "leg.osim"), MARKERS / "swing.trc")
    assert float(rows["markers"]["marker_rms_m"]) == found.rms
    assert pyarrow.read_table(tmp_path / "out" / rows["missing"]["file"]).num_rows == 0


def test_what_is_there_is_kept_and_what_is_asked_otherwise_is_not(table, tmp_path):
    out = tmp_path / "out"
    trials.make(trials.read(table), out, workers=1)
    first = digests(out)
    (out / "loads.parquet").unlink()
    stamps = {path.name: path.stat().st_mtime_ns for path in out.glob("*.parquet")}
    trials.make(trials.read(table), out)
    assert digests(out) == first
    assert all((out / name).stat().st_mtime_ns == stamp for name, stamp in stamps.items())
    table.write_text(TABLE.replace("grf.mot,calcn_r= calcn_l=1_,,,6,3", "grf.mot,calcn_r= calcn_l=1_,,,8,3"))
    trials.make(trials.read(table), out)
    changed = {name for name, digest in digests(out).items() if first[name] != digest}
    assert changed == {"plates.parquet", "trials.csv"}


def test_one_that_is_killed_loses_nothing(table, tmp_path):
    # No other copy of a row than whole: a file of its own that appears at once.
    out, command = tmp_path / "killed", [sys.executable, "-m", "solaris.trials", str(table), "--workers", "1", "--out"]
    running = subprocess.Popen([*command, str(out)], stderr=subprocess.DEVNULL)
    while running.poll() is None and not list(out.glob("*.parquet")):
        pass
    running.kill()
    running.wait()
    assert all(pyarrow.read_metadata(path) for path in out.glob("*.parquet"))
    done = subprocess.run([*command, str(out)], capture_output=True, text=True)
    assert done.returncode == 1 and "4 of 6 trials solved" in done.stdout and "nowhere.mot" in done.stderr
    trials.make(trials.read(table), tmp_path / "whole")
    left = {path.name for path in out.iterdir() if path.name.startswith(".")}
    assert {name: digest for name, digest in digests(out).items() if name not in left} == digests(tmp_path / "whole")


def test_two_workers_of_ray_are_as_one(table, tmp_path):
    ray = pytest.importorskip("ray")
    ray.init(num_cpus=2, include_dashboard=False, logging_level="error")
    try:
        trials.make(trials.read(table), tmp_path / "two", ray=True, workers=2)
        # The pure function, as `map_batches` takes it.
        rows = [dict(zip(trials.read(table), row)) for row in zip(*trials.read(table).values())]
        solved = ray.data.from_items(rows).map_batches(trials.solve, batch_size=2).take_all()
    finally:
        ray.shutdown()
    trials.make(trials.read(table), tmp_path / "one")
    assert digests(tmp_path / "two") == digests(tmp_path / "one")
    assert sorted(row["trial"] for row in solved if row["error"]) == ["missing", "wrong"]
    frames = {row["trial"]: row["frames"] for row in solved}
    assert frames["plates"] == pyarrow.read_table(tmp_path / "one" / "plates.parquet").num_rows


@pytest.mark.parametrize(
    "text, said",
    [
        ("trial,modell\na,b\n", "modell"),
        ("trial\na\n", "model"),
        ("trial,model\na\n", "line 2"),
        ("trial,model\nA/b,x\na_b,x\n", "would be one file"),
    ],
)
def test_a_wrong_table_is_said(text, said, tmp_path, capsys):
    path = tmp_path / "wrong.csv"
    path.write_text(text)
    assert trials._main([str(path), "--out", str(tmp_path / "out")]) == 1
    assert said in capsys.readouterr().err


def test_names_of_files_are_apart_and_fit(tmp_path):
    assert len(trials._file_name("\U00020000" * 80).encode()) < 255
    table = tmp_path / "twice.csv"
    # One letter, of which Python has one object.
    table.write_text("trial,model\n1,a.osim\n1,b.osim\n")
    with pytest.raises(ValueError, match="trials '1' and '1' would be one file"):
        trials.read(table)


def test_a_picture_takes_one_command(tmp_path, capsys):
    pytest.importorskip("matplotlib")
    out = tmp_path / "moments.svg"
    asked = [f"{SUBJECT}/subject.osim", f"{SUBJECT}/walk.mot", "--soles", f"{SUBJECT}/soles.ron", "--filter", "6"]
    assert plot._main([*asked, "--of", "knee_angle_*", "-o", str(out)]) == 0
    assert "for balance" in capsys.readouterr().out and "knee_angle_r" in out.read_text()
    assert plot._main([*asked, "--of", "knee_angel_r", "-o", str(out)]) == 1
    assert "did you mean 'knee_angle_r'" in capsys.readouterr().err
    assert plot._main([asked[0], "nowhere.mot", "-o", str(out)]) == 1


def test_metadata_says_what_was_asked(table, tmp_path):
    trials.make(trials.read(table), tmp_path / "out")
    said = json.loads(pyarrow.read_schema(tmp_path / "out" / "markers.parquet").metadata[b"solaris"])
    assert said["asked"]["filter"] == "6" and said["error"] == ""
