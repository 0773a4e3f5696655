# SPDX-License-Identifier: BSD-3-Clause
"""The records that flow from stage to stage: those of tolman/records.hpp and roles.hpp, with the same fields.

Times are integer nanoseconds, lengths metres, angles radians. A pose `T_a_b` is a 4x4 array that takes
coordinates of frame b to frame a; camera axes are x right, y down, z forward. Covariances are 6x6, translation
before rotation. An image is an array of bytes (height, width) or (height, width, 3), blue first, read-only;
None where there is none. Named arrays are a dict from name to array.
"""
from dataclasses import dataclass, field

import numpy as np


def _pose():
    return field(default_factory=lambda: np.eye(4))


def _covariance():
    return field(default_factory=lambda: np.zeros((6, 6)))


@dataclass(slots=True)
class CameraRig:
    """The cameras of a source, constant over a run."""

    width: int = 0  # px; 0 without images
    height: int = 0  # px
    calibrated: bool = False
    fx: float = 0.0  # px
    fy: float = 0.0  # px
    cx: float = 0.0  # px
    cy: float = 0.0  # px
    baseline: float = 0.0  # m; 0 for a single camera


@dataclass(slots=True)
class Frame:
    """One exposure of the cameras."""

    frame: int = -1
    stamp_ns: int = 0
    source_index: int = -1
    left: np.ndarray | None = None
    right: np.ndarray | None = None
    has_truth: bool = False
    T_world_camera_truth: np.ndarray = _pose()
    defect: str = ""
    sensors: dict = field(default_factory=dict)


@dataclass(slots=True)
class MotionRevision:
    """A better value for the motion that arrived at an earlier frame."""

    frame: int = -1
    T_previous_current: np.ndarray = _pose()
    covariance: np.ndarray = _covariance()


@dataclass(slots=True)
class Motion:
    """Answer of odometry: the motion since the frame before."""

    frame: int = -1
    stamp_ns: int = 0
    state: str = "initialising"  # or tracking, lost
    dt: float = 0.0  # s
    T_previous_current: np.ndarray = _pose()
    covariance: np.ndarray = _covariance()
    v: float = 0.0  # m/s in the plane, negative when reversing
    omega: float = 0.0  # rad/s, positive to the left
    scale_known: bool = True
    tracked: int = 0
    is_keyframe: bool = False
    points_frame: int = -1
    points: np.ndarray = field(default_factory=lambda: np.zeros((4, 0), np.float32))
    revisions: list = field(default_factory=list)


@dataclass(slots=True)
class Candidate:
    """A place that a recogniser considered; for explanations."""

    template_id: int = -1
    score: float = 0.0
    limit: float = 0.0
    agreeing: int = -1  # landmarks
    compared: int = -1
    needed: int = -1
    reason: str = ""


@dataclass(slots=True)
class PlaceObservation:
    """Answer of place recognition."""

    frame: int = -1
    stamp_ns: int = 0
    recognition: str = "none"  # or novel, familiar
    template_id: int = -1
    score: float = 0.0
    relative_yaw: float = 0.0  # rad, heading now minus heading of the template
    has_relative_pose: bool = False
    T_template_current: np.ndarray = _pose()
    covariance: np.ndarray = _covariance()
    candidates: list = field(default_factory=list)


@dataclass(slots=True)
class EarlierLoop:
    """A loop that was seen at an earlier frame and is accepted only now."""

    frame: int = -1
    experience: int = -1
    T_experience_camera: np.ndarray = _pose()
    covariance: np.ndarray = _covariance()


@dataclass(slots=True)
class PlaceHypothesis:
    """A place at which the cells suppose the robot to be, at a frame that changed it; for explanations."""

    id: int = -1
    fate: str = "born"  # or grew, accepted, faded, displaced
    experience: int = -1
    energy: float = 0.0  # nats
    change: float = 0.0  # nats
    share: float = 0.0
    limit: float = 0.0
    views: int = 0
    unsupported: float = 0.0  # m


