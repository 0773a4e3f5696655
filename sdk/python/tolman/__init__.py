# SPDX-License-Identifier: BSD-3-Clause
"""Tolman from Python: plugins (docs/python.md), and the results of runs."""
from tolman.geometry import between, compose, from_planar, set_planar_velocity, to_planar, wrap_angle
from tolman.parameters import parameter
from tolman.program import RunFailed, run
from tolman.plugins import (Cells, InvalidInput, InvalidParameter, Map, Observer, Odometry, Place, Plugin, Source,
                            Unsupported)
from tolman.records import (ArrayAxis, ArrayInfo, CameraRig, Decision, EarlierLoop, Experience, Finding, Frame, Link,
                            MapGraph, MapUpdate, Motion, MotionRevision, PlaceObservation, RunEvent, RunInfo, Snapshot,
                            SourceInfo)

from tolman.results import Run
from tolman.sweeps import Sweep, compare, sweep

__all__ = [name for name in dir() if not name.startswith("_")]
