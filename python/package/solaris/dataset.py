"""Datasets of walks: many people, a row each, in partitioned Parquet files.

``python -m solaris.dataset --people 1000 --out walks`` writes ``walks/part-00000.parquet`` and so on. A part is a pure function of
the seed and its number: a part that is there is not made again, so that whoever was interrupted goes on, and any number of
workers write the same bytes. Who cannot walk as asked stays in the table, with the reason in ``error``.

With Ray (``pip install "ray[data]"``) and ``--ray`` the parts are made by Ray Data's ``map_batches``, on one machine or on a
cluster; the folder must then be one that all of its machines see.

>>> from solaris import dataset
>>> rows = dataset.walks(dataset.people(0, 3, seed=7))
>>> rows["error"], bool(rows["step_length_m"][0] > 0.4)
(['', '', ''], True)
"""

from __future__ import annotations

import argparse
import json
import os
import sys
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path
from typing import Any, Mapping, Optional, Sequence

import numpy as np

import solaris
from solaris._parts import by_ray, threads, write

__all__ = ["make", "part", "people", "walks"]

#: People of a part.
PART = 500
#: What is measured of each walk, by the columns' names; missing of who cannot walk.
MEASURES = (
    "step_length_m",
    "speed_m_s",
    "duration_s",
    "peak_knee_flexion_rad",
    "peak_ankle_moment_nm_kg",
    "peak_vertical_force_over_weight",
    "work_of_joints_j_kg_m",
)


def people(start: int, count: int, seed: int = 0) -> dict[str, Any]:
    """People number ``start`` and the next ones: their size, pace and manner, drawn from the seed and their number alone.

    Heights and body mass indices are those of adults (1.70 ± 0.10 m, 24.5 ± 3.5 kg/m²), paces 105 ± 10 steps/min, all kept within
    2.5 deviations; a third walks in a manner.
    """
    manners = ["", "", "tired", "sad", "happy", "proud"]
    drawn = []
    for number in range(start, start + count):
        chance = np.random.Generator(np.random.PCG64([seed, number]))
        height, index, pace = np.clip(chance.standard_normal(3), -2.5, 2.5) * (0.10, 3.5, 10.0) + (1.70, 24.5, 105.0)
        manner = manners[int(chance.integers(len(manners)))]
        drawn.append((number, height, index * height**2, pace, manner, int(chance.integers(2**31))))
    names = ("person", "height_m", "mass_kg", "step_frequency_per_min", "manner", "seed")
    columns = dict(zip(names, map(list, zip(*drawn)))) if drawn else {name: [] for name in names}
    return {name: column if name == "manner" else np.array(column) for name, column in columns.items()}


def walks(batch: Mapping[str, Any], steps: int = 10, frames: Optional[float] = None) -> dict[str, Any]:
    """The walks of some people, a row each: a pure function of its arguments, for ``map_batches``.

    With ``frames`` (1/s) each row has its motion besides: ``time``, ``q`` and ``tau``, samples one after the other.
    """
    rows = len(batch["person"])

    def one(row: int) -> tuple[dict[str, float], str, Optional[tuple[np.ndarray, np.ndarray, np.ndarray]]]:
        asked = {name: batch[name][row] for name in batch}
        try:
            walk = solaris.walk(
                height=float(asked["height_m"]),
                mass=float(asked["mass_kg"]),
                step_frequency=float(asked["step_frequency_per_min"]),
                manner=str(asked["manner"]) or None,
                variability=1.0,
                seed=int(asked["seed"]),
                steps=steps,
                rate=frames or 60.0,
            )
        except (solaris.SolarisError, OverflowError, TypeError, ValueError) as error:
            return {}, str(error), None
        motion = walk.motion
        assert motion.tau is not None, "a walk has its forces"
        kept = (motion.time, motion.q.ravel(), motion.tau.ravel()) if frames else None
        return _measured(walk), "", kept

    # Planning lets go of Python, so that threads use the cores of this machine.
    with ThreadPoolExecutor(threads()) as pool:
        found = list(pool.map(one, range(rows)))
    table = {name: batch[name] for name in batch}
    for name in MEASURES:
        table[name] = np.array([measures.get(name, np.nan) for measures, _, _ in found])
    table["error"] = [error for _, error, _ in found]
    if frames:
        for at, name in enumerate(("time", "q", "tau")):
            table[name] = [[] if kept is None else kept[at] for _, _, kept in found]
    return table


