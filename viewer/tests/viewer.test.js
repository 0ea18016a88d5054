// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

import assert from 'node:assert/strict';
import { readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { after, before, test } from 'node:test';
import {
  bundle, colorsAt, folder, handmadePage, launch, mesh, open, visibleVertices, writtenPage,
} from './pages.js';

// Of color_map.h, the numbers once more, so that a change of one of the two is noticed.
const sequential = [[51, 16, 92], [53, 51, 118], [44, 82, 145], [44, 116, 147], [44, 148, 146],
  [76, 179, 127], [108, 209, 97], [190, 225, 83], [255, 239, 56]];
const diverging = [[3, 70, 163], [45, 116, 195], [85, 162, 225], [166, 202, 235], [242, 242, 242],
  [243, 180, 167], [234, 115, 93], [190, 68, 58], [146, 8, 23]];
const gray = [187, 187, 187];

function colorOf(map, t) {
  const x = Math.min(Math.max(t, 0), 1) * 8, i = Math.min(Math.floor(x), 7);
  return map[i].map((low, k) => low + (x - i) * (map[i + 1][k] - low));
}

function assertColor(found, expected, tolerance, what) {
  const difference = Math.max(...expected.map((c, k) => Math.abs(c - found[k])));
  assert.ok(difference <= tolerance, `${what}: ${found.slice(0, 3)}, not ${expected.map(Math.round)}`);
  assert.equal(found[3], 255, what);
}

const plain = { light: false, isolines: 0 };
const set = (page, changes) => page.evaluate((c) => globalThis.viewer.controls.set(c), changes);
const hovered = async (page, [x, y]) => {
  await page.mouse.move(x + 1, y);
  await page.mouse.move(x, y);
  await page.evaluate(() => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(() => done(true)))));
  return page.locator('#reading').innerText();
};
const number = (text) => Number(text.replaceAll('−', '-'));

let browser;
before(async () => { browser = await launch(); });
after(() => browser.close());

test('colors and readings are those of the table', async () => {
  const { page: file, rows } = writtenPage('poisson', 'solve_poisson', mesh('bunny00.off'), '--depth', '5');
  const page = await open(browser, file);
  const values = rows.map((row) => row[0]);
  const largest = Math.max(...values.map(Math.abs));
  const range = Math.max(...values) - Math.min(...values);
  const seen = await visibleVertices(page, 3);
  assert.equal(seen.length, 3);
  await set(page, plain);
  const colors = await colorsAt(page, seen.map((s) => s.place));
  for (const [i, { vertex, place }] of seen.entries()) {
    assertColor(colors[i], colorOf(diverging, 0.5 + (0.5 * values[vertex]) / largest), 8, `vertex ${vertex}`);
    const text = await hovered(page, place);
    const [, id, value] = text.match(/vertex (\d+): (\S+)/);
    assert.equal(Number(id), vertex);
    assert.ok(Math.abs(number(value) - values[vertex]) < 2e-7 * range, `${value} is ${values[vertex]}`);
    const position = text.match(/at (\S+), (\S+), (\S+)/).slice(1).map(number);
    const line = readFileSync(mesh('bunny00.off'), 'utf8').split('\n').filter((l) => l && !l.startsWith('#'))[2 + vertex];
    line.trim().split(/\s+/).map(Number).slice(0, 3).forEach((x, k) => assert.ok(Math.abs(x - position[k]) < 2e-3, text));
  }
  assert.match(await page.locator('header').innerText(), /solve_poisson bunny00\.off/);
  const ticks = (await page.locator('#bar .ticks span').allInnerTexts()).map(number);
  assert.ok(ticks.includes(0) && ticks.length >= 3 && ticks.every((t) => Math.abs(t) <= 1.001 * largest), `ticks ${ticks}`);
  // isolines darken some pixels, light makes colors differ from those of the bar
  await set(page, { isolines: 20 });
  const isDark = await page.evaluate(() => {
    const { stage } = globalThis.viewer;
    stage.render();
    const gl = stage.renderer.getContext(), all = new Uint8Array(4 * 900 * 600);
    gl.readPixels(0, 0, 900, 600, gl.RGBA, gl.UNSIGNED_BYTE, all);
    let dark = 0;
    for (let i = 0; i < all.length; i += 4) if (all[i + 3] > 0 && all[i] + all[i + 1] + all[i + 2] < 240) ++dark;
    return dark;
  });
  assert.ok(isDark > 200, `${isDark} dark pixels`);
  await set(page, { isolines: 0, light: true });
  const lit = await colorsAt(page, seen.map((s) => s.place));
  assert.ok(lit.some((c, i) => c.some((x, k) => Math.abs(x - colors[i][k]) > 4)));
  assert.deepEqual(page.complaints, []);
});

