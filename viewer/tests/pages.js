// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

// Pages for tests: those that programs write, and scenes written here, independently of the programs;
// and a browser to look at them with.

import { execFileSync } from 'node:child_process';
import { existsSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { deflateSync } from 'node:zlib';

// what CTest says
export const bundle = process.env.RESTRICTED_LAPLACIAN_3_VIEWER;
const programs = process.env.RESTRICTED_LAPLACIAN_3_PROGRAMS;
const data = process.env.RESTRICTED_LAPLACIAN_3_DATA_DIR;
const modules = process.env.RESTRICTED_LAPLACIAN_3_NODE_MODULES;

if (!bundle || !existsSync(bundle)) {
  console.log('SKIPPED: the viewer was not bundled');
  process.exit(0);
}
export const folder = mkdtempSync(join(tmpdir(), 'viewer-'));
process.on('exit', () => rmSync(folder, { recursive: true }));

export function mesh(name) {
  const file = join(data ?? '', name);
  if (!existsSync(file)) throw new Error(`${file} is missing`);
  return file;
}

// Runs a program of the package in `folder`; returns what it prints.
export function run(program, ...options) {
  return execFileSync(join(programs, program), options, { cwd: folder, encoding: 'utf8' });
}

// a page that a program wrote, with the rows of its table
export function writtenPage(name, program, meshFile, ...options) {
  const page = join(folder, `${name}.html`), table = join(folder, `${name}.csv`);
  run(program, meshFile, '--html', page, '--csv', table, ...options);
  const rows = readFileSync(table, 'utf8').trim().split('\n').filter((line) => !line.startsWith('#'));
  return { page, rows: rows.slice(1).map((row) => row.split(',').slice(1).map(Number)) };
}

function coded(numbers, stride) {
  const codes = numbers.map((x, i) => {
    const d = x - (i < stride ? 0 : numbers[i - stride]);
    return d < 0 ? -2 * d - 1 : 2 * d;
  });
  const largest = Math.max(0, ...codes);
  const planes = largest === 0 ? 0 : Math.floor(Math.log2(largest) / 8) + 1;
  const bytes = [];
  for (let plane = 0; plane < planes; ++plane)
    for (const code of codes) bytes.push(Math.floor(code / 256 ** plane) % 256);
  return { planes, bytes };
}

// A page of surfaces { name, points, triangles, fields: [{ name, values } or { name, colors }] }, with
// coordinates that are multiples of 1/64 from 0 to 64; fields may have points, too.
export function handmadePage(name, surfaces, description = {}) {
  const bytes = [];
  const add = (numbers, stride) => {
    const result = coded(numbers, stride);
    bytes.push(...result.bytes);
    return result.planes;
  };
  const codesOf = (points) => points.flat().map((x) => 64 * x);
  const field = ({ points, ...values }) => {
    const result = fieldOfValues(values);
    return points ? { ...result, positions: { planes: add(codesOf(points), 3) } } : result;
  };
  const fieldOfValues = ({ name: fieldName, values, colors }) => {
    if (colors) return { name: fieldName, kind: 'colors', planes: add(colors, 3) };
    const finite = values.filter(Number.isFinite);
    const low = Math.min(...finite, Infinity), high = Math.max(...finite, -Infinity);
    const codes = values.map((x) => (Number.isNaN(x) ? 0 : x === Infinity ? 1 : x === -Infinity ? 2
      : 3 + (high > low ? Math.round((2 ** 24 - 4) * ((x / 2 - low / 2) / (high / 2 - low / 2))) : 0)));
    const range = finite.length > 0 ? [low, high] : [0, 0];
    return { name: fieldName, kind: 'numbers', low: range[0], high: range[1], range, planes: add(codes, 1) };
  };
  const scene = {
    title: name, first: 0, isolines: 0, up: 'y', ...description,
    surfaces: surfaces.map((s) => ({
      name: s.name ?? '', vertices: s.points.length, faces: s.triangles.length, leftOut: 0,
      positions: {
        low: [0, 0, 0], step: 1 / 64, extent: [0, 1, 2].map((k) => Math.max(0, ...[s, ...(s.fields ?? [])].flatMap((f) => f.points ?? []).map((p) => 64 * p[k]))),
        planes: add(codesOf(s.points), 3),
      },
      triangles: { planes: add(s.triangles.flat(), 3) },
      fields: (s.fields ?? []).map(field),
    })),
  };
  const file = join(folder, `${name}.html`);
  const json = JSON.stringify(scene).replaceAll('<', '\\u003c');
  const text = deflateSync(Buffer.from(bytes)).toString('base64');
  writeFileSync(file, readFileSync(bundle, 'utf8').replace('<!-- scene -->',
    () => `<script id="scene" type="application/json">${json}</script><script id="data" type="text/plain">${text}</script>`));
  return file;
}

// Debian's Chromium, which draws without graphics hardware here.
export async function launch() {
  const { chromium } = await import(join(modules, 'playwright-core', 'index.mjs'));
  return chromium.launch({
    executablePath: process.env.RESTRICTED_LAPLACIAN_3_CHROMIUM,
    args: ['--no-sandbox', '--disable-quic', '--disable-background-networking', '--disable-component-update',
      '--disable-sync', '--no-first-run', '--use-angle=swiftshader', '--enable-unsafe-swiftshader'],
  });
}

// Opens a page. Its `complaints` are what must not happen: errors, and requests to anywhere.
export async function open(browser, file, options = {}) {
  const { width = 900, height = 600, colorScheme = 'light', ...others } = options;
  const context = await browser.newContext({ viewport: { width, height }, colorScheme, ...others });
  const page = await context.newPage();
  page.complaints = [];
  page.on('console', (m) => {
    if (['error', 'warning'].includes(m.type()) && !m.text().includes('GPU stall')) page.complaints.push(m.text());
  });
  page.on('pageerror', (error) => page.complaints.push(error.message));
  page.on('request', (request) => {
    if (request.url() !== `file://${file}` && !/^(data|blob):/.test(request.url()))
      page.complaints.push(`request of ${request.url()}`);
  });
  await page.goto(`file://${file}`);
  // waitForFunction() would compile text, which the page forbids
  const end = Date.now() + 60000;
  while (!(await page.evaluate(() => Boolean(globalThis.viewer)))) {
    if (Date.now() > end) throw new Error(`${file} shows nothing: ${page.complaints}`);
    await page.waitForTimeout(50);
  }
  return page;
}

// the color that the canvas has at places of the window, in bytes
export async function colorsAt(page, places) {
  return page.evaluate((all) => {
    const { stage } = globalThis.viewer;
    stage.render();
    const gl = stage.renderer.getContext(), ratio = stage.renderer.getPixelRatio();
    return all.map(([x, y]) => {
      const pixel = new Uint8Array(4);
      gl.readPixels(Math.floor(x * ratio), Math.floor(stage.canvas.height - y * ratio), 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, pixel);
      return [...pixel];
    });
  }, places);
}

// Numbers of vertices that are seen from the camera, far from each other: faces around them look at it,
// and nothing hides them.
export async function visibleVertices(page, number, surface = 0) {
  return page.evaluate(([wanted, index]) => {
    const { stage, scene } = globalThis.viewer;
    const result = [], places = [];
    const n = scene.surfaces[index].numberOfVertices;
    for (let v = 0, steps = 0; steps < Math.min(n, 500) && result.length < wanted; v = (v + 7919) % n, ++steps) {
      const place = stage.placeOf(index, v);
      if (places.some((q) => Math.hypot(q[0] - place[0], q[1] - place[1]) < 40)) continue;
      const around = [[0, 0], [3, 0], [-3, 0], [0, 3], [0, -3]].map(([dx, dy]) => stage.pick(place[0] + dx, place[1] + dy));
      if (!around.every(Boolean) || around[0].vertex !== v) continue;
      result.push(v);
      places.push(place);
    }
    return result.map((vertex, i) => ({ vertex, place: places[i] }));
  }, [number, surface]);
}
