# SPDX-License-Identifier: MIT
"""Data sets of motions, as `shigusa dataset` makes them: tables, arrays, plots and files for other programs.

    import shigusa.dataset
    data = shigusa.dataset.open("data")
    print(data.tasks.status.value_counts(), data.motions.score.median())
    print(data[0].angles.shape, data.column("torques")[:10].shape)
    data.select(verdict="possible", split="train").to_npz("clips")

Metres, kilograms, seconds, radians and newton metres. +Y is up, a body faces +Z at the start, and its left is +X; the
frames of a motion are at equal times, the last one at its duration. Needs h5py and pandas, and matplotlib for plots.
h5py reads what a file refers to: run `shigusa dataset check` on a data set of others first.
"""

from __future__ import annotations

import functools
import json
import pathlib
import re
from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING, Any

import numpy as np
import numpy.typing as npt

from ._library import InvalidValue, NotFound, Unsupported

if TYPE_CHECKING:
    import pandas  # type: ignore[import]

Array = npt.NDArray[Any]

VERSION = 1  # of the files that are read
VERDICTS = ("possible", "strains", "impossible")
SPLITS = ("train", "validation", "test")
_HEAD = re.compile(rb"shigusa data set, shard version (\d+)\nplan ([0-9a-f]{64})\nshard \d+\ntasks \d+ \d+\nsha256 ")
_NAME = re.compile(r"shard-(\d{6,})\.h5")


def open(folder: str | pathlib.Path) -> Dataset:  # pylint: disable=redefined-builtin
    """The data set of a folder. Shards that are not made yet are left out."""
    return Dataset(_Shards(pathlib.Path(folder)))


def _h5py() -> Any:
    try:
        import h5py  # type: ignore[import] # pylint: disable=import-outside-toplevel
    except ImportError as missing:
        raise ImportError("data sets are read by h5py: pip install h5py, or Debian's python3-h5py") from missing
    return h5py


def _pandas() -> Any:
    try:
        import pandas as pd  # pylint: disable=import-outside-toplevel
    except ImportError as missing:
        raise ImportError("tables are pandas frames: pip install pandas, or Debian's python3-pandas") from missing
    return pd


def _texts(values: Array) -> list[str]:
    return [value.decode() for value in values]


def _values(column: Any) -> Any:
    """Numbers, texts, or the words that numbers stand for."""
    if "words" in column.attrs:
        return _pandas().Categorical.from_codes(column[()], _texts(column.attrs["words"]))
    return _texts(column[()]) if column.dtype.kind == "S" else column[()]


def _frame(group: Any) -> pandas.DataFrame:
    """Columns of single numbers and texts, and those of vectors: "position_m.x"."""
    columns: dict[str, Any] = {}
    for name, column in group.items():
        if column.ndim == 1:
            columns[name] = _values(column)
        elif column.ndim == 2 and column.shape[1] in (3, 4):
            columns.update({f"{name}.{'xyzw'[k]}": column[:, k] for k in range(column.shape[1])})
    return _pandas().DataFrame(columns).astype({"task": np.int64})


class Body:
    """Bodies alike, whose motions are one table: the same joints, nodes and parameters."""

    def __init__(self, name: str, group: Any) -> None:
        self.name = name
        # of the axes: "joints", "nodes", "node_parents", "parameters", "criteria", "feet"; of work "actions", "things"
        self.names = {key: _texts(value) for key, value in group.attrs.items()}
        # of each column its shape within a row, its unit, what it is, and the words that its numbers stand for
        self.shapes: dict[str, tuple[int, ...]] = {key: column.shape[1:] for key, column in group.items()}
        self.units = {key: bytes(column.attrs.get("unit", b"")).decode() for key, column in group.items()}
        self.descriptions = {key: bytes(column.attrs.get("description", b"")).decode() for key, column in group.items()}
        self.words = {key: _texts(column.attrs["words"]) for key, column in group.items() if "words" in column.attrs}

    @property
    def joints(self) -> list[str]:
        """Names of the degrees of freedom, in the order of angles and torques."""
        return self.names["joints"]

    @property
    def nodes(self) -> list[str]:
        """Names of the skeleton's nodes, the root first."""
        return self.names["nodes"]

    @property
    def parents(self) -> Array:
        """(nodes) index of each node's parent, -1 of the root."""
        known = {name: k for k, name in enumerate(self.nodes)}
        return np.array([known.get(name, -1) for name in self.names["node_parents"]], dtype=np.int32)

    def __repr__(self) -> str:
        return f"<shigusa.dataset.Body {self.name}: {len(self.joints)} degrees of freedom, {len(self.nodes)} nodes>"


