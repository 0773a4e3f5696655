// SPDX-License-Identifier: BSD-3-Clause
// A synthetic run through the city: rows, graph and cells of every frame. The same numbers each time.
import { readFileSync } from 'node:fs';

const kRecords = readFileSync(
  new URL('../../../../../plugins/observer/web_viewer/page/src/wire/records.ts', import.meta.url), 'utf8');

/** Names of the columns of a row, from the page's generated declarations. */
export const kColumns = Array.from(
  kRecords.match(/kColumns = \[([^\]]*)\]/)[1].matchAll(/^ *'([^']*)',/gm), (match) => match[1]);

const kCorners = [
  [0, 0], [0, 3], [2, 3], [2, 1], [-1, 1], [-1, 4], [1, 4], [1, 2], [3, 2], [3, 5], [0, 5], [0, 3],
  [2, 3], [2, 1], [-1, 1], [-1, -1], [2, -1], [2, 0], [0, 0],
];
const kStep = 0.8; // m a frame, at 10 Hz
const kSmoothing = 7; // m

function noise(i, k) {
  const s = Math.sin(i * 12.9898 + k * 78.233) * 43758.5453;
  return s - Math.floor(s) - 0.5;
}

function onRoute(s) {
  for (let i = 0, rest = s; ; ++i) {
    const last = kCorners.length - 1;
    const [ax, az] = kCorners[i % last];
    const [bx, bz] = kCorners[(i % last) + 1];
    const length = 100 * Math.hypot(bx - ax, bz - az);
    if (rest <= length) {
      const t = rest / length;
      return [100 * (ax + t * (bx - ax)), 100 * (az + t * (bz - az))];
    }
    rest -= length;
  }
}

/** On the streets, with the corners cut. */
function truth(frame) {
  let [x, z] = [0, 0];
  const half = 6;
  for (let k = -half; k <= half; ++k) {
    const [px, pz] = onRoute(Math.max(0, frame * kStep + (k * kSmoothing) / half));
    x += px / (2 * half + 1);
    z += pz / (2 * half + 1);
  }
  return [x, z];
}

function poses(frames) {
  const list = [];
  const [startX, startZ] = truth(0);
  for (let f = 0; f < frames; ++f) {
    const [x, z] = truth(f);
    const [nx, nz] = truth(f + 1);
    list.push({ x: x - startX, z: z - startZ, y: -1.5 * Math.sin(x / 140) * Math.cos(z / 190),
                heading: Math.atan2(-(nx - x), nz - z) });
  }
  for (const p of list) p.y -= list[0].y;
  return list.map((p) => ({ ...p, startX, startZ }));
}

/** Dead reckoning that pulls to one side. */
function odometry(path) {
  const list = [{ x: 0, z: 0, y: 0 }];
  for (let f = 1; f < path.length; ++f) {
    const bias = 5.5e-5 * f + 0.01 * Math.sin(f / 400);
    const [dx, dz] = [path[f].x - path[f - 1].x, path[f].z - path[f - 1].z];
    const [c, s] = [1.004 * Math.cos(bias), 1.004 * Math.sin(bias)];
    const before = list[f - 1];
    list.push({ x: before.x + c * dx - s * dz, z: before.z + s * dx + c * dz, y: path[f].y * 1.2 + f * 4e-4 });
  }
  return list;
}

/** Earlier things near a place, by squares of 10 m. */
class Nearby {
  constructor() {
    this.squares = new Map();
  }
  add(id, frame, pose) {
    const key = `${Math.round(pose.x / 10)} ${Math.round(pose.z / 10)}`;
    if (!this.squares.has(key)) this.squares.set(key, []);
    this.squares.get(key).push({ id, frame, pose });
  }
  find(pose, before) {
    let best = null;
    for (let i = -1; i <= 1; ++i) {
      for (let j = -1; j <= 1; ++j) {
        const key = `${Math.round(pose.x / 10) + i} ${Math.round(pose.z / 10) + j}`;
        for (const one of this.squares.get(key) ?? []) {
          const off = Math.hypot(one.pose.x - pose.x, one.pose.z - pose.z);
          const turned = Math.cos(one.pose.heading - pose.heading) < 0.9;
          if (one.frame > before || off > 4 || turned) continue;
          if (best === null || off < best.off) best = { ...one, off };
        }
      }
    }
    return best;
  }
}

export class FakeRun {
  /** `scale`: units of the estimate in a metre, as of a single camera; 1 is a stereo pair. */
  constructor({ frames = 4541, spacing = 5, scale = 1 } = {}) {
    this.frames = frames;
    this.scale = scale;
    this.path = poses(frames);
    this.odometry = odometry(this.path);
    this.rows = new Float64Array(frames * kColumns.length);
    this.experiences = []; // { frame, template }
    this.links = []; // { from, to, loop }
    this.templates = []; // frame of each
    this.events = [];
    this.make(spacing);
  }

  row(frame) {
    const n = kColumns.length;
    return this.rows.subarray(frame * n, (frame + 1) * n);
  }
  value(frame, name) {
    return this.row(frame)[kColumns.indexOf(name)];
  }

  make(spacing) {
    const seen = { views: new Nearby(), places: new Nearby() };
    const state = { loops: 0, version: 0, current: -1, moved: Infinity, viewed: Infinity, closed: Infinity };
    for (let f = 0; f < this.frames; ++f) {
      const lost = f % 1900 >= 1400 && f % 1900 < 1412;
      const place = this.recognise(f, seen.views, state, lost);
      const action = this.decide(f, seen.places, state, spacing, place);
      this.write(f, lost, place, action, state);
    }
  }

