// SPDX-License-Identifier: BSD-3-Clause
// Containers for the tests, written independently of the parser.

const kSizes = { u8: 1, i32: 4, f32: 4, f64: 8 } as const;

export interface TestArray {
  readonly name: string;
  readonly dtype: keyof typeof kSizes;
  readonly shape: readonly number[];
  readonly values: readonly number[];
}

function put(view: DataView, at: number, dtype: TestArray['dtype'], value: number): void {
  if (dtype === 'u8') view.setUint8(at, value);
  else if (dtype === 'i32') view.setInt32(at, value, true);
  else if (dtype === 'f32') view.setFloat32(at, value, true);
  else view.setFloat64(at, value, true);
}

export function message(header: object, arrays: readonly TestArray[] = []): ArrayBuffer {
  let offset = 0;
  const list = arrays.map(({ name, dtype, shape, values }) => {
    const at = offset;
    offset += Math.ceil((values.length * kSizes[dtype]) / 8) * 8;
    return { name, dtype, shape, offset: at };
  });
  const json = new TextEncoder().encode(JSON.stringify({ ...header, arrays: list }));
  const payload = Math.ceil((4 + json.length) / 8) * 8;
  const bytes = new ArrayBuffer(payload + offset);
  const view = new DataView(bytes);
  view.setUint32(0, json.length, true);
  new Uint8Array(bytes, 4).set(json);
  arrays.forEach(({ dtype, values }, i) => {
    const at = payload + (list[i]?.offset ?? 0);
    values.forEach((value, k) => put(view, at + k * kSizes[dtype], dtype, value));
  });
  return bytes;
}
