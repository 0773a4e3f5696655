// SPDX-License-Identifier: BSD-3-Clause
// The arrays of a frame, sorted by their descriptions (ArrayInfo): activities of one axis are rings,
// of two axes sheets, bumps are drawn on the populations whose axes they have, and all other arrays
// are shown generically. Positions on an axis are shares of its period, 0 at unit 0.
//
// Runs recorded by older versions have no descriptions. Their arrays are taken for activities when
// they have the shape of a ring or a sheet.
import type { FrameArray } from '../wire/messages';
import type { ArrayAxis, ArrayInfo } from '../wire/records';

export interface Bump {
  readonly label: string; // e.g. estimate
  readonly mean: readonly number[]; // position on each axis of the population, in [0, 1) if periodic
  readonly sigma: readonly number[]; // standard deviation on each axis; NaN: unknown
  readonly energy: number; // NaN: unknown
  readonly weight: number; // energy, or else precision, as a share of the greatest of the population
  readonly isHypothesis: boolean; // one of several bumps of its array
}

export interface Population {
  readonly info: ArrayInfo;
  readonly title: string;
  readonly shape: readonly number[]; // [units] or [rows, columns]
  readonly activity: Float32Array;
  readonly bumps: readonly Bump[];
}

/** An array that is shown without interpretation. */
export interface OtherArray {
  readonly info: ArrayInfo;
  readonly shape: readonly number[];
  readonly values: Float32Array;
}

export interface SortedArrays {
  readonly rings: readonly Population[];
  readonly sheets: readonly Population[];
  readonly others: readonly OtherArray[];
}

const kLeastRing = 12; // units; smaller arrays without description are not drawn as rings
const kLeastSheet = 4; // units along each axis

export function sortArrays(arrays: readonly FrameArray[], infos: readonly ArrayInfo[]): SortedArrays {
  const described = arrays
    .filter((array) => array.values.length > 0)
    .map((array) => ({ ...array, info: infoOf(array, infos) }));
  const activities = described.filter(({ info, shape }) =>
    info.kind === 'activity' && (shape.length === 1 || shape.length === 2) && info.axes.length === shape.length);
  const bumps = described.filter(({ info, shape }) => info.kind === 'bump' && componentsOf(info, shape).length > 0);
  const populations = activities.map((activity) => makePopulation(activity, bumps, activities));
  const shown = new Set<OtherArray>([...activities, ...bumps.filter((b) => activities.some((a) => isOn(b, a, activities)))]);
  return {
    rings: populations.filter((p) => p.shape.length === 1),
    sheets: populations.filter((p) => p.shape.length === 2),
    others: described.filter((array) => !shown.has(array)),
  };
}

function infoOf({ name, shape }: FrameArray, infos: readonly ArrayInfo[]): ArrayInfo {
  const info = infos.find((i) => i.name === name);
  if (info !== undefined) return info;
  const isOldRun = infos.length === 0;
  const isRing = isOldRun && shape.length === 1 && (shape[0] as number) >= kLeastRing;
  const isSheet = isOldRun && shape.length === 2 && shape.every((units) => units >= kLeastSheet);
  const axes = shape.map((units, i) => ({ name: `axis ${i}`, unit: '', period: units, first: 0, step: 1, labels: [] }));
  return { name, kind: isRing || isSheet ? 'activity' : 'values', unit: '', doc: '', population: '', axes };
}

/** Names of a bump's components; the last axis of the array has them as labels. */
function componentsOf(info: ArrayInfo, shape: readonly number[]): readonly string[] {
  const labels = info.axes[info.axes.length - 1]?.labels ?? [];
  const matches = (shape.length === 1 || shape.length === 2) && labels.length === shape[shape.length - 1];
  return matches ? labels : [];
}

/**
 * Bumps are drawn on the activity that their description names. If there is none of that name they
 * are drawn on every activity whose axes are among their components.
 */
function isOn({ info, shape }: OtherArray, activity: OtherArray, activities: readonly OtherArray[]): boolean {
  if (activities.some((a) => a.info.name === info.population)) return activity.info.name === info.population;
  const components = componentsOf(info, shape);
  return activity.info.axes.every((axis) => components.includes(axis.name));
}

function makePopulation(activity: OtherArray, bumps: readonly OtherArray[], activities: readonly OtherArray[]): Population {
  const { info, shape, values } = activity;
  const found = bumps.filter((b) => isOn(b, activity, activities)).flatMap((b) => readBumps(b, activity));
  return {
    info,
    title: info.name.replace(/\.activity$/, ''),
    shape,
    activity: values,
    bumps: withWeights(found),
  };
}

type UnweightedBump = Omit<Bump, 'weight'> & { readonly precision: number };

function readBumps({ info, shape, values }: OtherArray, activity: OtherArray): UnweightedBump[] {
  const components = componentsOf(info, shape);
  const label = info.name.slice(info.name.lastIndexOf('.') + 1);
  const axes = activity.info.axes.map((axis, i) => ({ axis, units: activity.shape[i] as number }));
  // The mean comes first, unless the labels name its components.
  const named = axes.map(({ axis }) => components.indexOf(axis.name));
  const meanIndices = named.includes(-1) ? axes.map((_, i) => i) : named;
  const bumps: UnweightedBump[] = [];
  for (let at = 0; at + components.length <= values.length; at += components.length) {
    const component = (...names: string[]) => {
      const index = components.findIndex((c) => names.includes(c));
      return index < 0 ? NaN : (values[at + index] as number);
    };
    const precision = (axis: ArrayAxis) =>
      component(`precision.${axis.name}`, ...(axis.unit === 'rad' ? ['concentration', 'precision'] : ['precision', 'concentration']));
    bumps.push({
      label,
      mean: axes.map(({ axis, units }, i) => shareOf(values[at + meanIndices[i]!] as number, axis, units)),
      sigma: axes.map(({ axis, units }) => 1 / Math.sqrt(precision(axis)) / extentOf(axis, units)),
      energy: component('energy'),
      precision: precision(activity.info.axes[0] as ArrayAxis),
      isHypothesis: shape.length === 2,
    });
  }
  return bumps;
}

/** Bumps whose energy, or else precision, is not positive are left out. */
function withWeights(bumps: readonly UnweightedBump[]): Bump[] {
  const sizeOf = (b: UnweightedBump) => (Number.isNaN(b.energy) ? b.precision : b.energy);
  const greatest = Math.max(...bumps.map(sizeOf).filter(Number.isFinite));
  return bumps
    .filter((b) => !(sizeOf(b) <= 0) && b.mean.every(Number.isFinite))
    .map((b) => ({ ...b, weight: greatest > 0 && Number.isFinite(sizeOf(b)) ? sizeOf(b) / greatest : 1 }));
}

/** Length of an axis in its own unit. */
export function extentOf({ period, step }: ArrayAxis, units: number): number {
  return period > 0 ? period : Math.abs(step) * units;
}

export function isPeriodic({ info }: Population): boolean {
  return info.axes.every((axis) => axis.period > 0);
}

function shareOf(mean: number, axis: ArrayAxis, units: number): number {
  const share = (mean - axis.first) / extentOf(axis, units);
  return axis.period > 0 ? share - Math.floor(share) : share;
}

/** The mean of a bump in the units of the population's axes. */
export function meanInUnits({ info, shape }: Population, { mean }: Bump): number[] {
  return mean.map((share, i) => {
    const axis = info.axes[i] as ArrayAxis;
    const value = axis.first + share * extentOf(axis, shape[i] as number);
    return axis.period > 0 ? value - axis.period * Math.floor(value / axis.period) : value;
  });
}
