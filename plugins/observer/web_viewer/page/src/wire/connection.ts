// SPDX-License-Identifier: BSD-3-Clause
// The WebSocket to the server. Reconnects after a failure, with a wait that doubles each time.
import { parseContainer, type Container } from './container';

export type LinkState = 'connecting' | 'open' | 'waiting' | 'ended';

export interface ConnectionListener {
  message(message: Container): void;
  state(state: LinkState, retryInSeconds: number): void;
}

const kFirstWait = 0.5; // s
const kLongestWait = 10;

export function nextWait(wait: number): number {
  return Math.min(kLongestWait, wait * 2);
}

export class Connection {
  private socket: WebSocket | null = null;
  private wait = kFirstWait;
  private live = true;
  private ended = false;

  constructor(
    private readonly address: string,
    private readonly listener: ConnectionListener,
  ) {}

  open(): void {
    this.ended = false;
    this.listener.state('connecting', 0);
    const socket = new WebSocket(this.address);
    socket.binaryType = 'arraybuffer';
    this.socket = socket;
    socket.onopen = () => {
      if (!this.live) this.say();
      this.listener.state('open', 0);
    };
    socket.onmessage = (event: MessageEvent<unknown>) => this.receive(event.data);
    socket.onclose = () => this.closed();
  }

  /** With `live` false the server sends rows, events and graphs only: no images and arrays. */
  setFlow(live: boolean): void {
    if (this.live === live) return;
    this.live = live;
    this.say();
  }

  private say(): void {
    if (this.socket?.readyState === WebSocket.OPEN) {
      this.socket.send(JSON.stringify({ type: 'flow', live: this.live }));
    }
  }

  private receive(data: unknown): void {
    if (!(data instanceof ArrayBuffer)) return;
    const message = parseContainer(data);
    if (message.type === 'hello') this.wait = kFirstWait;
    if (message.type === 'end') this.ended = true;
    this.listener.message(message);
  }

  private closed(): void {
    this.socket = null;
    if (this.ended) {
      this.listener.state('ended', 0);
      return;
    }
    const wait = this.wait;
    this.wait = nextWait(wait);
    this.listener.state('waiting', wait);
    setTimeout(() => this.open(), wait * 1000);
  }
}
