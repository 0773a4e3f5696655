// SPDX-License-Identifier: BSD-3-Clause
// Numbers as text.
import { kChoices } from '../wire/records';

const kUnknown = '–';

export function integer(value: number): string {
  return Number.isFinite(value) ? Math.round(value).toString() : kUnknown;
}

export function fixed(value: number, decimals: number): string {
  if (!Number.isFinite(value)) return kUnknown;
  const text = value.toFixed(decimals);
  return Number(text) === 0 ? text.replace('-', '') : text;
}

/** A number with three significant digits. */
export function brief(value: number): string {
  if (!Number.isFinite(value)) return kUnknown;
  const size = Math.abs(value);
  return fixed(value, size >= 100 ? 0 : size >= 10 ? 1 : size >= 0.1 || size === 0 ? 2 : 3);
}

export function degrees(radians: number): string {
  return Number.isFinite(radians) ? `${fixed((radians * 180) / Math.PI, 1)}°` : kUnknown;
}

/** A length in m or km. */
export function metres(value: number): string {
  return value >= 1000 ? `${Number(value.toPrecision(6)) / 1000} km` : `${Number(value.toPrecision(3))} m`;
}

/** A length of a run without scale. */
export function units(value: number): string {
  return `${brief(value)} units`;
}

/** A time span as in the program's texts: "3.7 s", from a minute on "1:04 min", from an hour on "1:02 h". */
export function duration(seconds: number): string {
  if (!Number.isFinite(seconds)) return kUnknown;
  if (Math.round(10 * seconds) < 600) return `${fixed(seconds, 1)} s`;
  const hours = Math.round(seconds) >= 3600;
  const units = Math.round(hours ? seconds / 60 : seconds);
  return `${Math.floor(units / 60)}:${String(units % 60).padStart(2, '0')} ${hours ? 'h' : 'min'}`;
}

/** Name of the value of a column that holds an enumeration. */
export function choiceName(column: keyof typeof kChoices, index: number): string {
  const names: readonly string[] = kChoices[column];
  return names[index]?.replace('_', ' ') ?? kUnknown;
}
