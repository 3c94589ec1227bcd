"""Map: every layout and type of array is read right, or refused by name."""

from __future__ import annotations

import pathlib
from typing import Any

import numpy as np
import numpy.typing as npt
import pytest
import wend
from hypothesis import given
from hypothesis import strategies as st

CELLS = np.array([[0, 1, 0, 0], [1, 0, 0, 1], [0, 0, 1, 0]], dtype=np.int8)

TYPES = ["?", "i1", "u1", "i2", "u2", "i4", "u4", "i8", "u8", "f2", "f4", "f8", "g", ">i4", ">f8"]


def layouts(cells: npt.NDArray[Any]) -> dict[str, npt.NDArray[Any]]:
    """The same cells, laid out in memory in different ways."""
    height, width = cells.shape
    big = np.zeros((2 * height, 3 * width), dtype=cells.dtype)
    big[::2, ::3] = cells
    fields = np.zeros(cells.shape, dtype=[("odd", "u1"), ("cell", cells.dtype)])
    fields["cell"] = cells
    read_only = cells.copy()
    read_only.flags.writeable = False
    return {
        "plain": cells,
        "fortran": np.asfortranarray(cells),
        "every other": big[::2, ::3],
        "rows reversed": cells[::-1].copy()[::-1],
        "columns reversed": cells[:, ::-1].copy()[:, ::-1],
        "transposed": cells.T.copy().T,
        "unaligned field": fields["cell"],
        "read-only": read_only,
    }


@pytest.mark.parametrize("type_name", TYPES)
@pytest.mark.parametrize("layout", layouts(CELLS))
def test_reads_every_type_and_layout(type_name: str, layout: str) -> None:
    array = layouts(CELLS.astype(type_name))[layout]
    before = array.copy()
    assert wend.Map(array).array.tolist() == CELLS.tolist()
    assert np.array_equal(array, before)


def test_reads_repeated_rows() -> None:
    array = np.broadcast_to(np.array([0, 1, 0], dtype=np.int8), (4, 3))
    assert array.strides[0] == 0
    assert wend.Map(array).array.tolist() == [[0, 1, 0]] * 4


def test_reads_lists_and_unknown_cells() -> None:
    mixed: Any = [[0, -1], [1.0, False]]
    assert wend.Map(mixed).array.tolist() == [[0, -1], [1, 0]]


@given(st.data())
def test_array_is_what_was_given(data: st.DataObject) -> None:
    height = data.draw(st.integers(1, 9))
    width = data.draw(st.integers(1, 140))
    seed = data.draw(st.integers(0, 2**32 - 1))
    cells = np.random.default_rng(seed).integers(-1, 2, size=(height, width), dtype=np.int8)
    assert np.array_equal(wend.Map(cells).array, cells)


@pytest.mark.parametrize(
    ("array", "message"),
    [
        ([[0, 0], [0, 7]], r"array\[1, 1\] is 7: use 0"),
        (np.array([[0, 255]], dtype=np.uint8), r"array\[0, 1\] is 255"),
        (np.array([[0.0, 0.5]]), r"array\[0, 1\] is 0.5"),
        (np.array([[0.0, np.nan]]), r"array\[0, 1\] is nan"),
        (np.array([[0.0, np.inf]]), r"array\[0, 1\] is inf"),
        (np.array([[2**64 - 1]], dtype=np.uint64), r"array\[0, 0\] is"),
        (np.zeros((0, 3)), r"array has the shape \(0, 3\)"),
        (np.zeros((3, 0)), r"array has the shape \(3, 0\)"),
        ([], r"array has the shape \(0\)"),
        (np.zeros(3), r"array has the shape \(3\)"),
        (np.zeros((2, 2, 2)), r"array has the shape \(2, 2, 2\)"),
        (np.array(0), r"array has the shape \(\)"),
        ([[0, 0], [0]], "array is not an array"),
        ([["a"]], "array has the type"),
        (np.zeros((2, 2), dtype=complex), "array has the type complex128"),
        (np.zeros((2, 2), dtype=object), "array has the type object"),
        (np.zeros((2, 2), dtype="M8[s]"), "array has the type datetime64"),
        (None, "array has the type object"),
    ],
)
def test_refuses_with_the_place(array: Any, message: str) -> None:
    with pytest.raises(ValueError, match=message) as caught:
        wend.Map(array)
    assert isinstance(caught.value, wend.Error)
    assert caught.value.status == "invalid_map"
    assert caught.value.where == "array"


