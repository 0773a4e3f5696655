// SPDX-License-Identifier: BSD-3-Clause
// A ring of head direction cells: unit 0 ahead (up), headings growing to the left. Activity as
// colour; bumps as arcs inside it (mean and one standard deviation); the estimate as a hand.
import { css, viridis } from '../look/colour_map';
import type { Surface } from '../look/dom';
import type { Population } from '../model/cell_modules';
import { bumpColours } from './bump_look';
import type { Colours } from '../look/theme';

const kTurn = 2 * Math.PI;
const kTracks = { integrator: 0, calibration: 1, injected: 2 } as const;

export function drawRing(surface: Surface, ring: Population, colours: Colours): void {
  const context = surface.clear();
  const middle = Math.min(surface.width, surface.height) / 2;
  context.translate(surface.width / 2, surface.height / 2);
  // Canvas angles grow clockwise from the right; headings anticlockwise from the top.
  context.rotate(-Math.PI / 2);
  context.scale(1, -1);
  const outer = middle - 23;
  const inner = outer * 0.62;
  drawCells(context, ring.activity, inner, outer);
  drawTracks(context, ring, inner - 5, colours);
  drawHand(context, ring, inner - 16, colours);
  labelDirections(surface, middle, colours);
}

function drawCells(
  context: CanvasRenderingContext2D,
  activity: Float32Array,
  inner: number,
  outer: number,
): void {
  const most = activity.reduce((a, b) => Math.max(a, b), 1e-9);
  const half = (0.46 * kTurn) / activity.length;
  for (let i = 0; i < activity.length; ++i) {
    const angle = (i * kTurn) / activity.length;
    context.beginPath();
    context.arc(0, 0, outer, angle - half, angle + half);
    context.arc(0, 0, inner, angle + half, angle - half, true);
    context.closePath();
    context.fillStyle = css(viridis((activity[i] as number) / most));
    context.fill();
  }
}

/** Concentric tracks; weight of the line tells the share of the energy. */
function drawTracks(
  context: CanvasRenderingContext2D,
  ring: Population,
  radius: number,
  colours: Colours,
): void {
  const total = ring.bumps.reduce((sum, b) => (b.kind === 'estimate' ? Math.max(sum, b.precision) : sum), 0);
  const look = bumpColours(colours);
  for (const bump of ring.bumps) {
    if (bump.kind === 'estimate' || !(bump.precision > 0)) continue;
    const track = radius - 5 * kTracks[bump.kind];
    const mean = bump.mean[0] ?? NaN;
    const sigma = Math.min(Math.PI, 1 / Math.sqrt(bump.precision));
    const share = total > 0 ? Math.min(1, bump.precision / total) : 1;
    context.beginPath();
    context.arc(0, 0, track, mean - sigma, mean + sigma);
    context.strokeStyle = look[bump.kind];
    context.globalAlpha = 0.35 + 0.65 * share;
    context.lineWidth = 3.5;
    context.lineCap = 'round';
    context.stroke();
    context.globalAlpha = 1;
  }
}

function drawHand(
  context: CanvasRenderingContext2D,
  ring: Population,
  tip: number,
  colours: Colours,
): void {
  const estimate = ring.bumps.find((b) => b.kind === 'estimate');
  if (estimate === undefined) return;
  const units = ring.inUnits ? kTurn / ring.activity.length : 1;
  const angle = (estimate.mean[0] ?? 0) * units;
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
