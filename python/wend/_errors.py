"""The exceptions of wend, and how errors of the C++ side become exceptions."""

from __future__ import annotations

from . import _core
from ._listed import Listed

__all__ = ["Error", "InvalidArgument", "Metrics", "NoPath"]


class Metrics(Listed[int], fields=_core.search_metrics()):
    """The work of one search."""

    __slots__ = ()


class Error(Exception):
    """Why wend could not do what was asked.

    `status` is the name of the kind of problem, the same as in C++ (``"invalid_map"``, ``"index_mismatch"``, ...);
    `where` is what is wrong: the name of an argument or an option, or a file and line; it may be empty.
    """

    status: str
    where: str

    def __init__(self, message: str, status: str = "invalid_option", where: str = "") -> None:
        # Exceptions are pickled, and so come out of other processes, by these arguments.
        super().__init__(message, status, where)
        self.status = status
        self.where = where

    def __str__(self) -> str:
        return str(self.args[0])


class InvalidArgument(Error, ValueError):
    """An argument, an option or a map that is not valid.

    >>> import wend
    >>> wend.Map([[0, 7]])
    Traceback (most recent call last):
    ...
    wend.InvalidArgument: array[0, 1] is 7: use 0 (free), 1 (obstacle) or -1 (unknown)
    """


class NoPath(Error):
    """A search that found no path. `reason` says why, and what would help; `metrics` is the work of the search.

    >>> import wend
    >>> space = wend.Map([[0, 1, 0]]).free_space()
    >>> try:
    ...     space.plan((0, 0), (2, 0))
    ... except wend.NoPath as no_path:
    ...     print(no_path.status)
    unreachable
    """

    metrics: Metrics
    _unread: _core.Reason | None

    def __init__(self, message: str, status: str, where: str, metrics: Metrics) -> None:
        super().__init__(message, status, where)
        self.args = (message, status, where, metrics)
        self.metrics = metrics
        self._unread = None

    def __str__(self) -> str:
        if self._unread is not None:
            self.args = (self._unread.text(), *self.args[1:])
            self._unread = None
        return super().__str__()

    def __repr__(self) -> str:
        str(self)
        return super().__repr__()

    def __reduce__(self) -> tuple[type[NoPath], tuple[object, ...]]:
        str(self)
        return type(self), self.args

    @property
    def reason(self) -> str:
        """Why there is no path, in one or more sentences. That of ``plan()`` is found out when it is first read, on the
        map of that moment, which may take as long as several searches of the whole map; Ctrl-C stops it."""
        return str(self)


_INVALID = frozenset({"invalid_option", "invalid_map", "unsupported_map", "unsupported_query"})
_NOT_A_SEARCH = _INVALID | {"invalid_file", "index_missing", "index_mismatch"}


def make_error(
    status: str, message: str, where: str, work: list[int] | None, unread: _core.Reason | None = None
) -> Error:
    """The exception of an error of the C++ side. `work` is set if it is that of a search, `unread` if its reason is found
    out when it is read."""
    if work is not None and status not in _NOT_A_SEARCH:
        no_path = NoPath(message, status, where, Metrics(*work))
        no_path._unread = unread
        return no_path
    if unread is not None:
        message = unread.text()
    if status in _INVALID or status.endswith("_outside"):
        return InvalidArgument(message, status, where)
    return Error(message, status, where)
