// SPDX-License-Identifier: BSD-3-Clause
// A city of square blocks, seen by ray casting: grey images and exact depths for the fake run.
// Axes of the world: x right, z forward at the start. Streets run along multiples of 100 m.
import jpeg from 'jpeg-js';

export const kCamera = { width: 620, height: 188, fx: 360, fy: 360, cx: 310, cy: 94, baseline: 0.54 };
const kEye = 1.65; // m above the road
const kCell = 10; // m
const kBlock = 10; // cells
const kFar = 400; // m

function hash(a, b) {
  let h = Math.imul(a, 374761393) + Math.imul(b, 668265263);
  h = Math.imul(h ^ (h >>> 13), 1274126177);
  return ((h ^ (h >>> 16)) >>> 0) / 4294967296;
}

function isStreet(cx, cz) {
  const mod = (n) => ((n % kBlock) + kBlock) % kBlock;
  return mod(cx) === 0 || mod(cz) === 0;
}

/** The first wall along a ray: distance, what wall it is, and where along it. */
function cast(x, z, dx, dz) {
  let cx = Math.floor((x + kCell / 2) / kCell);
  let cz = Math.floor((z + kCell / 2) / kCell);
  const next = (p, c, d) => (d > 0 ? (c + 0.5) * kCell - p : p - (c - 0.5) * kCell) / Math.abs(d);
  let tx = dx === 0 ? Infinity : next(x, cx, dx);
  let tz = dz === 0 ? Infinity : next(z, cz, dz);
  for (;;) {
    const alongX = tx < tz;
    const t = alongX ? tx : tz;
    if (t > kFar) return null;
    if (alongX) {
      cx += Math.sign(dx);
      tx += kCell / Math.abs(dx);
    } else {
      cz += Math.sign(dz);
      tz += kCell / Math.abs(dz);
    }
    if (isStreet(cx, cz)) continue;
    const along = alongX ? z + t * dz : x + t * dx;
    return { t, along, lit: alongX ? 0.82 : 1, tone: hash(cx, cz), height: 7 + 11 * hash(cz, cx + 7) };
  }
}

function wallTone({ along, lit, tone }, up, height) {
  const window = up > 1 && up < height - 0.8 && (along / 2.4 - Math.floor(along / 2.4)) > 0.45 &&
    (up / 3 - Math.floor(up / 3)) > 0.4;
  const brick = 10 * hash(Math.floor(along * 3), Math.floor(up * 5));
  return lit * (window ? 52 + 60 * tone : 118 + 80 * tone) + brick;
}

function groundTone(x, z) {
  const mod = (v) => ((v + 5) % 100 + 100) % 100 - 5;
  const [mx, mz] = [mod(x), mod(z)];
  const off = Math.min(Math.abs(mx), Math.abs(mz)); // from the nearest centre line
  const along = Math.abs(mx) < Math.abs(mz) ? z : x;
  if (off < 0.12 && (along / 6 - Math.floor(along / 6)) < 0.5) return 205;
  if (off > 3.4) return 128 + 14 * hash(Math.floor(x), Math.floor(z));
  return 84 + 10 * hash(Math.floor(x * 2), Math.floor(z * 2));
}

/** Tone and distance of a pixel, given the wall of its column. */
function look(pose, column, v) {
  const { height, fy, cy } = kCamera;
  const slope = (cy - v) / fy; // up per metre forward
  const { hit, forward, dx, dz } = column;
  const z = hit ? hit.t * forward : Infinity;
  if (slope * z < -kEye || (!hit && slope < 0)) {
    const ground = -kEye / slope;
    const range = ground / forward;
    return { tone: groundTone(pose.x + range * dx, pose.z + range * dz), depth: ground };
  }
  if (hit && kEye + slope * z < hit.height) {
    const haze = Math.min(1, z / 260);
    const tone = wallTone(hit, kEye + slope * z, hit.height);
    return { tone: tone + haze * (190 - tone), depth: z };
  }
  return { tone: 232 - (50 * (cy - v)) / height, depth: Infinity };
}

/** Heading 0 looks along z, positive to the left. */
function columnAt(pose, u) {
  const side = (u - kCamera.cx) / kCamera.fx;
  const length = Math.hypot(side, 1);
  const [c, s] = [Math.cos(pose.heading), Math.sin(pose.heading)];
  const dx = (side * c - s) / length;
  const dz = (side * s + c) / length;
  return { hit: cast(pose.x, pose.z, dx, dz), forward: 1 / length, dx, dz };
}

export function picture(pose, scale = 1) {
  const width = Math.round(kCamera.width * scale);
  const height = Math.round(kCamera.height * scale);
  const data = Buffer.alloc(width * height * 4, 255);
  for (let i = 0; i < width; ++i) {
    const column = columnAt(pose, (i + 0.5) / scale);
    for (let j = 0; j < height; ++j) {
      const { tone } = look(pose, column, (j + 0.5) / scale);
      const at = (j * width + i) * 4;
      data[at] = data[at + 1] = data[at + 2] = Math.max(0, Math.min(255, tone));
    }
  }
  return jpeg.encode({ data, width, height }, 80).data;
}

/** u, v, inverse depth, variance of points at edges, as a sparse odometry would choose them. */
export function points(pose, most = 900) {
  const found = [];
  for (let u = 4; u < kCamera.width - 4; u += 5) {
    const column = columnAt(pose, u);
    let before = look(pose, column, 2).tone;
    for (let v = 4; v < kCamera.height - 2; v += 2) {
      const { tone, depth } = look(pose, column, v);
      const edge = Math.abs(tone - before) > 14;
      before = tone;
      if (edge && depth < 150 && hash(u, v) < 0.8) found.push(u, v, 1 / depth, 1e-4);
    }
  }
  const step = Math.max(1, Math.ceil(found.length / 4 / most));
  const kept = [];
  for (let i = 0; i < found.length / 4; i += step) kept.push(...found.slice(4 * i, 4 * i + 4));
  return Float32Array.from(kept);
}
