// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

// One surface as objects of three.js: its triangles or points, and lines on request.

import {
  BufferAttribute, BufferGeometry, DataTexture, DoubleSide, GLSL3, Group, LineBasicMaterial,
  LineSegments, LinearFilter, Matrix4, Mesh, Points, RGBAFormat, ShaderMaterial, UnsignedByteType,
  Vector2, Vector3,
} from 'three';
import { colorOfNothing, colorTable, defaultMap, fractionOf, shownRange } from './colors.js';
import { LineMaterial } from 'three/addons/lines/LineMaterial.js';
import { LineSegments2 } from 'three/addons/lines/LineSegments2.js';
import { LineSegmentsGeometry } from 'three/addons/lines/LineSegmentsGeometry.js';
import { coarseTriangles, edgesOf, firstHit, firstPoint, shadedCorners } from './geometry.js';

const nothing = -1e30; // the value of a vertex without one

const vertexShader = `
in float value;
in vec3 paint;
uniform float pointSize;
out vec3 place;
out vec3 direction;
out float shade;
out vec3 own;
void main() {
  vec4 seen = modelViewMatrix * vec4(position, 1.0);
  place = seen.xyz;
  direction = normalMatrix * normal;
  shade = value;
  own = paint;
  gl_Position = projectionMatrix * seen;
  gl_PointSize = pointSize / -seen.z;
}`;

const fragmentShader = `
precision highp float;
in vec3 place;
in vec3 direction;
in float shade;
in vec3 own;
uniform sampler2D table;
uniform vec3 without;
uniform vec2 levels; // the first level, and the distance of levels; none if that is 0
uniform float middle; // the level 0, which is drawn wider; none if it is negative
uniform bool lit, flat_faces, painted, round_points;
out vec4 color;

float line(float t, float width) {
  float pixel = max(fwidth(t), 1e-12);
  float d = abs(fract(t + 0.5) - 0.5) / pixel;
  // where lines are as dense as pixels there is nothing to see
  return (1.0 - smoothstep(width - 0.5, width + 0.5, d)) * (1.0 - smoothstep(0.2, 0.5, pixel));
}

void main() {
  if (round_points && length(gl_PointCoord - 0.5) > 0.5) discard;
  vec3 base = painted ? own : texture(table, vec2(clamp(shade, 0.0, 1.0) * 255.0 / 256.0 + 0.5 / 256.0, 0.5)).rgb;
  bool is_value = painted || shade > -1e20;
  // the derivatives that lines take, outside of branches
  float t = levels.y > 0.0 ? (clamp(shade, -1e6, 1e6) - levels.x) / levels.y : 0.25;
  float lines = line(t, 0.8);
  float wide = middle >= 0.0 ? 1.0 - smoothstep(1.2, 2.2, abs(shade - middle) / max(fwidth(shade), 1e-12)) : 0.0;
  if (!is_value) base = without;
  else if (levels.y > 0.0 && !painted) base = mix(base, vec3(0.05), 0.75 * max(lines, wide));
  if (lit) {
    vec3 n = flat_faces ? cross(dFdx(place), dFdy(place)) : direction;
    float size = length(n);
    n = size > 0.0 ? n / size : vec3(0.0, 0.0, 1.0);
    vec3 eye = -normalize(place);
    if (dot(n, eye) < 0.0) n = -n;
    vec3 lamp = normalize(vec3(-0.35, 0.5, 1.0));
    float light = 0.34 + 0.66 * max(dot(n, lamp), 0.0);
    float gloss = 0.14 * pow(max(dot(n, normalize(lamp + eye)), 0.0), 40.0);
    base = pow(pow(base, vec3(2.2)) * light + gloss, vec3(1.0 / 2.2));
  }
  color = vec4(base, 1.0);
}`;