@dataclass(slots=True)
class Decision:
    """Answer of the cells."""

    frame: int = -1
    stamp_ns: int = 0
    action: str = "stay"  # or create_experience, close_loop
    experience: int = -1
    template_id: int = -1
    relative_yaw: float = 0.0  # rad, heading now minus heading at the experience
    has_relative_pose: bool = False
    T_experience_current: np.ndarray = _pose()
    covariance: np.ndarray = _covariance()
    heading: float = 0.0  # rad in [0, 2 pi), positive to the left
    confidence: float = 1.0
    earlier: list = field(default_factory=list)
    hypotheses: list = field(default_factory=list)


@dataclass(slots=True)
class Experience:
    """A node of the map."""

    id: int = -1
    frame: int = -1
    template_id: int = -1
    T_world_experience: np.ndarray = _pose()


@dataclass(slots=True)
class Link:
    """A spatial constraint between two experiences."""

    id: int = -1
    from_: int = -1
    to: int = -1
    kind: str = "odometry"  # or loop
    frame: int = -1
    T_from_to: np.ndarray = _pose()
    covariance: np.ndarray = _covariance()
    duration: float = 0.0  # s
    weight: float = 1.0


@dataclass(slots=True)
class MapUpdate:
    """Answer of the map."""

    frame: int = -1
    stamp_ns: int = 0
    experience: int = -1
    T_experience_camera: np.ndarray = _pose()
    T_world_camera: np.ndarray = _pose()
    version: int = 0
    experiences: int = 0
    links: int = 0
    loops: int = 0


@dataclass(slots=True)
class MapGraph:
    """The whole map."""

    version: int = 0
    experiences: list = field(default_factory=list)
    links: list = field(default_factory=list)
    rejected: list = field(default_factory=list)
    residuals: list = field(default_factory=list)


@dataclass(slots=True)
class Finding:
    """Something in the data that their user should know."""

    severity: str = "note"  # or warning, error
    where: str = ""
    message: str = ""
    remedy: str = ""
    kind: str = "unusual"  # or damaged, contradiction


@dataclass(slots=True)
class SourceInfo:
    """Description of the data."""

    description: str = ""
    rig: CameraRig = field(default_factory=CameraRig)
    frames: int = -1
    has_truth: bool = False


@dataclass(slots=True)
class RunEvent:
    """An event that is no answer of a stage."""

    frame: int = -1
    level: str = "info"  # or debug, warning, error
    source: str = ""
    message: str = ""


@dataclass(slots=True)
class ArrayAxis:
    """One axis of a named array: index i stands for first + i * step, modulo the period."""

    name: str = ""
    unit: str = ""
    first: float = 0.0
    step: float = 1.0
    period: float = 0.0
    labels: list = field(default_factory=list)


@dataclass(slots=True)
class ArrayInfo:
    """What the numbers of a named array are."""

    name: str = ""
    kind: str = "values"  # or activity, bump, depth_image
    unit: str = ""
    doc: str = ""
    population: str = ""
    axes: list = field(default_factory=list)


@dataclass(slots=True)
class RunInfo:
    """Description of the run, for observers."""

    name: str = ""
    directory: str = ""
    source: SourceInfo = field(default_factory=SourceInfo)
    arrays: list = field(default_factory=list)


@dataclass(slots=True)
class Snapshot:
    """Everything about one frame, for observers."""

    frame: Frame
    motion: Motion
    place: PlaceObservation
    decision: Decision
    map: MapUpdate
    cells: dict  # named arrays of the cells
    graph: MapGraph | None  # None unless the map changed since the last snapshot
    stage_times_ns: dict
    events: list


# By the names of the records in tolman/fields.hpp.
BY_NAME = {
    "camera": CameraRig, "frame": Frame, "motion_revision": MotionRevision, "motion": Motion,
    "candidate": Candidate, "place": PlaceObservation, "earlier_loop": EarlierLoop,
    "hypothesis": PlaceHypothesis, "decision": Decision, "experience": Experience,
    "link": Link, "map_update": MapUpdate, "map_graph": MapGraph, "finding": Finding, "source_info": SourceInfo,
    "run_event": RunEvent, "array_axis": ArrayAxis, "array_info": ArrayInfo, "run_info": RunInfo,
    "snapshot": Snapshot,
}  # yapf: disable