class _Shards:
    """The shards of a folder, one of them open at a time."""

    def __init__(self, folder: pathlib.Path) -> None:
        self.folder = folder
        found = [(int(name[1]), path) for path in folder.glob("*.h5") if (name := _NAME.fullmatch(path.name))]
        self.paths = [path for _, path in sorted(found)]
        if not self.paths:
            raise NotFound(f"{folder} has no shards: `shigusa dataset PLAN.json --out {folder}` makes them")
        self.digest = self._check()
        self._open: tuple[int, Any] | None = None
        self._tables: dict[str, pandas.DataFrame] = {}
        self.bodies: dict[str, Body] = {}
        # as the folder has it, with its name and licence, or as the shards do
        told = folder / "plan.json"
        self.plan: dict[str, Any] = json.loads(told.read_bytes() if told.exists() else self.file(0)["plan"][()])

    def _check(self) -> str:
        """The digest of the plan, which all shards must be of."""
        digests: dict[str, pathlib.Path] = {}
        for path in self.paths:
            with path.open("rb") as file:
                head = _HEAD.match(file.read(512))
            if head is None or int(head[1]) != VERSION:
                raise InvalidValue(f"{path} is no shard of version {VERSION}, or a damaged one")
            digests[head[2].decode()] = path
        if len(digests) > 1:
            raise InvalidValue(f"{' and '.join(str(path) for path in digests.values())} are of different plans")
        return next(iter(digests))

    def file(self, number: int) -> Any:
        if self._open is None or self._open[0] != number:
            if self._open is not None:
                self._open[1].close()
                self._open = None
            try:
                self._open = (number, _h5py().File(self.paths[number], "r"))
            except OSError as wrong:
                raise InvalidValue(f"{self.paths[number]} is damaged: {wrong}") from wrong
        return self._open[1]

    def motions(self, number: int) -> Iterator[tuple[Body, Any]]:
        """The tables of motions of a shard."""
        for name, group in self.file(number).get("motions", {}).items():
            if name not in self.bodies:
                self.bodies[name] = Body(name, group)
            yield self.bodies[name], group

    def table(self, name: str) -> pandas.DataFrame:
        """A table of all shards, by task."""
        if name not in self._tables:
            frames = [_frame(self.file(number)[name]) for number in range(len(self.paths))]
            self._tables[name] = _pandas().concat(frames, ignore_index=True).set_index("task")
        return self._tables[name]

    @functools.cached_property
    def rows(self) -> pandas.DataFrame:
        """The single numbers of all motions, with the shard and the row of each, by task and rank."""
        frames = []
        for number in range(len(self.paths)):
            for body, group in self.motions(number):
                columns = {key: _values(column) for key, column in group.items() if column.ndim == 1}
                frame = _pandas().DataFrame(columns).astype({"task": np.int64, "rank": np.int64})
                frames.append(frame.assign(body=body.name, shard=number, row=np.arange(len(frame))))
        if not frames:
            return _pandas().DataFrame({"task": [], "rank": [], "verdict": [], "body": [], "shard": [], "row": []})
        return _pandas().concat(frames).set_index(["task", "rank"]).sort_index()

    @functools.cached_property
    def splits(self) -> pandas.DataFrame:
        path = self.folder / "index.h5"
        if not path.exists():
            raise NotFound(f"{path} is not there: `shigusa dataset merge {self.folder}` writes it, with the splits")
        with _h5py().File(path, "r") as index:
            if index.attrs["plan_sha256"].decode() != self.digest:
                raise InvalidValue(f"{path} is of another plan than the shards: merge them again")
            splits = _frame(index["splits"]).set_index("task")
        if not splits.index.equals(self.table("tasks").index):
            raise InvalidValue(f"{path} has other tasks than the shards: merge them again")
        return splits


