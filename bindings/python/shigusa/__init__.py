# SPDX-License-Identifier: MIT
"""Natural whole-body motions to final places of hands and feet.

    import shigusa
    result = shigusa.reach("human", goals={"right_hand": (-0.2, 0.6, 0.45)}, seed=3)
    print(result[0].verdict, result[0].angles.shape)
    result[0].edit(squat_deg=80).save("reach.bvh")

Metres, kilograms, seconds and radians, unless a name says otherwise. +Y is up, a body faces +Z, its left is +X, and
the origin is on the floor between the feet. Tasks have the keys of task files (docs/task.schema.json).
"""

from __future__ import annotations

import io
import math
import pathlib
from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, Any, NamedTuple, Union, overload

from . import _library
from ._library import (
    Cancelled, Criterion, Failure, InvalidValue, Motions, NotFound, OutOfMemory, Progress, SystemRefused, Table,
    Unsupported,
)

if TYPE_CHECKING:
    import pandas  # type: ignore[import]

__version__ = _library.version()
__all__ = [
    "Cancelled", "Candidate", "Character", "Criterion", "Failure", "InvalidValue", "Motions", "Nodes", "NotFound",
    "OutOfMemory", "Result", "SystemRefused", "Unsupported", "facts", "motion", "reach", "reach_all", "score",
]

Place = Union[Sequence[float], Table]
Goals = Union[Mapping[str, Union[Place, Mapping[str, Any]]], Sequence[Mapping[str, Any]]]
Edit = Union[float, bool, str]
# Styles of a page within a notebook: as small as can be seen well.
_IN_NOTEBOOKS = (
    "header,footer,.asked{display:none}.result{margin:12px 0}.candidates{grid-template-columns:repeat(auto-fill,minmax(230px,1fr))}"
    ".candidates>li{max-width:280px}"
)
_NO_COST = "costs are not told: the task has no cost=True"

# Series, by shigusa_series.
_SERIES = {
    "time": 0, "angles": 1, "torques": 2, "centre_of_mass": 3, "support": 4, "effectors": 5, "node_translations": 6,
    "node_rotations": 7, "upper_limits": 8, "things": 9,
}


class Character:
    """Who moves: a built-in body ("human", "full_body", "half_body"), or a person's or robot's file."""

    def __init__(self, source: str | pathlib.Path = "human", **spec: Any) -> None:
        """`spec`: the keys of a task's `character`, such as stature_m=1.6, sex="female", seat_m=0.45 or map={…}."""
        path = pathlib.Path(source)
        file = path.read_bytes() if path.suffix else None
        self._handle = _library.create_character({"source": path.name if path.suffix else str(source), **spec}, file)
        self._name = path.name
        self._about: dict[str, Any] | None = None

    @classmethod
    def of_nodes(cls, nodes: Sequence[Mapping[str, Any]], name: str = "nodes", **spec: Any) -> Character:
        """The person of a host's skeleton, in its own axes: nodes with "name", "parent" (index or -1), "translation",
        "rotation" (x, y, z, w) and "scale" at rest, and "pose" with these as they are now, from which motions start.
        `spec`: as of Character()."""
        made = cls.__new__(cls)
        made._handle = _library.character_of_nodes({"source": f"{name}.glb", **spec}, [dict(node) for node in nodes])
        made._name = name
        made._about = None
        return made

    @property
    def about(self) -> dict[str, Any]:
        """The description that `shigusa body --json` prints: joints with limits and strength, effectors, nodes."""
        if self._about is None:
            self._about = _library.describe_character(self._handle)
        assert self._about is not None
        return self._about

    @property
    def joint_names(self) -> list[str]:
        """Names of the degrees of freedom, in the order of angles."""
        return [joint["name"] for joint in self.about["joints"]]

    def __repr__(self) -> str:
        return f"<shigusa.Character {self._name}: {len(self.joint_names)} degrees of freedom>"


class Nodes(NamedTuple):
    """Motion of a skeleton's nodes, each in its parent."""

    names: list[str]
    translations: Table  # (frames, nodes, 3), in units of the description's node_unit_m
    rotations: Table  # (frames, nodes, 4): x, y, z, w


