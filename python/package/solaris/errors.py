"""What can go wrong, as exceptions with fields.

All of them are ``SolarisError``, which is a ``ValueError``: the input was refused, and nothing was changed.
"""

from __future__ import annotations

from typing import NamedTuple, Optional, Sequence

__all__ = [
    "ArgumentError",
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

    #: Empty where it is of no file.
    file: str
    #: From 1; 0 where it has no place, for it is of no text.
    line: int
    #: From 1, in characters.
    column: int
    message: str


class SolarisError(ValueError):
    """Input that was refused."""


class ArgumentError(SolarisError):
    """An argument of another shape, or that is none of those that there are; ``argument`` is its name, empty where several do not fit
    or the message alone says which.

    >>> import numpy, solaris
    >>> ann = solaris.human(1.65, 58.0)
    >>> try:
    ...     solaris.Dynamics(ann).mass_matrix(numpy.zeros(3))
    ... except solaris.ArgumentError as error:
    ...     print(error.argument)
    q
    """

    def __init__(self, message: str, argument: str = "") -> None:
        super().__init__(message)
        self.argument = argument


class _Ranged(SolarisError):
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


class _Faulty(SolarisError):
    def __init__(self, message: str, path: str = "", faults: Sequence[Fault] = ()) -> None:
        super().__init__(message)
        self.path = path
        self.faults = list(faults)


class FileError(_Faulty):
    """A file that cannot be read, or does not hold what is needed."""


class FigureError(_Ranged):
    """A figure that cannot be: every fault stands in ``faults`` with its file, line and column.

    Of a person who cannot be, the fields say which number is out of its range, as those of :class:`WalkError`.

    >>> import solaris
    >>> try:
    ...     solaris.Figure.from_text("Figure(version: 1, nam: \\"x\\", links: [])")
    ... except solaris.FigureError as error:
    ...     print([(fault.line, fault.column, fault.message) for fault in error.faults][:1])
    [(1, 20, "Figure has no field 'nam'; did you mean 'name'?")]
    >>> try:
    ...     solaris.human(9.0)
    ... except solaris.FigureError as error:
    ...     print(error.parameter, error.value, error.lower, error.upper, error.unit)
    height 9.0 0.8 2.3 m
    """

    def __init__(self, message: str, path: str = "", faults: Sequence[Fault] = (), **ranged: object) -> None:
        super().__init__(message, **ranged)  # type: ignore[arg-type]
        self.path = path
        self.faults = list(faults)


class SceneError(_Faulty):
    """A scene that cannot be: every fault stands in ``faults`` with its file, line and column."""


class ProfileError(_Faulty):
    """A profile that cannot be; faults of its text stand in ``faults`` with line and column."""


class MotionError(_Faulty):
    """Numbers that are no motion, or one of another figure: where known, at which ``sample`` or ``time`` (s) and of which ``dof``."""

    def __init__(
        self,
        message: str,
        sample: Optional[int] = None,
        time: Optional[float] = None,
        dof: Optional[str] = None,
        path: str = "",
        faults: Sequence[Fault] = (),
    ) -> None:
        super().__init__(message, path, faults)
        self.sample = sample
        self.time = time
        self.dof = dof


class DynamicsError(SolarisError):
    """A state that the kernel refuses: where known, which ``argument``, and the ``name`` of the degree of freedom, link or frame.

    Of many states ``rows`` names those that were refused; all others are done.
    """

    def __init__(
        self, message: str, rows: Sequence[int] = (), argument: Optional[str] = None, name: Optional[str] = None
    ) -> None:
        super().__init__(message)
        self.rows = list(rows)
        self.argument = argument
        self.name = name


class WalkError(_Ranged):
    """A walk that cannot be. Where a number is out of its range, its fields say which and what it may be.

    >>> import solaris
    >>> try:
    ...     solaris.walk(step_frequency=300)
    ... except solaris.WalkError as error:
    ...     print(error.parameter, error.lower, error.upper, error.unit)
    step_frequency 60.0 130.0 steps/min
    """


class RunError(SolarisError):
    """A simulation that did not come to its end: when (``time``, s), of which ``dof`` where it is one, and ``remedies``, what helps."""

    def __init__(
        self, message: str, time: Optional[float] = None, dof: Optional[str] = None, remedies: Sequence[str] = ()
    ) -> None:
        super().__init__(message)
        self.time = time
        self.dof = dof
        self.remedies = list(remedies)
