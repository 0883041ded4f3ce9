"""Datasets: pure, resumed, and by any number of workers the same."""

import hashlib
import subprocess
import sys
import time

import numpy as np
import pytest

from solaris import dataset

pyarrow = pytest.importorskip("pyarrow.parquet")


def digests(folder):
    return {path.name: hashlib.sha256(path.read_bytes()).hexdigest() for path in sorted(folder.glob("part-*"))}


def test_people_depend_on_their_number_alone():
    all_of_them, some = dataset.people(0, 9, seed=4), dataset.people(5, 2, seed=4)
    for name, column in some.items():
        assert list(column) == list(all_of_them[name][5:7])
    assert dataset.people(0, 3, seed=5)["height_m"][0] != all_of_them["height_m"][0]


def test_who_cannot_walk_stays_in_the_table():
    batch = dataset.people(0, 3)
    batch["step_frequency_per_min"][1] = 300.0
    found = dataset.walks(batch, steps=4)
    assert found["error"][0] == found["error"][2] == "" and "300" in found["error"][1]
    assert np.isnan(found["speed_m_s"][1]) and np.isfinite(found["speed_m_s"][[0, 2]]).all()
    assert 1.0 < found["peak_vertical_force_over_weight"][0] < 1.6


def test_a_dataset_is_gone_on_with(tmp_path):
    paths = dataset.make(tmp_path / "a", 10, part_size=4, steps=4)
    assert [path.name for path in paths] == ["part-00000.parquet", "part-00001.parquet", "part-00002.parquet"]
    first = digests(tmp_path / "a")
    paths[1].unlink()
    stamp = paths[0].stat().st_mtime_ns
    dataset.make(tmp_path / "a", 10, part_size=4, steps=4)
    assert digests(tmp_path / "a") == first and paths[0].stat().st_mtime_ns == stamp
    table = pyarrow.read_table(tmp_path / "a")
    assert table["person"].to_pylist() == list(range(10))
    with pytest.raises(ValueError, match="another dataset"):
        dataset.make(tmp_path / "a", 11, part_size=4, steps=4)


def test_one_that_is_killed_loses_and_doubles_nothing(tmp_path):
    out = tmp_path / "killed"
    command = [sys.executable, "-m", "solaris.dataset", "--people", "60", "--part", "5", "--steps", "4", "--out", str(out)]
    running = subprocess.Popen(command, stderr=subprocess.DEVNULL)
    deadline = time.monotonic() + 60
    while len(list(out.glob("part-*"))) < 2 and time.monotonic() < deadline:
        time.sleep(0.01)
    running.kill()
    running.wait()
    assert subprocess.run(command, capture_output=True, check=True).stdout
    whole = dataset.make(tmp_path / "whole", 60, part_size=5, steps=4)
    assert digests(out) == digests(tmp_path / "whole") and len(whole) == 12


def test_motions_are_kept(tmp_path):
    (path,) = dataset.make(tmp_path, 2, steps=4, frames=30.0)
    table = pyarrow.read_table(path)
    time, q = np.array(table["time"][0].as_py()), np.array(table["q"][0].as_py())
    assert q.size == 66 * time.size and abs(time[1] - 1 / 30) < 1e-9


def test_two_workers_of_ray_are_as_one(tmp_path):
    ray = pytest.importorskip("ray")
    ray.init(num_cpus=2, include_dashboard=False, logging_level="error")
    try:
        dataset.make(tmp_path / "two", 8, part_size=2, steps=4, ray=True, workers=2)
    finally:
        ray.shutdown()
    dataset.make(tmp_path / "one", 8, part_size=2, steps=4)
    assert digests(tmp_path / "two") == digests(tmp_path / "one") and len(digests(tmp_path / "one")) == 4


def test_what_is_asked_wrong_is_said(tmp_path, capsys):
    assert dataset._main(["--people", "0", "--out", str(tmp_path)]) == 1
    assert "at least 1" in capsys.readouterr().err
    for wrong in (["--steps", "0"], ["--frames", "0"], ["--frames", "-3"], ["--seed", "-1"]):
        assert dataset._main(["--people", "3", "--out", str(tmp_path), *wrong]) == 1
        assert wrong[0][2:] in capsys.readouterr().err
    assert not list(tmp_path.glob("part-*"))
    (tmp_path / "_plan.json").write_text("{")
    assert dataset._main(["--people", "3", "--out", str(tmp_path)]) == 1
    assert "is no plan of a dataset" in capsys.readouterr().err


def test_what_no_walk_can_be_asked_of_is_a_row_too():
    batch = dataset.people(0, 3)
    batch["mass_kg"] = [None, *batch["mass_kg"][1:]]
    batch["seed"] = [batch["seed"][0], -1, batch["seed"][2]]
    found = dataset.walks(batch, steps=4)
    assert found["error"][0] and found["error"][1] and found["error"][2] == ""
