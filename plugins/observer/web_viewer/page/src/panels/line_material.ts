// SPDX-License-Identifier: BSD-3-Clause
// Lines with a width in pixels: one opaque rectangle per segment, without instancing, which is slow
// with software rendering. Of a map with storeys, those that the robot is not on are faded.
import { Color, NoBlending, ShaderMaterial, Vector2 } from 'three';

const kVertex = /* glsl */ `
attribute vec3 start;
attribute vec3 end;
uniform vec2 resolution;
uniform float width;
uniform float level;
uniform float reach;
varying float away;
const float kNear = 0.01;

void main() {
  vec4 a = projectionMatrix * modelViewMatrix * vec4(start, 1.0);
  vec4 b = projectionMatrix * modelViewMatrix * vec4(end, 1.0);
  // What lies behind the viewer has no place on the screen: cut it off.
  if (a.w < kNear && b.w > kNear) a = mix(a, b, (kNear - a.w) / (b.w - a.w));
  else if (b.w < kNear && a.w > kNear) b = mix(b, a, (kNear - b.w) / (a.w - b.w));
  vec2 way = (b.xy / b.w - a.xy / a.w) * resolution;
  float far = length(way);
  vec2 along = far > 1e-6 ? way / far : vec2(1.0, 0.0);
  vec2 across = vec2(-along.y, along.x);
  vec4 here = position.x > 0.0 ? b : a;
  float height = (position.x > 0.0 ? end : start).y;
  away = reach > 0.0 ? smoothstep(reach, 1.5 * reach, abs(height - level)) : 0.0;
  // Half a width beyond the ends closes the corners.
  here.xy += (along * position.x + across * position.y) * width / resolution * here.w;
  // Layers lie in their order, those of other storeys behind all.
  here.z = (away > 0.5 ? 0.5 : 0.0) * here.w;
  gl_Position = here;
}`;

const kFragment = /* glsl */ `
uniform vec3 colour;
uniform vec3 paper;
varying float away;
void main() {
  gl_FragColor = vec4(mix(colour, paper, 0.75 * away), 1.0);
  #include <colorspace_fragment>
}`;

/** Size of the canvas in CSS pixels, shared by all lines. */
export type Resolution = { value: Vector2 };

/** How the storeys are faded that the robot is not on, shared by all layers. */
export interface Fade {
  readonly level: { value: number }; // height of the robot in the scene
  readonly reach: { value: number }; // heights up to here are of its storey; 0: nothing is faded
  readonly paper: { value: Color }; // of the background
}

export class LineMaterial extends ShaderMaterial {
  constructor(width: number, resolution: Resolution, fade: Fade) {
    super({
      vertexShader: kVertex,
      fragmentShader: kFragment,
      uniforms: { width: { value: width }, colour: { value: new Color() }, resolution, ...fade },
      // Opaque, but in the pass of the transparent ones, so that layers keep their order.
      transparent: true,
      blending: NoBlending,
      depthTest: true,
      depthWrite: true,
      side: 2,
    });
  }

  setColour(colour: string): void {
    (this.uniforms['colour']?.value as Color).set(colour);
  }
}
