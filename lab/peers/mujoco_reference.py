"""Where a motion ends, by SciPy's DOP853 on MuJoCo's accelerations: an answer apart from our equations and from both steppers.

Reads `model FILE`, `duration S`, `q …`, `v …` from the standard input, a line each; the coordinates are hinges and slides only.
Writes `result q … v …` for each `solve TOLERANCE`.
"""

import sys

import mujoco
import numpy as np
import scipy
from scipy.integrate import solve_ivp

print("version", mujoco.__version__, scipy.__version__, flush=True)
model = data = duration = q = v = None
for line in sys.stdin:
    word, _, rest = line.strip().partition(" ")
    if word == "model":
        model = mujoco.MjModel.from_xml_path(rest)
        data = mujoco.MjData(model)
        assert model.nq == model.nv
    elif word == "duration":
        duration = float(rest)
    elif word == "q":
        q = np.array(rest.split(), float)
    elif word == "v":
        v = np.array(rest.split(), float)
    elif word == "solve":

        def rate(_, y):
            data.qpos[:], data.qvel[:] = y[: model.nq], y[model.nq :]
            mujoco.mj_forward(model, data)
            return np.concatenate([data.qvel, data.qacc])

        tolerance = float(rest)
        found = solve_ivp(rate, (0, duration), np.concatenate([q, v]), "DOP853", rtol=tolerance, atol=tolerance)
        assert found.success, found.message
        print("result", *(repr(float(x)) for x in found.y[:, -1]), flush=True)
