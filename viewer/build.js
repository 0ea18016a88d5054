// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

// usage: node build.js OUTPUT
//
// Bundles the viewer, and what it uses of three.js, into one page without a scene: programs put a scene
// where the page says <!-- scene -->.

import { build } from 'esbuild';
import { mkdir, readFile, writeFile } from 'node:fs/promises';
import { dirname, join } from 'node:path';
import { fileURLToPath } from 'node:url';

const source = join(dirname(fileURLToPath(import.meta.url)), 'src');

async function bundled(file) {
  const result = await build({
    entryPoints: [join(source, file)],
    bundle: true,
    minify: true,
    write: false,
    format: 'iife',
    target: ['chrome103', 'firefox113', 'safari16.4'],
    legalComments: 'inline',
    logLevel: 'warning',
  });
  return result.outputFiles[0].text;
}

const output = process.argv[2];
if (!output) {
  console.error('usage: node build.js OUTPUT');
  process.exit(2);
}
const parts = {
  style: await bundled('viewer.css'),
  // the end of a script, in a text of it, would end it
  script: (await bundled('main.js')).replaceAll('</script', '<\\/script'),
};
const page = await readFile(join(source, 'page.html'), 'utf8');
await mkdir(dirname(output), { recursive: true });
await writeFile(output, page.replace(/\/\* (style|script) \*\//g, (_, name) => parts[name]));
