# SPDX-License-Identifier: BSD-3-Clause
"""Runs the program `tolman`: TOLMAN_PROGRAM, that of the build tree that this package lies in, or the one on the path."""
import json
import math
import os
import pathlib
import re
import shutil
import warnings

from tolman.results import Run


class RunFailed(Exception):
    """The program ended with a failure; its words, and its exit code (docs/errors.md) as `code`."""

    def __init__(self, text, code):
        super().__init__(text)
        self.code = code


def program():
    """The path of the program. Raises FileNotFoundError."""
    beside = pathlib.Path(__file__).parents[2] / "bin/tolman"
    found = os.environ.get("TOLMAN_PROGRAM") or (str(beside) if beside.is_file() else shutil.which("tolman"))
    if not found:
        raise FileNotFoundError("no program 'tolman'; install the package tolman, or set TOLMAN_PROGRAM")
    return found


_PLAIN = re.compile(r"-?[A-Za-z0-9_./][A-Za-z0-9_./+-]*")
_READ_OTHERWISE = ("null", "Null", "NULL", "...")


def _quoted(text):
    """A text that YAML reads as this text; numbers and words stay without quotes, for keys that take them.
    `${NAME}` is a variable of the environment also in quotes."""
    is_plain = _PLAIN.fullmatch(text) and text not in _READ_OTHERWISE
    return text if is_plain else json.dumps(text, ensure_ascii=False)  # its escapes are those of YAML


def _text(value):
    """As a configuration writes it. Raises TypeError or ValueError where it cannot write such a value."""
    if hasattr(value, "tolist"):  # numbers and arrays of NumPy
        value = value.tolist()
    if value is None:
        return "null"
    if isinstance(value, bool):
        return "true" if value else "false"
    if isinstance(value, dict):
        return "{" + ", ".join(f"{_quoted(str(key))}: {_text(item)}" for key, item in value.items()) + "}"
    if isinstance(value, (list, tuple)):
        return "[" + ", ".join(_text(item) for item in value) + "]"
    if isinstance(value, float) and not math.isfinite(value):
        raise ValueError(f"{value} is no number that a configuration takes; give a finite one")
    if not isinstance(value, (str, int, float, os.PathLike)):
        raise TypeError(f"{value!r} of type {type(value).__name__} cannot be written into a configuration; give a text, a "
                        "number, a bool, None, a path, or a list or dict of them")
    return str(value) if isinstance(value, (int, float)) else _quoted(os.fspath(value))


def _settings(given):
    """The words of --set. Raises TypeError and ValueError, with the key."""
    if not isinstance(given or {}, dict):
        raise TypeError(f"'set' is a dict of values by their keys, such as {{'cells.spacing': 3}}, not {type(given).__name__}")
    words = []
    for key, value in (given or {}).items():
        if not isinstance(key, str):
            raise TypeError(f"set: the key {key!r} is no text")
        try:
            words += ["--set", f"{key}={_text(value)}"]
        except (TypeError, ValueError) as error:
            raise type(error)(f"set: '{key}': {error}") from None
    return words


def call(*arguments):
    """What the program prints. Raises RunFailed."""
    import subprocess  # here, for it installs a handler of signals, which plugins must not

    finished = subprocess.run([program(), *map(os.fspath, map(_word, arguments))], capture_output=True, text=True, check=False)
    if finished.returncode != 0:
        raise RunFailed(finished.stderr.strip() or finished.stdout.strip(), finished.returncode)
    for line in finished.stderr.splitlines():
        if line.startswith("warning: "):
            warnings.warn(line[len("warning: "):], stacklevel=3)
    return finished.stdout


def _word(argument):
    return argument if isinstance(argument, os.PathLike) else str(argument)


def run(config, set=None, out=None, plugin_path=()):  # noqa: A002: the word of the command line
    """Runs a configuration, with values in other words: run("demo", set={"cells.spacing": 3}). Gives its Run.
    None is YAML's null; a type that a configuration cannot hold raises TypeError, and NaN ValueError."""
    words = ["run", config, *_settings(set)]
    for folder in plugin_path:
        words += ["--plugin-path", folder]
    if out is not None:
        words += ["--out", out]
    printed = call(*words)
    if out is None:
        out = next(line.split(None, 1)[1] for line in printed.splitlines() if line.startswith("run  "))
    return Run(out)
