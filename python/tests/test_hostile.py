"""Names that mean no good go through every file and page, and come back as names."""

import html.parser
import json
import struct

import numpy as np
import pytest

import solaris

NAMES = [
    "</script><script>alert(1)</script>",
    '"><img src=x onerror=alert(1)>',
    "a\",\"name\":\"b",
    "a\\\"b\\n",
    "a;b,c\td",
    "'; DROP TABLE walks; --",
    "=cmd|' /C calc'!A0",
    "\u202eevil\u200b",
    "{{7*7}} ${x} `id`",
    "../../etc/passwd",
    "one\ntwo\r\nthree",
    "nul\0byte",
    "\x1b[31mred",
    "\N{BONE} \N{ZERO WIDTH JOINER}",
    " ends with a space ",
    "x" * 3000,
]


def swung(name):
    """A pendulum of that name, link and joint too, and how it swings."""
    said = "".join(f"\\u{{{ord(letter):x}}}" if not letter.isalnum() else letter for letter in name)
    figure = solaris.Figure.from_text(
        f'Figure(version: 1, name: "{said}", links: [Link(name: "{said}", joint: Joint(name: "{said}", axes: [rx(name: "{said}")]), '
        "mass: 1.0, com: (0.0, -0.5, 0.0), inertia: (0.1, 0.1, 0.1))])"
    )
    assert figure.links == [name] and figure.v_names == [name]
    time = np.linspace(0.0, 1.0, 11)
    return solaris.Motion(figure, time, np.sin(time)[:, None])


class Seen(html.parser.HTMLParser):
    """Elements of a page, and what runs in it."""

    def __init__(self, page):
        super().__init__()
        self.tags, self.handlers = [], []
        self.feed(page)

    def handle_starttag(self, tag, attrs):
        self.tags.append(tag)
        self.handlers += [name for name, _ in attrs if name.startswith("on")]


@pytest.mark.parametrize("name", NAMES)
def test_a_page_runs_nothing_of_a_name(name):
    usual = Seen(swung("arm").to_html())
    seen = Seen(swung(name).to_html())
    assert seen.tags == usual.tags and seen.handlers == usual.handlers
    shown = Seen(swung(name)._repr_html_())
    assert shown.tags == ["iframe"] and not shown.handlers


@pytest.mark.parametrize("name", NAMES)
def test_tables_keep_names(name, tmp_path):
    parquet = pytest.importorskip("pyarrow.parquet")
    motion = swung(name)
    motion.save(tmp_path / "x.parquet")
    table = parquet.read_table(tmp_path / "x.parquet")
    assert table.column_names == motion.columns and f"{name}.q" in table.column_names
    assert np.array_equal(table[f"{name}.q"].to_numpy(), motion.q[:, 0])
    if "\n" in name or name != name.strip():
        with pytest.raises(solaris.FileError, match="cannot be a name in CSV"):
            motion.save(tmp_path / "x.csv")
        return
    motion.save(tmp_path / "x.csv")
    assert np.array_equal(solaris.read_motion(motion.figure, tmp_path / "x.csv").q, motion.q)


@pytest.mark.parametrize("name", NAMES)
def test_animation_files_keep_names(name, tmp_path):
    motion = swung(name)
    motion.save(tmp_path / "x.glb")
    data = (tmp_path / "x.glb").read_bytes()
    length = struct.unpack_from("<I", data, 12)[0]
    document = json.loads(data[20 : 20 + length])
    assert name in {node.get("name") for node in document["nodes"]}
    # Names make no lines and no parts of their own.
    usual = swung("arm")
    for path, parts in (("x.bvh", ("JOINT", "ROOT", "End Site")), ("x.usda", ("def ", "{", "}"))):
        shapes = []
        for saved in (motion, usual):
            saved.save(tmp_path / path)
            lines = (tmp_path / path).read_text().splitlines()
            shapes.append([len(lines), *(sum(line.lstrip().startswith(part) for line in lines) for part in parts)])
        assert shapes[0] == shapes[1], path
