# SPDX-License-Identifier: MIT
"""The C library (shigusa.h) by ctypes: JSON in and out, failures as exceptions, tables as views."""

from __future__ import annotations

import contextlib
import ctypes
import importlib.metadata
import json
import os
import pathlib
import signal
import threading
from collections.abc import Callable, Iterator, Sequence
from typing import Any, NamedTuple, Optional

import numpy as np
import numpy.typing as npt

ABI_VERSION = 1

Table = npt.NDArray[np.float64]
Progress = Callable[[float, int, float], Optional[bool]]


class Failure(Exception):
    """A failure of the library; its text names the place, the value seen and what is allowed."""


class InvalidValue(Failure, ValueError):
    """A value is out of range, or a text or file does not follow its format."""


class NotFound(Failure, LookupError):
    """There is no file, joint or effector of that name."""


class SystemRefused(Failure, OSError):
    """The operating system refused."""


class Unsupported(Failure, NotImplementedError):
    """Valid, but not supported by this build."""


class Cancelled(Failure):
    """Stopped without a result."""


class OutOfMemory(Failure, MemoryError):
    """Out of memory."""


_FAILURES: dict[int, type[Failure]] = {
    1: InvalidValue, 2: NotFound, 3: InvalidValue, 4: SystemRefused, 5: Unsupported, 6: Cancelled, 7: OutOfMemory,
}

_Report = ctypes.CFUNCTYPE(ctypes.c_int32, ctypes.c_void_p, ctypes.c_double, ctypes.c_int32, ctypes.c_double)


class _Watch(ctypes.Structure):
    _fields_ = [("report", _Report), ("user", ctypes.c_void_p)]


class Motions(NamedTuple):
    """Motions that a criterion gets to see, of equal shapes."""

    angles: Table  # (motions, frames, degrees of freedom) rad, in the order of joint_names
    torques: Table  # (motions, frames, degrees of freedom) N·m
    centre_of_mass: Table  # (motions, frames, 3) m, world
    effectors: Table  # (motions, frames, goals, 3) m, world
    frame_time: float  # s between frames


class Criterion(NamedTuple):
    """A criterion of one's own: any number of a whole motion, where less is better. Its penalty is value / scale, held
    between 0 and 1, and adds weight * penalty to a score."""

    name: str
    values: Callable[[Motions], npt.ArrayLike]  # (motions), of all motions of a step of the search at once
    weight: float = 0.1
    scale: float = 1.0


class _Motions(ctypes.Structure):
    _fields_ = [(name, ctypes.c_size_t) for name in ("motions", "frames", "dofs", "effectors")] + [
        ("frame_time", ctypes.c_double),
        *((name, ctypes.POINTER(ctypes.c_double)) for name in ("angles", "torques", "centre_of_mass", "effector_places")),
    ]

    def copied(self) -> Motions:
        """The tables, which live during the call alone, as arrays that last."""
        shape = (self.motions, self.frames)

        def table(name: str, *columns: int) -> Table:
            if not all(columns):
                return np.zeros(shape + columns)
            return np.array(np.ctypeslib.as_array(getattr(self, name), shape + columns))

        return Motions(
            angles=table("angles", self.dofs),
            torques=table("torques", self.dofs),
            centre_of_mass=table("centre_of_mass", 3),
            effectors=table("effector_places", self.effectors, 3),
            frame_time=self.frame_time,
        )


_Values = ctypes.CFUNCTYPE(
    ctypes.c_int32, ctypes.c_void_p, ctypes.POINTER(_Motions), ctypes.POINTER(ctypes.c_double)
)


class _Criterion(ctypes.Structure):
    _fields_ = [
        ("name", ctypes.c_char_p), ("weight", ctypes.c_double), ("scale", ctypes.c_double), ("values", _Values),
        ("user", ctypes.c_void_p),
    ]


