// SPDX-License-Identifier: BSD-3-Clause
import { describe, expect, it } from 'vitest';
import { parseContainer } from '../src/wire/container';
import { message } from './messages';

describe('a container', () => {
  it('gives header and arrays of each type with their shapes', () => {
    const parsed = parseContainer(
      message({ type: 'frame', frame: 7, name: 'Gödel' }, [
        { name: 'image', dtype: 'u8', shape: [3], values: [255, 216, 255] },
        { name: 'ids', dtype: 'i32', shape: [2], values: [-1, 70000] },
        { name: 'points', dtype: 'f32', shape: [1, 4], values: [1.5, 2, 0.25, 0] },
        { name: 'rows', dtype: 'f64', shape: [2, 2], values: [1e300, 0.1, NaN, -0] },
      ]),
    );
    expect(parsed.type).toBe('frame');
    expect(parsed.header['name']).toBe('Gödel');
    expect(parsed.arrays.get('image')?.values).toEqual(Uint8Array.of(255, 216, 255));
    expect(parsed.arrays.get('ids')?.values).toEqual(Int32Array.of(-1, 70000));
    expect(parsed.arrays.get('points')).toEqual({ shape: [1, 4], values: Float32Array.of(1.5, 2, 0.25, 0) });
    expect(parsed.arrays.get('rows')?.values).toEqual(Float64Array.of(1e300, 0.1, NaN, -0));
  });

  it('aligns whatever the length of the header', () => {
    for (let n = 0; n < 9; ++n) {
      const parsed = parseContainer(
        message({ type: 'x'.repeat(n) }, [{ name: 'a', dtype: 'f64', shape: [1], values: [n] }]),
      );
      expect(parsed.arrays.get('a')?.values[0]).toBe(n);
    }
  });

  it('takes an empty array and a message without arrays', () => {
    const empty = { name: 'rows', dtype: 'f64', shape: [0, 32], values: [] } as const;
    expect(parseContainer(message({ type: 'frame' }, [empty])).arrays.get('rows')?.values.length).toBe(0);
    expect(parseContainer(message({ type: 'end' })).arrays.size).toBe(0);
  });

  it.each([
    ['nothing', new ArrayBuffer(0), 'shorter'],
    ['a header beyond the end', Uint32Array.of(1000).buffer, 'longer'],
    ['no JSON', Uint8Array.of(2, 0, 0, 0, 0x7b, 0x7b).buffer, 'not JSON'],
    ['no type', message({ kind: 'frame' }), 'without a type'],
  ])('refuses %s', (_, bytes, reason) => {
    expect(() => parseContainer(bytes)).toThrow(reason);
  });

  it('refuses an array that reaches beyond the message', () => {
    const bytes = message({ type: 'f' }, [{ name: 'a', dtype: 'f64', shape: [4], values: [1, 2] }]);
    expect(() => parseContainer(bytes)).toThrow('array a reaches beyond the message');
  });

  it('refuses a negative shape', () => {
    const bytes = message({ type: 'f' }, [{ name: 'a', dtype: 'u8', shape: [-1], values: [1] }]);
    expect(() => parseContainer(bytes)).toThrow('array a: shape');
  });
});
