// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

// Normals, edges and picking of triangles in plain arrays.

// of a face with the normal of a vertex that looks round, and of two faces that share a normal
const roundCosine = Math.cos((30 * Math.PI) / 180), sharedCosine = Math.cos((45 * Math.PI) / 180);

function faceNormals(p, t) {
  const normals = new Float32Array(t.length);
  for (let f = 0; f < t.length; f += 3) {
    const a = 3 * t[f], b = 3 * t[f + 1], c = 3 * t[f + 2];
    const ux = p[b] - p[a], uy = p[b + 1] - p[a + 1], uz = p[b + 2] - p[a + 2];
    const vx = p[c] - p[a], vy = p[c + 1] - p[a + 1], vz = p[c + 2] - p[a + 2];
    normals[f] = uy * vz - uz * vy;
    normals[f + 1] = uz * vx - ux * vz;
    normals[f + 2] = ux * vy - uy * vx;
  }
  return normals;
}

function normalize(v) {
  for (let i = 0; i < v.length; i += 3) {
    const length = Math.hypot(v[i], v[i + 1], v[i + 2]);
    if (length > 0) for (let k = 0; k < 3; ++k) v[i + k] /= length;
  }
  return v;
}

// the faces around each vertex: those of vertex v are faces[first[v]] to faces[first[v + 1] - 1]
function facesAround(numberOfVertices, t) {
  const first = new Uint32Array(numberOfVertices + 1);
  for (let i = 0; i < t.length; ++i) ++first[t[i] + 1];
  for (let v = 0; v < numberOfVertices; ++v) first[v + 1] += first[v];
  const next = first.slice(0, numberOfVertices);
  const faces = new Uint32Array(t.length);
  for (let i = 0; i < t.length; ++i) faces[next[t[i]]++] = (i / 3) | 0;
  return { first, faces };
}

// Normals at the vertices, weighted by area. Where a face is turned away from that of one of its
// vertices, an edge or a corner of the surface, each face around the vertex gets a copy of it: `origin`
// tells of which vertex each is one.
export function shadedCorners(positions, triangles) {
  const numberOfVertices = positions.length / 3;
  const weighted = faceNormals(positions, triangles);
  const smooth = new Float32Array(positions.length);
  for (let i = 0; i < triangles.length; ++i) {
    const face = i - (i % 3);
    for (let k = 0; k < 3; ++k) smooth[3 * triangles[i] + k] += weighted[face + k];
  }
  normalize(smooth);
  const unit = normalize(weighted.slice());
  const isSharp = new Uint8Array(numberOfVertices);
  for (let i = 0; i < triangles.length; ++i) {
    const f = i - (i % 3), v = 3 * triangles[i];
    const cosine = unit[f] * smooth[v] + unit[f + 1] * smooth[v + 1] + unit[f + 2] * smooth[v + 2];
    const hasArea = unit[f] !== 0 || unit[f + 1] !== 0 || unit[f + 2] !== 0;
    if (hasArea && cosine < roundCosine) isSharp[triangles[i]] = 1;
  }
  const turned = [];
  for (let i = 0; i < triangles.length; ++i) if (isSharp[triangles[i]]) turned.push(i);
  const indices = triangles.slice();
  const normals = new Float32Array(positions.length + 3 * turned.length);
  normals.set(smooth);
  const origin = new Uint32Array(numberOfVertices + turned.length);
  for (let v = 0; v < numberOfVertices; ++v) origin[v] = v;
  if (turned.length > 0) {
    const { first, faces } = facesAround(numberOfVertices, triangles);
    turned.forEach((corner, number) => {
      const copy = numberOfVertices + number, vertex = triangles[corner], f = corner - (corner % 3);
      // a hub of many faces would take the square of their number
      const end = Math.min(first[vertex + 1], first[vertex] + 64);
      const sum = [weighted[f], weighted[f + 1], weighted[f + 2]];
      for (let j = first[vertex]; j < end; ++j) {
        const g = 3 * faces[j];
        const cosine = unit[f] * unit[g] + unit[f + 1] * unit[g + 1] + unit[f + 2] * unit[g + 2];
        if (g !== f && cosine >= sharedCosine) for (let k = 0; k < 3; ++k) sum[k] += weighted[g + k];
      }
      const length = Math.hypot(...sum);
      if (length > 0) for (let k = 0; k < 3; ++k) normals[3 * copy + k] = sum[k] / length;
      indices[corner] = copy;
      origin[copy] = vertex;
    });
  }
  return { indices, normals, origin };
}

