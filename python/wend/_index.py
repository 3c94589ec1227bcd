"""Index: what a planner with an index computes once for a map and a robot."""

from __future__ import annotations

import os

from . import _core
from ._arrays import checked_threads
from ._progress import progress_bar
from ._space import FreeSpace
from ._types import named_types

__all__ = ["Index"]


class Index:
    """An index for queries in microseconds. It belongs to one map, robot and policy for unknown cells.

    >>> import wend
    >>> space = wend.Map([[0, 0, 0], [0, 1, 0]]).free_space()
    >>> index = wend.Index.build(space, "hub_labels")
    >>> space.use_index(index)
    >>> space.plan((0, 1), (2, 1), planner="hub_labels").bound
    1.0
    """

    __slots__ = ("_inner",)

    _inner: _core.Index

    def __init__(self, core: _core.Index) -> None:
        self._inner = core

    @classmethod
    @named_types
    def build(
        cls, space: FreeSpace, planner: str = "hub_labels", *, threads: int = 0, progress: bool = False
    ) -> Index:
        """Computes an index. It can take minutes for a large map. Ctrl-C stops it.

        :param planner: a planner with an index, see ``wend.planners()``.
        :param threads: 0: as many as the machine runs at once.
        :param progress: show a progress bar of tqdm, where that is installed.
        :raises ValueError: the planner is unknown, or has no index.
        """
        with progress_bar(progress, 100, "%") as tell:
            return cls(_core.build_index(space._inner, planner, checked_threads(threads), tell))

    @classmethod
    @named_types
    def open(cls, file: str | os.PathLike[str]) -> Index:
        """Reads an index file into memory; who writes to the file later does not harm its users.

        :raises wend.Error: ``invalid_file``, or ``index_mismatch`` for a file that is not an index.
        """
        return cls(_core.open_index(os.fspath(file)))

    @named_types
    def save(self, file: str | os.PathLike[str]) -> None:
        """Writes the index; the file is replaced completely or not at all.

        :raises wend.Error: ``invalid_file``.

        >>> import tempfile, pathlib, wend
        >>> file = pathlib.Path(tempfile.mkdtemp()) / "map.idx"
        >>> wend.Index.build(wend.Map([[0, 0]]).free_space()).save(file)
        >>> wend.Index.open(file).planner
        'hub_labels'
        """
        self._inner.save(os.fspath(file))

    @property
    def planner(self) -> str:
        """The name of the planner that reads it."""
        return self._inner.planner

    @property
    def size(self) -> int:
        """Bytes."""
        return self._inner.size

    def __repr__(self) -> str:
        return f"<wend.Index of {self.planner}, {self.size} bytes>"
