// SPDX-License-Identifier: BSD-3-Clause
// Requests over HTTP.
import { parseContainer, type Container } from './container';
import { headerOf, readFrame, readGraph, readRows } from './messages';
import type { HistoryHeader } from './records';
import type { FrameMessage, GraphMessage, RowBlock } from './messages';

export const kHistoryLimit = 10000; // rows in one answer

async function get(path: string): Promise<Container | null> {
  const answer = await fetch(path, { cache: 'no-store' });
  if (answer.status === 404) return null;
  if (!answer.ok) throw new Error(`${path}: ${answer.status}`);
  return parseContainer(await answer.arrayBuffer());
}

export async function fetchHistory(from: number, count: number): Promise<RowBlock | null> {
  const asked = Math.min(count, kHistoryLimit);
  const message = await get(`/api/history?from=${from}&count=${asked}`);
  return message && readRows(message, headerOf<HistoryHeader>(message).from);
}

export async function fetchFrame(frame: number): Promise<FrameMessage | null> {
  const message = await get(`/api/frame/${frame}`);
  return message && readFrame(message);
}

export async function fetchGraph(): Promise<GraphMessage | null> {
  const message = await get('/api/graph');
  return message && readGraph(message);
}

export function templateAddress(template: number): string {
  return `/api/template/${template}`;
}
