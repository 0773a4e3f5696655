# SPDX-License-Identifier: BSD-3-Clause
"""Files that are whole or not there, and the exit codes of the commands that write them."""
import contextlib
import os
import sqlite3
import sys

DATA, RECORD = 5, 8  # of `tolman`, docs/errors.md


class Unwritten(OSError):
    """A file that could not be written; the words name it, the reason and what to look at."""


@contextlib.contextmanager
def written(file):
    """Turns a failed write into words for a person: Unwritten."""
    try:
        yield
    except OSError as error:
        reason = os.strerror(error.errno) if error.errno else str(error).splitlines()[0]
        raise Unwritten(f"{file}: cannot be written ({reason}); look for a full disk, its permissions, and a limit of file sizes "
                        "(`ulimit -f`)") from error


@contextlib.contextmanager
def replacing(file):
    """A temporary file beside `file`, which replaces it at the end; removed when the block fails."""
    unfinished = file.with_name(f"{file.name}.{os.getpid()}.part")  # exports at the same time must not share it
    try:
        yield unfinished
        os.replace(unfinished, file)
    finally:
        unfinished.unlink(missing_ok=True)


def exit_code_of(command):
    """Runs `command`; a failure is one line on standard error. ImportError is left to Python, which ends with 1."""
    try:
        command()
    except Unwritten as error:
        print(error, file=sys.stderr, flush=True)
        os._exit(RECORD)  # at the end of the process zipfile would try to finish the file
    except OSError as error:
        print(error, file=sys.stderr)
        return DATA if isinstance(error, FileNotFoundError) else RECORD
    except (KeyError, ValueError, sqlite3.Error) as error:
        print(error.args[0] if isinstance(error, KeyError) else error, file=sys.stderr)
        return DATA
    return 0
