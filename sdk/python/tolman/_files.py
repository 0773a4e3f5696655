# SPDX-License-Identifier: BSD-3-Clause
"""Files that are whole or not there, and the exit codes of the commands that write them."""
import contextlib
import os
import sqlite3
import sys

DATA, RECORD = 5, 8  # of `tolman`, docs/errors.md


@contextlib.contextmanager
def replacing(file):
    """A temporary file beside `file`, which replaces it at the end; removed when the block fails."""
    unfinished = file.with_name(file.name + ".part")
    try:
        yield unfinished
        os.replace(unfinished, file)
    finally:
        unfinished.unlink(missing_ok=True)


def exit_code_of(command):
    """Runs `command`; a failure is one line on standard error. ImportError is left to Python, which ends with 1."""
    try:
        command()
    except OSError as error:
        print(error, file=sys.stderr)
        return DATA if isinstance(error, FileNotFoundError) else RECORD
    except (KeyError, ValueError, sqlite3.Error) as error:
        print(error.args[0] if isinstance(error, KeyError) else error, file=sys.stderr)
        return DATA
    return 0
