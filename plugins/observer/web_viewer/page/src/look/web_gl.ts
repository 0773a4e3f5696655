// SPDX-License-Identifier: BSD-3-Clause
// Kind of WebGL that the browser has.

export type WebGl = 'none' | 'software' | 'hardware';

let known: WebGl | null = null;

/** `software`: WebGL without a graphics card, whose cost grows with the number of pixels. */
export function webGl(): WebGl {
  known ??= ask();
  return known;
}

function ask(): WebGl {
  const context = document.createElement('canvas').getContext('webgl2');
  if (context === null) return 'none';
  const info = context.getExtension('WEBGL_debug_renderer_info');
  const name = String(info ? context.getParameter(info.UNMASKED_RENDERER_WEBGL) : '');
  context.getExtension('WEBGL_lose_context')?.loseContext();
  return /swiftshader|llvmpipe|software|basic render/i.test(name) ? 'software' : 'hardware';
}
