# SPDX-License-Identifier: MIT
"""Plots of a data set by matplotlib."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Any

import numpy as np

from ._library import InvalidValue
from .dataset import VERDICTS, Array, Dataset, Motion

if TYPE_CHECKING:
    import pandas  # type: ignore[import]

# Of each view: the axes of the world across and up, and their names.
_ACROSS, _HEIGHT, _AHEAD = "to the body's left (m)", "height (m)", "ahead (m)"
_VIEWS = {"front": ("x", "y", _ACROSS, _HEIGHT), "side": ("z", "y", _AHEAD, _HEIGHT), "above": ("x", "z", _ACROSS, _AHEAD)}
_OUTCOMES = {"reached": ("o", "C0"), "unsteady": ("^", "C1"), "unreachable": ("x", "C4")}
_COLOURS = {"possible": "C2", "strains": "C1", "impossible": "C3"}
_STYLES = ("upright", "half squat", "squat", "stoop", "sitting")
_CELL = (0.25, 0.1)  # m, height and distance
_BINS = 40
_SIDE = math.radians(62.0)  # from straight ahead: where the viewer of a motion stands, on the side of what moves


def _axes(ax: Any) -> Any:
    if ax is not None:
        return ax
    return _pyplot().subplots()[1]


def _pyplot() -> Any:
    try:
        import matplotlib.pyplot as plt  # type: ignore[import] # pylint: disable=import-outside-toplevel
    except ImportError as missing:
        raise ImportError("plots are made by matplotlib: pip install matplotlib, or python3-matplotlib") from missing
    return plt


def overview(data: Dataset) -> Any:
    figure, axes = _pyplot().subplots(2, 3, figsize=(15, 9), layout="constrained")
    figure.suptitle(f"{data.plan.get('name') or 'Motions'}: {len(data.tasks):,} tasks, {len(data):,} motions")
    for ax, view in zip(axes[0], _VIEWS):
        goals(data, ax, view)
    scores(data, axes[1, 0])
    styles(data, axes[1, 1])
    people(data, axes[1, 2])
    return axes


def goals(data: Dataset, ax: Any, view: str) -> Any:
    if view not in _VIEWS:
        raise InvalidValue(f"view is {view!r}; allowed are {', '.join(_VIEWS)}")
    ax = _axes(ax)
    across, up, across_name, up_name = _VIEWS[view]
    view_name = view if view == "above" else f"the {view}"
    tasks = data.tasks["status"]
    places = data.goals.join(tasks, on="task")
    for status, (marker, colour) in _OUTCOMES.items():
        here = places[places["status"] == status]
        label = f"{status}: {(tasks == status).sum():,} tasks"
        ax.scatter(here[f"position_m.{across}"], here[f"position_m.{up}"], 12, colour, marker, alpha=0.7, label=label)
    ax.set(xlabel=across_name, ylabel=up_name, title=f"Goals from {view_name}", aspect="equal")
    ax.legend(fontsize="small")
    return ax


def scores(data: Dataset, ax: Any) -> Any:
    ax = _axes(ax)
    motions = data.motions
    if len(motions):
        low, high = motions["score"].min(), motions["score"].quantile(0.995)
        bins = np.linspace(low, max(high, low + 0.01), _BINS + 1)
        for verdict in VERDICTS:
            own = motions["score"][motions["verdict"] == verdict]
            if len(own):
                label = f"{verdict}: {len(own):,}, median {own.median():.2f}"
                # each verdict by its own scale; the last bar has all that is more
                share = np.full(len(own), 1.0 / len(own))
                ax.hist(own.clip(upper=bins[-1]), bins, weights=share, alpha=0.5, color=_COLOURS[verdict], label=label)
        ax.legend(fontsize="small")
    ax.set(xlabel="score (less is better)", ylabel="share of the verdict's motions", title="Scores by verdict")
    return ax


def style_cells(data: Dataset) -> pandas.DataFrame:
    """Of the best motion of each reached task: its style, and the cell (height, distance) of the task's first goal."""
    met = data.tasks["status"].isin(["reached", "unsteady"])
    first = data.goals.groupby(level=0)[["position_m.x", "position_m.y", "position_m.z"]].first()
    first = first[first.index.isin(met.index[met])]
    best = data.motions.groupby(level="task")["words"].first().str.split(", ").str[0].rename("style")
    cells = first.join(best, how="inner")
    cells["height"] = np.floor(cells["position_m.y"] / _CELL[0])
    cells["distance"] = np.floor(np.hypot(cells["position_m.x"], cells["position_m.z"]) / _CELL[1])
    return cells[["style", "height", "distance"]]