// Triangles of fewer vertices for what moves: those in a cell of a grid, of which 64 go along each side of a cube
// around the ball of radius 1, become the first of them. (A sphere keeps about 20,000 triangles.)
export function coarseTriangles(positions, t) {
  const cells = 64, first = new Map(), own = new Uint32Array(positions.length / 3);
  for (let v = 0; v < own.length; ++v) {
    let cell = 0;
    for (let k = 0; k < 3; ++k)
      cell = cell * cells + Math.min(Math.floor(((positions[3 * v + k] + 1) / 2) * cells), cells - 1);
    if (!first.has(cell)) first.set(cell, v);
    own[v] = first.get(cell);
  }
  const result = [];
  for (let f = 0; f < t.length; f += 3) {
    const a = own[t[f]], b = own[t[f + 1]], c = own[t[f + 2]];
    if (a !== b && b !== c && c !== a) result.push(a, b, c);
  }
  return Uint32Array.from(result);
}

// All edges once, and those that have one face, and more than two: pairs of vertices.
export function edgesOf(numberOfVertices, t) {
  const keys = new Float64Array(t.length);
  for (let i = 0; i < t.length; ++i) {
    const a = t[i], b = t[i % 3 === 2 ? i - 2 : i + 1];
    keys[i] = Math.min(a, b) * numberOfVertices + Math.max(a, b);
  }
  keys.sort();
  const all = [], boundary = [], nonManifold = [];
  for (let i = 0; i < keys.length; ) {
    let end = i + 1;
    while (end < keys.length && keys[end] === keys[i]) ++end;
    const a = Math.floor(keys[i] / numberOfVertices), b = keys[i] - a * numberOfVertices;
    all.push(a, b);
    if (end - i === 1) boundary.push(a, b);
    if (end - i > 2) nonManifold.push(a, b);
    i = end;
  }
  return { all, boundary, nonManifold };
}

// The first triangle that a ray meets: the face, the place in it, and the distance; or null.
export function firstHit(p, t, o, d) {
  let best = null, nearest = Infinity;
  const [ox, oy, oz] = o, [dx, dy, dz] = d;
  for (let f = 0; f < t.length; f += 3) {
    const a = 3 * t[f], b = 3 * t[f + 1], c = 3 * t[f + 2];
    const ux = p[b] - p[a], uy = p[b + 1] - p[a + 1], uz = p[b + 2] - p[a + 2];
    const vx = p[c] - p[a], vy = p[c + 1] - p[a + 1], vz = p[c + 2] - p[a + 2];
    const hx = dy * vz - dz * vy, hy = dz * vx - dx * vz, hz = dx * vy - dy * vx;
    const determinant = ux * hx + uy * hy + uz * hz;
    if (determinant === 0) continue;
    const wx = ox - p[a], wy = oy - p[a + 1], wz = oz - p[a + 2];
    const u = (wx * hx + wy * hy + wz * hz) / determinant;
    if (!(u >= 0 && u <= 1)) continue;
    const qx = wy * uz - wz * uy, qy = wz * ux - wx * uz, qz = wx * uy - wy * ux;
    const v = (dx * qx + dy * qy + dz * qz) / determinant;
    if (!(v >= 0 && u + v <= 1)) continue;
    const distance = (vx * qx + vy * qy + vz * qz) / determinant;
    if (distance > 0 && distance < nearest) {
      nearest = distance;
      best = { face: f / 3, barycentric: [1 - u - v, u, v], distance };
    }
  }
  return best;
}

// The first of the points that are nearer to a ray than `width` times their distance; or null.
export function firstPoint(p, o, d, width) {
  let best = null, nearest = Infinity;
  for (let v = 0; v < p.length; v += 3) {
    const wx = p[v] - o[0], wy = p[v + 1] - o[1], wz = p[v + 2] - o[2];
    const along = wx * d[0] + wy * d[1] + wz * d[2];
    const across = wx * wx + wy * wy + wz * wz - along * along;
    if (along > 0 && across < (width * along) ** 2 && along < nearest) {
      nearest = along;
      best = { vertex: v / 3, distance: along };
    }
  }
  return best;
}
