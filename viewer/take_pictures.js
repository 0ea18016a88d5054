// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

// usage: node take_pictures.js PAGE_DIR OUTPUT_DIR
//
// The pictures of the manual's gallery: what each page of PAGE_DIR shows first, without what lies around it,
// as OUTPUT_DIR/gallery_NAME.png. Needs the variables of tests/pages.js in the environment.

import { mkdirSync, readdirSync } from 'node:fs';
import { join, parse, resolve } from 'node:path';
import { launch, open } from './tests/pages.js';

const [from, to] = process.argv.slice(2);
if (!to) {
  console.error('usage: node take_pictures.js PAGE_DIR OUTPUT_DIR');
  process.exit(2);
}
mkdirSync(to, { recursive: true });
const browser = await launch();
for (const file of readdirSync(from).filter((name) => name.endsWith('.html'))) {
  const page = await open(browser, join(resolve(from), file), { width: 480, height: 360, deviceScaleFactor: 2 });
  await page.addStyleTag({ content: 'header, #tools, #fields, .name { display: none } #bar { flex: none; width: 240px } .caption { display: none } #stage { inset: 0 0 44px }' });
  await page.evaluate(() => globalThis.viewer.stage.render());
  await page.screenshot({ path: join(to, `gallery_${parse(file).name}.png`), scale: 'css' });
  await page.close();
}
await browser.close();
