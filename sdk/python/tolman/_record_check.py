# SPDX-License-Identifier: BSD-3-Clause
"""Whether run.sqlite is the file that its run wrote, as `tolman` checks it (framework/record/digest.hpp)."""
import fcntl
import hashlib
import os
import sqlite3


def connect(file):
    """A connection that only reads."""
    return sqlite3.connect(file.as_uri() + "?mode=ro", uri=True)


def require_whole(database, file, info):
    """Raises ValueError for no record, and for one that was changed after the run. `info` is run.json."""
    if not database.execute("SELECT count(*) FROM sqlite_master WHERE name = 'run'").fetchone()[0]:
        raise ValueError(f"{file}: has no table 'run': it is no record of a run, or one that begins at this moment; if its run is "
                         "going on, try again")
    digest = info.get("record_sha256")
    if digest is None or _is_being_written(file.parent):
        return
    log = file.with_name(file.name + "-wal")
    changed = log if log.is_file() and log.stat().st_size > 0 else file if digest_of(file) != digest else None
    if changed:
        raise ValueError(f"{changed}: is not what the run wrote: changed, damaged or of another run since; put the file back, or "
                         "run it again")


def digest_of(file):
    """SHA-256 of a file, which may be large."""
    sha = hashlib.sha256()
    with open(file, "rb") as stream:
        for block in iter(lambda: stream.read(1 << 20), b""):
            sha.update(block)
    return sha.hexdigest()


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
