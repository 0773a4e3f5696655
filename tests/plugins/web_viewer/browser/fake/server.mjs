// SPDX-License-Identifier: BSD-3-Clause
// A server that speaks the viewer's protocol over the fake run, and serves the built page.
import { createServer } from 'node:http';
import { readFile } from 'node:fs/promises';
import { extname, join, normalize } from 'node:path';
import { fileURLToPath } from 'node:url';
import { WebSocketServer } from 'ws';
import { cells, kArrays } from './cells.mjs';
import { kCamera, picture, points } from './city.mjs';
import { kColumns, FakeRun } from './run.mjs';
import { container } from './wire.mjs';

const kPage = fileURLToPath(
  new URL('../../../../../plugins/observer/web_viewer/page/dist/', import.meta.url),
);
const kTypes = { '.html': 'text/html; charset=utf-8', '.js': 'text/javascript', '.css': 'text/css' };
const kPolicy = "default-src 'self'; img-src 'self' blob: data:; style-src 'self' 'unsafe-inline'";
const kMaxRows = 2000;

export class FakeServer {
  /** `start`: rows that are there already; `images`: false for a run without camera; `recorded`: the
   *  run is over, and its record is still read. */
  constructor({ start = 200, images = true, recorded = false, name = 'fake-city', ...run } = {}) {
    this.run = new FakeRun(run);
    this.rows = Math.min(start, this.run.frames);
    this.images = images;
    this.recorded = recorded;
    this.name = name;
    this.ended = false;
    this.clients = new Map(); // socket -> { sent, events, flow, dropped }
    this.requests = [];
    this.thumbnails = new Map();
  }

  async listen(port = 0) {
    this.http = createServer((request, answer) => void this.serve(request, answer));
    this.sockets = new WebSocketServer({ server: this.http, path: '/live' });
    this.sockets.on('connection', (socket) => this.greet(socket));
    await new Promise((resolve) => this.http.listen(port, '127.0.0.1', resolve));
    this.port = this.http.address().port;
    this.url = `http://127.0.0.1:${this.port}`;
    return this;
  }

  async close() {
    this.pause();
    this.drop();
    this.sockets.close();
    this.http.closeAllConnections?.();
    await new Promise((resolve) => this.http.close(resolve));
  }

  /** Breaks every connection, as a network would. */
  drop() {
    for (const socket of this.clients.keys()) socket.terminate();
    this.clients.clear();
  }

  /** Frames at a rate, until the end or pause(). */
  play(rate) {
    this.pause();
    const started = Date.now();
    const first = this.rows;
    this.timer = setInterval(() => {
      const due = first + Math.floor(((Date.now() - started) / 1000) * rate);
      if (due > this.rows) this.advance(due - this.rows);
      if (this.rows >= this.run.frames) this.finish();
    }, 1000 / Math.min(rate, 30));
  }
  pause() {
    clearInterval(this.timer);
  }

  advance(count = 1) {
    const before = this.rows;
    this.rows = Math.min(this.run.frames, this.rows + count);
    if (this.rows === before) return;
    const everySecond = Math.floor(before / 3) !== Math.floor(this.rows / 3);
    for (const [socket, client] of this.clients) {
      socket.send(this.frameMessage(client));
      if (everySecond) this.sendGraph(socket);
    }
  }

  finish(state = 'finished') {
    this.pause();
    this.ended = true;
    for (const socket of this.clients.keys()) {
      this.sendGraph(socket);
      socket.send(container({ type: 'end', state, frames: this.rows }));
      if (!this.recorded) socket.close(1000); // a recorded run is served until somebody stops that
    }
  }

  info() {
    return {
      run: {
        name: this.name,
        directory: `/runs/${this.name}`,
        source: {
          description: 'a synthetic drive through a city of blocks',
          rig: this.images ? kCamera : { width: 0, height: 0, baseline: 0 },
          frames: this.run.frames,
          has_truth: true,
        },
        arrays: kArrays,
      },
      live: !this.ended,
      recorded: this.recorded,
      rows: this.rows,
      columns: kColumns.map((name) => ({ name, unit: '', doc: '' })),
    };
  }

  greet(socket) {
    const client = { sent: this.rows, events: this.pastEvents(this.rows).length, flow: true, dropped: 0 };
    this.clients.set(socket, client);
    socket.on('close', () => this.clients.delete(socket));
    socket.on('message', (data) => {
      client.flow = JSON.parse(data.toString()).live;
    });
    socket.send(container({ type: 'hello', ...this.info() }));
    this.sendGraph(socket);
    if (this.ended) this.finish();
  }

