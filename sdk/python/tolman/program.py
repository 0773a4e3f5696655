# SPDX-License-Identifier: BSD-3-Clause
"""Runs the program `tolman`: TOLMAN_PROGRAM, that of the build tree that this package lies in, or the one on the path."""
import os
import pathlib
import shutil

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


def _text(value):
    """As a configuration writes it."""
    if isinstance(value, bool):
        return "true" if value else "false"
    if isinstance(value, dict):
        return "{" + ", ".join(f"{key}: {_text(item)}" for key, item in value.items()) + "}"
    if isinstance(value, (list, tuple)):
        return "[" + ", ".join(_text(item) for item in value) + "]"
    return str(value)


def run(config, set=None, out=None, plugin_path=()):  # noqa: A002: the word of the command line
    """Runs a configuration, with values in other words: run("demo", set={"cells.spacing": 3}). Gives its Run."""
    import subprocess  # here, for it installs a handler of signals, which plugins must not

    command = [program(), "run", str(config)]
    for key, value in (set or {}).items():
        command += ["--set", f"{key}={_text(value)}"]
    for folder in plugin_path:
        command += ["--plugin-path", str(folder)]
    if out is not None:
        command += ["--out", str(out)]
    finished = subprocess.run(command, capture_output=True, text=True, check=False)
    if finished.returncode != 0:
        raise RunFailed(finished.stderr.strip() or finished.stdout.strip(), finished.returncode)
    if out is None:
        out = next(line.split(None, 1)[1] for line in finished.stdout.splitlines() if line.startswith("run  "))
    return Run(out)