def test_refuses_wrong_costs() -> None:
    with pytest.raises(ValueError, match=r"costs\[0, 1\] is 0.5: costs are finite and at least 1"):
        wend.Map([[0, 0]], costs=[[1, 0.5]])
    with pytest.raises(ValueError, match=r"costs has the shape \(1, 1\), the map has \(1, 2\)"):
        wend.Map([[0, 0]], costs=[[1]])
    with pytest.raises(ValueError, match="costs"):
        wend.Map([[0, 0]], costs=[[1, float("nan")]])


@pytest.mark.parametrize("resolution", [0, -1, float("nan"), float("inf")])
def test_refuses_wrong_resolutions(resolution: float) -> None:
    with pytest.raises(wend.InvalidArgument):
        wend.Map([[0]], resolution=resolution)


@pytest.mark.parametrize("origin", [(1,), (1, 2, 3, 4), (float("nan"), 0, 0)])
def test_refuses_wrong_origins(origin: tuple[float, ...]) -> None:
    with pytest.raises(wend.InvalidArgument):
        wend.Map([[0]], origin=origin)


def test_costs_and_frame_come_back() -> None:
    costs = np.array([[1.0, 2.5], [3.0, 1.0]])
    made = wend.Map([[0, 0], [0, 1]], resolution=0.5, origin=(1, 2, 0.25), costs=costs, y_up=True)
    assert np.array_equal(made.costs, costs)
    assert [made.width, made.height, made.resolution] == [2, 2, 0.5]
    assert list(made.origin) == [1, 2, 0.25]
    assert made.y_up
    for layer in (made.array, made.costs):
        with pytest.raises(ValueError, match="read-only"):
            layer[0, 0] = 1
    assert wend.Map([[0, 0]]).costs.tolist() == [[1, 1]]


def test_notes_say_what_is_probably_not_meant(tmp_path: pathlib.Path) -> None:
    (tmp_path / "m.pgm").write_text("P2 3 1 255 0 205 254\n")
    (tmp_path / "m.yaml").write_text(
        "image: /home/someone/m.pgm\nresolution: 0.5\norigin: [0, 0, 0]\nnegate: 0\n"
        "occupied_thresh: 0.65\nfree_thresh: 0.25\n"
    )
    room = wend.Map.load(tmp_path / "m.yaml")
    assert room.array.tolist() == [[1, 0, 0]]
    assert len(room.notes) == 2 and "beside the map.yaml" in room.notes[0] and "grey 205" in room.notes[1]
    assert len(room.with_mask(tmp_path / "m.yaml").notes) == 4
    assert wend.Map(np.zeros((1, 3), dtype=np.int8)).notes == ()


@pytest.mark.parametrize("name", ["map.yaml", "map.map", "map.txt", "map.png", "map.pgm"])
def test_saves_and_loads(tmp_path: pathlib.Path, name: str) -> None:
    cells = CELLS
    made = wend.Map(cells, resolution=0.1, y_up=True) if name.endswith("yaml") else wend.Map(cells)
    made.save(tmp_path / name)
    assert np.array_equal(wend.Map.load(str(tmp_path / name)).array, cells)


def test_bad_files_are_errors(tmp_path: pathlib.Path) -> None:
    with pytest.raises(wend.Error) as caught:
        wend.Map.load(tmp_path / "missing.yaml")
    assert caught.value.status == "invalid_file"
    (tmp_path / "bad.map").write_text("no map")
    with pytest.raises(wend.Error, match="bad.map"):
        wend.Map.load(tmp_path / "bad.map")
    with pytest.raises(wend.Error):
        wend.Map([[-1]]).save(tmp_path / "unknown.map")
    assert not (tmp_path / "unknown.map").exists()


def test_a_masked_array_is_refused() -> None:
    masked = np.ma.MaskedArray(np.zeros((3, 4)), mask=np.eye(3, 4, dtype=bool))
    with pytest.raises(wend.InvalidArgument, match="masked array"):
        wend.Map(masked)
    with pytest.raises(wend.InvalidArgument, match="masked array"):
        wend.search(masked, (0, 1), (2, 0))
    with pytest.raises(wend.InvalidArgument, match="masked array"):
        wend.Map(np.zeros((3, 4)), costs=masked + 1)
    assert wend.Map(masked.filled(-1)).array[0, 0] == -1