def _load() -> ctypes.CDLL:
    beside = pathlib.Path(__file__).parent / "libshigusa_c.so"
    library = ctypes.CDLL(os.environ.get("SHIGUSA_LIBRARY", str(beside)))
    for name, answer in {
        "shigusa_version": ctypes.c_char_p,
        "shigusa_message": ctypes.c_char_p,
        "shigusa_bytes_data": ctypes.c_void_p,
        "shigusa_bytes_size": ctypes.c_size_t,
        "shigusa_bytes_free": None,
        "shigusa_character_free": None,
        "shigusa_result_free": None,
    }.items():
        getattr(library, name).restype = answer
    return library


_library = _load()


def check(status: int) -> None:
    """Raises the last failure of this thread."""
    if status != 0:
        raise _FAILURES.get(status, Failure)(_library.shigusa_message().decode())


def version() -> str:
    """Version of the library."""
    return str(_library.shigusa_version().decode())


def check_version(expected: str) -> None:
    """Raises Unsupported where the library is of another ABI, or older."""
    check(_library.shigusa_check_version(ctypes.c_uint32(ABI_VERSION), expected.encode()))


if "SHIGUSA_LIBRARY" in os.environ:
    try:
        check_version(importlib.metadata.version("shigusa"))
    except importlib.metadata.PackageNotFoundError:
        check_version("0.0.0")  # not installed: any library of this ABI


def _plain(value: Any) -> Any:
    if isinstance(value, (np.ndarray, np.generic)):
        return value.tolist()
    raise InvalidValue(f"{value!r} is no number, text, list or dictionary")


def _text(value: object) -> bytes | None:
    if value is None:
        return None
    try:
        return json.dumps(value, allow_nan=False, default=_plain).encode()
    except ValueError as wrong:
        raise wrong if isinstance(wrong, Failure) else InvalidValue("a number is not finite") from None


def _take(pointer: ctypes.c_void_p) -> bytes:
    try:
        size = _library.shigusa_bytes_size(pointer)
        return ctypes.string_at(_library.shigusa_bytes_data(pointer), size)
    finally:
        _library.shigusa_bytes_free(pointer)


class Handle:
    """An object of the library, freed with the last reference to it. Calls release Python's lock."""

    def __init__(self, pointer: ctypes.c_void_p, kind: str) -> None:
        self._pointer: ctypes.c_void_p | None = pointer
        self._free = getattr(_library, f"shigusa_{kind}_free")

    def __del__(self) -> None:
        if self._pointer is not None:
            self._free(self._pointer)
            self._pointer = None

    @property
    def pointer(self) -> ctypes.c_void_p | None:
        return self._pointer


def call_bytes(name: str, *arguments: Any) -> bytes:
    """Calls a function whose last argument is bytes to be given."""
    out = ctypes.c_void_p()
    check(getattr(_library, name)(*arguments, ctypes.byref(out)))
    return _take(out)


def call_json(name: str, *arguments: Any) -> Any:
    """Calls a function that gives JSON."""
    return json.loads(call_bytes(name, *arguments))


def call_handle(kind: str, name: str, *arguments: Any) -> Handle:
    """Calls a function whose last argument is an object to be given."""
    out = ctypes.c_void_p()
    check(getattr(_library, name)(*arguments, ctypes.byref(out)))
    return Handle(out, kind)


