"""Profiles beside closed forms and beside differences of their own samples."""

import numpy as np
import pytest

import solaris


def test_the_least_jerk_is_that_of_flash_and_hogan():
    reach = solaris.Profile("minimum-jerk", from_=1.0, to=3.0, duration=2.0)
    t = np.linspace(0.0, 2.0, 41)
    s = t / 2.0
    assert np.allclose(reach(t), 1.0 + 2.0 * (10 * s**3 - 15 * s**4 + 6 * s**5), atol=1e-14)
    assert reach.at(1.0)[1] == pytest.approx(2.0 * 1.875 / 2.0)
    assert reach.peaks()["velocity"] == pytest.approx((1.0, 1.875))
    assert reach.stationary() == [] and reach.is_monotone


def test_every_kind_has_the_derivatives_that_differences_have():
    values = {"from_": 0.1, "to": 1.2, "duration": 1.5, "exponent": 3, "stiffness": 2.0, "shape": 1.4}
    made = 0
    for name, kind in solaris.Profile.kinds().items():
        keys = [(0.0, 0.0), (0.5, 1.0), (1.5, 0.4)] if kind["keys"] else None
        given = {key: values[key] for key in kind["required"] if key in values}
        try:
            profile = solaris.Profile(name, keys=keys, **given)
        except solaris.ProfileError:
            continue
        made += 1
        t = np.linspace(0.0, profile.duration, 403)[1:-1]
        # A kink or a jump between two samples is none of differences.
        q = profile.at(t)
        h = 1e-5 * profile.duration
        inside = (t > 2 * h) & (t < profile.duration - 2 * h)
        for of in range(2):
            slope = (profile.at(t + h)[:, of] - profile.at(t - h)[:, of]) / (2 * h)
            error = np.abs(slope - q[:, of + 1])[inside] / (1.0 + np.abs(q[:, of + 1])[inside])
            assert np.median(error) < 1e-5, name
        assert profile.range()[0] <= q[:, 0].min() + 1e-12 and profile.range()[1] >= q[:, 0].max() - 1e-12
        assert solaris.Profile.from_text(profile.to_text()) == profile
    assert made > 10


def test_a_sine_turns_round_where_it_does():
    wave = solaris.Profile.from_text("Sine(amplitude: 0.2, period: 1, cycles: 2, offset: 0.5)")
    assert [round(time, 9) for time, _ in wave.stationary()] == [0.25, 0.75, 1.25, 1.75]
    assert {turn for _, turn in wave.stationary()} == {"reversal"}
    assert wave.range("velocity", 0.2, 0.3)[1] == pytest.approx(0.2 * 2 * np.pi * np.cos(2 * np.pi * 0.2))
    assert np.shape(wave(0.1)) == () and wave.at(np.zeros((2, 3))).shape == (2, 3, 4)


def test_what_is_no_profile_is_said():
    for make, message in (
        (lambda: solaris.Profile("minimum-jrk"), "minimum-jerk"),
        (lambda: solaris.Profile("minimum-jerk", from_=0.0, to=1.0), "duration"),
        (lambda: solaris.Profile("minimum-jerk", from_=0.0, to=1.0, duration=-1.0), "-1"),
        (lambda: solaris.Profile("minimum-jerk", from_=0.0, to=float("nan"), duration=1.0), "NaN"),
        (lambda: solaris.Profile("line", from_=0.0, to=1.0, duration=1.0, speed=2.0), "speed"),
        (lambda: solaris.Profile("line", from_=0.0, to=1.0, duration=1.0)([0.0, np.nan]), "t holds NaN at 1"),
        (lambda: solaris.Profile("line", from_=0.0, to=1.0, duration=1.0).range("speed"), "quantity is 'speed'"),
        (lambda: solaris.Profile("line", from_=0.0, to=1.0, duration=1.0).range(start=0.5, end=2.0), "end is 2"),
    ):
        with pytest.raises(ValueError, match=message):
            make()
    with pytest.raises(solaris.ProfileError) as caught:
        solaris.Profile.from_text("Line(from: 0, to: 1,\n     durtion: 2)")
    assert [(fault.line, fault.column) for fault in caught.value.faults] == [(1, 1), (2, 6)]
