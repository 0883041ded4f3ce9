"""What can go wrong, as exceptions with fields.

All of them are ``SolarisError``, which is a ``ValueError``: the input was refused, and nothing was changed.
"""

from __future__ import annotations

from typing import NamedTuple, Optional, Sequence

__all__ = [
    "DynamicsError",
    "Fault",
    "FigureError",
    "FileError",
    "MotionError",
    "ProfileError",
    "RunError",
    "SceneError",
    "SolarisError",
    "WalkError",
]


class Fault(NamedTuple):
    """One fault of a text, with its place."""

    file: str
    #: From 1.
    line: int
    #: From 1, in characters.
    column: int
    message: str


class SolarisError(ValueError):
    """Input that was refused."""


class FileError(SolarisError):
    """A file that cannot be read, or does not hold what is needed."""

    def __init__(self, message: str, path: str = "") -> None:
        super().__init__(message)
        self.path = path


class _Faulty(SolarisError):
    def __init__(self, message: str, path: str = "", faults: Sequence[Fault] = ()) -> None:
        super().__init__(message)
        self.path = path
        self.faults = list(faults)


class FigureError(_Faulty):
    """A figure that cannot be: every fault stands in ``faults`` with its file, line and column.

    >>> import solaris
    >>> try:
    ...     solaris.Figure.from_text("Figure(version: 1, nam: \\"x\\", links: [])")
    ... except solaris.FigureError as error:
    ...     print([(fault.line, fault.column, fault.message) for fault in error.faults][:1])
    [(1, 20, "Figure has no field 'nam'; did you mean 'name'?")]
    """


class SceneError(_Faulty):
    """A scene that cannot be: every fault stands in ``faults`` with its file, line and column."""


class ProfileError(_Faulty):
    """A profile that cannot be; faults of its text stand in ``faults`` with line and column."""


class MotionError(SolarisError):
    """Numbers that are no motion, or one of another figure."""


class DynamicsError(SolarisError):
    """A state that the kernel refuses; of many states ``rows`` names those that were refused, all others are done."""

    def __init__(self, message: str, rows: Sequence[int] = ()) -> None:
        super().__init__(message)
        self.rows = list(rows)


class WalkError(SolarisError):
    """A walk that cannot be. Where a number is out of its range, its fields say which and what it may be.

    >>> import solaris
    >>> try:
    ...     solaris.walk(step_frequency=300)
    ... except solaris.WalkError as error:
    ...     print(error.parameter, error.lower, error.upper, error.unit)
    step_frequency 60.0 130.0 steps/min
    """

    def __init__(
        self,
        message: str,
        parameter: Optional[str] = None,
        value: Optional[float] = None,
        lower: Optional[float] = None,
        upper: Optional[float] = None,
        unit: Optional[str] = None,
    ) -> None:
        super().__init__(message)
        self.parameter = parameter
        self.value = value
        self.lower = lower
        self.upper = upper
        self.unit = unit


class RunError(SolarisError):
    """A simulation that did not come to its end."""
