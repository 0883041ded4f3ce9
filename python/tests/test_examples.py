"""Every example in a docstring, and every block of docs/python.md, is run."""

import doctest
import re
import subprocess
import sys
from pathlib import Path

import pytest

import solaris
import solaris._solaris
import solaris.dataset
import solaris.errors
import solaris.plot
import solaris.trials

REPOSITORY = Path(__file__).resolve().parents[2]


def documented():
    """Functions, classes and their methods that have examples."""
    for name in solaris.__all__:
        thing = getattr(solaris, name)
        yield name, thing.__doc__
        if isinstance(thing, type):
            for part, method in vars(thing).items():
                if not part.startswith("_"):
                    yield f"{name}.{part}", getattr(method, "__doc__", None)
    for module in (solaris, solaris.errors, solaris.dataset, solaris.trials, solaris.plot):
        yield module.__name__, module.__doc__


@pytest.mark.parametrize("name", [name for name, text in documented() if text and ">>>" in text])
def test_examples_run(name):
    text = dict(documented())[name]
    parsed = doctest.DocTestParser().get_doctest(text, {}, name, name, 0)
    result = doctest.DocTestRunner().run(parsed)
    assert result.attempted > 0 and result.failed == 0


def test_everything_public_is_documented():
    for name, text in documented():
        assert text, f"{name} has no docstring"


@pytest.mark.parametrize(
    "page, least",
    [
        ("docs/python.md", 10),
        ("docs/learn/biomechanics.md", 1),
        ("docs/learn/robotics.md", 1),
        ("README.md", 1),
        ("python/README.md", 1),
    ],
)
def test_pages_run(page, least, tmp_path, monkeypatch):
    text = (REPOSITORY / page).read_text()
    blocks = re.findall(r"```python\n(.*?)```", text, re.S)
    assert len(blocks) >= least
    (tmp_path / "fixtures").symlink_to(REPOSITORY / "fixtures")
    monkeypatch.chdir(tmp_path)
    import matplotlib

    matplotlib.use("Agg")
    names: dict = {}
    for block in blocks:
        exec(compile(block, page, "exec"), names)


def test_a_picture_takes_the_command_of_the_page(tmp_path, monkeypatch):
    text = (REPOSITORY / "docs/python.md").read_text().replace("\\\n", " ")
    (line,) = re.findall(r"&& python (-m solaris\.plot .*)", text)
    (tmp_path / "fixtures").symlink_to(REPOSITORY / "fixtures")
    done = subprocess.run([sys.executable, *line.split()], capture_output=True, text=True, cwd=tmp_path)
    assert done.returncode == 0, done.stderr
    assert (tmp_path / "moments.png").stat().st_size > 10_000


def test_the_stub_is_what_is_there():
    pytest.importorskip("mypy")
    configured = str(REPOSITORY / "python" / "pyproject.toml")
    command = [sys.executable, "-m", "mypy.stubtest", "solaris", "--mypy-config-file", configured]
    found = subprocess.run(command, capture_output=True, text=True, cwd=Path(__file__).parent)
    assert found.returncode == 0, found.stdout

