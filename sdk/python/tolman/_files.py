# SPDX-License-Identifier: BSD-3-Clause
"""Files that are whole or not there, and the exit codes of the commands that write them."""
import contextlib
import os
import pathlib
import sqlite3
import sys

DATA, RECORD, MEMORY = 5, 8, 70  # of `tolman`, docs/errors.md


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
    except MemoryError:
        print("out of memory: give it more, or raise its limit (`ulimit -v`)", file=sys.stderr)
        return MEMORY
    except OSError as error:
        print(error, file=sys.stderr)
        return DATA if isinstance(error, FileNotFoundError) else RECORD
    except (KeyError, ValueError, sqlite3.Error) as error:
        print(error.args[0] if isinstance(error, KeyError) else error, file=sys.stderr)
        return DATA
    return 0


def refuse_existing(files, replace, remedy):
    """The rule of `tolman` for files that the user named: one that exists and is not empty is replaced only with --force."""
    for file in files:
        if not replace and (file.is_symlink() or (file.is_file() and file.stat().st_size > 0)):
            raise FileExistsError(f"{file}: exists; {remedy}, or replace it with --force")


def add_output_options(parser):
    parser.add_argument("--force", action="store_true", help="replace the file")
    parser.add_argument("--quiet", action="store_true", help="do not print its name")


def write_output(given, chosen, write):
    """Calls `write`, which gives the path of the file, and prints it. `chosen` is the file that the user named, or None."""
    refuse_existing([pathlib.Path(chosen)] if chosen else [], given.force, "choose another file")
    file = write()
    if not given.quiet:
        print(file)
