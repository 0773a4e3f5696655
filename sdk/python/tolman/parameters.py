# SPDX-License-Identifier: BSD-3-Clause
"""Parameters: annotated class attributes, from which come the checks of a configuration, the reference and completion.

    spacing: float = tolman.parameter(0.4, range=(0.05, 100), unit="m", doc="Distance between fields.")

Types: bool, int, float, str, pathlib.Path (a file or folder), list[float], and typing.Literal["a", "b"].
"""
import math
import pathlib
import typing
from dataclasses import dataclass


class _Required:
    def __repr__(self):
        return "required"


REQUIRED = _Required()
_TYPES = {bool: "bool", int: "integer", float: "real", str: "text", pathlib.Path: "path", list[float]: "list"}


@dataclass(frozen=True)
class Parameter:
    default: object
    range: tuple = (-math.inf, math.inf)
    unit: str = ""
    doc: str = ""


def parameter(default=REQUIRED, *, range=None, unit="", doc=""):  # noqa: A002: the word of the C++ SDK
    """Declares a parameter. `range`: smallest and largest legal value; without default it must be configured."""
    return Parameter(default, (-math.inf, math.inf) if range is None else tuple(range), unit, doc)


def _zero(kind, choices):
    """A value of the type, for a parameter that has no default."""
    empty = {"bool": False, "integer": 0, "real": 0.0, "list": []}
    return choices[0] if choices else empty.get(kind, "")


def _typed(value, kind, name):
    """The value in its declared type. Raises TypeError where it has another."""
    legal = {"bool": bool, "integer": int, "real": (int, float), "list": (list, tuple)}.get(kind, (str, pathlib.Path))
    if not isinstance(value, legal) or (kind in ("integer", "real") and isinstance(value, bool)):
        raise TypeError(f"parameter '{name}': {value!r} is no {kind}")
    if kind == "real":
        return float(value)
    if kind == "list":
        return [float(item) for item in value]
    return str(value) if kind in ("text", "path", "choice") else value


def _described(name, annotation, declared):
    choices = [str(choice) for choice in typing.get_args(annotation)] if _is_literal(annotation) else []
    kind = "choice" if choices else _TYPES.get(annotation)
    if kind is None:
        raise TypeError(f"parameter '{name}' is annotated as {annotation!r}; legal types are bool, int, float, str, "
                        "pathlib.Path, list[float] and typing.Literal of texts")
    low, high = declared.range
    required = declared.default is REQUIRED
    default = _zero(kind, choices) if required else _typed(declared.default, kind, name)
    return {"name": name, "type": kind, "default": default, "required": required, "min": float(low),
            "max": float(high), "unit": declared.unit, "doc": declared.doc, "choices": choices}


def _is_literal(annotation):
    return typing.get_origin(annotation) is typing.Literal


def schema(cls):
    """The parameters that a class and its bases declare, in order. Raises TypeError for a wrong declaration."""
    listed = {}
    for base in reversed(cls.__mro__):
        hints = typing.get_type_hints(base) if vars(base).get("__annotations__") else {}
        for name, declared in vars(base).items():
            if not isinstance(declared, Parameter):
                continue
            if name not in hints:
                raise TypeError(f"parameter '{name}' has no type; write '{name}: float = tolman.parameter(...)'")
            listed[name] = _described(name, hints[name], declared)
    return list(listed.values())


def bound(cls, values):
    """The values of all parameters: defaults, and `values` in the types of the annotations."""
    complete = {}
    for info in schema(cls):
        value = _typed(values.get(info["name"], info["default"]), info["type"], info["name"])
        if info["choices"] and value not in info["choices"]:
            raise TypeError(f"parameter '{info['name']}': {value!r} is none of {', '.join(info['choices'])}")
        complete[info["name"]] = pathlib.Path(value) if info["type"] == "path" else value
    return complete