  sendGraph(socket) {
    if (this.rows === 0) return;
    const { header, arrays } = this.run.graph(this.rows - 1);
    socket.send(container(header, arrays));
  }

  pastEvents(rows) {
    return this.run.events.filter((e) => e.frame < rows);
  }

  frameMessage(client) {
    const n = kColumns.length;
    const to = Math.min(this.rows, client.sent + kMaxRows);
    const rows = this.run.rows.slice(client.sent * n, to * n);
    const events = this.pastEvents(this.rows).slice(client.events);
    const extra = { rows_from: client.sent, dropped: client.dropped, events };
    const arrays = { rows: { shape: [to - client.sent, n], values: rows } };
    client.events += events.length;
    client.sent = to;
    return this.frameContainer(this.rows - 1, extra, arrays, client.flow);
  }

  frameContainer(frame, extra, arrays, flow) {
    const value = (name) => this.run.value(frame, name);
    const header = { type: 'frame', frame, points_frame: frame, rows_from: 0, dropped: 0, ...extra };
    if (!flow) return container(header, arrays);
    const pose = this.pose(frame);
    const neural = cells(this.run.mapped(frame, value('map_update.loops')), value('decision.heading'),
                         value('place.recognition') === 2 && value('decision.action') === 2, value('map_update.loops'));
    if (!this.images) return container(header, { ...arrays, ...neural });
    const dots = points(pose);
    return container(header, {
      ...arrays,
      image: Uint8Array.from(picture(pose)),
      points: { shape: [dots.length / 4, 4], values: dots },
      ...neural,
    });
  }

  pose(frame) {
    const { x, z, heading, startX, startZ } = this.run.path[frame];
    return { x: x + startX, z: z + startZ, heading };
  }

  async serve(request, answer) {
    const url = new URL(request.url, 'http://localhost');
    this.requests.push(url.pathname + url.search);
    const api = url.pathname.match(/^\/api\/(\w+)(?:\/(\d+))?$/);
    if (api) this.serveApi(api[1], Number(api[2]), url.searchParams, answer);
    else await this.servePage(url.pathname, answer);
  }

  serveApi(kind, number, query, answer) {
    const send = (type, body) => {
      answer.writeHead(200, { 'content-type': type, 'cache-control': 'no-store' });
      answer.end(body);
    };
    const binary = 'application/octet-stream';
    if (kind === 'run') return send('application/json', JSON.stringify(this.info()));
    if (kind === 'history') return send(binary, this.history(query));
    if (kind === 'graph' && this.rows > 0) {
      const { header, arrays } = this.run.graph(this.rows - 1);
      return send(binary, container(header, arrays));
    }
    if (kind === 'frame' && this.rows > 0) {
      const frame = Math.min(number, this.rows - 1);
      return send(binary, this.frameContainer(frame, { events: [] }, {}, true));
    }
    if (kind === 'template' && this.run.templates[number] !== undefined && this.images) {
      return send('image/jpeg', this.thumbnail(number));
    }
    answer.writeHead(404);
    return answer.end();
  }

  thumbnail(template) {
    if (!this.thumbnails.has(template)) {
      this.thumbnails.set(template, picture(this.pose(this.run.templates[template]), 0.4));
    }
    return this.thumbnails.get(template);
  }

  history(query) {
    const n = kColumns.length;
    const from = Math.min(Number(query.get('from') ?? 0), this.rows);
    const to = Math.min(this.rows, from + Math.min(10000, Number(query.get('count') ?? 10000)));
    const rows = { shape: [to - from, n], values: this.run.rows.slice(from * n, to * n) };
    return container({ type: 'history', from, total: this.rows }, { rows });
  }

  async servePage(path, answer) {
    const file = normalize(path === '/' ? 'index.html' : path.slice(1));
    try {
      if (file.startsWith('..')) throw new Error('outside');
      const body = await readFile(join(kPage, file));
      answer.writeHead(200, {
        'content-type': kTypes[extname(file)] ?? 'application/octet-stream',
        'content-security-policy': kPolicy,
        'x-content-type-options': 'nosniff',
      });
      answer.end(body);
    } catch {
      answer.writeHead(404);
      answer.end();
    }
  }
}
