// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

// The path of somebody who comes for the first time: the README's command, the first picture, an own mesh in
// the viewer. All but what installs and compiles, in less than three minutes.

import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { existsSync, readFileSync, writeFileSync } from 'node:fs';
import { dirname, join } from 'node:path';
import { test } from 'node:test';
import { fileURLToPath } from 'node:url';
import { folder, launch, mesh, open, run } from './pages.js';

const root = join(dirname(fileURLToPath(import.meta.url)), '..', '..');

test('from the README to an own mesh', async () => {
  const begin = performance.now();
  const [command] = readFileSync(join(root, 'README.md'), 'utf8').match(/bash scripts\/demo\.sh/);
  const demo = readFileSync(join(root, command.split(' ')[1]), 'utf8');

  // what the script does once everything is built
  const [, steps] = demo.match(/^(mkdir -p demo_output$[\s\S]*)$/m);
  const script = `set -euo pipefail\npages=true\nmesh='${mesh('bunny00.off')}'\n`
    + `programs='${process.env.RESTRICTED_LAPLACIAN_3_PROGRAMS}'\n${steps}`;
  const printed = execFileSync('bash', ['-c', script], { cwd: folder, encoding: 'utf8' });
  const output = join(folder, 'demo_output');
  const named = [...printed.matchAll(/--html (\S+)/g)].map((m) => m[1]);
  assert.deepEqual(named, ['poisson.html', 'eigenfunctions.html']);
  for (const picture of ['poisson.png', 'eigenfunction.png']) assert.ok(existsSync(join(output, picture)));

  // an own mesh: a tetrahedron typed by hand
  const own = join(folder, 'own.off');
  writeFileSync(own, 'OFF\n4 4 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 0 3 2\n3 1 2 3\n');
  run('laplace_spectrum', own, '--count', '6', '--refine', '2', '--html', join(folder, 'own.html'));

  const browser = await launch();
  for (const file of [...named.map((name) => join(output, name)), join(folder, 'own.html')]) {
    const page = await open(browser, file);
    const shown = await page.evaluate(() => {
      const { stage } = globalThis.viewer;
      stage.render();
      const gl = stage.renderer.getContext(), all = new Uint8Array(4 * 900 * 600);
      gl.readPixels(0, 0, 900, 600, gl.RGBA, gl.UNSIGNED_BYTE, all);
      return all.filter((x, i) => i % 4 === 3 && x > 0).length;
    });
    assert.ok(shown > 20000, `${shown} pixels of ${file}`);
    assert.deepEqual(page.complaints, []);
  }
  await browser.close();
  const seconds = (performance.now() - begin) / 1000;
  assert.ok(seconds < 180, `${seconds} s`);
});
