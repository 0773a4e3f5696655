# SPDX-License-Identifier: BSD-3-Clause
"""Files that are whole or not there, and the exit codes of the commands that write them."""
import contextlib
import errno
import os
import pathlib
import sqlite3
import sys

DATA, RECORD, MEMORY = 5, 8, 70  # of `tolman`, docs/errors.md


_MORE_FILES = "too many open files: allow more (`ulimit -n`)"


def _is_descriptor_limit(error):
    """Whether a limit of open files caused it, also where a library or SQLite could not be opened for it."""
    if isinstance(error, OSError) and error.errno in (errno.EMFILE, errno.ENFILE):
        return True
    if isinstance(error, ImportError) and os.strerror(errno.EMFILE) in str(error):
        return True
    if not isinstance(error, sqlite3.OperationalError) or "unable to open" not in str(error):
        return False
    try:
        os.close(os.open(os.devnull, os.O_RDONLY))
    except OSError as why:
        return why.errno in (errno.EMFILE, errno.ENFILE)
    return False


class Unwritten(OSError):
    """A file that could not be written; the words name it, the reason and what to look at."""


@contextlib.contextmanager
def written(file):
    """Turns a failed write into words for a person: Unwritten."""
    try:
        yield
    except OSError as error:
        if _is_descriptor_limit(error):
            raise Unwritten(f"{file}: cannot be written; {_MORE_FILES}") from error
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
    """Runs `command`; a failure is one line on standard error. Other ImportErrors are left to Python, which ends with 1."""
    try:
        command()
    except Unwritten as error:
        print(error, file=sys.stderr, flush=True)
        os._exit(RECORD)  # at the end of the process zipfile would try to finish the file
    except Exception as error:
        if not _is_descriptor_limit(error):
            return _failed(error)
        print(_MORE_FILES, file=sys.stderr)
        return RECORD
    return 0


def _failed(failure):
    """The exit code of a failure, after its words."""
    try:
        raise failure
    except MemoryError:
        print("out of memory: give it more, or raise its limit (`ulimit -v`)", file=sys.stderr)
        return MEMORY
    except OSError as error:
        print(error, file=sys.stderr)
        return DATA if isinstance(error, FileNotFoundError) else RECORD
    except (KeyError, ValueError, sqlite3.Error) as error:
        print(error.args[0] if isinstance(error, KeyError) else error, file=sys.stderr)
        return DATA


def refuse_existing(files, replace, remedy):
    """The rule of `tolman` for files that the user named: one that exists and is not empty is replaced only with --force."""
    for file in files:
        if not replace and (file.is_symlink() or (file.is_file() and file.stat().st_size > 0)):
            raise FileExistsError(f"{file}: exists; {remedy}, or replace it with --force")


def _holds_run(folder):
    return (folder / "run.sqlite").exists() or ((folder / "run.json").exists() and (folder / "config.resolved.yaml").exists())


def refuse_run_places(file, own, remedy):
    """The rule of `tolman` for places: nothing is written into the directory of a run, but for that of `own`."""
    place = pathlib.Path(file).resolve()
    for folder in place.parents:
        if not _holds_run(folder):
            continue
        is_own = own and folder == pathlib.Path(own).resolve()
        if not is_own or place.relative_to(folder).parts[0] in ("figures", "artefacts", "state"):
            raise FileExistsError(f"{file}: lies in the directory of the run {folder}, whose files belong to that run alone; {remedy}")


def add_output_options(parser):
    parser.add_argument("--force", action="store_true", help="replace the file")
    parser.add_argument("--quiet", action="store_true", help="do not print its name")


def write_output(given, chosen, write):
    """Calls `write`, which gives the path of the file, and prints it. `chosen` is the file that the user named, or None."""
    if chosen:
        refuse_run_places(chosen, given.run, "choose another file")
    refuse_existing([pathlib.Path(chosen)] if chosen else [], given.force, "choose another file")
    file = write()
    if not given.quiet:
        print(file)
