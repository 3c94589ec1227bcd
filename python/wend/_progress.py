"""Progress bars: those of tqdm, where it is installed."""

from __future__ import annotations

import contextlib
from collections.abc import Callable, Iterator
from typing import Any

__all__ = ["progress_bar"]


def _tqdm() -> Any:
    try:
        from tqdm.auto import tqdm
    except ImportError:
        return None
    return tqdm


@contextlib.contextmanager
def progress_bar(shown: bool, total: int, unit: str) -> Iterator[Callable[[float], None] | None]:
    """A function that takes the share that is done, from 0 to 1; None without tqdm, or if nothing is to be shown."""
    tqdm = _tqdm() if shown else None
    if tqdm is None:
        yield None
        return
    with tqdm(total=total, unit=unit) as bar:
        yield lambda share: bar.update(round(share * total) - bar.n)
        bar.update(total - bar.n)  # some planners do not say that they are done
