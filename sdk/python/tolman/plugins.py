# SPDX-License-Identifier: BSD-3-Clause
"""The six roles. A plugin is one file with one class that derives from one of these.

The host sets the parameters and, before `start()`, `self.log` (debug, info, warning, error), `self.rng` (a seeded
numpy Generator), `self.seed`, `self.rig` (the cameras) and `self.name` (of the stage). A reset makes a new object
and calls `start()` again, so everything that changes belongs to attributes that `start()` sets.

An answer has the frame and the time of its question; both may be left out. Results may depend on inputs, parameters
and `self.rng` alone. Raise InvalidInput, InvalidParameter or Unsupported for faults of the data, the configuration,
or this plugin's limits.
"""
from tolman import parameters, records


class InvalidInput(Exception):
    """The data are wrong."""


class InvalidParameter(Exception):
    """The configuration is wrong."""


class Unsupported(Exception):
    """Valid, but this plugin cannot do it."""


class _NoLog:
    """Takes the log's place where no host runs the plugin."""

    def debug(self, text):
        pass

    info = warning = error = debug


class Plugin:
    """What all roles have. `Mine(spacing=0.5)` makes one without a host, for tests."""

    version = "0.1.0"

    def __init__(self, *, seed=1, rig=None, **values):
        import numpy as np

        known = parameters.bound(type(self), values)
        unknown = set(values) - set(known)
        if unknown:
            raise TypeError(f"{type(self).__name__} has no parameter '{min(unknown)}'")
        for name, value in known.items():
            setattr(self, name, value)
        self.log, self.rig, self.seed, self.name = _NoLog(), rig or records.CameraRig(), seed, ""
        self.rng = np.random.Generator(np.random.PCG64(seed))
        self.start()

    def start(self):
        """Prepares the state of a run."""

    def add_finding(self, finding):
        """Reports a Finding: an error is left out and stops the run, unless it has `on_findings: continue`."""

    def write_artefact(self, name, content):
        """Writes bytes or text to artefacts/STAGE/NAME of the run directory."""


class Source(Plugin):
    """Gives frames in the order of time."""

    def info(self):
        """A SourceInfo."""
        raise NotImplementedError("a source has info(), which returns a SourceInfo")

    def next(self):
        """The next Frame, None after the last."""
        raise NotImplementedError("a source has next(), which returns a Frame, or None at the end")


class Odometry(Plugin):
    """Estimates the motion from one frame to the next."""

    def track(self, frame):
        """A Motion. The first one is `initialising`, the identity."""
        raise NotImplementedError("odometry has track(frame), which returns a Motion")

    def finish(self):
        """After the last frame: a list of MotionRevision."""
        return []


class Place(Plugin):
    """Decides whether a view was seen before. With `needs_motion = True` it gets the motion of the frame, too."""

    needs_motion = False

    def observe(self, frame, motion):
        """A PlaceObservation. `motion` is None unless `needs_motion`."""
        raise NotImplementedError("place recognition has observe(frame, motion), which returns a PlaceObservation")

    def finish(self):
        """After the last frame."""


class Cells(Plugin):
    """A model of spatial cells: decides where the robot is."""

    def step(self, motion, place):
        """A Decision."""
        raise NotImplementedError("cells have step(motion, place), which returns a Decision")

    def finish(self):
        """After the last frame."""


class Map(Plugin):
    """Keeps the graph of experiences that the decisions of the cells define."""

    def update(self, motion, decision):
        """A MapUpdate."""
        raise NotImplementedError("a map has update(motion, decision), which returns a MapUpdate")

    def pose_of(self, frame):
        """T_world_camera of a frame, as estimated now. Raises InvalidParameter for one that was not seen."""
        raise NotImplementedError("a map has pose_of(frame), which returns a 4x4 pose")

    def graph(self):
        """A MapGraph."""
        raise NotImplementedError("a map has graph(), which returns a MapGraph")

    def finish(self, revisions):
        """After the last frame, with the last revisions of motions."""


class Observer(Plugin):
    """Reads everything, changes nothing."""

    def begin(self, run):
        """Before the first frame, with a RunInfo."""

    def observe(self, snapshot):
        """One frame, a Snapshot."""

    def finish(self, graph):
        """After the last frame, with the final MapGraph."""


ROLES = {"source": Source, "odometry": Odometry, "place": Place, "cells": Cells, "map": Map, "observer": Observer}
