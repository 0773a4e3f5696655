// SPDX-License-Identifier: BSD-3-Clause
// Numbers as text.

const kUnknown = '–';

export function integer(value: number): string {
  return Number.isFinite(value) ? Math.round(value).toString() : kUnknown;
}

export function fixed(value: number, decimals: number): string {
  if (!Number.isFinite(value)) return kUnknown;
  const text = value.toFixed(decimals);
  return Number(text) === 0 ? text.replace('-', '') : text;
}

/** Three significant digits. */
export function brief(value: number): string {
  if (!Number.isFinite(value)) return kUnknown;
  const size = Math.abs(value);
  return fixed(value, size >= 100 ? 0 : size >= 10 ? 1 : size >= 0.1 || size === 0 ? 2 : 3);
}

export function degrees(radians: number): string {
  return Number.isFinite(radians) ? `${fixed((radians * 180) / Math.PI, 1)}°` : kUnknown;
}

/** A length without needless zeros. */
export function metres(value: number): string {
  return value >= 1000 ? `${Number(value.toPrecision(6)) / 1000} km` : `${Number(value.toPrecision(3))} m`;
}

/** m:ss.t of data time. */
export function clock(seconds: number): string {
  if (!Number.isFinite(seconds)) return kUnknown;
  const minutes = Math.floor(seconds / 60);
  return `${minutes}:${(seconds - 60 * minutes).toFixed(1).padStart(4, '0')}`;
}

export const kTrackingNames = ['initialising', 'tracking', 'lost'] as const;
export const kRecognitionNames = ['none', 'novel', 'familiar'] as const;
export const kActionNames = ['stay', 'create', 'loop'] as const;

export function nameOf(names: readonly string[], index: number): string {
  return names[index] ?? kUnknown;
}
