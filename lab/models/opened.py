"""Which model files the reference engines open: one process a file, for some of them crash.

    pip install pin mujoco opensim
    python opened.py FOLDER SET=ENGINE:PATTERN …

writes FOLDER/SET.opened for each set, a line a file: `ok` or `no`, the path under FOLDER, and what the engine said. PATTERN is a
glob under FOLDER; ENGINE is pinocchio, mujoco or opensim. `cargo lab models FOLDER` reads it.
"""

import glob
import os
import subprocess
import sys

OPEN = {
    "pinocchio": "import pinocchio, sys; m = pinocchio.buildModelFromUrdf(sys.argv[1]); print('opened', m.nq, m.nv)",
    "mujoco": "import mujoco, sys; m = mujoco.MjModel.from_xml_path(sys.argv[1]); print('opened', m.nq, m.nv)",
    "opensim": "import opensim, sys; opensim.Logger.setLevelString('off'); m = opensim.Model(sys.argv[1]); "
    "s = m.initSystem(); print('opened', s.getNQ(), s.getNU())",
}


def opened(engine, path):
    """Whether the engine opens the file, and the last line that it said."""
    try:
        run = subprocess.run(
            [sys.executable, "-c", OPEN[engine], path], capture_output=True, timeout=120, stdin=subprocess.DEVNULL
        )
    except subprocess.TimeoutExpired:
        return False, "no answer in 120 s"
    lines = run.stdout.decode("utf8", "replace").splitlines()
    good = [line for line in lines if line.startswith("opened")]
    said = run.stderr.decode("utf8", "replace").strip().splitlines()
    return bool(good), good[0] if good else (said or [f"exit code {run.returncode}"])[-1][:200]


def main():
    folder = sys.argv[1]
    for argument in sys.argv[2:]:
        name, rest = argument.split("=", 1)
        engine, pattern = rest.split(":", 1)
        paths = sorted(glob.glob(pattern, root_dir=folder, recursive=True))
        with open(os.path.join(folder, f"{name}.opened"), "w", encoding="utf8") as out:
            for path in paths:
                good, said = opened(engine, os.path.abspath(os.path.join(folder, path)))
                out.write(f"{'ok' if good else 'no'}\t{path}\t{said}\n")
                out.flush()
        print(name, len(paths), "files")


main()
