"""From files to a picture of a subject's joint moments, in one command.

``python -m solaris.plot subject.osim walk.mot --soles soles.ron --filter 6 --of "knee_angle_*" -o moments.svg``
"""

from __future__ import annotations

import argparse
import sys
from typing import Optional, Sequence

from solaris.trials import solve_one


def _main(arguments: Optional[Sequence[str]] = None) -> int:
    parser = argparse.ArgumentParser(prog="python -m solaris.plot", description="Joint moments of a recorded motion, as a picture.")
    parser.add_argument("model", help="the subject: .osim, .urdf, .xml, .sdf, .ron")
    parser.add_argument("motion", help="the motion: .mot, .sto, .csv, or markers: .c3d, .trc")
    parser.add_argument("--external", help="forces of plates: .mot, with --plates")
    parser.add_argument("--plates", help='whose they are, as "calcn_r= calcn_l=1_" (link=prefix of the columns)')
    parser.add_argument("--external-loads", help="an OpenSim file that says both")
    parser.add_argument("--soles", help="points of the feet, for forces of the ground that are found without plates")
    parser.add_argument("--filter", help="cut-off of a filter (Hz)")
    parser.add_argument("--order", help="its order (2)")
    parser.add_argument("--of", nargs="+", default=[], metavar="NAME", help="degrees of freedom; * stands for any text (the first six)")
    parser.add_argument("-o", "--out", default="moments.png", help="the picture: .png, .svg, .pdf (moments.png)")
    asked = vars(parser.parse_args(arguments))
    names, out = asked.pop("of"), asked.pop("out")
    if asked["motion"].lower().endswith((".c3d", ".trc")):
        asked["markers"], asked["motion"] = asked["motion"], None
    measures, error, motion = solve_one(asked)
    if motion is None:
        print(f"error: {error}", file=sys.stderr)
        return 1
    try:
        import matplotlib

        matplotlib.use("Agg")
        axes = motion.plot(*names, of="tau")
        axes.figure.savefig(out)
    except (ImportError, ValueError, OSError) as error:
        print(f"error: {error}", file=sys.stderr)
        return 1
    print(f"{measures['residual_force_rms_n']:.2f} N are missing for balance, rms; wrote {out}")
    return 0


if __name__ == "__main__":
    sys.exit(_main())
