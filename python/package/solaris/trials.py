"""Batches of trials: recorded motions, a row of a table each, to joint forces.

``python -m solaris.trials trials.csv --out forces`` writes a Parquet file for each trial, with the motion and the forces in every frame,
and ``forces/trials.csv``, a row for each. What is there is not made again; what cannot be solved stays in the table, with the reason in
``error``. With ``--ray`` the trials are solved by Ray Data's ``map_batches``, on one machine or on a cluster, and the files are the same.

Columns of the table, paths beside it:

====================  =====================================================================================
``trial``             its name, that of its file
``model``             a figure: ``.osim``, ``.urdf``, ``.xml``, ``.sdf``, ``.ron``
``motion``            its motion: ``.mot``, ``.sto``, ``.csv``; or
``markers``           a recording: ``.c3d``, ``.trc``
``external``          forces of plates: ``.mot``, with
``plates``            whose they are: ``calcn_r= calcn_l=1_`` (link=prefix of the columns); or
``external_loads``    an OpenSim file that says both; or
``soles``             points of the feet, for forces of the ground that are found without plates
``filter``, ``order`` cut-off (Hz) and order of a filter
====================  =====================================================================================

>>> from solaris import trials
>>> row = {"trial": "walk", "model": "fixtures/subject/subject.osim", "motion": "fixtures/subject/walk.mot", "soles": "fixtures/subject/soles.ron"}
>>> found = trials.solve({name: [value] for name, value in {**row, "filter": 6.0, "order": 3}.items()})
>>> found["error"], bool(found["residual_force_rms_n"][0] < 1.0)
([''], True)
"""

from __future__ import annotations

import argparse
import csv
import json
import os
import sys
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path
from typing import Any, Mapping, Optional, Sequence

import numpy as np

import solaris
from solaris._parts import by_ray, threads, write

__all__ = ["make", "read", "solve", "solve_one"]

#: What a table of trials may say of each.
COLUMNS = ("trial", "model", "motion", "markers", "external", "plates", "external_loads", "soles", "filter", "order")
#: Those of them that are paths.
PATHS = ("model", "motion", "markers", "external", "external_loads", "soles")
#: What is measured of each; missing of what cannot be solved.
MEASURES = ("frames", "duration_s", "mass_kg", "residual_force_rms_n", "residual_moment_rms_nm", "marker_rms_m")


def read(path: os.PathLike[str] | str) -> dict[str, list[str]]:
    """A table of trials, by columns; its paths as seen from here."""
    with open(path, newline="", encoding="utf-8-sig") as file:
        lines = csv.reader(file)
        names = [name.strip() for name in next(lines, [])]
        rows = [row for row in lines if any(field.strip() for field in row)]
    unknown = [name for name in names if name not in COLUMNS]
    if unknown or not {"trial", "model"} <= set(names):
        known = ", ".join(COLUMNS)
        raise solaris.FileError(f"{path}: the first line names its columns; {unknown or names} are not or not enough of {known}", str(path))
    for number, row in enumerate(rows, 2):
        if len(row) != len(names):
            raise solaris.FileError(f"{path}, line {number}: it has {len(row)} fields, the header has {len(names)}", str(path))
    table = {name: [row[at].strip() for row in rows] for at, name in enumerate(names)}
    for name in set(PATHS) & set(names):
        table[name] = [str(Path(path).parent / field) if field else "" for field in table[name]]
    taken: dict[str, int] = {}
    for index, trial in enumerate(table["trial"]):
        file_name = _file_name(trial)
        # Names that differ in their letters' case are one file on some disks.
        other = taken.setdefault(file_name.lower(), index)
        if other != index:
            raise solaris.FileError(f"{path}: trials '{table['trial'][other]}' and '{trial}' would be one file, {file_name}", str(path))
    return table


def solve(batch: Mapping[str, Sequence[Any]]) -> dict[str, Any]:
    """The joint forces of some trials, a row each: a pure function of the files that are named, for ``map_batches``.

    Besides :data:`MEASURES` and ``error`` a row has ``motion``: all columns of ``motion.to_dict()``, as a dictionary of lists.
    """
    rows = range(len(batch["trial"]))
    # Analyses let go of Python, so that threads use the cores of this machine.
    with ThreadPoolExecutor(threads()) as pool:
        found = list(pool.map(lambda row: solve_one({name: batch[name][row] for name in batch}), rows))
    table: dict[str, Any] = {name: list(batch[name]) for name in batch}
    for name in MEASURES:
        table[name] = np.array([measures.get(name, np.nan) for measures, _, _ in found])
    table["error"] = [error for _, error, _ in found]
    table["motion"] = [motion.to_dict() if motion else {} for _, _, motion in found]
    return table


def solve_one(asked: Mapping[str, Any]) -> tuple[dict[str, float], str, Optional[solaris.Motion]]:
    """One trial: its measures, what is wrong with it (nothing where all went well), and its motion with joint forces."""
    said = {name: str(value) for name, value in asked.items() if value is not None and str(value).strip() not in ("", "nan")}
    measures: dict[str, float] = {}
    try:
        smooth: dict[str, Any] = {}
        if "filter" in said:
            smooth = {"filter": _number(said, "filter"), "order": int(_number(said, "order")) if "order" in said else 2}
        figure = solaris.read_figure(_needed(said, "model"))
        if "markers" in said:
            found = solaris.inverse_kinematics(figure, said["markers"])
            motion, measures["marker_rms_m"] = found.motion, found.rms
        else:
            motion = solaris.read_motion(figure, _needed(said, "motion"))
        if "soles" in said:
            ground = solaris.ground_forces(motion, soles=said["soles"], **smooth)
            solved = solaris.inverse_dynamics(ground.motion, ground)
        else:
            solved = solaris.inverse_dynamics(
                motion,
                external=said.get("external"),
                plates=_plates(said["plates"]) if "plates" in said else None,
                external_loads=said.get("external_loads"),
                **smooth,
            )
    except (solaris.SolarisError, OSError) as error:
        return {}, str(error), None
    motion = solved.motion
    measures["frames"] = len(motion)
    measures["duration_s"] = float(motion.time[-1] - motion.time[0])
    measures["mass_kg"] = figure.mass
    measures["residual_force_rms_n"] = solved.residual["force_rms_n"]
    measures["residual_moment_rms_nm"] = solved.residual["moment_rms_nm"]
    return measures, "", motion


