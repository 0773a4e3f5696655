// SPDX-License-Identifier: BSD-3-Clause
// The messages of the server: a header, whose type is generated from the C++ records, and arrays.
import type { Container } from './container';
import { kColumns, type FrameHeader, type GraphHeader, type HelloHeader } from './records';

/** Whole rows, one after the other; `from` is the number of the first one. */
export interface RowBlock {
  readonly from: number;
  readonly columns: number;
  readonly values: Float64Array;
}

/** An array of the cells under its name. */
export interface FrameArray {
  readonly name: string;
  readonly shape: readonly number[];
  readonly values: Float32Array;
}

export interface FrameMessage {
  readonly header: FrameHeader;
  readonly image: Uint8Array | null; // a JPEG file
  readonly points: Float32Array | null; // u, v (px), inverse depth (1/m), its variance of each
  readonly arrays: readonly FrameArray[];
  readonly rows: RowBlock | null;
}

export interface GraphMessage {
  readonly header: GraphHeader;
  readonly experience: Float32Array; // x, y, z (m), yaw (rad) of each
  readonly link: Int32Array; // from, to of each
  readonly linkKind: Uint8Array; // 0 odometry, 1 loop
  readonly linkRejected: Uint8Array; // 1: loop link that the map has rejected
  readonly loop: Int32Array; // of each loop link: its number, its frame, the frames of its ends
  readonly loopResidual: Float32Array; // standard deviations; -1: not known
}

/** The header of a message of the type that its "type" names. */
export function headerOf<T extends { readonly type: string }>({ header }: Container): T {
  return header as unknown as T;
}

/** False when the server is of another version than this page. */
export function hasSameColumns(hello: HelloHeader): boolean {
  return hello.columns.map((c) => c.name).join() === kColumns.join();
}

export function readRows(message: Container, from: number): RowBlock | null {
  const rows = message.arrays.get('rows');
  if (!(rows?.values instanceof Float64Array) || rows.shape.length !== 2) return null;
  return { from, columns: rows.shape[1] ?? 0, values: rows.values };
}

const kArrayPrefix = 'cells.';

function readArrays(message: Container): FrameArray[] {
  const arrays: FrameArray[] = [];
  for (const [name, { shape, values }] of message.arrays) {
    if (name.startsWith(kArrayPrefix) && values instanceof Float32Array) {
      arrays.push({ name: name.slice(kArrayPrefix.length), shape, values });
    }
  }
  return arrays;
}

export function readFrame(message: Container): FrameMessage {
  const header = headerOf<FrameHeader>(message);
  const image = message.arrays.get('image')?.values;
  const points = message.arrays.get('points')?.values;
  return {
    header,
    image: image instanceof Uint8Array && image.length > 0 ? image : null,
    points: points instanceof Float32Array ? points : null,
    arrays: readArrays(message),
    rows: readRows(message, header.rows_from),
  };
}

export function readGraph(message: Container): GraphMessage {
  const values = (name: string) => message.arrays.get(name)?.values;
  const experience = values('experience');
  const link = values('link');
  const linkKind = values('link_kind');
  const linkRejected = values('link_rejected');
  const loop = values('loop');
  const loopResidual = values('loop_residual');
  return {
    header: headerOf<GraphHeader>(message),
    experience: experience instanceof Float32Array ? experience : new Float32Array(),
    link: link instanceof Int32Array ? link : new Int32Array(),
    linkKind: linkKind instanceof Uint8Array ? linkKind : new Uint8Array(),
    linkRejected: linkRejected instanceof Uint8Array ? linkRejected : new Uint8Array(),
    loop: loop instanceof Int32Array ? loop : new Int32Array(),
    loopResidual: loopResidual instanceof Float32Array ? loopResidual : new Float32Array(),
  };
}
