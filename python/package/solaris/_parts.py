"""Parts of a large job: each a file that is there whole or not at all, made here or by Ray Data's workers."""

from __future__ import annotations

import os
from pathlib import Path
from typing import Any, Callable, Optional


def write(table: Any, path: Path) -> None:
    """Writes a table of pyarrow as Parquet: whoever is killed leaves no half of a file."""
    import pyarrow.parquet

    beside = path.with_name(f".{path.name}-{os.getpid()}")
    pyarrow.parquet.write_table(table, beside, compression="zstd")
    with open(beside, "rb") as written:
        os.fsync(written.fileno())
    beside.replace(path)


def by_ray(make: Callable[[int], Path], count: int, workers: Optional[int]) -> list[Path]:
    """Makes so many parts on Ray's machines, so many at once."""
    import ray.data

    def makes(batch: dict[str, Any]) -> dict[str, list[str]]:
        return {"path": [str(make(int(number))) for number in batch["id"]]}

    parts = ray.data.range(count, override_num_blocks=count)
    done = parts.map_batches(makes, batch_size=1, concurrency=workers).take_all()
    return sorted(Path(row["path"]) for row in done)


def threads() -> int:
    """How many threads a part may have: as ``OMP_NUM_THREADS`` says, which Ray sets to the cores of a task, or one a core."""
    said = os.environ.get("OMP_NUM_THREADS", "")
    return int(said) if said.isdigit() and int(said) > 0 else os.cpu_count() or 1