class Candidate:
    """One of the motions of a result. Arrays are views that must not be written to."""

    def __init__(self, result: Result, number: int) -> None:
        self._result = result
        self._number = number

    @property
    def about(self) -> dict[str, Any]:
        """The candidate in the summary: its verdict with reasons, scores by criterion, what was reached, loads, actions."""
        found: dict[str, Any] = self._result.summary["candidates"][self._number - 1]
        return found

    @property
    def score(self) -> float:
        """The lower, the better."""
        return float(self.about["score"])

    @property
    def verdict(self) -> str:
        """ "possible", "strains" or "impossible"."""
        return str(self.about["verdict"])

    @property
    def reasons(self) -> list[str]:
        """Why it is not possible, in words."""
        return [str(reason["words"]) for reason in self.about["reasons"]]

    def _series(self, name: str) -> Table:
        return _library.series(self._result._handle, self._number, _SERIES[name])

    @property
    def times(self) -> Table:
        """(frames) s."""
        return self._series("time")[:, 0]

    @property
    def angles(self) -> Table:
        """(frames, degrees of freedom) rad, in the order of joint_names."""
        return self._series("angles")

    @property
    def torques(self) -> Table:
        """(frames, degrees of freedom) N·m."""
        return self._series("torques")

    @property
    def centre_of_mass(self) -> Table:
        """(frames, 3) m, world."""
        return self._series("centre_of_mass")

    @property
    def nodes(self) -> Nodes:
        """Motion of the nodes of the character's skeleton."""
        return self.nodes_at(None)

    def nodes_at(self, fps: float | None, place: str = "world") -> Nodes:
        """Nodes at a rate (Hz), in the world or, with place="file", where the character stands in its file."""
        translations, about = self.table("node_translations", fps, place)
        rotations, _ = self.table("node_rotations", fps, place)
        return Nodes(about["names"], translations, rotations)

    def table(self, series: str, fps: float | None = None, place: str = "world") -> tuple[Table, dict[str, Any]]:
        """A series by name ("angles", "torques", "effectors", "things", …) with its unit, shape and names; `fps`: rate
        (Hz, 1 to 240), the motion's own when not given."""
        if series not in _SERIES:
            raise NotFound(f"there is no series {series!r}; there are {', '.join(_SERIES)}")
        options: dict[str, Any] = {"place": place}
        if fps is not None:
            options["fps"] = fps
        return _library.table(self._result._handle, self._number, _SERIES[series], options)

    @property
    def joint_names(self) -> list[str]:
        """Names of the degrees of freedom, in the order of angles."""
        names: list[str] = self.table("angles")[1]["names"]
        return names

    def parameters(self, action: int | None = None) -> dict[str, dict[str, Any]]:
        """The parameters that edit() changes, by name, with their values and ranges; `action`: of one of several
        actions, from 1."""
        found = _library.parameters(self._result._handle, self._number, action)
        return {parameter["name"]: parameter for parameter in found}

    def edit(
        self,
        parameters: Mapping[str, Edit] | None = None,
        *,
        action: int | None = None,
        again: Sequence[int] = (),
        keep: Sequence[int] = (),
        seed: int | None = None,
        progress: Progress | None = None,
        **more: Edit,
    ) -> Candidate:
        """The motion again with other parameters, such as squat_deg=80 or {"right_knee.flexion.weight": 3}. Of a piece
        of work: those of one action; actions of `again` are searched anew, or all but those of `keep`."""
        values = {**(parameters or {}), **more}
        assignments = [f"{name}={str(value).lower() if isinstance(value, bool) else value}" for name, value in values.items()]
        if action is None and not again and not keep:
            made = _library.replay(self._result._handle, self._number, assignments)
        else:
            edit: dict[str, Any] = {"set": assignments, "again": list(again), "keep": list(keep)}
            if action is not None:
                edit["action"] = action
            if seed is not None:
                edit["seed"] = seed
            edit = {key: value for key, value in edit.items() if value != []}
            made = _library.replay_work(self._result._handle, self._number, edit, progress)
        return Result(made)[0]

    def export(self, form: str, **options: Any) -> bytes:
        """The motion as a file: "bvh", "csv", "npz", "svg", "glb", "vrma" or "html" (a page with the moving figure),
        with fps=24, clip="Reach", joint_names="mixamo" or in_place=True."""
        return _library.export(self._result._handle, self._number, form, options or None)

    def save(self, path: str | pathlib.Path, **options: Any) -> None:
        """Writes the motion to a file, whose ending tells the format; `options` as of export()."""
        target = pathlib.Path(path)
        target.write_bytes(self.export(target.suffix.lstrip(".").lower(), **options))

    def to_frame(self, fps: float | None = None) -> pandas.DataFrame:
        """A pandas frame by time (s): angles (rad) and torques (N·m) of each degree of freedom."""
        import pandas as pd  # pylint: disable=import-outside-toplevel

        columns = [self.table(series, fps) for series in ("angles", "torques")]
        times = self.table("time", fps)[0].reshape(-1)
        parts = {
            about["name"]: pd.DataFrame(values.reshape(len(times), -1), columns=about["names"], index=times)
            for values, about in columns
        }
        frame = pd.concat(parts, axis=1)
        frame.index.name = "time_s"
        return frame

    @property
    def cost(self) -> dict[str, Any]:
        """What the motion costs the body, by methods of ergonomics ("reba", "rula", "en_1005_4", "low_back",
        "strengths", "niosh"); of tasks with cost=True, and of pieces of work."""
        found: dict[str, Any] | None = self.about.get("cost")
        if found is None:
            raise NotFound(_NO_COST)
        return found

    def cost_frame(self) -> pandas.DataFrame:
        """A pandas frame by time (s) of a task with cost=True: REBA and RULA of each side, their sub-scores of the worse
        one, and moment, compression and shear at L5/S1."""
        import pandas as pd  # pylint: disable=import-outside-toplevel

        table = pd.read_csv(io.BytesIO(self.export("csv")), index_col=0)
        table.index.name = "time_s"
        columns = [name for name in table if name.startswith(("reba.", "rula.", "l5s1."))]
        if not columns:
            raise NotFound(_NO_COST)
        return table[columns]

    def _repr_html_(self) -> str:
        return _framed(self.export("html"))

    def __repr__(self) -> str:
        return f"<shigusa.Candidate {self.verdict}, score {self.score:.3f}, {self.times[-1]:.2f} s>"


