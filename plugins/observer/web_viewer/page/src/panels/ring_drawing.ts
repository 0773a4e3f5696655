// SPDX-License-Identifier: BSD-3-Clause
// A ring of cells: phase 0 up (ahead), phases grow to the left. Activity as colour; bumps as arcs
// inside it (mean and one standard deviation); the estimate as a pointer.
import { css, viridis } from '../look/colour_map';
import type { Surface } from '../look/dom';
import type { Bump, Population } from '../model/populations';
import { bumpColour } from './bump_colours';
import type { Colours } from '../look/theme';

const kTurn = 2 * Math.PI;
const kTrack = 5; // px between the arcs of two labels

export function drawRing(surface: Surface, ring: Population, colours: Colours): void {
  const context = surface.clear();
  const middle = Math.min(surface.width, surface.height) / 2;
  context.translate(surface.width / 2, surface.height / 2);
  // Canvas angles grow clockwise from the right; headings anticlockwise from the top.
  context.rotate(-Math.PI / 2);
  context.scale(1, -1);
  const outer = middle - 23;
  const inner = outer * 0.62;
  drawCells(context, ring, inner, outer);
  const labels = [...new Set(ring.bumps.map((b) => b.label))].filter((label) => label !== 'estimate');
  for (const bump of ring.bumps) {
    if (bump.label === 'estimate') drawPointer(context, angleOf(ring, bump), inner - 16, colours);
    else drawArc(context, ring, bump, inner - kTrack * (1 + labels.indexOf(bump.label)), colours);
  }
  if (ring.info.axes[0]?.unit === 'rad') labelDirections(surface, middle, colours);
}

/** Angle of a bump's mean; `first` is the phase of unit 0. */
function angleOf(ring: Population, bump: Bump): number {
  return firstAngle(ring) + kTurn * (bump.mean[0] ?? 0);
}

function firstAngle({ info }: Population): number {
  const axis = info.axes[0];
  return axis && axis.period > 0 ? (kTurn * axis.first) / axis.period : 0;
}

function drawCells(
  context: CanvasRenderingContext2D,
  ring: Population,
  inner: number,
  outer: number,
): void {
  const { activity } = ring;
  const greatest = activity.reduce((a, b) => Math.max(a, b), 1e-9);
  const half = (0.46 * kTurn) / activity.length;
  for (let i = 0; i < activity.length; ++i) {
    const angle = firstAngle(ring) + (i * kTurn) / activity.length;
    context.beginPath();
    context.arc(0, 0, outer, angle - half, angle + half);
    context.arc(0, 0, inner, angle + half, angle - half, true);
    context.closePath();
    context.fillStyle = css(viridis((activity[i] as number) / greatest));
    context.fill();
  }
}

/** One standard deviation on each side of the mean, and a dot at the mean of a hypothesis. */
function drawArc(
  context: CanvasRenderingContext2D,
  ring: Population,
  bump: Bump,
  radius: number,
  colours: Colours,
): void {
  const mean = angleOf(ring, bump);
  const sigma = Math.min(Math.PI, kTurn * (bump.sigma[0] || 0));
  context.strokeStyle = context.fillStyle = bumpColour(bump.label, colours);
  context.globalAlpha = 0.35 + 0.65 * bump.weight;
  context.lineWidth = bump.isHypothesis ? 2 : 3.5;
  context.lineCap = 'round';
  context.beginPath();
  context.arc(0, 0, radius, mean - sigma, mean + sigma);
  context.stroke();
  if (bump.isHypothesis) {
    context.beginPath();
    context.arc(radius * Math.cos(mean), radius * Math.sin(mean), 2 + 4 * bump.weight, 0, kTurn);
    context.fill();
  }
  context.globalAlpha = 1;
}

function drawPointer(
  context: CanvasRenderingContext2D, angle: number, tip: number, colours: Colours,
): void {
  const [c, s] = [Math.cos(angle), Math.sin(angle)];
  context.fillStyle = colours.ink;
  context.beginPath();
  context.moveTo(tip * c, tip * s);
  context.lineTo(-0.16 * tip * c - 0.2 * tip * s, -0.16 * tip * s + 0.2 * tip * c);
  context.lineTo(-0.16 * tip * c + 0.2 * tip * s, -0.16 * tip * s - 0.2 * tip * c);
  context.closePath();
  context.fill();
}

function labelDirections(surface: Surface, middle: number, colours: Colours): void {
  const { context } = surface;
  const scale = window.devicePixelRatio;
  context.setTransform(scale, 0, 0, scale, 0, 0);
  context.translate(surface.width / 2, surface.height / 2);
  context.fillStyle = colours.soft;
  context.font = '10px system-ui, sans-serif';
  context.textAlign = 'center';
  context.textBaseline = 'middle';
  const r = middle - 11;
  context.fillText('0°', 0, -r);
  context.fillText('90°', -r, 0);
  context.fillText('180°', 0, r);
  context.fillText('270°', r, 0);
}
