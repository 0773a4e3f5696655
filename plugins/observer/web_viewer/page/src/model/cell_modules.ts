// SPDX-License-Identifier: BSD-3-Clause
// The cells' arrays, sorted into rings and sheets. By name: "M.activity" is a population of module
// M, and "M.integrator", ".calibration", ".injected", ".estimate" are its bumps as (mean...,
// precision). A block over (theta, y, x) is shown as its two projections. A three-number
// ".estimate" of a module without activity is a pose in cells (x, y, theta), for ring and sheet.
import type { CellArray } from '../wire/messages';

export type BumpKind = 'integrator' | 'calibration' | 'injected' | 'estimate';
export const kBumpKinds: readonly BumpKind[] = ['integrator', 'calibration', 'injected', 'estimate'];

export interface Bump {
  readonly kind: BumpKind;
  readonly mean: readonly number[]; // in the module's own unit
  readonly precision: number; // NaN: unknown
}

export interface Population {
  readonly module: string;
  readonly shape: readonly number[]; // [units] or [rows y, columns x]
  readonly activity: Float32Array;
  readonly bumps: readonly Bump[];
  readonly inUnits: boolean; // means count units, not the module's phase
}

export interface CellModules {
  readonly rings: readonly Population[];
  readonly sheets: readonly Population[];
}

export function sortCells(arrays: readonly CellArray[]): CellModules {
  const byName = new Map(arrays.map((a) => [a.name, a]));
  const rings: Population[] = [];
  const sheets: Population[] = [];
  const pose = poseEstimate(byName);
  for (const array of arrays) {
    if (!array.name.endsWith('.activity') || array.values.length === 0) continue;
    const module = array.name.slice(0, -'.activity'.length);
    for (const part of populations(module, array)) {
      const axes = part.shape.length;
      const own = bumpsOf(byName, module, axes);
      const bumps = own.length > 0 ? own : poseBumps(pose, axes);
      (axes === 1 ? rings : sheets).push({ ...part, bumps, inUnits: own.length === 0 });
    }
  }
  return { rings, sheets };
}

type Part = Pick<Population, 'module' | 'shape' | 'activity'>;

function populations(module: string, { shape, values }: CellArray): Part[] {
  if (shape.length === 1 || shape.length === 2) return [{ module, shape, activity: values }];
  if (shape.length !== 3) return [];
  const [layers, height, width] = shape as [number, number, number];
  const layer = height * width;
  const ring = new Float32Array(layers);
  const sheet = new Float32Array(layer);
  for (let i = 0; i < values.length; ++i) {
    const value = values[i] as number;
    ring[Math.floor(i / layer)]! += value;
    sheet[i % layer]! += value;
  }
  return [
    { module: `${module}, all places`, shape: [layers], activity: ring },
    { module: `${module}, all headings`, shape: [height, width], activity: sheet },
  ];
}

function bumpsOf(byName: ReadonlyMap<string, CellArray>, module: string, axes: number): Bump[] {
  const bumps: Bump[] = [];
  for (const kind of kBumpKinds) {
    const values = byName.get(`${module}.${kind}`)?.values;
    if (values === undefined || values.length !== axes + 1) continue;
    const mean = Array.from(values.subarray(0, axes));
    bumps.push({ kind, mean, precision: values[axes] as number });
  }
  return bumps;
}

function poseEstimate(byName: ReadonlyMap<string, CellArray>): CellArray | null {
  for (const [name, array] of byName) {
    if (!name.endsWith('.estimate') || array.values.length !== 3) continue;
    if (!byName.has(name.replace(/estimate$/, 'activity'))) return array;
  }
  return null;
}

function poseBumps(pose: CellArray | null, axes: number): Bump[] {
  if (pose === null) return [];
  const [x, y, theta] = pose.values as unknown as [number, number, number];
  return [{ kind: 'estimate', mean: axes === 1 ? [theta] : [x, y], precision: NaN }];
}

/**
 * The period of a sheet in the unit of its bumps, which the wire does not say: activity is the
 * estimate's bump, so its circular mean, as a share of the sheet, is the estimate's mean as a share
 * of the period. Least squares over what has been seen, away from the seam.
 */
export class PeriodFinder {
  private products = 0;
  private squares = 0;

  get period(): number {
    return this.squares > 0 ? this.products / this.squares : NaN;
  }

  note({ shape, activity, bumps, inUnits }: Population): void {
    const estimate = bumps.find((b) => b.kind === 'estimate');
    if (estimate === undefined || shape.length !== 2) return;
    const [rows, columns] = shape as [number, number];
    if (inUnits) {
      [this.products, this.squares] = [columns, 1];
      return;
    }
    this.add(estimate.mean[0] ?? NaN, circularMean(activity, columns, (i) => i % columns));
    this.add(estimate.mean[1] ?? NaN, circularMean(activity, rows, (i) => Math.floor(i / columns)));
  }

  private add(mean: number, share: number): void {
    if (!(share > 0.05 && share < 0.95) || !Number.isFinite(mean)) return;
    this.products += mean * share;
    this.squares += share * share;
  }
}

/** In [0, 1) of the way round. */
export function circularMean(
  activity: Float32Array,
  units: number,
  unitOf: (index: number) => number,
): number {
  let [x, y] = [0, 0];
  for (let i = 0; i < activity.length; ++i) {
    const angle = (2 * Math.PI * unitOf(i)) / units;
    x += (activity[i] as number) * Math.cos(angle);
    y += (activity[i] as number) * Math.sin(angle);
  }
  const turn = Math.atan2(y, x) / (2 * Math.PI);
  return turn < 0 ? turn + 1 : turn;
}