class _Watcher:
    """A search's progress. Ctrl-C, and whatever `report` raises, ends the search and is raised after it."""

    def __init__(self, report: Progress | None) -> None:
        self._raised: BaseException | None = None
        self._stopped = False

        def tell(_: object, fraction: float, evaluations: int, best: float) -> int:
            try:
                if not self._stopped and report is not None:
                    self._stopped = report(fraction, evaluations, best) is False
            except BaseException as raised:  # pylint: disable=broad-except
                self._raised = raised
                self._stopped = True
            return 1 if self._stopped else 0

        self._report = _Report(tell)
        self.watch = _Watch(self._report, None)

    def criterion(self, own: Criterion) -> _Criterion:
        """A criterion as the library calls it; what it raises ends the search and is raised after it."""

        def tell(_: object, motions: Any, values: Any) -> int:
            try:
                shown = motions.contents
                told = np.asarray(own.values(shown.copied()), dtype=np.float64)
                if told.shape != (shown.motions,):
                    raise InvalidValue(
                        f"the criterion {own.name} gives values of the shape {told.shape}; one of each of "
                        f"{shown.motions} motions is needed: ({shown.motions},)"
                    )
                np.ctypeslib.as_array(values, told.shape)[:] = told
            except BaseException as raised:  # pylint: disable=broad-except
                self._raised = raised
                return 1
            return 0

        return _Criterion(own.name.encode(), own.weight, own.scale, _Values(tell), None)

    def _interrupt(self, *_: object) -> None:
        self._raised = KeyboardInterrupt()
        self._stopped = True

    @contextlib.contextmanager
    def watching(self) -> Iterator[None]:
        """Ctrl-C within is noted: raised in the middle of a callback it would be lost."""
        own = threading.current_thread() is threading.main_thread()
        own = own and signal.getsignal(signal.SIGINT) is signal.default_int_handler
        if own:
            signal.signal(signal.SIGINT, self._interrupt)
        try:
            yield
        except Failure:
            if self._raised is None:
                raise
        finally:
            if own:
                signal.signal(signal.SIGINT, signal.default_int_handler)
        if self._raised is not None:
            raise self._raised


def create_character(spec: dict[str, Any], file: bytes | None) -> Handle:
    """A character of a spec, and of its file's bytes."""
    size = ctypes.c_size_t(len(file) if file is not None else 0)
    return call_handle("character", "shigusa_character_create", _text(spec), file, size)


def character_of_nodes(spec: dict[str, Any], nodes: Sequence[dict[str, Any]]) -> Handle:
    """A character of a spec and of the nodes of a host's skeleton."""
    return call_handle("character", "shigusa_character_of_nodes", _text(spec), _text({"nodes": list(nodes)}))


def describe_character(character: Handle) -> Any:
    return call_json("shigusa_character_describe", character.pointer)


def _pointer(character: Handle | None) -> ctypes.c_void_p | None:
    return None if character is None else character.pointer


def _watched(name: str, report: Progress | None, *arguments: Any) -> Handle:
    watcher = _Watcher(report)
    with watcher.watching():
        return call_handle("result", name, *arguments, ctypes.byref(watcher.watch))


def generate(
    character: Handle | None, task: dict[str, Any], criteria: Sequence[Criterion], threads: int, report: Progress | None
) -> Handle:
    """Searches motions, by criteria of Python as well."""
    watcher = _Watcher(report)
    own = (_Criterion * len(criteria))(*[watcher.criterion(one) for one in criteria])
    with watcher.watching():
        return call_handle(
            "result", "shigusa_generate_by", _pointer(character), _text(task), own, ctypes.c_size_t(len(criteria)),
            ctypes.c_int32(threads), ctypes.byref(watcher.watch),
        )


def generate_all(
    character: Handle | None, tasks: Sequence[dict[str, Any]], threads: int, report: Progress | None
) -> list[Handle | Failure]:
    """A result or a failure of each task."""
    count = len(tasks)
    texts = (ctypes.c_char_p * count)(*[_text(task) for task in tasks])
    results = (ctypes.c_void_p * count)()
    watcher = _Watcher(report)
    made: list[Handle | Failure] = []
    with watcher.watching():
        told = call_json(
            "shigusa_generate_all", _pointer(character), texts, ctypes.c_size_t(count), ctypes.c_int32(threads),
            ctypes.byref(watcher.watch), results,
        )
        for pointer, failure in zip(results, told):
            made.append(Handle(ctypes.c_void_p(pointer), "result") if pointer else _failure(failure))
    return made


