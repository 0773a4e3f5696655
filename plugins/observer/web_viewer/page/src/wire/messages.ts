// SPDX-License-Identifier: BSD-3-Clause
// What the server says, typed. Missing or odd fields get neutral values, never an exception.
import { isObject, type Container, type JsonObject, type JsonValue } from './container';

export interface CameraInfo {
  readonly width: number;
  readonly height: number;
  readonly baseline: number;
}

export interface RunInfo {
  readonly name: string;
  readonly directory: string;
  readonly description: string;
  readonly frames: number; // -1: unknown
  readonly hasTruth: boolean;
  readonly live: boolean;
  readonly camera: CameraInfo | null;
  readonly stages: readonly string[];
  readonly columns: readonly string[];
  readonly rows: number;
  readonly newest: number;
}

export interface LogEvent {
  readonly frame: number;
  readonly level: string;
  readonly source: string;
  readonly message: string;
}

export interface RowBlock {
  readonly from: number;
  readonly columns: number;
  readonly values: Float64Array;
}

/** Activity and bumps of the cells, by their own names. */
export interface CellArray {
  readonly name: string;
  readonly shape: readonly number[];
  readonly values: Float32Array;
}

export interface FrameMessage {
  readonly frame: number;
  readonly image: Uint8Array | null;
  readonly points: Float32Array | null;
  readonly pointsFrame: number;
  readonly cells: readonly CellArray[];
  readonly rows: RowBlock | null;
  readonly events: readonly LogEvent[];
  readonly dropped: number;
  readonly clients: number;
}

export interface GraphMessage {
  readonly version: number;
  readonly frame: number;
  readonly experience: Float32Array; // x, y, z, yaw
  readonly experienceFrame: Int32Array;
  readonly link: Int32Array; // from, to
  readonly linkKind: Uint8Array; // 0 odometry, 1 loop
}

export function numberOf(value: JsonValue | undefined, otherwise = NaN): number {
  return typeof value === 'number' ? value : otherwise;
}

function textOf(value: JsonValue | undefined, otherwise = ''): string {
  return typeof value === 'string' ? value : otherwise;
}

function listOf(value: JsonValue | undefined): JsonValue[] {
  return Array.isArray(value) ? value : [];
}

export function readRun(header: JsonObject): RunInfo {
  const camera = header['camera'];
  return {
    name: textOf(header['name'], 'run'),
    directory: textOf(header['directory']),
    description: textOf(header['description']),
    frames: numberOf(header['frames'], -1),
    hasTruth: header['has_truth'] === true,
    live: header['live'] === true,
    camera: isObject(camera)
      ? {
          width: numberOf(camera['width'], 0),
          height: numberOf(camera['height'], 0),
          baseline: numberOf(camera['baseline'], 0),
        }
      : null,
    stages: listOf(header['stages']).filter((s): s is string => typeof s === 'string'),
    columns: listOf(header['row']).map((c) => (isObject(c) ? textOf(c['name']) : '')),
    rows: numberOf(header['rows'], 0),
    newest: numberOf(header['newest'], -1),
  };
}

export function readRows(message: Container, from: number): RowBlock | null {
  const rows = message.arrays.get('rows');
  if (!(rows?.values instanceof Float64Array) || rows.shape.length !== 2) return null;
  return { from, columns: rows.shape[1] ?? 0, values: rows.values };
}

function readEvents(value: JsonValue | undefined): LogEvent[] {
  return listOf(value)
    .filter(isObject)
    .map((e) => ({
      frame: numberOf(e['frame'], -1),
      level: textOf(e['level'], 'info'),
      source: textOf(e['source']),
      message: textOf(e['message']),
    }));
}

function readCells(message: Container): CellArray[] {
  const cells: CellArray[] = [];
  for (const [name, array] of message.arrays) {
    if (name.startsWith('cells.') && array.values instanceof Float32Array) {
      cells.push({ name: name.slice(6), shape: array.shape, values: array.values });
    }
  }
  return cells;
}

export function readFrame(message: Container): FrameMessage {
  const { header, arrays } = message;
  const image = arrays.get('image')?.values;
  const points = arrays.get('points')?.values;
  return {
    frame: numberOf(header['frame'], -1),
    image: image instanceof Uint8Array && image.length > 0 ? image : null,
    points: points instanceof Float32Array ? points : null,
    pointsFrame: numberOf(header['points_frame'], -1),
    cells: readCells(message),
    rows: readRows(message, numberOf(header['rows_from'], 0)),
    events: readEvents(header['events']),
    dropped: numberOf(header['dropped'], 0),
    clients: numberOf(header['clients'], 0),
  };
}

export function readGraph({ header, arrays }: Container): GraphMessage {
  const experience = arrays.get('experience')?.values;
  const experienceFrame = arrays.get('experience_frame')?.values;
  const link = arrays.get('link')?.values;
  const linkKind = arrays.get('link_kind')?.values;
  return {
    version: numberOf(header['version'], 0),
    frame: numberOf(header['frame'], -1),
    experience: experience instanceof Float32Array ? experience : new Float32Array(),
    experienceFrame: experienceFrame instanceof Int32Array ? experienceFrame : new Int32Array(),
    link: link instanceof Int32Array ? link : new Int32Array(),
    linkKind: linkKind instanceof Uint8Array ? linkKind : new Uint8Array(),
  };
}