def styles(data: Dataset, ax: Any) -> Any:
    ax = _axes(ax)
    for (height, distance), cell in style_cells(data).groupby(["height", "distance"])["style"]:
        counts = cell.value_counts()
        colour = f"C{_STYLES.index(counts.index[0])}"
        low, left = height * _CELL[0], distance * _CELL[1]
        ax.add_patch(_pyplot().Rectangle((left, low), _CELL[1], _CELL[0], facecolor=colour, alpha=0.3))
        text = f"{counts.index[0]}\n{counts.iloc[0]} of {counts.sum()}"
        ax.text(left + 0.5 * _CELL[1], low + 0.5 * _CELL[0], text, ha="center", va="center", fontsize=6)
    ax.autoscale_view()
    ax.set(xlabel="distance from the body (m)", ylabel="height of the goal (m)", title="Styles of the best motions")
    return ax


def people(data: Dataset, ax: Any) -> Any:
    ax = _axes(ax)
    tasks = data.tasks[data.tasks["status"] != "refused"]
    if data.plan.get("people"):
        tasks = tasks.drop_duplicates("person")
    for sex, marker, colour in (("female", "^", "C1"), ("male", "o", "C0")):
        own = tasks[tasks["sex"] == sex]
        ax.scatter(own["stature_m"], own["mass_kg"], 12, colour, marker, alpha=0.7, label=f"{sex}: {len(own):,}")
    ax.set(xlabel="stature (m)", ylabel="mass (kg)", title="Statures and masses")
    ax.legend(fontsize="small")
    return ax


def motion(one: Motion, ax: Any) -> Any:
    ax = _axes(ax)
    places, parents, nodes = one.places, one.body.parents, one.body.nodes
    effectors = list(one.goals["effector"])
    left = bool(effectors) and effectors[0].startswith("left")
    view = np.array([math.cos(_SIDE), 0.0, -math.sin(_SIDE) if left else math.sin(_SIDE)])

    def shown(points: Array) -> tuple[Array, Array]:
        return points @ view, points[..., 1]

    bones = np.array([(parent, node) for node, parent in enumerate(parents) if parent >= 0])
    for frame, colour in ((0, "0.8"), (len(places) // 2, "0.6"), (len(places) - 1, "0.1")):
        across, up = shown(places[frame])
        ax.plot(across[bones.T], up[bones.T], color=colour, linewidth=2, solid_capstyle="round")
    for effector, goal in zip(effectors, one.goals[["position_m.x", "position_m.y", "position_m.z"]].to_numpy()):
        node = next((name for name in (f"{effector}_grip", effector) if name in nodes), None)
        if node is not None:
            ax.plot(*shown(places[:, nodes.index(node)]), ":", color="C1")
        ax.plot(*shown(goal), "+", color="C1", markersize=12)
    ax.axhline(0.0, color="0.6", linewidth=1)
    ax.set(aspect="equal", xticks=[], yticks=[])
    about = one.about
    ax.set_title(f"{one.id}\n{about['words']}\n{about['verdict']}, score {about['score']:.2f}", fontsize="x-small")
    return ax


def motions(data: Dataset, most: int) -> Any:
    # one of each way to end, then a second of each, until there are enough
    rows = data.motions.reset_index()
    turn = rows.groupby("words").cumcount()
    chosen = sorted(turn.sort_values(kind="stable").index[:most])
    columns = max(1, min(6, len(chosen)))
    lines = max(1, -(-len(chosen) // columns))
    _, axes = _pyplot().subplots(lines, columns, figsize=(2.6 * columns, 3.2 * lines), squeeze=False, layout="constrained")
    for ax in axes.flat:
        ax.set_axis_off()
    for ax, number in zip(axes.flat, chosen):
        motion(data[number], ax)
    return axes