def _needed(said: Mapping[str, str], name: str) -> str:
    if name not in said:
        raise solaris.SolarisError(f"the trial has no {name}")
    return said[name]


def _number(said: Mapping[str, str], name: str) -> float:
    try:
        return float(said[name])
    except ValueError:
        raise solaris.SolarisError(f"{name} is '{said[name]}', which is no number") from None


def _plates(said: str) -> dict[str, str]:
    pairs = [pair.partition("=") for pair in said.split()]
    wrong = [link for link, sign, _ in pairs if not sign]
    if wrong:
        raise solaris.SolarisError(f"plates: '{wrong[0]}' is no link=prefix, such as calcn_l=1_")
    return {link: prefix for link, _, prefix in pairs}


def _file_name(trial: str) -> str:
    clean = "".join(letter if letter.isalnum() or letter in "-_." else "_" for letter in trial[:80]).lstrip(".")
    # Names of files have so many bytes.
    clean = clean.encode()[:200].decode(errors="ignore")
    return f"{clean or '_'}.parquet"


def _part(number: int, table: Mapping[str, Sequence[Any]], out: Path) -> Path:
    """Solves one trial, if its file is not there, and gives its path; what was measured stands in the file's metadata."""
    import pyarrow

    path = out / _file_name(str(table["trial"][number]))
    if path.exists() and _said(path)["asked"] == _asked(number, table):
        return path
    measures, error, motion = solve_one({name: table[name][number] for name in table})
    columns = motion.to_dict() if motion else {}
    said = {"asked": _asked(number, table), "error": error, **measures}
    part = pyarrow.table(columns).replace_schema_metadata({"solaris": json.dumps(said)})
    write(part, path)
    return path


def _asked(number: int, table: Mapping[str, Sequence[Any]]) -> dict[str, str]:
    return {name: str(table[name][number]) for name in COLUMNS if name in table}


def _said(path: Path) -> dict[str, Any]:
    import pyarrow.parquet

    metadata = pyarrow.parquet.read_schema(path).metadata or {}
    said: dict[str, Any] = json.loads(metadata.get(b"solaris", b'{"asked": {}}'))
    return said


def make(
    table: Mapping[str, Sequence[Any]],
    out: os.PathLike[str] | str,
    *,
    ray: bool = False,
    workers: Optional[int] = None,
    progress: bool = False,
) -> Path:
    """Solves all trials of a table, or those that are not there yet, and gives the path of ``trials.csv``, a row for each."""
    folder = Path(out)
    folder.mkdir(parents=True, exist_ok=True)
    folder = folder.resolve()
    count = len(table["trial"])
    if ray and count:
        by_ray(lambda number: _part(number, table, folder), count, workers)
    else:
        with ThreadPoolExecutor(workers or os.cpu_count()) as pool:
            for done, _ in enumerate(pool.map(lambda number: _part(number, table, folder), range(count)), 1):
                if progress:
                    print(f"\r{done} of {count} trials", end="", file=sys.stderr, flush=True)
        if progress:
            print(file=sys.stderr)
    index = folder / "trials.csv"
    beside = folder / f".trials-{os.getpid()}.csv"
    with open(beside, "w", newline="", encoding="utf-8") as file:
        lines = csv.writer(file)
        lines.writerow(["trial", "file", *MEASURES, "error"])
        for trial in table["trial"]:
            name = _file_name(str(trial))
            said = _said(folder / name)
            lines.writerow([trial, name, *(said.get(measure, "") for measure in MEASURES), said["error"]])
    beside.replace(index)
    return index


def _main(arguments: Optional[Sequence[str]] = None) -> int:
    parser = argparse.ArgumentParser(
        prog="python -m solaris.trials", description="Recorded motions, a row of a table each, to joint forces.", epilog=f"Columns: {', '.join(COLUMNS)}."
    )
    parser.add_argument("table", help="trials.csv, a trial a row")
    parser.add_argument("--out", required=True, help="folder for a .parquet of each and trials.csv; what is there is kept")
    parser.add_argument("--ray", action="store_true", help="by Ray Data, on all of its machines")
    parser.add_argument("--workers", type=int, help="trials at once (one a core; with Ray as it thinks)")
    asked = parser.parse_args(arguments)
    try:
        index = make(read(asked.table), asked.out, ray=asked.ray, workers=asked.workers, progress=True)
        with open(index, newline="", encoding="utf-8") as file:
            rows = list(csv.DictReader(file))
    except (ValueError, OSError, ImportError) as error:
        print(f"error: {error}", file=sys.stderr)
        return 1
    except KeyboardInterrupt:
        print("\nstopped; the same command goes on where this one was", file=sys.stderr)
        return 130
    wrong = [row for row in rows if row["error"]]
    for row in wrong[:3]:
        print(f"{row['trial']}: {row['error']}", file=sys.stderr)
    print(f"{len(rows) - len(wrong)} of {len(rows)} trials solved; {index}")
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(_main())