test('the slider changes the field', async () => {
  const { page: file } = writtenPage('spectrum', 'laplace_spectrum', mesh('elephant.off'), '--depth', '4',
    '--count', '6', '--eigenfunction', '2');
  const page = await open(browser, file);
  await set(page, plain);
  const seen = await visibleVertices(page, 3);
  const label = page.locator('#fields label');
  assert.match(await label.innerText(), /^eigenfunction 2, eigenvalue /);
  const places = seen.map((s) => s.place);
  const first = await colorsAt(page, places);
  await page.locator('#field').fill('3');
  assert.match(await label.innerText(), /^eigenfunction 3, eigenvalue /);
  assert.notDeepEqual(await colorsAt(page, places), first);
  await page.locator('canvas[role=img]').focus();
  await page.keyboard.press('ArrowLeft');
  assert.match(await label.innerText(), /^eigenfunction 2, /);
  assert.deepEqual(await colorsAt(page, places), first);
  for (let i = 0; i < 9; ++i) await page.keyboard.press('ArrowRight');
  assert.match(await label.innerText(), /^eigenfunction 5, /);
  // another slider has the arrows while it has the focus
  await page.keyboard.press('o');
  await page.locator('#isolines').focus();
  await page.keyboard.press('ArrowLeft');
  await page.keyboard.press('ArrowRight');
  await page.keyboard.press('ArrowRight');
  assert.equal(await page.evaluate(() => globalThis.viewer.controls.state.isolines), 2);
  assert.match(await label.innerText(), /^eigenfunction 5, /);
  assert.deepEqual(page.complaints, []);
});

test('what is not reached has no color', async () => {
  // two tetrahedra; distances from a vertex of the first
  const off = join(folder, 'two.off');
  const points = [[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]];
  const faces = [[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]];
  writeFileSync(off, `OFF\n8 8 0\n${points.map((p) => p.join(' ')).join('\n')}\n`
    + `${points.map((p) => `${p[0] + 2} ${p[1]} ${p[2]}`).join('\n')}\n`
    + `${faces.map((f) => `3 ${f.join(' ')}`).join('\n')}\n${faces.map((f) => `3 ${f.map((v) => v + 4).join(' ')}`).join('\n')}\n`);
  const { page: file } = writtenPage('two', 'geodesic_distance', off, '--source', '0');
  const page = await open(browser, file);
  await set(page, plain);
  await page.evaluate(() => globalThis.viewer.stage.resetCamera('y', globalThis.viewer.stage.camera.position.clone().set(0.2, 0.3, 1)));
  // the middle of a face of each that looks at the camera
  const middles = await page.evaluate(() => {
    const { stage } = globalThis.viewer;
    const middle = (vertices) => [0, 1].map((k) => vertices.reduce((s, v) => s + stage.placeOf(0, v)[k] / 3, 0));
    return [middle([1, 2, 3]), middle([5, 6, 7])];
  });
  const [near, far] = await colorsAt(page, middles);
  assert.notDeepEqual(near.slice(0, 3), gray);
  assertColor(far, gray, 1, 'the second tetrahedron');
  assert.match(await hovered(page, middles[1]), /∞/);
  assert.match(await hovered(page, middles[0]), /^[\d.]+\n/);
  assert.deepEqual(page.complaints, []);
});