def _failure(told: dict[str, Any]) -> Failure:
    message = told["message"]
    words = message["text"] if isinstance(message, dict) else message
    return Failure(f"{told['place']}: {words}" if told["place"] else words)


def result_of_angles(character: Handle, task: dict[str, Any] | None, angles: Table, fps: float) -> Handle:
    table = np.ascontiguousarray(angles, dtype=np.float64)
    if table.ndim != 2:
        raise InvalidValue(f"angles have {table.ndim} dimensions; 2 are needed: frames and degrees of freedom")
    frames, columns = table.shape
    return call_handle(
        "result", "shigusa_result_of_angles", character.pointer, _text(task), table.ctypes.data_as(ctypes.c_void_p),
        ctypes.c_size_t(frames), ctypes.c_size_t(columns), ctypes.c_double(fps),
    )


def restore(character: Handle | None, summary: dict[str, Any], report: Progress | None) -> Handle:
    return _watched("shigusa_restore_watched", report, _pointer(character), _text(summary))


def replay(result: Handle, candidate: int, assignments: list[str]) -> Handle:
    return call_handle("result", "shigusa_replay", result.pointer, ctypes.c_int32(candidate), _text(assignments))


def replay_work(result: Handle, candidate: int, edit: dict[str, Any], report: Progress | None) -> Handle:
    return _watched("shigusa_replay_work", report, result.pointer, ctypes.c_int32(candidate), _text(edit))


def mirror(result: Handle) -> Handle:
    return call_handle("result", "shigusa_mirror", result.pointer)


def describe_result(result: Handle) -> Any:
    return call_json("shigusa_result_describe", result.pointer)


def parameters(result: Handle, candidate: int, action: int | None) -> Any:
    if action is None:
        return call_json("shigusa_result_parameters", result.pointer, ctypes.c_int32(candidate))
    return call_json(
        "shigusa_result_action_parameters", result.pointer, ctypes.c_int32(candidate), ctypes.c_int32(action)
    )


def export(result: Handle, candidate: int, form: str, options: dict[str, Any] | None) -> bytes:
    return call_bytes(
        "shigusa_result_export_with", result.pointer, ctypes.c_int32(candidate), form.encode(), _text(options)
    )


class _View:
    """Rows of a result, which lives as long as arrays of them do."""

    def __init__(self, result: Handle, address: int, shape: tuple[int, int]) -> None:
        self._result = result
        self.__array_interface__ = {"shape": shape, "typestr": "<f8", "data": (address, True), "version": 3}


def series(result: Handle, candidate: int, number: int) -> Table:
    """A series at the motion's own frames, without a copy and not to be written to."""
    values = ctypes.c_void_p()
    frames, columns = ctypes.c_size_t(), ctypes.c_size_t()
    check(
        _library.shigusa_result_series(
            result.pointer, ctypes.c_int32(candidate), ctypes.c_int32(number), ctypes.byref(values),
            ctypes.byref(frames), ctypes.byref(columns),
        )
    )
    if not columns.value or not values.value:
        return np.zeros((frames.value, columns.value))
    return np.asarray(_View(result, values.value, (frames.value, columns.value)))


def table(
    result: Handle, candidate: int, number: int, options: dict[str, Any] | None
) -> tuple[Table, dict[str, Any]]:
    """A series and the meaning of its columns."""
    rows = ctypes.c_void_p()
    about: dict[str, Any] = call_json(
        "shigusa_result_table", result.pointer, ctypes.c_int32(candidate), ctypes.c_int32(number), _text(options),
        ctypes.byref(rows),
    )
    return np.frombuffer(_take(rows), dtype=np.float64).reshape(about["shape"]), about


def score_clip(name: str, file: bytes, options: dict[str, Any] | None) -> Any:
    return call_json("shigusa_score_clip", name.encode(), file, ctypes.c_size_t(len(file)), _text(options))


def facts() -> Any:
    return call_json("shigusa_facts")