class Column:
    """A column of the motions of one body, by slices: (motions, …) in the order of Dataset.motions. Only what is asked
    for is read, shard by shard."""

    def __init__(self, shards: _Shards, name: str, body: Body, rows: pandas.DataFrame) -> None:
        if name not in body.shapes:
            raise NotFound(f"{body.name} has no column {name!r}; it has {', '.join(body.shapes)}")
        self._shards, self._places = shards, rows[["shard", "row"]].to_numpy()
        self.name, self.body = name, body
        self.unit = body.units[name]
        self.shape = (len(self._places), *body.shapes[name])

    def __len__(self) -> int:
        return self.shape[0]

    def __getitem__(self, which: Any) -> Array:
        """As of an array; further indices, as in [:, -1], choose from what is read of each shard."""
        rows, *rest = which if isinstance(which, tuple) else (which,)
        if isinstance(rows, (int, np.integer)):
            one: Array = self._read(self._places[[rows]], rest)[0]
            return one
        return self._read(self._places[rows], rest)

    def __array__(self, dtype: Any = None) -> Array:
        return np.asarray(self[:], dtype)

    def _read(self, places: Array, rest: Sequence[Any]) -> Array:
        made: Array | None = None
        for number in np.unique(places[:, 0]):
            here = places[:, 0] == number
            rows = places[here, 1]
            stored = self._shards.file(int(number))["motions"][self.body.name][self.name]
            values = stored[rows.min() : rows.max() + 1][rows - rows.min()][(slice(None), *rest)]
            if made is None:
                made = np.empty((len(places), *values.shape[1:]), values.dtype)
            made[here] = values
        return np.empty((0, *self.shape[1:]))[(slice(None), *rest)] if made is None else made

    def __repr__(self) -> str:
        unit = f" {self.unit}" if self.unit else ""
        return f"<shigusa.dataset.Column {self.name}: {' × '.join(map(str, self.shape))}{unit}>"


class Motion:
    """A motion of a data set: its numbers, and its series as arrays."""

    def __init__(self, data: Dataset, number: int) -> None:
        self._data = data
        self.about = data._rows.iloc[number].drop(["shard", "row"])  # its row of Dataset.motions
        self._rows = data._rows.iloc[[number]]
        self.body = data.bodies[self.about["body"]]

    @property
    def task(self) -> int:
        """Number of its task."""
        return int(self.about.name[0])

    @property
    def rank(self) -> int:
        """Among the candidates of its task, from 1."""
        return int(self.about.name[1])

    @property
    def id(self) -> str:
        """The name of its files: "000012-1"."""
        return f"{self.task:06}-{self.rank}"

    @property
    def duration(self) -> float:
        """s"""
        return float(self.about["duration_s"])

    @property
    def goals(self) -> pandas.DataFrame:
        """The rows of its task's goals."""
        goals = self._data._shards.table("goals")
        return goals.loc[[self.task]] if self.task in goals.index else goals.iloc[:0]

    @property
    def person(self) -> pandas.Series:
        """The row of its task."""
        return self._data._shards.table("tasks").loc[self.task]

    def __contains__(self, column: str) -> bool:
        return column in self.body.shapes

    def __getitem__(self, column: str) -> Array:
        """A column: a series is (frames, …)."""
        return Column(self._data._shards, column, self.body, self._rows)[0]

    @property
    def angles(self) -> Array:
        """(frames, joints) rad."""
        return self["angles"]

    @property
    def torques(self) -> Array:
        """(frames, joints) N·m."""
        return self["torques"]

    @property
    def times(self) -> Array:
        """(frames) s."""
        frames = next((shape[0] for shape in self.body.shapes.values() if len(shape) > 1), 2)
        return np.linspace(0.0, self.duration, frames)

    @property
    def places(self) -> Array:
        """(frames, nodes, 3) m, world: of the series `positions`, or by forward kinematics from `nodes`."""
        if "positions" in self:
            return self["positions"].astype(np.float64)
        self._need("nodes", "positions")
        nodes = self["nodes"].astype(np.float64)
        return forward_kinematics(nodes, self["root_m"], self["offsets_m"], self.body.parents)

    def _need(self, *series: str) -> None:
        if not any(one in self for one in series):
            raise Unsupported(
                f"the data set keeps no {' or '.join(series)}: make the plan again with one of them among its series, "
                "which changes no motion"
            )

    def plot(self, ax: Any = None) -> Any:
        """The body from the side at the start, halfway and at the end, the goals, and the ways to them; gives the axes."""
        from . import _dataset_plots as plots  # pylint: disable=import-outside-toplevel

        return plots.motion(self, ax)

    def __repr__(self) -> str:
        about = self.about
        return f"<shigusa.dataset.Motion {self.id}: {about['words']}, {about['verdict']}, score {about['score']:.3f}>"