test('values that are no numbers', async () => {
  const points = [[0, 0, 0], [64, 0, 0], [64, 64, 0], [0, 64, 0]];
  const file = handmadePage('nan', [{
    points, triangles: [[0, 1, 2], [0, 2, 3]],
    fields: [{ name: 'part', values: [0, 1, 2, NaN] }, { name: 'all', values: [NaN, NaN, NaN, NaN] }, { name: 'constant', values: [3, 3, 3, 3] },
      { name: 'largest', values: [-1.7e308, 0, 1.7e308, -1.7e308] }, { name: 'smallest', values: [0, 5e-324, 0, 0] }],
  }]);
  const page = await open(browser, file);
  await set(page, plain);
  const places = await page.evaluate(() => {
    const { stage } = globalThis.viewer;
    return [[0, 1, 2], [0, 2, 3]].map((t) => [0, 1].map((k) => t.reduce((s, v) => s + stage.placeOf(0, v)[k] / 3, 0)));
  });
  let colors = await colorsAt(page, places);
  const value = await page.evaluate(([x, y]) => globalThis.viewer.stage.pick(x, y).value, places[0]);
  assert.ok(Math.abs(value - 1) < 0.3);
  assertColor(colors[0], colorOf(sequential, value / 2), 4, 'the face with values');
  assertColor(colors[1], gray, 1, 'the face with a vertex without');
  assert.match(await hovered(page, places[1]), /no value/);
  await page.keyboard.press('ArrowRight');
  colors = await colorsAt(page, places);
  for (const color of colors) assertColor(color, gray, 1, 'no value at all');
  await page.keyboard.press('ArrowRight');
  colors = await colorsAt(page, places);
  for (const color of colors) assertColor(color, colorOf(sequential, 0), 1, 'a constant');
  await set(page, { isolines: 0, field: 3 });
  const large = await page.evaluate(([x, y]) => globalThis.viewer.stage.pick(x, y).value, places[0]);
  assertColor((await colorsAt(page, places))[0], colorOf(diverging, 0.5 + large / 2 / 1.7e308), 4, 'huge values');
  await set(page, { isolines: 20, field: 4 });
  assert.deepEqual(page.complaints, []);
});

test('no triangle', async () => {
  // points alone
  const points = [[0, 0, 0], [64, 0, 0], [64, 64, 0], [0, 64, 0], [32, 32, 0]];
  let page = await open(browser, handmadePage('points', [{ points, triangles: [], fields: [{ name: 'u', values: [0, 1, 2, 3, 4] }] }]));
  await set(page, plain);
  const place = await page.evaluate(() => globalThis.viewer.stage.placeOf(0, 4));
  const [color] = await colorsAt(page, [place]);
  assertColor(color, colorOf(sequential, 1), 1, 'the point in the middle');
  assert.match(await hovered(page, place), /vertex 4: 4/);
  assert.match(await page.locator('header').innerText(), /5 points/);
  assert.deepEqual(page.complaints, []);
  // nothing
  page = await open(browser, handmadePage('nothing', [{ points: [], triangles: [] }]));
  assert.match(await page.locator('#message').innerText(), /no vertex/);
  assert.deepEqual(page.complaints, []);
  // one point, which has no extent; and a page without a scene
  page = await open(browser, handmadePage('point', [{ points: [[1, 2, 3]], triangles: [], fields: [{ name: 'u', values: [7] }] }]));
  assert.deepEqual(page.complaints, []);
  page = await browser.newPage();
  await page.goto(`file://${bundle}`);
  await page.getByText('This page holds no surface').waitFor();
});

test('two surfaces side by side', async () => {
  const square = (size) => ({
    points: [[0, 0, 0], [size, 0, 0], [size, size, 0], [0, size, 0]], triangles: [[0, 1, 2], [0, 2, 3]],
  });
  const page = await open(browser, handmadePage('pair', [
    { name: 'left', ...square(64), fields: [{ name: 'u', values: [0, 0, 0, 0] }] },
    { name: 'right', ...square(2), fields: [{ name: 'u', values: [1, 1, 1, 1] }] },
  ]));
  await set(page, plain);
  const middle = () => page.evaluate(() => [0, 1].map((i) => {
    const { stage } = globalThis.viewer;
    return [0, 1].map((k) => (stage.placeOf(i, 0)[k] + stage.placeOf(i, 2)[k]) / 2);
  }));
  const before = await middle();
  assert.ok(before[0][0] < 450 && before[1][0] > 450);
  // one range for both
  const colors = await colorsAt(page, before);
  assertColor(colors[0], colorOf(sequential, 0), 2, 'left');
  assertColor(colors[1], colorOf(sequential, 1), 2, 'right');
  assert.match(await hovered(page, before[1]), /vertex \d: 1/);
  assert.match(await hovered(page, before[0]), /vertex \d: 0/);
  for (const name of ['left', 'right']) assert.ok(await page.getByText(name, { exact: true }).isVisible());
  // one camera: after a drag over the left one both are seen alike
  const corner = () => page.evaluate(() => [0, 1].map((i) => globalThis.viewer.stage.placeOf(i, 2)));
  const [a] = await corner();
  await page.mouse.move(before[0][0], before[0][1]);
  await page.mouse.down();
  await page.mouse.move(before[0][0] + 80, before[0][1] + 30, { steps: 4 });
  await page.mouse.up();
  const [b, c] = await corner();
  assert.ok(Math.hypot(b[0] - a[0], b[1] - a[1]) > 5, 'the drag turned the surface');
  assert.ok(Math.abs(c[0] - b[0] - 450) < 1e-3 && Math.abs(c[1] - b[1]) < 1e-3, `${b} and ${c}`);
  // one above the other on a phone
  await page.setViewportSize({ width: 390, height: 844 });
  await page.evaluate(() => globalThis.viewer.stage.render());
  const stacked = await middle();
  assert.ok(Math.abs(stacked[0][0] - stacked[1][0]) < 1e-3 && stacked[1][1] - stacked[0][1] > 300);
  assert.deepEqual(page.complaints, []);
});