export class SurfaceView {
  constructor(surface) {
    this.surface = surface;
    this.object = new Group();
    this.hasFaces = surface.triangles.length > 0;
    this.geometry = new BufferGeometry();
    this.lines = {};
    this.isCoarse = false;
    this.#place(surface.positions);

    this.table = new DataTexture(new Uint8Array(4 * 256), 256, 1, RGBAFormat, UnsignedByteType);
    this.table.magFilter = this.table.minFilter = LinearFilter;
    this.uniforms = {
      table: { value: this.table },
      without: { value: new Vector3(...colorOfNothing).divideScalar(255) },
      levels: { value: new Vector2(0, 0) },
      middle: { value: -1 },
      lit: { value: true },
      flat_faces: { value: false },
      painted: { value: false },
      round_points: { value: false },
      pointSize: { value: 1 },
    };
    this.faces = new Mesh(this.geometry, this.#material({}));
    this.faces.visible = this.hasFaces;
    this.points = new Points(this.geometry, this.#material({ round_points: { value: true } }));
    this.points.visible = !this.hasFaces;
    this.object.add(this.faces, this.points);
    for (const part of this.object.children) part.frustumCulled = false;
    if (surface.segments.length > 0) {
      const geometry = new LineSegmentsGeometry().setPositions(surface.segments);
      const paths = new LineSegments2(geometry, new LineMaterial({ linewidth: 3, color: '#e0218a' }));
      paths.frustumCulled = false;
      this.object.add(paths);
    }
  }

  // Where the vertices are.
  #place(positions) {
    this.positions = positions;
    const corners = this.hasFaces ? shadedCorners(positions, this.surface.triangles) : null;
    this.origin = corners ? corners.origin : null;
    const size = corners ? corners.origin.length : this.surface.numberOfVertices;
    this.geometry.dispose();
    this.geometry.setAttribute('position', new BufferAttribute(this.#ofVertices(positions, 3), 3));
    const normals = corners ? corners.normals : this.surface.normals;
    this.geometry.setAttribute('normal', new BufferAttribute(normals ?? new Float32Array(3 * size), 3));
    this.geometry.setAttribute('value', new BufferAttribute(new Float32Array(size), 1));
    this.geometry.setAttribute('paint', new BufferAttribute(new Uint8Array(3), 3, true));
    if (corners) this.geometry.setIndex(new BufferAttribute(corners.indices, 1));
    this.coarseIndex = null;
    for (const { geometry } of Object.values(this.lines)) {
      geometry.dispose();
      geometry.setAttribute('position', new BufferAttribute(positions, 3));
    }
  }

  // Shows fewer triangles and no lines, or all of them again.
  setCoarse(isCoarse) {
    if (isCoarse === this.isCoarse || !this.hasFaces) return;
    this.isCoarse = isCoarse;
    if (!this.coarse) {
      this.coarse = new Mesh(new BufferGeometry(), this.faces.material);
      this.coarse.frustumCulled = false;
      this.object.add(this.coarse);
    }
    if (isCoarse && !this.coarseIndex) {
      this.coarseIndex = new BufferAttribute(coarseTriangles(this.positions, this.surface.triangles), 1);
      this.coarse.geometry.dispose();
      this.coarse.geometry.setIndex(this.coarseIndex);
    }
    for (const [name, attribute] of Object.entries(this.geometry.attributes))
      this.coarse.geometry.setAttribute(name, attribute);
    this.coarse.visible = isCoarse;
    this.faces.visible = !isCoarse;
    for (const line of Object.values(this.lines)) line.layers.set(isCoarse ? 1 : 0);
  }

  #material(own) {
    return new ShaderMaterial({
      vertexShader, fragmentShader, glslVersion: GLSL3, side: DoubleSide,
      uniforms: { ...this.uniforms, ...own },
      // lines lie in front of the faces
      polygonOffset: true, polygonOffsetFactor: 1, polygonOffsetUnits: 1,
    });
  }

  // numbers of vertices, also of their copies
  #ofVertices(numbers, components) {
    if (!this.origin || this.origin.length * components === numbers.length) return numbers;
    const result = new numbers.constructor(this.origin.length * components);
    for (let v = 0; v < this.origin.length; ++v)
      for (let k = 0; k < components; ++k)
        result[components * v + k] = numbers[components * this.origin[v] + k];
    return result;
  }

  // Shows a field; null for a surface without any.
  // \param options.map a name of colors.js, or 'auto'
  // \param options.range null for that of the field
  setField(field, options) {
    const choice = JSON.stringify([this.surface.fields.indexOf(field), options]);
    if (choice === this.choice) return;
    this.choice = choice;
    this.field = field;
    const positions = field?.positions ?? this.surface.positions;
    if (positions !== this.positions) this.#place(positions);
    this.uniforms.painted.value = Boolean(field?.colors);
    if (!field) {
      this.geometry.getAttribute('value').array.fill(nothing);
      this.geometry.getAttribute('value').needsUpdate = true;
      return;
    }
    if (field.colors) {
      this.geometry.setAttribute('paint', new BufferAttribute(this.#ofVertices(field.colors, 3), 3, true));
      return;
    }
    const range = options.range ?? field.range;
    this.mapName = options.map === 'auto' ? defaultMap(range) : options.map;
    this.range = shownRange(range, this.mapName);
    const values = this.geometry.getAttribute('value').array;
    for (let v = 0; v < values.length; ++v) {
      const value = field.valueOf(this.origin ? this.origin[v] : v);
      values[v] = Number.isFinite(value) ? fractionOf(value, this.range) : nothing;
    }
    this.geometry.getAttribute('value').needsUpdate = true;
    this.table.image.data.set(colorTable(this.mapName, 256));
    this.table.needsUpdate = true;
  }

  // Draws lines at multiples of a step; none if it is 0.
  setLevels(step) {
    const isOn = step > 0 && this.field && !this.field.colors;
    const range = this.range ?? [0, 1];
    const first = isOn ? fractionOf(Math.ceil(range[0] / step) * step, range) : 0;
    this.uniforms.levels.value.set(first, isOn ? fractionOf(range[0] + step, range) : 0);
    this.uniforms.middle.value = isOn && range[0] < 0 && range[1] > 0 ? fractionOf(0, range) : -1;
  }

  setLit(isLit) {
    this.uniforms.lit.value = isLit && (this.hasFaces || this.surface.normals !== null);
  }

  setFlat(isFlat) {
    this.uniforms.flat_faces.value = isFlat && this.hasFaces;
  }

  setPoints(isShown) {
    this.points.visible = isShown || !this.hasFaces;
  }

  // \param pixels of the height that one unit of length takes at distance 1
  setPointSize(pixels) {
    // of a surface of that many vertices, evenly spread
    const spacing = Math.sqrt(6 / Math.max(this.surface.numberOfVertices, 1));
    this.uniforms.pointSize.value = pixels * Math.min(spacing * (this.hasFaces ? 0.3 : 0.8), 0.1);
  }

  // \param kind 'all', 'boundary' or 'nonManifold'
  setEdges(kind, isShown, color) {
    if (!this.lines[kind] && isShown && this.hasFaces) {
      this.edges ??= edgesOf(this.surface.numberOfVertices, this.surface.triangles);
      const geometry = new BufferGeometry();
      geometry.setAttribute('position', new BufferAttribute(this.positions, 3));
      geometry.setIndex(new BufferAttribute(Uint32Array.from(this.edges[kind]), 1));
      this.lines[kind] = new LineSegments(geometry, new LineBasicMaterial());
      this.lines[kind].frustumCulled = false;
      this.object.add(this.lines[kind]);
    }
    if (!this.lines[kind]) return;
    this.lines[kind].visible = isShown;
    this.lines[kind].material.color.set(color);
    this.lines[kind].material.opacity = kind === 'all' ? 0.35 : 1;
    this.lines[kind].material.transparent = kind === 'all';
  }

  // What a ray meets: place, value there, the nearest vertex and its value; or null.
  // \param width of a pixel, over the distance
  pick(ray, width) {
    const back = new Matrix4().copy(this.object.matrixWorld).invert();
    const origin = ray.origin.clone().applyMatrix4(back).toArray();
    const direction = ray.direction.clone().transformDirection(back).toArray();
    const { positions } = this, { triangles } = this.surface;
    let vertex, local, corners = null, barycentric = [1];
    if (this.hasFaces) {
      const hit = firstHit(positions, triangles, origin, direction);
      if (!hit) return null;
      corners = [0, 1, 2].map((k) => triangles[3 * hit.face + k]);
      barycentric = hit.barycentric;
      local = origin.map((x, axis) => x + hit.distance * direction[axis]);
      const distance = (v) => Math.hypot(...local.map((x, axis) => x - positions[3 * v + axis]));
      vertex = corners.reduce((a, b) => (distance(b) < distance(a) ? b : a));
    } else {
      const hit = firstPoint(positions, origin, direction, 5 * width);
      if (!hit) return null;
      vertex = hit.vertex;
      corners = [vertex];
      local = [0, 1, 2].map((axis) => positions[3 * vertex + axis]);
    }
    const result = { vertex, position: this.surface.pointAt(local), vertexPosition: (this.field ?? this.surface).pointOf(vertex) };
    if (this.field?.colors) {
      result.color = [...this.field.colors.subarray(3 * vertex, 3 * vertex + 3)];
    } else if (this.field) {
      result.value = corners.reduce((sum, v, k) => sum + barycentric[k] * this.field.valueOf(v), 0);
      result.vertexValue = this.field.valueOf(vertex);
    }
    return result;
  }
}