def rotation_matrices(quaternions: Array) -> Array:
    """(…, 3, 3) of unit quaternions (…, 4): x, y, z, w."""
    x, y, z, w = np.moveaxis(np.asarray(quaternions, dtype=np.float64), -1, 0)
    rows = [
        [1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w)],
        [2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w)],
        [2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)],
    ]
    return np.stack([np.stack(row, axis=-1) for row in rows], axis=-2)


def forward_kinematics(rotations: Array, root: Array, offsets: Array, parents: Sequence[int] | Array) -> Array:
    """(frames, nodes, 3) m, world: places of nodes from their rotations (frames, nodes, 4) and offsets (nodes, 3; m), each
    in its parent, and the place of the root (frames, 3; m). Parents come before their children."""
    turns = rotation_matrices(rotations)
    places = np.zeros(turns.shape[:2] + (3,))
    for node, parent in enumerate(parents):
        if parent < 0:
            places[:, node] = root
        else:
            places[:, node] = places[:, parent] + turns[:, parent] @ np.asarray(offsets[node], dtype=np.float64)
            turns[:, node] = turns[:, parent] @ turns[:, node]
    return places


class Dataset(Sequence[Motion]):
    """Motions of a data set, by task and rank. Tables are read when they are first asked for."""

    def __init__(self, shards: _Shards, chosen: tuple[Array, Array] | None = None) -> None:
        self._shards = shards
        self._chosen = chosen  # of all tasks, and of all motions, whether they are meant

    @property
    def plan(self) -> dict[str, Any]:
        """The plan, as docs/plan.schema.json describes it."""
        return self._shards.plan

    @property
    def digest(self) -> str:
        """SHA-256 of the plan and its characters' files."""
        return self._shards.digest

    @property
    def version(self) -> int:
        """Version of the files."""
        return VERSION

    @property
    def axes(self) -> str:
        """A sentence about units and axes."""
        return str(self._shards.file(0).attrs["axes"].decode())

    @property
    def series(self) -> list[str]:
        """What is kept of each frame: "angles", "torques", "nodes", …"""
        return list(self.plan.get("series", []))

    @property
    def bodies(self) -> dict[str, Body]:
        """The tables of motions, by name."""
        return self._bodies

    @functools.cached_property
    def _bodies(self) -> dict[str, Body]:
        return {name: self._shards.bodies[name] for name in self._rows["body"].unique()}

    def _table(self, name: str) -> pandas.DataFrame:
        table = self._shards.table(name)
        if self._chosen is None:
            return table
        return table[table.index.isin(self._shards.table("tasks").index[self._chosen[0]])]

    @property
    def tasks(self) -> pandas.DataFrame:
        """A row a task, by its number: person, status, character, stature_m, mass_kg, sex, seat_m, …"""
        return self._table("tasks")

    @property
    def goals(self) -> pandas.DataFrame:
        """A row a goal, by task: effector, position_m.x, …, load_kg."""
        return self._table("goals")

    @property
    def obstacles(self) -> pandas.DataFrame:
        """A row an obstacle, by task: name, position_m.x, size_m.x, …"""
        return self._table("obstacles")

    @property
    def missed(self) -> pandas.DataFrame:
        """A row a goal out of reach, by task: effector, nearest_m.x, error_m, …"""
        return self._table("missed")

    @property
    def has_index(self) -> bool:
        """Whether there are splits."""
        return (self._shards.folder / "index.h5").exists()

    @property
    def splits(self) -> pandas.DataFrame:
        """A row a task: its part by_person and by_region, of the index that `shigusa dataset merge` writes."""
        splits = self._shards.splits
        return splits if self._chosen is None else splits[self._chosen[0]]

    @functools.cached_property
    def _rows(self) -> pandas.DataFrame:
        rows = self._shards.rows
        return rows if self._chosen is None else rows[self._chosen[1]]

    @property
    def motions(self) -> pandas.DataFrame:
        """A row a motion, by task and rank: score, verdict, words, duration_s, body, …"""
        return self._rows.drop(columns=["shard", "row"])

    @property
    def penalties(self) -> pandas.DataFrame:
        """A row a motion: the penalty of each criterion; NaN where the score does without."""
        return self._vectors("penalties", "criteria")

    @property
    def parameters(self) -> pandas.DataFrame:
        """A row a motion: the parameters that it is made from; NaN where locked, or where a body has none."""
        return self._vectors("parameters", "parameters")

    def _vectors(self, name: str, axis: str) -> pandas.DataFrame:
        """A column that has a number for each name of an axis."""
        frames = []
        for body in self.bodies.values():
            if name in body.shapes:
                index = self._rows.index[self._rows["body"] == body.name]
                values = self.column(name, body.name)[:]
                frames.append(_pandas().DataFrame(values, columns=body.names[axis], index=index))
        return _pandas().concat(frames).sort_index() if frames else _pandas().DataFrame(index=self._rows.index[:0])

    def column(self, name: str, body: str | None = None) -> Column:
        """A column of the motions of a body (which one where there are several) as (motions, …): "angles", "torques",
        "nodes", "penalties", …"""
        if body is None and len(self.bodies) != 1:
            raise InvalidValue(f"there are motions of {len(self.bodies)} bodies: give one of {', '.join(self.bodies)}")
        body = next(iter(self.bodies)) if body is None else body
        if body not in self.bodies:
            raise NotFound(f"there is no body {body!r}; there are {', '.join(self.bodies)}")
        return Column(self._shards, name, self.bodies[body], self._rows[self._rows["body"] == body])

    def select(
        self,
        *,
        verdict: str | None = None,
        body: str | None = None,
        split: str | None = None,
        by: str = "person",
        tasks: range | None = None,
        most: int | None = None,
    ) -> Dataset:
        """Some of the motions: of this verdict or a better one; of a body; of a split ("train", "validation", "test"), by
        "person" or by "region"; of a range of tasks; no more than `most`. Splits and tasks choose rows of the tables of
        tasks too."""
        if verdict is not None and verdict not in VERDICTS:
            raise InvalidValue(f"verdict is {verdict!r}; allowed are {', '.join(VERDICTS)}")
        if split is not None and split not in SPLITS:
            raise InvalidValue(f"split is {split!r}; allowed are {', '.join(SPLITS)}")
        if by not in ("person", "region"):
            raise InvalidValue(f"by is {by!r}; allowed are person, region")
        numbers = self._shards.table("tasks").index
        rows = self._shards.rows
        of_tasks, of_motions = self._chosen or (np.full(len(numbers), True), np.full(len(rows), True))
        if split is not None:
            of_tasks = of_tasks & (self._shards.splits[f"by_{by}"] == split).to_numpy()
        if tasks is not None:
            of_tasks = of_tasks & np.isin(numbers, tasks)
        of_motions = of_motions & rows.index.get_level_values("task").isin(numbers[of_tasks])
        if verdict is not None:
            of_motions = of_motions & rows["verdict"].isin(VERDICTS[: VERDICTS.index(verdict) + 1]).to_numpy()
        if body is not None:
            self.column("task", body)  # fails where there is none
            of_motions = of_motions & (rows["body"] == body).to_numpy()
        if most is not None:
            of_motions = of_motions & (np.cumsum(of_motions) <= most)
        return Dataset(self._shards, (of_tasks, of_motions))

    def __len__(self) -> int:
        return len(self._rows)

    def __getitem__(self, place: Any) -> Any:
        """A motion by its place in `motions`, or a list of them."""
        numbers = range(len(self))[place]
        return Motion(self, numbers) if isinstance(numbers, int) else [Motion(self, number) for number in numbers]

    def motion(self, task: int, rank: int = 1) -> Motion:
        """The motion of a task and a rank."""
        if (task, rank) not in self._rows.index:
            raise NotFound(f"there is no motion {task:06}-{rank}")
        return Motion(self, int(self._rows.index.get_loc((task, rank))))

    def plot(self) -> Any:
        """A figure of plot_goals, plot_scores, plot_styles and plot_people; gives its axes."""
        from . import _dataset_plots as plots  # pylint: disable=import-outside-toplevel

        return plots.overview(self)

    def plot_goals(self, ax: Any = None, view: str = "front") -> Any:
        """Where goals are and whether they are reached, seen from the "front", the "side" or "above"; gives the axes."""
        from . import _dataset_plots as plots  # pylint: disable=import-outside-toplevel

        return plots.goals(self, ax, view)

    def plot_scores(self, ax: Any = None) -> Any:
        """Histograms of the scores, by verdict; gives the axes."""
        from . import _dataset_plots as plots  # pylint: disable=import-outside-toplevel

        return plots.scores(self, ax)

    def plot_styles(self, ax: Any = None) -> Any:
        """The most frequent style of tasks' best motions, by height and distance of the goal; gives the axes."""
        from . import _dataset_plots as plots  # pylint: disable=import-outside-toplevel

        return plots.styles(self, ax)

    def plot_people(self, ax: Any = None) -> Any:
        """Masses over statures of the people; gives the axes."""
        from . import _dataset_plots as plots  # pylint: disable=import-outside-toplevel

        return plots.people(self, ax)

    def plot_motions(self, most: int = 12) -> Any:
        """A sheet of motions, spread over the ways in which they end; gives its axes."""
        from . import _dataset_plots as plots  # pylint: disable=import-outside-toplevel

        return plots.motions(self, most)

    def to_npz(self, folder: str | pathlib.Path, fps: float = 60.0) -> int:
        """NumPy archives, one a motion, with AMASS's keys on shigusa's own skeleton (docs/data.md), into a new or empty
        folder; gives the number of motions. Needs the series `nodes`."""
        from . import _dataset_export as export  # pylint: disable=import-outside-toplevel

        return export.to_npz(self, pathlib.Path(folder), fps)

    def to_humanml3d(self, folder: str | pathlib.Path, least_frames: int = 0) -> int:
        """HumanML3D's folders: (frames, 22, 3) joint positions (m) at 20 Hz, sentences, and lists of the splits by person;
        gives the number of motions. Motions of fewer frames than `least_frames` hold their last pose. Needs the series
        `positions` or `nodes`, and the index."""
        from . import _dataset_export as export  # pylint: disable=import-outside-toplevel

        return export.to_humanml3d(self, pathlib.Path(folder), least_frames)

    def to_csv(self, folder: str | pathlib.Path, series: bool = False) -> int:
        """index.csv, a row a motion with all of its numbers; with `series` also a file a motion, a row a frame. Gives the
        number of motions."""
        from . import _dataset_export as export  # pylint: disable=import-outside-toplevel

        return export.to_csv(self, pathlib.Path(folder), series)

    def __repr__(self) -> str:
        name = self.plan.get("name") or self._shards.folder.name
        return (
            f"<shigusa.dataset.Dataset {name}: {len(self.tasks)} tasks, {len(self)} motions, "
            f"{len(self._shards.paths)} shards>"
        )