test('the slider moves the surface', async () => {
  const small = [[0, 0, 0], [8, 0, 0], [8, 8, 0], [0, 8, 0]], large = small.map((p) => p.map((x) => 8 * x));
  const bent = large.map(([x, y], i) => [x, y, i === 2 ? 32 : 0]);
  const page = await open(browser, handmadePage('moving', [{
    points: small, triangles: [[0, 1, 2], [0, 2, 3]],
    fields: [{ name: 'own', values: [0, 1, 2, 3] }, { name: 'large', values: [0, 1, 2, 3], points: large },
      { name: 'bent', values: [0, 1, 2, 3], points: bent }, { name: 'painted', colors: Array(12).fill(255), points: large }],
  }]));
  await set(page, { ...plain, wireframe: true, boundary: true });
  const state = (field) => page.evaluate((f) => {
    const { controls, stage } = globalThis.viewer;
    controls.setField(f);
    const corners = [0, 2].map((v) => stage.placeOf(0, v));
    const middle = corners[0].map((x, k) => (x + corners[1][k]) / 2);
    const edges = stage.views[0].lines.all.geometry.getAttribute('position').array;
    const normals = stage.views[0].geometry.getAttribute('normal').array;
    return {
      corners, middle, hit: stage.pick(...middle), edge: edges[3] - edges[0], normal: normals[0],
      coarse: (stage.views[0].setCoarse(true), stage.views[0].coarse.geometry.index.count), fine: stage.views[0].setCoarse(false),
    };
  }, field);
  const length = ({ corners: [a, b] }) => Math.hypot(a[0] - b[0], a[1] - b[1]);
  const own = await state(0), grown = await state(1), folded = await state(2), painted = await state(3), back = await state(0);
  assert.ok(Math.abs(length(grown) / length(own) - 8) < 2, `${length(own)} and ${length(grown)}`);
  assert.ok(Math.abs(grown.edge / own.edge - 8) < 1e-4, 'edges move, too');
  assert.equal(own.normal, 0);
  assert.ok(Math.abs(folded.normal) > 0.1, 'and normals');
  assert.deepEqual(painted.corners, grown.corners);
  assert.deepEqual(back, own);
  const [a, b, c] = grown.hit.position;
  assert.ok(Math.abs(a - b) < 1e-3 && a > 30 && a < 40 && Math.abs(c) < 1e-3, `${grown.hit.position}`);
  await page.evaluate(() => globalThis.viewer.controls.setField(1));
  assert.deepEqual(await page.evaluate(() => globalThis.viewer.scene.surfaces[0].fields[1].pointOf(2)), [64, 64, 0]);
  const [x, y] = grown.corners[1];
  assert.match(await hovered(page, [x - 3, y + 3]), /at 6\d\.?\d*, 6\d\.?\d*, /);
  assert.deepEqual(page.complaints, []);
});

test('paths lie on the surface', async () => {
  const { page: file } = writtenPage('path', 'geodesic_distance', mesh('elephant.off'), '--source', '0', '--path', '1000');
  const page = await open(browser, file);
  const { ends, source, target, pink } = await page.evaluate(() => {
    const { stage, scene: { surfaces: [surface] } } = globalThis.viewer;
    const point = (v) => [...surface.positions.subarray(3 * v, 3 * v + 3)];
    stage.render();
    const gl = stage.renderer.getContext(), all = new Uint8Array(4 * 900 * 600);
    gl.readPixels(0, 0, 900, 600, gl.RGBA, gl.UNSIGNED_BYTE, all);
    let count = 0;
    for (let i = 0; i < all.length; i += 4) if (all[i] > 200 && all[i + 1] < 60 && all[i + 2] > 110 && all[i + 2] < 170) ++count;
    return { ends: [surface.segments.slice(0, 3), surface.segments.slice(-3)], source: point(0), target: point(1000), pink: count };
  });
  const distance = (a, b) => Math.hypot(...a.map((x, k) => x - b[k]));
  assert.ok(Math.min(distance(ends[0], target) + distance(ends[1], source), distance(ends[0], source) + distance(ends[1], target)) < 1e-4);
  assert.ok(pink > 20, `${pink} pixels of the path`);
  assert.deepEqual(page.complaints, []);
});

