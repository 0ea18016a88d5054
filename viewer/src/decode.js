// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

// Reads the scene that a program has put into the page, see viewer_page.h for how it is written.

const codeOfInfinity = 1, codeOfMinusInfinity = 2, firstCode = 3, steps = 2 ** 24 - 1 - firstCode;

async function inflated(base64) {
  const text = atob(base64);
  const bytes = new Uint8Array(text.length);
  for (let i = 0; i < text.length; ++i) bytes[i] = text.charCodeAt(i);
  const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream('deflate'));
  return new Uint8Array(await new Response(stream).arrayBuffer());
}

// Integers, each stored as the difference from the one `stride` before it: the bytes of all of them,
// lowest first, the sign in the lowest bit.
class Integers {
  constructor(bytes) {
    this.bytes = bytes;
    this.offset = 0;
  }

  take(size, stride, planes) {
    const result = new Int32Array(size);
    for (let plane = 0; plane < planes; ++plane, this.offset += size) {
      const shift = 8 * plane;
      for (let i = 0; i < size; ++i) result[i] |= this.bytes[this.offset + i] << shift;
    }
    for (let i = 0; i < size; ++i) {
      const difference = (result[i] >>> 1) ^ -(result[i] & 1);
      result[i] = difference + (i < stride ? 0 : result[i - stride]);
    }
    return result;
  }
}

function numberOf(code, low, high) {
  if (code >= firstCode) {
    const t = (code - firstCode) / steps;
    return low === high ? low : low * (1 - t) + high * t; // whose difference may overflow
  }
  return code === codeOfInfinity ? Infinity : code === codeOfMinusInfinity ? -Infinity : NaN;
}

// with `codes` of the places that the vertices have while it is shown, if these are its own
function decodedField(field, integers, vertices) {
  const result = { ...field };
  if (field.kind === 'colors') {
    result.colors = Uint8Array.from(integers.take(3 * vertices, 3, field.planes));
  } else {
    const codes = integers.take(vertices, 1, field.planes);
    result.valueOf = (vertex) => numberOf(codes[vertex], field.low, field.high);
  }
  if (field.positions) result.codes = integers.take(3 * vertices, 3, field.positions.planes);
  return result;
}

// The surfaces of a page: positions in coordinates of the file less `center`, for which single
// precision is enough.
export async function decodedScene(description, base64) {
  const integers = new Integers(await inflated(base64));
  const surfaces = description.surfaces.map((s) => {
    const codes = integers.take(3 * s.vertices, 3, s.positions.planes);
    const extent = [0, 1, 2].map((axis) => s.positions.step * s.positions.extent[axis]);
    const center = [0, 1, 2].map((axis) => s.positions.low[axis] + extent[axis] / 2);
    const size = Math.hypot(...extent);
    const triangles = new Uint32Array(integers.take(3 * s.faces, 3, s.triangles.planes));
    let normals = null;
    if (s.normals) normals = Float32Array.from(integers.take(3 * s.vertices, 3, s.normals.planes), (n) => n / 127);
    const fields = s.fields.map((field) => decodedField(field, integers, s.vertices));
    let square = 0;
    for (const places of [codes, ...fields.map((field) => field.codes).filter(Boolean)])
      for (let v = 0; size > 0 && v < places.length; v += 3) {
        let sum = 0;
        for (let axis = 0; axis < 3; ++axis)
          sum += ((s.positions.step * places[v + axis] - extent[axis] / 2) / size) ** 2;
        square = Math.max(square, sum);
      }
    const radius = size * Math.sqrt(square);
    // scaled to a ball of radius one: coordinates may be of any size
    const scale = radius > 0 ? 1 / radius : 1;
    const placed = (code, i) => (s.positions.step * code - extent[i % 3] / 2) * scale;
    const positions = Float32Array.from(codes, placed);
    const pointOf = (places) => (vertex) =>
      [0, 1, 2].map((axis) => s.positions.low[axis] + s.positions.step * places[3 * vertex + axis]);
    for (const field of fields) {
      field.positions = field.codes ? Float32Array.from(field.codes, placed) : positions;
      field.pointOf = pointOf(field.codes ?? codes);
    }
    const segments = [];
    if (s.lines) {
      const sizes = integers.take(s.lines.number, 1, s.lines.sizes.planes);
      const points = Float32Array.from(integers.take(3 * s.lines.points.number, 3, s.lines.points.planes), placed);
      let first = 0;
      for (const size of sizes) {
        for (let v = first; v + 1 < first + size; ++v) segments.push(...points.subarray(3 * v, 3 * v + 6));
        first += size;
      }
    }
    return {
      name: s.name,
      numberOfVertices: s.vertices,
      numberOfFaces: s.faces,
      leftOut: s.leftOut,
      positions,
      triangles,
      normals,
      segments,
      pointAt: (p) => p.map((x, axis) => center[axis] + x * (radius > 0 ? radius : 1)),
      pointOf: pointOf(codes),
      fields,
    };
  });
  return { ...description, surfaces };
}