def _measured(walk: solaris.Walk) -> dict[str, float]:
    motion, figure = walk.motion, walk.figure
    assert motion.tau is not None and motion.v is not None, "a walk has its forces"
    names = figure.v_names
    at = {name: names.index(name) for name in ("left_knee.rx", "right_knee.rx", "left_ankle.rx", "right_ankle.rx")}
    knees = motion.q[:, [at["left_knee.rx"], at["right_knee.rx"]]]
    ankles = motion.tau[:, [at["left_ankle.rx"], at["right_ankle.rx"]]]
    force = np.stack([contact["force"][:, 1] for contact in motion.contacts.values()])
    power = np.abs(motion.tau[:, 6:] * motion.v[:, 6:]).sum(axis=1)
    work = float(((power[1:] + power[:-1]) / 2 * np.diff(motion.time)).sum())
    way = float(np.hypot(*(motion.q[-1, [0, 2]] - motion.q[0, [0, 2]])))
    weight = figure.mass * float(np.linalg.norm(motion.gravity))
    return dict(
        zip(
            MEASURES,
            (
                walk.step_length,
                walk.speed,
                walk.duration,
                float(np.abs(knees).max()),
                float(np.abs(ankles).max()) / figure.mass,
                float(force.max()) / weight,
                work / (figure.mass * way),
            ),
        )
    )


def part(number: int, plan: Mapping[str, Any]) -> Path:
    """Makes one part of a dataset, if it is not there, and gives its path: it is there whole or not at all."""
    import pyarrow

    path = Path(plan["out"]) / f"part-{number:05}.parquet"
    if path.exists():
        return path
    start = number * plan["part"]
    count = min(plan["part"], plan["people"] - start)
    write(pyarrow.table(walks(people(start, count, plan["seed"]), plan["steps"], plan["frames"])), path)
    return path


def make(
    out: os.PathLike[str] | str,
    people: int,
    *,
    seed: int = 0,
    steps: int = 10,
    frames: Optional[float] = None,
    part_size: int = PART,
    ray: bool = False,
    workers: Optional[int] = None,
    progress: bool = False,
) -> list[Path]:
    """Writes a dataset, or goes on with one, and gives the paths of its parts. Another plan in the same folder is refused."""
    if people < 1 or part_size < 1:
        raise solaris.ArgumentError(f"people is {people} and part_size {part_size}; both must be at least 1")
    if seed < 0 or steps < 1 or (frames is not None and not 0.0 < frames < float("inf")):
        raise solaris.ArgumentError(f"seed is {seed}, steps {steps} and frames {frames}; they must be at least 0, at least 1 and above 0 or left out")
    folder = Path(out)
    folder.mkdir(parents=True, exist_ok=True)
    plan: dict[str, Any] = {"people": people, "seed": seed, "steps": steps, "frames": frames, "part": part_size}
    # Rows of two versions are no one dataset.
    plan["solaris"] = solaris.__version__
    # Begins as what readers of whole folders leave out.
    said = folder / "_plan.json"
    if said.exists() and _read(said) != plan:
        raise solaris.FileError(
            f"{said} is of another dataset: {said.read_text().strip()}; name another folder, or ask for the same with the same version",
            str(said),
        )
    beside = said.with_name(f".plan-{os.getpid()}.json")
    beside.write_text(json.dumps(plan) + "\n")
    beside.replace(said)
    plan["out"] = str(folder.resolve())
    numbers = range(-(-people // part_size))
    if ray:
        return by_ray(lambda number: part(number, plan), len(numbers), workers)
    done = []
    for number in numbers:
        done.append(part(number, plan))
        if progress:
            print(f"\r{number + 1} of {len(numbers)} parts", end="", file=sys.stderr, flush=True)
    if progress:
        print(file=sys.stderr)
    return done


def _read(plan: Path) -> Any:
    try:
        return json.loads(plan.read_text())
    except ValueError:
        raise solaris.FileError(f"{plan} is no plan of a dataset; name another folder, or delete it if its parts are of this very command", str(plan)) from None


def _main(arguments: Optional[Sequence[str]] = None) -> int:
    parser = argparse.ArgumentParser(prog="python -m solaris.dataset", description="Many people walk: a row each, as Parquet.")
    parser.add_argument("--people", type=int, required=True, help="how many")
    parser.add_argument("--out", required=True, help="folder for part-*.parquet; what is there is kept, and gone on with")
    parser.add_argument("--seed", type=int, default=0, help="another seed is other people (0)")
    parser.add_argument("--steps", type=int, default=10, help="steps of each walk (10)")
    parser.add_argument("--frames", type=float, help="keep the motions, so many samples a second")
    parser.add_argument("--part", type=int, default=PART, help=f"people of a file ({PART})")
    parser.add_argument("--ray", action="store_true", help="by Ray Data, on all of its machines")
    parser.add_argument("--workers", type=int, help="parts that Ray makes at once (as it thinks)")
    asked = parser.parse_args(arguments)
    try:
        paths = make(
            asked.out,
            asked.people,
            seed=asked.seed,
            steps=asked.steps,
            frames=asked.frames,
            part_size=asked.part,
            ray=asked.ray,
            workers=asked.workers,
            progress=True,
        )
    except (ValueError, OSError, ImportError) as error:
        print(f"error: {error}", file=sys.stderr)
        return 1
    except KeyboardInterrupt:
        print("\nstopped; the same command goes on where this one was", file=sys.stderr)
        return 130
    print(f"{len(paths)} files in {asked.out}")
    return 0


if __name__ == "__main__":
    sys.exit(_main())
