// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

// usage: node viewer_pages.js MESH_DIR
//
// Pages for browsers, as `--html` writes them, of three meshes in MESH_DIR: their size and that of the viewer
// in them; and in Chromium without graphics hardware, in a window of 1366 x 768 pixels, milliseconds to decode
// the surface, to the first picture, for a picture (mean of 3), for a frame while it turns, with fewer triangles if it is
// slow (mean of 20), and to read what is under the pointer (mean of 5). Needs the variables of viewer/tests/pages.js in the environment.

import { execFileSync } from 'node:child_process';
import { statSync } from 'node:fs';
import { cpus } from 'node:os';
import { dirname, join, resolve } from 'node:path';
import { fileURLToPath } from 'node:url';
import { bundle, folder, launch, open, run } from '../../../viewer/tests/pages.js';

if (process.argv.length !== 3) {
  console.error('usage: node viewer_pages.js MESH_DIR');
  process.exit(2);
}
const meshes = resolve(process.argv[2]);
const calls = [
  ['bunny_closed_70k', 'solve_poisson', '--depth', '6'],
  ['armadillo', 'laplace_spectrum', '--depth', '5', '--count', '20'],
  ['armadillo_mc1m', 'estimate_curvature', '--depth', '6'],
];

const commit = execFileSync('git', ['describe', '--always', '--dirty'],
  { cwd: dirname(fileURLToPath(import.meta.url)), encoding: 'utf8' }).trim();
const browser = await launch();
console.log(`# commit: ${commit}`);
console.log(`# machine: ${cpus()[0].model.replace(/ \d.*| Processor.*/, '')}, ${cpus().length} cores`);
console.log(`# versions: Node.js ${process.version}, Chromium ${browser.version()}, SwiftShader`);
console.log('# command: viewer_pages');
console.log('# mesh             triangles  fields  page_MB  viewer_MB  decode_ms  first_ms  picture_ms  frame_ms  hover_ms');
for (const [mesh, program, ...options] of calls) {
  const file = join(folder, `${mesh}.html`);
  run(program, join(meshes, `${mesh}.ply`), '--html', file, ...options);
  const page = await open(browser, file, { width: 1366, height: 768 });
  await page.waitForTimeout(5000); // what was asked for is drawn
  const measured = await page.evaluate(() => {
    const { stage, scene, milliseconds } = globalThis.viewer;
    const gl = stage.renderer.getContext(), pixel = new Uint8Array(4);
    const mean = (number, act) => {
      const begin = performance.now();
      for (let i = 0; i < number; ++i) act(i);
      return (performance.now() - begin) / number;
    };
    const picture = mean(3, () => stage.timedRender());
    stage.isMoving = stage.isSlow;
    stage.render();
    const frame = mean(20, () => {
      stage.camera.position.applyAxisAngle(stage.camera.up, 0.05);
      stage.controls.update();
      stage.render();
      gl.readPixels(0, 0, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, pixel); // waits for the picture
    });
    stage.isMoving = false;
    const hover = mean(5, (i) => stage.pick(600 + 40 * i, 384));
    const [surface] = scene.surfaces;
    return { triangles: surface.numberOfFaces, fields: surface.fields.length, picture, frame, hover, ...milliseconds };
  });
  const megabytes = (path) => (statSync(path).size / 1e6).toFixed(2);
  console.log([mesh.padEnd(16), String(measured.triangles).padStart(11), String(measured.fields).padStart(7),
    megabytes(file).padStart(8), megabytes(bundle).padStart(10),
    ...[['decode', 10], ['first_picture', 9], ['picture', 11], ['frame', 9], ['hover', 9]]
      .map(([name, width]) => measured[name].toFixed(1).padStart(width))].join(' '));
  await page.close();
}
await browser.close();
