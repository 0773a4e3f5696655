// SPDX-License-Identifier: BSD-3-Clause
// Serves the fake run: node fake/main.mjs [port] [frames a second] [rows at the start]
import { FakeServer } from './server.mjs';

const [port = 8080, rate = 15, start = 1200] = process.argv.slice(2).map(Number);
const server = await new FakeServer({ start }).listen(port);
if (rate > 0) server.play(rate);
console.log(`fake viewer at ${server.url}, ${rate} frames/s from frame ${start}`);