test('a large surface moves with fewer triangles', async () => {
  const { page: file } = writtenPage('large', 'geodesic_distance', mesh('bunny00.off'), '--source', '0');
  const page = await open(browser, file);
  const state = () => page.evaluate(() => {
    const { stage } = globalThis.viewer;
    stage.render();
    return { triangles: stage.renderer.info.render.triangles, place: stage.placeOf(0, 0) };
  });
  await page.evaluate(() => { globalThis.viewer.stage.isSlow = true; });
  await page.mouse.move(450, 300);
  const before = await state();
  await page.mouse.down();
  await page.mouse.move(500, 320, { steps: 3 });
  const moving = await state();
  assert.ok(moving.triangles > 1000 && moving.triangles < 0.4 * before.triangles, `${moving.triangles} of ${before.triangles}`);
  assert.notDeepEqual(moving.place, before.place);
  // it looks alike: of the window nearly the same part is covered
  const covered = () => page.evaluate(() => {
    const { stage } = globalThis.viewer;
    stage.render();
    const gl = stage.renderer.getContext(), all = new Uint8Array(4 * 900 * 600);
    gl.readPixels(0, 0, 900, 600, gl.RGBA, gl.UNSIGNED_BYTE, all);
    return all.filter((x, i) => i % 4 === 3 && x > 0).length;
  });
  const coarse = await covered();
  await page.mouse.up();
  await page.waitForTimeout(400);
  assert.equal((await state()).triangles, before.triangles);
  assert.ok(Math.abs((await covered()) / coarse - 1) < 0.03);
  assert.deepEqual(page.complaints, []);
});

test('in a frame, as a notebook shows it', async () => {
  const points = [[0, 0, 0], [64, 0, 0], [64, 64, 0], [0, 64, 0]];
  const file = handmadePage('inner', [{ points, triangles: [[0, 1, 2], [0, 2, 3]], fields: [{ name: 'u', values: [0, 1, 2, 3] }] }]);
  const text = readFileSync(file, 'utf8').replaceAll('&', '&amp;').replaceAll('"', '&quot;').replaceAll('<', '&lt;');
  const outer = join(folder, 'outer.html');
  writeFileSync(outer, `<!doctype html><p>before</p><iframe srcdoc="${text}" width="100%" height="520"></iframe>`);
  const page = await browser.newPage();
  const complaints = [];
  page.on('pageerror', (error) => complaints.push(error.message));
  page.on('request', (r) => { if (!r.url().startsWith(`file://${outer}`) && !/^(data|blob|about):/.test(r.url())) complaints.push(r.url()); });
  await page.goto(`file://${outer}`);
  const frame = page.frames()[1];
  for (let i = 0; i < 200 && !(await frame.evaluate(() => Boolean(globalThis.viewer))); ++i) await page.waitForTimeout(50);
  const pixels = await frame.evaluate(() => {
    const { stage } = globalThis.viewer;
    stage.render();
    const gl = stage.renderer.getContext(), { width, height } = stage.canvas, all = new Uint8Array(4 * width * height);
    gl.readPixels(0, 0, width, height, gl.RGBA, gl.UNSIGNED_BYTE, all);
    return all.filter((x, i) => i % 4 === 3 && x > 0).length;
  });
  assert.ok(pixels > 20000, `${pixels}`);
  assert.deepEqual(complaints, []);
  await page.close();
});

