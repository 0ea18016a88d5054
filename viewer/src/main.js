// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

import { decodedScene } from './decode.js';
import { Interface } from './interface.js';
import { Stage } from './stage.js';

async function start() {
  const text = (id) => document.getElementById(id)?.textContent;
  const message = document.createElement('p');
  message.id = 'message';
  message.setAttribute('role', 'status');
  document.body.append(message);
  const say = (what) => {
    message.textContent = what;
    message.hidden = !what;
  };
  try {
    if (!text('scene')) throw new Error('This page holds no surface.');
    if (typeof DecompressionStream === 'undefined')
      throw new Error('This browser is too old: Chrome 103, Firefox 113 or Safari 16.4 will do.');
    say('Reading the surface …');
    const begin = performance.now();
    const scene = await decodedScene(JSON.parse(text('scene')), text('data'));
    const decoded = performance.now();
    const stage = new Stage(scene);
    const controls = new Interface(scene, stage);
    stage.timedRender();
    const drawn = performance.now();
    stage.estimateSpeed();
    stage.requestRender();
    say(scene.surfaces.some((s) => s.numberOfVertices > 0) ? '' : 'This surface has no vertex.');
    // for scripts, and for tests
    globalThis.viewer = {
      scene, stage, controls,
      milliseconds: { decode: decoded - begin, first_picture: drawn - begin },
    };
  } catch (error) {
    say(error.message);
    throw error;
  }
}

start();
