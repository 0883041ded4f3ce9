"""Motions shown: a page in a notebook, and plots."""

from __future__ import annotations

import fnmatch
import html
from typing import Any, Optional, Sequence

from .errors import ArgumentError

#: Whose names a plot without names draws at most.
_MOST = 6


def frame(page: str) -> str:
    """A page inside of another."""
    return (
        f'<iframe srcdoc="{html.escape(page, quote=True)}" sandbox="allow-scripts" '
        'style="width:100%;height:640px;border:0"></iframe>'
    )


def plot(motion: Any, names: Sequence[str], of: str, axes: Optional[Any]) -> Any:
    """Columns of a motion over time; see ``Motion.plot``."""
    numbers = {"q": motion.q, "v": motion.v, "a": motion.a, "tau": motion.tau}
    if of not in numbers:
        raise ArgumentError(f"of is '{of}'; it must be 'q', 'v', 'a' or 'tau'", "of")
    if numbers[of] is None:
        raise ArgumentError(f"of is '{of}', which is not known of this motion", "of")
    known = motion.figure.q_names if of == "q" else motion.figure.v_names
    chosen = [i for name in names for i in _found(name, known)] if names else list(range(len(known)))[:_MOST]
    try:
        import matplotlib.pyplot as plt
    except ImportError as error:
        raise ImportError("plots need matplotlib: pip install matplotlib") from error
    if axes is None:
        _, axes = plt.subplots()
    for i in chosen:
        axes.plot(motion.time, numbers[of][:, i], label=known[i])
    units = {"q": "rad, m", "v": "rad/s, m/s", "a": "rad/s², m/s²", "tau": "N m, N"}
    axes.set_xlabel("time (s)")
    axes.set_ylabel(f"{of} ({units[of]})")
    axes.legend()
    return axes


def _found(name: str, known: Sequence[str]) -> list[int]:
    found = [i for i, other in enumerate(known) if fnmatch.fnmatchcase(other, name)]
    if not found:
        near = __import__("difflib").get_close_matches(name, known, 1)
        hint = f"; did you mean '{near[0]}'?" if near else ""
        raise ArgumentError(f"there is no column '{name}'{hint}", "columns")
    return found