test('edges, boundary, vertices, colors, keys', async () => {
  const points = [[0, 0, 0], [64, 0, 0], [64, 64, 0], [0, 64, 0]];
  const file = handmadePage('square', [{
    points, triangles: [[0, 1, 2], [0, 2, 3]],
    fields: [{ name: 'paint', colors: [255, 0, 0, 255, 0, 0, 255, 0, 0, 255, 0, 0] }, { name: 'u', values: [-1, 0, 3, 0] }],
  }]);
  const page = await open(browser, file);
  const counts = () => page.evaluate(() => {
    const { lines } = globalThis.viewer.stage.views[0];
    return Object.fromEntries(Object.entries(lines).map(([k, l]) => [k, l.visible ? l.geometry.index.count / 2 : 0]));
  });
  await page.keyboard.press('w');
  assert.deepEqual(await counts(), { all: 5 });
  await page.keyboard.press('w');
  await page.keyboard.press('b');
  assert.deepEqual(await counts(), { all: 0, boundary: 4, nonManifold: 0 });
  await page.keyboard.press('l');
  const middle = await page.evaluate(() => [0, 1].map((k) => (globalThis.viewer.stage.placeOf(0, 1)[k] * 2 + globalThis.viewer.stage.placeOf(0, 3)[k]) / 3));
  assertColor((await colorsAt(page, [middle]))[0], [255, 0, 0], 0, 'painted');
  assert.ok(await page.locator('#bar').isHidden());
  assert.match(await hovered(page, middle), /255, 0, 0/);
  await page.keyboard.press('ArrowRight');
  assert.ok(await page.locator('#bar').isVisible());
  // symmetric by default, as there are both signs; sequential on request; a range of one's own
  const u = await page.evaluate(([x, y]) => globalThis.viewer.stage.pick(x, y).value, middle);
  assertColor((await colorsAt(page, [middle]))[0], colorOf(diverging, 0.5 + u / 6), 4, 'symmetric');
  await page.keyboard.press('o');
  await page.locator('#map').selectOption('sequential');
  assertColor((await colorsAt(page, [middle]))[0], colorOf(sequential, (u + 1) / 4), 4, 'sequential');
  await page.locator('#range').fill('-10, 10');
  await page.locator('#range').press('Enter');
  assertColor((await colorsAt(page, [middle]))[0], colorOf(sequential, (u + 10) / 20), 4, 'a range');
  await page.locator('#range').fill('nonsense');
  await page.locator('#range').press('Enter');
  assertColor((await colorsAt(page, [middle]))[0], colorOf(sequential, (u + 1) / 4), 4, 'no range');
  await page.keyboard.press('Escape');
  const download = page.waitForEvent('download');
  await page.getByRole('button', { name: 'Save picture' }).click();
  assert.match((await download).suggestedFilename(), /\.png$/);
  assert.deepEqual(page.complaints, []);
});

for (const [width, height] of [[1366, 768], [390, 844]])
  for (const colorScheme of ['light', 'dark'])
    test(`${width} pixels, ${colorScheme}`, async () => {
      const points = [[0, 0, 0], [64, 0, 0], [64, 64, 0], [0, 64, 0]];
      const file = handmadePage('size', [{
        name: 'a', points, triangles: [[0, 1, 2], [0, 2, 3]],
        fields: [{ name: 'a field with a name that is long enough to wrap', values: [0, 1, 2, 3] }, { name: 'b', values: [-1e-9, 0, 0, 1e-7] }],
      }], { title: 'A title that does not fit into one line of a phone, and has no end' });
      const page = await open(browser, file, { width, height, colorScheme });
      await page.keyboard.press('o');
      const boxes = await page.evaluate(() => ['header', '#tools', '#options', '#bar', '#fields'].map((s) => {
        const { left, top, right, bottom } = document.querySelector(s).getBoundingClientRect();
        return { left, top, right, bottom };
      }));
      for (const box of boxes) assert.ok(box.left >= 0 && box.top >= 0 && box.right <= width && box.bottom <= height, JSON.stringify(box));
      const apart = (a, b) => a.right <= b.left || b.right <= a.left || a.bottom <= b.top || b.bottom <= a.top;
      const [header, , options, bar, fields] = boxes;
      assert.ok(apart(bar, fields) && apart(options, bar) && apart(options, fields));
      // the options may hide the title of a phone, while they are open
      assert.ok(width < 640 || apart(header, options));
      // the surface is seen whole, clear of what lies around it
      const corners = await page.evaluate(() => [0, 1, 2, 3].map((v) => globalThis.viewer.stage.placeOf(0, v)));
      for (const [x, y] of corners) assert.ok(x > 0 && x < width && y > 0 && y < height);
      const back = await page.evaluate(() => getComputedStyle(document.body).backgroundColor);
      const brightness = back.match(/\d+/g).map(Number).reduce((a, b) => a + b) / 3;
      assert.ok(colorScheme === 'dark' ? brightness < 60 : brightness > 200, back);
      assert.deepEqual(page.complaints, []);
    });
