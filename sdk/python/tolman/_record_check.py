# SPDX-License-Identifier: BSD-3-Clause
"""Whether run.sqlite has all rows of its run: the checks of `tolman` (framework/record/run_reader.cpp) without its digests."""
import contextlib
import fcntl
import os
import re
import sqlite3

_OF_FRAMES = ("frame", "motion", "place", "decision", "map_update")
_ENDED = ("finished", "interrupted")


def connect(file, *, with_log=True):
    """A connection that only reads; without the log SQLite does not look at run.sqlite-wal."""
    return sqlite3.connect(file.as_uri() + "?mode=ro" + ("" if with_log else "&immutable=1"), uri=True)


def require_whole(database, file, info):
    """Raises ValueError where rows are missing. `info` is what run.json said before `database` was read."""
    try:
        _require_rows(database, file, info)
    except (ValueError, sqlite3.DatabaseError) as error:
        if info.get("status") in _ENDED and _is_whole_without_log(file, info):
            log = f"{file.name}-wal"
            raise ValueError(f"{file}: is whole, but the {log} beside it is of another state of it, such as a copy that was made "
                             f"during the run; remove {log} and {file.name}-shm") from error
        raise


def _require_rows(database, file, info):
    if not database.execute("SELECT count(*) FROM sqlite_master WHERE name = 'run'").fetchone()[0]:
        raise ValueError(f"{file}: has no table 'run': it is no record of a run, or one that begins at this moment; if its run is "
                         "going on, try again")
    run, recorded = info.get("id"), _entry(database, "id")
    if run is not None and run != recorded:
        raise ValueError(f"{file}: is of another run than the run.json of this run directory; put back the files of one run")
    counts = _entry(database, "rows")  # the last that a run records
    if not counts and info.get("status") in _ENDED and not _is_being_written(file.parent):
        raise ValueError(f"{file}: lacks the end of the run, which has ended by run.json; if run.sqlite-wal was not copied with it, "
                         "put it beside it, or run it again")
    for table, rows in re.findall(r"(\w+)=(\d+)", counts or ""):
        found = database.execute(f'SELECT count(*) FROM "{table}"').fetchone()[0]
        if found != int(rows):
            raise ValueError(f"{file}: table '{table}' has {found} rows, and had {rows} when the run ended: rows were removed or "
                             "added; take back the change, or run it again")
    _require_rows_of_frames(database, file)


def _require_rows_of_frames(database, file):
    """Every stage that has answers has one of each frame, and a motion is of the time of its frame."""
    tables = [table for table in _OF_FRAMES if database.execute(f"SELECT frame FROM {table} LIMIT 1").fetchone()]
    for table in tables[1:]:
        for missing, other in ((table, tables[0]), (tables[0], table)):
            row = database.execute(f"SELECT min(frame) FROM {other} WHERE frame NOT IN (SELECT frame FROM {missing})").fetchone()
            if row[0] is not None:
                raise ValueError(f"{file}: the {missing} of frame {row[0]} is missing: rows of the record were removed; take back "
                                 "the change, or run it again")
    row = database.execute("SELECT min(frame) FROM frame JOIN motion USING (frame) WHERE frame.stamp_ns <> motion.stamp_ns").fetchone()
    if row[0] is not None:
        raise ValueError(f"{file}: the stamps of frame {row[0]} and of its motion differ; take back the change, or run it again")


def _is_whole_without_log(file, info):
    """Whether the file alone has the end of its run and all rows, so that a log beside it is not its own."""
    log = file.with_name(file.name + "-wal")
    if not log.is_file() or _is_being_written(file.parent):
        return False
    try:
        with contextlib.closing(connect(file, with_log=False)) as alone:
            _require_rows(alone, file, info)
            return bool(_entry(alone, "rows"))
    except (ValueError, sqlite3.DatabaseError):
        return False


def _entry(database, key):
    """A value of table `run`; None where it has none."""
    row = database.execute("SELECT value FROM run WHERE key = ?", (key,)).fetchone()
    return row[0] if row else None


def _is_being_written(directory):
    """Whether a run holds the lock of its directory, as record::RunDirectory takes it."""
    try:
        descriptor = os.open(directory, os.O_RDONLY | os.O_DIRECTORY | os.O_CLOEXEC)
    except OSError:
        return False
    try:
        fcntl.flock(descriptor, fcntl.LOCK_SH | fcntl.LOCK_NB)
        return False
    except OSError:
        return True
    finally:
        os.close(descriptor)