class Result(Sequence[Candidate]):
    """The candidates of a task, the best first."""

    def __init__(self, handle: _library.Handle) -> None:
        self._handle = handle
        self._summary: dict[str, Any] | None = None

    @classmethod
    def restore(
        cls, summary: Mapping[str, Any], character: Character | None = None, progress: Progress | None = None
    ) -> Result:
        """The motions of a summary (summary.json) again, without a search."""
        handle = None if character is None else character._handle
        return cls(_library.restore(handle, dict(summary), progress))

    @property
    def summary(self) -> dict[str, Any]:
        """The object of summary.json."""
        if self._summary is None:
            self._summary = _library.describe_result(self._handle)
        assert self._summary is not None
        return self._summary

    @property
    def status(self) -> str:
        """ "reached", "unsteady" (no motion that somebody can make was found) or "unreachable"."""
        return str(self.summary["status"])

    def mirrored(self) -> Result:
        """Mirror images of all candidates."""
        return Result(_library.mirror(self._handle))

    def __len__(self) -> int:
        return len(self.summary["candidates"])

    @overload
    def __getitem__(self, place: int) -> Candidate: ...
    @overload
    def __getitem__(self, place: slice) -> list[Candidate]: ...
    def __getitem__(self, place: int | slice) -> Candidate | list[Candidate]:
        numbers = range(1, len(self) + 1)[place]
        if isinstance(numbers, range):
            return [Candidate(self, number) for number in numbers]
        return Candidate(self, numbers)

    def costs(self) -> pandas.DataFrame:
        """A pandas frame with a row for each candidate, from 1: greatest and mean scores, the greatest loads at L5/S1,
        the share of people who are strong enough, and lifting indices (infinite where no load is allowed). Of tasks with
        cost=True, and of pieces of work."""
        import pandas as pd  # pylint: disable=import-outside-toplevel

        rows = pd.DataFrame([_cost_row(candidate) for candidate in self], index=range(1, len(self) + 1))
        rows.index.name = "candidate"
        return rows

    def export(self, form: str, **options: Any) -> bytes:
        """All motions in one file, "glb" or "html"; `options` as of Candidate.export()."""
        return _library.export(self._handle, 0, form, options or None)

    def save(self, path: str | pathlib.Path, **options: Any) -> None:
        """Writes all motions to one file, whose ending tells the format: .glb or .html."""
        target = pathlib.Path(path)
        target.write_bytes(self.export(target.suffix.lstrip(".").lower(), **options))

    def _repr_html_(self) -> str:
        return _framed(self.export("html"))

    def __repr__(self) -> str:
        return f"<shigusa.Result {self.status}, {len(self)} candidates>"


