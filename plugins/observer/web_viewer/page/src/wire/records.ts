// SPDX-License-Identifier: BSD-3-Clause
// Generated from the records' field lists by scripts/build-page; do not edit.

export interface Camera {
  readonly width: number; // px
  readonly height: number; // px
  readonly calibrated: boolean;
  readonly 'pinhole.fx': number; // px
  readonly 'pinhole.fy': number; // px
  readonly 'pinhole.cx': number; // px
  readonly 'pinhole.cy': number; // px
  readonly baseline: number; // m
}

export interface SourceInfo {
  readonly description: string;
  readonly rig: Camera;
  readonly frames: number;
  readonly has_truth: boolean;
}

export interface ArrayAxis {
  readonly name: string;
  readonly unit: string;
  readonly first: number;
  readonly step: number;
  readonly period: number;
  readonly labels: readonly string[];
}

export interface ArrayInfo {
  readonly name: string;
  readonly kind: 'values' | 'activity' | 'bump' | 'depth_image';
  readonly unit: string;
  readonly doc: string;
  readonly population: string;
  readonly axes: readonly ArrayAxis[];
}

export interface RunInfo {
  readonly name: string;
  readonly directory: string;
  readonly source: SourceInfo;
  readonly arrays: readonly ArrayInfo[];
}

export interface Column {
  readonly name: string;
  readonly unit: string;
  readonly doc: string;
}

export interface HelloHeader {
  readonly type: 'hello';
  readonly run: RunInfo;
  readonly live: boolean;
  readonly recorded: boolean;
  readonly rows: number;
  readonly columns: readonly Column[];
}

export interface RunEvent {
  readonly frame: number;
  readonly level: 'debug' | 'info' | 'warning' | 'error';
  readonly source: string;
  readonly message: string;
}

export interface FrameHeader {
  readonly type: 'frame';
  readonly frame: number;
  readonly points_frame: number;
  readonly rows_from: number;
  readonly dropped: number;
  readonly events: readonly RunEvent[];
}

export interface HistoryHeader {
  readonly type: 'history';
  readonly from: number;
  readonly total: number;
}

export interface GraphHeader {
  readonly type: 'graph';
  readonly version: number;
  readonly frame: number;
}

export interface EndHeader {
  readonly type: 'end';
  readonly state: string;
  readonly frames: number;
}

/** Columns of a history row, in the order of its values. */
export const kColumns = [
  'frame.frame',
  'frame.time',
  'frame.source_index',
  'frame.has_truth',
  'motion.state',
  'motion.dt',
  'motion.v',
  'motion.omega',
  'motion.scale_known',
  'motion.tracked',
  'motion.is_keyframe',
  'motion.points_frame',
  'place.recognition',
  'place.template_id',
  'place.score',
  'place.relative_yaw',
  'place.has_relative_pose',
  'candidate.template_id',
  'candidate.score',
  'candidate.limit',
  'candidate.agreeing',
  'candidate.compared',
  'candidate.needed',
  'decision.action',
  'decision.experience',
  'decision.template_id',
  'decision.relative_yaw',
  'decision.has_relative_pose',
  'decision.heading',
  'decision.confidence',
  'hypothesis.id',
  'hypothesis.fate',
  'hypothesis.experience',
  'hypothesis.energy',
  'hypothesis.change',
  'hypothesis.share',
  'hypothesis.limit',
  'hypothesis.views',
  'hypothesis.unsupported',
  'map_update.experience',
  'map_update.version',
  'map_update.experiences',
  'map_update.links',
  'map_update.loops',
  'odometry.x',
  'odometry.y',
  'odometry.z',
  'map.x',
  'map.y',
  'map.z',
  'truth.x',
  'truth.y',
  'truth.z',
  'anchor.x',
  'anchor.y',
  'anchor.z',
  'anchor.yaw',
  'measured.error',
  'measured.sigmas',
  'duration.source',
  'duration.odometry',
  'duration.place',
  'duration.cells',
  'duration.map',
] as const;
export type ColumnName = (typeof kColumns)[number];

/** Names of the values of columns that hold an enumeration. */
export const kChoices = {
  'motion.state': ['initialising', 'tracking', 'lost'],
  'place.recognition': ['none', 'novel', 'familiar'],
  'decision.action': ['stay', 'create_experience', 'close_loop'],
  'hypothesis.fate': ['born', 'grew', 'accepted', 'faded', 'displaced'],
} as const;
