// SPDX-License-Identifier: BSD-3-Clause
// The numbers that the page must show, read past the page: from the server's own answers, decoded
// here again, and from run.sqlite when TOLMAN_RUN names a run's folder.
import { execFileSync } from 'node:child_process';

const kReaders = {
  u8: (bytes, at, n) => Array.from({ length: n }, (_, i) => bytes.readUInt8(at + i)),
  i32: (bytes, at, n) => Array.from({ length: n }, (_, i) => bytes.readInt32LE(at + 4 * i)),
  f32: (bytes, at, n) => Array.from({ length: n }, (_, i) => bytes.readFloatLE(at + 4 * i)),
  f64: (bytes, at, n) => Array.from({ length: n }, (_, i) => bytes.readDoubleLE(at + 8 * i)),
};

async function get(url) {
  const answer = await fetch(url);
  if (!answer.ok) throw new Error(`${url}: ${answer.status}`);
  const bytes = Buffer.from(await answer.arrayBuffer());
  const length = bytes.readUInt32LE(0);
  const header = JSON.parse(bytes.subarray(4, 4 + length).toString('utf8'));
  const payload = Math.ceil((4 + length) / 8) * 8;
  const arrays = {};
  for (const { name, dtype, shape, offset } of header.arrays ?? []) {
    const count = shape.reduce((a, b) => a * b, 1);
    arrays[name] = { shape, values: kReaders[dtype](bytes, payload + offset, count) };
  }
  return { header, arrays };
}

export async function runInfo(url) {
  return (await fetch(`${url}/api/run`)).json();
}

/** All rows, as objects. */
export async function allRows(url) {
  const { columns } = await runInfo(url);
  const rows = [];
  for (;;) {
    const { header, arrays } = await get(`${url}/api/history?from=${rows.length}&count=10000`);
    const { shape, values } = arrays.rows;
    for (let r = 0; r < shape[0]; ++r) {
      rows.push(Object.fromEntries(columns.map(({ name }, c) => [name, values[r * shape[1] + c]])));
    }
    if (shape[0] === 0 || rows.length >= header.total) return rows;
  }
}

export async function graph(url) {
  const { header, arrays } = await get(`${url}/api/graph`);
  const rejected = arrays.link_rejected.values.filter((flag) => flag === 1).length;
  const loops = arrays.link_kind.values.filter((kind) => kind === 1).length - rejected;
  return {
    version: header.version,
    experiences: arrays.experience.shape[0],
    links: arrays.link.shape[0],
    loops,
    rejected,
  };
}

/** The arrays of a stored frame. */
export async function storedFrame(url, frame) {
  return get(`${url}/api/frame/${frame}`);
}

const kQuery = `
import json, sqlite3, sys
db = sqlite3.connect(f"file:{sys.argv[1]}/run.sqlite?mode=ro", uri=True)
db.row_factory = sqlite3.Row
f = int(sys.argv[2])
one = lambda table: dict(db.execute(f'select * from {table} where frame = ?', (f,)).fetchone() or {})
print(json.dumps({t: one(t) for t in ("motion", "place", "decision", "map_update")}, default=repr))
`;

/** What run.sqlite says of a frame; null when there is no run to compare with. */
export function recorded(frame) {
  const run = process.env.TOLMAN_RUN;
  if (!run) return null;
  return JSON.parse(execFileSync('python3', ['-c', kQuery, run, String(frame)], { encoding: 'utf8' }));
}
