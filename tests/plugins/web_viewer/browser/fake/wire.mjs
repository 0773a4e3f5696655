// SPDX-License-Identifier: BSD-3-Clause
// Writes the container of the wire: JSON header, then arrays, little endian.

const kTypes = new Map([
  [Uint8Array, 'u8'],
  [Int32Array, 'i32'],
  [Float32Array, 'f32'],
  [Float64Array, 'f64'],
]);

const aligned = (bytes) => Math.ceil(bytes / 8) * 8;

/** `arrays`: name -> { shape, values } or a typed array of one dimension. */
export function container(header, arrays = {}) {
  let offset = 0;
  const list = [];
  const parts = [];
  for (const [name, given] of Object.entries(arrays)) {
    const values = ArrayBuffer.isView(given) ? given : given.values;
    const dtype = kTypes.get(Object.getPrototypeOf(values).constructor) ?? 'u8';
    list.push({ name, dtype, shape: given.shape ?? [values.length], offset });
    parts.push([offset, Buffer.from(values.buffer, values.byteOffset, values.byteLength)]);
    offset += aligned(values.byteLength);
  }
  const json = Buffer.from(JSON.stringify({ ...header, arrays: list }), 'utf8');
  const payload = aligned(4 + json.length);
  const message = Buffer.alloc(payload + offset);
  message.writeUInt32LE(json.length, 0);
  json.copy(message, 4);
  for (const [at, bytes] of parts) bytes.copy(message, payload + at);
  return message;
}
