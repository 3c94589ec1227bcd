"""The notebooks of python/examples run from the first cell to the last, and are kept without outputs."""

from __future__ import annotations

import asyncio
import pathlib
import re
from typing import Any

import nbclient
import nbformat
import pytest

FOLDER = pathlib.Path(__file__).resolve().parents[1] / "examples"
NOTEBOOKS = sorted(FOLDER.glob("*.ipynb"))


def read(path: pathlib.Path) -> Any:
    return nbformat.read(path, as_version=4)  # type: ignore[no-untyped-call]


def all_outputs(notebook: Any) -> list[Any]:
    return [output for cell in notebook.cells for output in cell.get("outputs", [])]


@pytest.fixture(scope="module")
def executed() -> dict[str, Any]:
    """All of them, each in its own kernel, side by side: most of the time is that of starting kernels."""

    async def execute(path: pathlib.Path) -> Any:
        client = nbclient.NotebookClient(read(path), timeout=120, resources={"metadata": {"path": str(FOLDER)}})
        return await client.async_execute()

    async def execute_all() -> list[Any]:
        return await asyncio.gather(*map(execute, NOTEBOOKS))

    return {path.stem: notebook for path, notebook in zip(NOTEBOOKS, asyncio.run(execute_all()))}


@pytest.mark.parametrize("path", NOTEBOOKS, ids=lambda path: path.stem)
def test_a_notebook_is_kept_without_outputs(path: pathlib.Path) -> None:
    notebook = read(path)
    nbformat.validate(notebook)
    for cell in notebook.cells:
        assert not cell.get("outputs") and cell.get("execution_count") is None, cell.id
    assert path.stat().st_size < 16_000


@pytest.mark.parametrize("path", NOTEBOOKS, ids=lambda path: path.stem)
def test_cells_that_show_times_have_a_tag(path: pathlib.Path) -> None:
    """The site leaves their outputs out, because they differ from machine to machine."""
    for cell in read(path).cells:
        measured = ("perf_counter", ".seconds", ".first_seconds", ".planning_seconds", ".worst_seconds")
        shows_times = cell.cell_type == "code" and any(name in cell.source for name in measured)
        assert shows_times == ("times" in cell.metadata.get("tags", [])), cell.source


@pytest.mark.parametrize("name", [path.stem for path in NOTEBOOKS])
def test_a_notebook_runs_without_warnings(name: str, executed: dict[str, Any]) -> None:
    assert all_outputs(executed[name])
    for output in all_outputs(executed[name]):
        assert output.get("name") != "stderr", output.text


def outputs_of(notebook: Any, kind: str) -> list[str]:
    """What its cells show, in one format."""
    return [output.data[kind] for output in all_outputs(notebook) if kind in output.get("data", {})]


def texts_of(notebook: Any) -> str:
    return "".join(output.get("text", "") for output in all_outputs(notebook))


def test_the_notebooks_show_what_they_say(executed: dict[str, Any]) -> None:
    assert len(NOTEBOOKS) == 8
    pages = outputs_of(executed["search"], "text/html")
    assert len(pages) == 4 and all("srcdoc" in page for page in pages)
    assert "shortest           pure_pursuit  collision" in texts_of(executed["robot"])
    assert "careful, smoothed  pure_pursuit  reached" in texts_of(executed["robot"])
    assert "It is right on 300 worlds." in texts_of(executed["own_planner"])
    assert "Hasty: the path has 3 steps, 1 are enough" in texts_of(executed["own_planner"])
    assert len(outputs_of(executed["compare"], "image/png")) == 2
    assert len(outputs_of(executed["car"], "image/svg+xml")) == 1
    assert len(outputs_of(executed["costs"], "image/png")) == 4
    says, sums = texts_of(executed["costs"]).splitlines()[:2]
    assert says.split()[0] == sums.split()[0]
    assert len(outputs_of(executed["parking"], "image/png")) == 2
    assert "reached after" in texts_of(executed["parking"])
    assert len(outputs_of(executed["explore"], "image/png")) == 3
    explored = texts_of(executed["explore"])
    assert "a box off the path: 0 states expanded, the same path: True" in explored
    assert re.search(r"a door closes: .* (\S+) now\nastar: .* cost \1\n", explored)