def _cost_row(candidate: Candidate) -> dict[str, Any]:
    cost = candidate.cost
    row: dict[str, Any] = {"score": candidate.score, "verdict": candidate.verdict}
    for method in ("reba", "rula"):
        row[method] = cost.get(method, {}).get("worst", math.nan)
        row[f"{method}_mean"] = cost.get(method, {}).get("mean", math.nan)
    for load in ("moment_nm", "compression_n", "shear_n"):
        row[load] = cost.get("low_back", {}).get(load, math.nan)
    weakest = cost["strengths"][0] if cost["strengths"] else {}
    row["strong_enough"], row["weakest_joint"] = weakest.get("able", math.nan), weakest.get("joint")
    row["lifting_index"] = max((lift.get("lifting_index", math.inf) for lift in cost["niosh"]), default=math.nan)
    row["composite_index"] = cost.get("composite_index", math.nan)
    return row


def _framed(page: bytes) -> str:
    """A page in a notebook: its script runs, and neither reaches the other's styles."""
    text = page.decode().replace("</head>", f"<style>{_IN_NOTEBOOKS}</style></head>", 1)
    text = text.replace("&", "&amp;").replace("'", "&#39;")
    look = "width:100%;height:620px;border:0"
    return f"<iframe sandbox='allow-scripts' title='Moving figures' style='{look}' srcdoc='{text}'></iframe>"


def _goals(goals: Goals) -> list[dict[str, Any]]:
    if not isinstance(goals, Mapping):
        return [dict(goal) for goal in goals]
    made = []
    for effector, goal in goals.items():
        told = dict(goal) if isinstance(goal, Mapping) else {"position_m": goal}
        made.append({"effector": effector, **told})
    return made


def _task(goals: Goals | None, actions: Sequence[Mapping[str, Any]] | None, more: Mapping[str, Any]) -> dict[str, Any]:
    task = dict(more)
    if goals is not None:
        task["goals"] = _goals(goals)
    if actions is not None:
        task["version"] = 2
        task["actions"] = [
            {**action, "goals": _goals(action["goals"])} if "goals" in action else dict(action) for action in actions
        ]
    return task


def _character(character: Character | str | pathlib.Path) -> Character:
    return character if isinstance(character, Character) else Character(character)


def reach(
    character: Character | str | pathlib.Path = "human",
    goals: Goals | None = None,
    *,
    actions: Sequence[Mapping[str, Any]] | None = None,
    own_criteria: Sequence[Criterion] = (),
    threads: int = 0,
    progress: Progress | None = None,
    **task: Any,
) -> Result:
    """Searches motions.

    `goals`: places (m) by effector, {"right_hand": (-0.2, 0.6, 0.45)}, or with the other keys of a goal,
    {"right_hand": {"position_m": …, "load_kg": 2}}. `actions`: a piece of work instead, as in tasks of version 2, with
    things={…}. `own_criteria`: functions that motions are scored by as well; edits are scored without them. `task`:
    other keys of a task file, such as seed=3, candidates=8 or obstacles=[…]. `threads`: 0 for all
    cores; results are the same. `progress`: called with the share done, the motions scored and the best score; False
    ends the search with the best so far. Ctrl-C ends it too.
    """
    return Result(_library.generate(
        _character(character)._handle, _task(goals, actions, task), own_criteria, threads, progress
    ))


def reach_all(
    character: Character | str | pathlib.Path,
    tasks: Sequence[Mapping[str, Any]],
    *,
    threads: int = 0,
    progress: Progress | None = None,
) -> list[Result | Failure]:
    """Searches motions for many tasks in one call, as reach(); each is what its keywords would be. A task that fails is
    its failure in the list."""
    texts = [
        _task(task.get("goals"), task.get("actions"), {k: v for k, v in task.items() if k not in ("goals", "actions")})
        for task in tasks
    ]
    made = _library.generate_all(_character(character)._handle, texts, threads, progress)
    return [one if isinstance(one, Failure) else Result(one) for one in made]


def motion(
    character: Character | str | pathlib.Path, angles: Table, fps: float = 60.0, task: Mapping[str, Any] | None = None
) -> Candidate:
    """Score, verdict and series of given angles (frames, degrees of freedom; rad) at a rate (Hz)."""
    told = None if task is None else dict(task)
    return Result(_library.result_of_angles(_character(character)._handle, told, angles, fps))[0]


def score(path: str | pathlib.Path, **options: Any) -> dict[str, Any]:
    """The score of a recorded motion (BVH, GLB, glTF, VRM, VRMA), as `shigusa score --json` prints it; with cost=True also
    what it costs the body."""
    file = pathlib.Path(path)
    told: dict[str, Any] = _library.score_clip(file.name, file.read_bytes(), options or None)
    return told


def facts() -> dict[str, Any]:
    """Bodies, presets, criteria, ranges and formats of this build."""
    told: dict[str, Any] = _library.facts()
    return told