  recognise(f, views, state, lost) {
    state.viewed += kStep;
    if (lost || f % 2 === 1) return { recognition: 0, template: -1, score: NaN };
    const known = views.find(this.path[f], f - 300);
    if (known) return { recognition: 2, template: known.id, score: 0.02 + known.off * 0.03 + 0.01 * noise(f, 1) };
    if (state.viewed < 3) {
      return { recognition: 2, template: this.templates.length - 1, score: 0.05 + 0.02 * state.viewed };
    }
    state.viewed = 0;
    this.templates.push(f);
    views.add(this.templates.length - 1, f, this.path[f]);
    return { recognition: 1, template: this.templates.length - 1, score: 0.4 + 0.2 * noise(f, 2) };
  }

  decide(f, places, state, spacing, place) {
    state.moved += kStep;
    state.closed += kStep;
    const known = places.find(this.path[f], f - 300);
    if (known) {
      if (place.recognition !== 2 || state.closed < 8) return 0;
      this.links.push({ from: state.current, to: known.id, loop: true, frame: f, rejected: state.loops % 4 === 3 });
      [state.current, state.closed, state.moved] = [known.id, 0, 0];
      ++state.loops;
      ++state.version;
      return 2;
    }
    if (state.moved < spacing) return 0;
    const id = this.experiences.length;
    this.experiences.push({ frame: f, template: place.template });
    places.add(id, f, this.path[f]);
    if (id > 0) this.links.push({ from: state.current, to: id, loop: false });
    [state.current, state.moved] = [id, 0];
    return 1;
  }

  /** Odometry until the first loop, then near the truth. */
  mapped(f, loops) {
    const share = loops === 0 ? 1 : 0.06;
    const [t, o] = [this.path[f], this.odometry[f]];
    return this.scaled({ x: t.x + share * (o.x - t.x), y: t.y + share * (o.y - t.y), z: t.z + share * (o.z - t.z) });
  }

  scaled({ x, y, z }) {
    return { x: this.scale * x, y: this.scale * y, z: this.scale * z };
  }

  write(f, lost, place, action, state) {
    const [t, o, m] = [this.path[f], this.scaled(this.odometry[f]), this.mapped(f, state.loops)];
    const before = this.path[Math.max(0, f - 1)];
    const turn = Math.atan2(Math.sin(t.heading - before.heading), Math.cos(t.heading - before.heading));
    const heading = ((t.heading + 0.02 * noise(f, 3)) % (2 * Math.PI) + 2 * Math.PI) % (2 * Math.PI);
    const times = [3.1 + noise(f, 4), 24 + 9 * noise(f, 5) + (f % 5 === 0 ? 18 : 0), 2.2 + noise(f, 6),
                   0.06 + 0.04 * noise(f, 7), 0.05 + state.loops * 0.01 + (action === 2 ? 6 + state.loops * 0.05 : 0)];
    const values = {
      'frame.frame': f, 'frame.time': f * 0.1, 'motion.state': f === 0 ? 0 : lost ? 2 : 1,
      'motion.scale_known': this.scale === 1 ? 1 : 0, 'motion.v': f === 0 ? 0 : 8 + 0.4 * noise(f, 8), 'motion.omega': turn * 10,
      'motion.tracked': lost ? 12 : 1500 + Math.round(300 * noise(f, 9)), 'motion.is_keyframe': f % 5 === 0 ? 1 : 0,
      'odometry.x': o.x, 'odometry.y': o.y, 'odometry.z': o.z, 'map.x': m.x, 'map.y': m.y, 'map.z': m.z,
      'truth.x': t.x, 'truth.y': t.y, 'truth.z': t.z, 'place.recognition': place.recognition,
      'place.template_id': place.template, 'place.score': place.score, 'decision.action': action,
      'decision.experience': state.current, 'decision.heading': heading,
      'decision.confidence': action === 2 ? 0.8 : 1, 'map_update.experiences': this.experiences.length,
      'map_update.links': this.links.length, 'map_update.loops': state.loops, 'map_update.version': state.version,
      'duration.source': times[0], 'duration.odometry': times[1], 'duration.place': times[2],
      'duration.cells': times[3], 'duration.map': times[4],
    };
    this.rows.set(kColumns.map((name) => values[name] ?? NaN), f * kColumns.length);
    if (lost && f % 1900 === 1400) {
      this.events.push({ frame: f, level: 'warning', source: 'odometry/fake', message: 'too few points: 12' });
    }
  }

  /** The graph as it stands after `frame`. */
  graph(frame) {
    const n = this.value(frame, 'map_update.experiences');
    const m = this.value(frame, 'map_update.links');
    const loops = this.value(frame, 'map_update.loops');
    const experience = new Float32Array(4 * n);
    this.experiences.slice(0, n).forEach((e, i) => {
      const p = this.mapped(e.frame, loops);
      experience.set([p.x, p.y, p.z, this.path[e.frame].heading], 4 * i);
    });
    const links = this.links.slice(0, m);
    const numbers = [...links.keys()].filter((i) => links[i].loop);
    const ends = numbers.map((i) => [i, links[i].frame, ...[links[i].from, links[i].to].map((e) => this.experiences[e].frame)]);
    return {
      header: { type: 'graph', version: this.value(frame, 'map_update.version'), frame },
      arrays: {
        experience: { shape: [n, 4], values: experience },
        link: { shape: [m, 2], values: Int32Array.from(links.flatMap((l) => [l.from, l.to])) },
        link_kind: Uint8Array.from(links, (l) => (l.loop ? 1 : 0)),
        link_rejected: Uint8Array.from(links, (l) => (l.rejected ? 1 : 0)),
        loop: { shape: [ends.length, 4], values: Int32Array.from(ends.flat()) },
        loop_residual: Float32Array.from(ends, (_, i) => i / 4),
      },
    };
  }
}
