// SPDX-License-Identifier: BSD-3-Clause
// The binary form of all messages: a JSON header and numeric arrays, little-endian.

export type NumericArray = Uint8Array | Int32Array | Float32Array | Float64Array;

export interface WireArray {
  readonly shape: readonly number[];
  readonly values: NumericArray;
}

export interface Container {
  readonly type: string;
  readonly header: JsonObject;
  readonly arrays: ReadonlyMap<string, WireArray>;
}

export type JsonValue = null | boolean | number | string | JsonValue[] | JsonObject;
export interface JsonObject {
  [key: string]: JsonValue;
}

type ArrayMaker = (bytes: ArrayBuffer, offset: number, count: number) => NumericArray;

const kMakers: Readonly<Record<string, { size: number; make: ArrayMaker }>> = {
  u8: { size: 1, make: (bytes, offset, count) => new Uint8Array(bytes, offset, count) },
  i32: { size: 4, make: (bytes, offset, count) => new Int32Array(bytes, offset, count) },
  f32: { size: 4, make: (bytes, offset, count) => new Float32Array(bytes, offset, count) },
  f64: { size: 8, make: (bytes, offset, count) => new Float64Array(bytes, offset, count) },
};

export class WireError extends Error {}

export function isObject(value: JsonValue | undefined): value is JsonObject {
  return typeof value === 'object' && value !== null && !Array.isArray(value);
}

/** Arrays are views into `bytes`. Throws WireError for a malformed message. */
export function parseContainer(bytes: ArrayBuffer): Container {
  if (bytes.byteLength < 4) throw new WireError('message shorter than its length field');
  const headerLength = new DataView(bytes).getUint32(0, true);
  if (4 + headerLength > bytes.byteLength) throw new WireError('header longer than the message');
  const header = parseHeader(new Uint8Array(bytes, 4, headerLength));
  const type = header['type'];
  if (typeof type !== 'string') throw new WireError('header without a type');
  const payload = Math.ceil((4 + headerLength) / 8) * 8;
  return { type, header, arrays: parseArrays(bytes, payload, header['arrays']) };
}

function parseHeader(bytes: Uint8Array): JsonObject {
  let header: JsonValue;
  try {
    header = JSON.parse(new TextDecoder('utf-8', { fatal: true }).decode(bytes)) as JsonValue;
  } catch {
    throw new WireError('header is not JSON');
  }
  if (!isObject(header)) throw new WireError('header is not an object');
  return header;
}

function parseArrays(
  bytes: ArrayBuffer,
  payload: number,
  list: JsonValue | undefined,
): Map<string, WireArray> {
  const arrays = new Map<string, WireArray>();
  if (list === undefined) return arrays;
  if (!Array.isArray(list)) throw new WireError('"arrays" is not a list');
  for (const entry of list) {
    if (!isObject(entry)) throw new WireError('an array is not described by an object');
    const name = entry['name'];
    if (typeof name !== 'string') throw new WireError('an array without a name');
    arrays.set(name, parseArray(bytes, payload, name, entry));
  }
  return arrays;
}

function parseArray(
  bytes: ArrayBuffer,
  payload: number,
  name: string,
  entry: JsonObject,
): WireArray {
  const maker = kMakers[String(entry['dtype'])];
  const shape = entry['shape'];
  const offset = entry['offset'];
  if (maker === undefined) throw new WireError(`array ${name}: unknown dtype`);
  if (!Array.isArray(shape) || !shape.every(isCount)) throw new WireError(`array ${name}: shape`);
  if (!isCount(offset) || offset % 8 !== 0) throw new WireError(`array ${name}: offset`);
  const count = (shape as number[]).reduce((product, n) => product * n, 1);
  if (payload + offset + count * maker.size > bytes.byteLength) {
    throw new WireError(`array ${name} reaches beyond the message`);
  }
  return { shape: shape as number[], values: maker.make(bytes, payload + offset, count) };
}

function isCount(value: JsonValue | undefined): value is number {
  return typeof value === 'number' && Number.isInteger(value) && value >= 0;
}
