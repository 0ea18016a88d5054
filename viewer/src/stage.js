// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

// The canvas: surfaces side by side, which one camera sees.

import { PerspectiveCamera, Raycaster, Scene, Vector2, Vector3, WebGLRenderer } from 'three';
import { OrbitControls } from 'three/addons/controls/OrbitControls.js';
import { SurfaceView } from './surface_view.js';

const fieldOfView = 30; // degrees
const defaultDirection = new Vector3(0.35, 0.3, 1);

export class Stage {
  constructor(scene) {
    this.element = document.createElement('div');
    this.element.id = 'stage';
    document.body.prepend(this.element);
    this.renderer = this.#makeRenderer();
    this.renderer.autoClear = false;
    this.canvas = this.renderer.domElement;
    this.canvas.tabIndex = 0;
    this.canvas.setAttribute('role', 'img');
    this.canvas.setAttribute('aria-label', `${scene.title}: a surface; drag to turn it`);
    this.element.append(this.canvas);
    this.camera = new PerspectiveCamera(fieldOfView, 1, 0.01, 100);
    this.controls = new OrbitControls(this.camera, this.canvas);
    this.controls.zoomToCursor = true;
    this.controls.minDistance = 0.02;
    this.controls.maxDistance = 50;
    this.views = scene.surfaces.map((surface) => new SurfaceView(surface));
    this.scenes = this.views.map((view) => {
      const result = new Scene();
      result.add(view.object);
      return result;
    });
    this.resetCamera(scene.up);
    this.controls.addEventListener('change', () => this.requestRender());
    new ResizeObserver(() => this.render()).observe(this.element);
    this.listeners = [];
    // While it moves, a surface whose picture takes long is shown with fewer triangles.
    this.isSlow = false;
    this.isMoving = false;
    let timer;
    this.controls.addEventListener('start', () => {
      clearTimeout(timer);
      this.isMoving = this.isSlow;
    });
    this.controls.addEventListener('end', () => {
      clearTimeout(timer);
      if (this.isMoving) timer = setTimeout(() => {
        this.isMoving = false;
        this.requestRender();
      }, 150); // steps of a wheel are movements, too
    });
  }

  // Draws a picture and waits for it. Returns the milliseconds.
  timedRender() {
    const pixel = new Uint8Array(4), gl = this.renderer.getContext();
    const begin = performance.now();
    this.render();
    gl.readPixels(0, 0, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, pixel);
    return performance.now() - begin;
  }

  // Finds out whether a picture takes so long that it would move in jerks, from one of a part of the triangles.
  estimateSpeed() {
    const part = 20000;
    const shown = (triangles) => {
      for (const view of this.views) view.geometry.setDrawRange(0, 3 * triangles);
      return this.timedRender();
    };
    const without = shown(0), withPart = shown(part);
    for (const view of this.views) view.geometry.setDrawRange(0, Infinity);
    const triangles = Math.max(0, ...this.views.map((view) => view.surface.numberOfFaces));
    this.isSlow = triangles > part && without + ((withPart - without) * triangles) / part > 50;
  }

  #makeRenderer() {
    try {
      return new WebGLRenderer({ antialias: true, alpha: true, powerPreference: 'high-performance' });
    } catch {
      throw new Error('This browser does not draw in three dimensions: WebGL 2 is off.');
    }
  }

  resetCamera(up = this.up, direction = null) {
    this.up = up ?? 'y';
    this.camera.up.set(0, this.up === 'y' ? 1 : 0, this.up === 'z' ? 1 : 0);
    // the same view of a surface whose other axis points up: x to the right
    const d = direction ?? (this.up === 'y' ? defaultDirection
      : new Vector3(defaultDirection.x, -defaultDirection.z, defaultDirection.y));
    this.camera.position.copy(d).normalize().multiplyScalar(this.#distance());
    this.controls.target.set(0, 0, 0);
    this.controls.update();
    this.requestRender();
  }

  // from where a ball of radius 1 is seen whole, also in narrow panes
  #distance() {
    const [width, height] = this.#paneSize();
    const half = (fieldOfView * Math.PI) / 360;
    const narrow = Math.atan(Math.tan(half) * Math.min(1, width / Math.max(height, 1)));
    return 1.02 / Math.sin(Math.min(half, narrow));
  }

  #paneSize() {
    const { clientWidth, clientHeight } = this.element;
    const n = Math.max(this.views?.length ?? 1, 1);
    return this.isStacked() ? [clientWidth, clientHeight / n] : [clientWidth / n, clientHeight];
  }

  // one above the other where the window is higher than wide
  isStacked() {
    return this.element.clientHeight > this.element.clientWidth;
  }

  // of a surface, in CSS pixels: left, top, width, height
  pane(index) {
    const [width, height] = this.#paneSize();
    return this.isStacked() ? [0, index * height, width, height] : [index * width, 0, width, height];
  }

  requestRender() {
    this.pending ??= requestAnimationFrame(() => this.render());
  }

  render() {
    if (this.pending) cancelAnimationFrame(this.pending);
    this.pending = undefined;
    const { clientWidth, clientHeight } = this.element;
    if (clientWidth === 0 || clientHeight === 0) return;
    this.renderer.setPixelRatio(Math.min(devicePixelRatio, 2));
    this.renderer.setSize(clientWidth, clientHeight, false);
    this.renderer.setScissorTest(false);
    this.renderer.clear();
    this.renderer.setScissorTest(true);
    const [width, height] = this.#paneSize();
    this.camera.aspect = width / height;
    const distance = this.camera.position.distanceTo(this.controls.target);
    this.camera.near = Math.max(0.001, 0.02 * distance);
    this.camera.far = distance + this.controls.target.length() + 4;
    this.camera.updateProjectionMatrix();
    const pixels = (height * this.renderer.getPixelRatio()) / (2 * Math.tan((fieldOfView * Math.PI) / 360));
    this.scenes.forEach((scene, index) => {
      const [left, top] = this.pane(index);
      this.views[index].setPointSize(pixels);
      this.views[index].setCoarse(this.isMoving);
      this.renderer.setViewport(left, clientHeight - top - height, width, height);
      this.renderer.setScissor(left, clientHeight - top - height, width, height);
      this.renderer.render(scene, this.camera);
    });
    this.listeners?.forEach((listener) => listener());
  }

  // What is at a place of the window, see SurfaceView.pick(); with the index of the surface.
  pick(x, y) {
    for (let index = 0; index < this.views.length; ++index) {
      const [left, top, width, height] = this.pane(index);
      const at = new Vector2((2 * (x - left)) / width - 1, 1 - (2 * (y - top)) / height);
      if (Math.abs(at.x) > 1 || Math.abs(at.y) > 1) continue;
      const caster = new Raycaster();
      this.camera.updateMatrixWorld();
      caster.setFromCamera(at, this.camera);
      const pixel = (2 * Math.tan((fieldOfView * Math.PI) / 360)) / height;
      const hit = this.views[index].pick(caster.ray, pixel);
      return hit && { index, ...hit };
    }
    return null;
  }

  // where a vertex is seen, in CSS pixels
  placeOf(index, vertex) {
    const [left, top, width, height] = this.pane(index);
    this.camera.updateMatrixWorld();
    const p = new Vector3().fromArray(this.views[index].positions, 3 * vertex).project(this.camera);
    return [left + (width * (p.x + 1)) / 2, top + (height * (1 - p.y)) / 2];
  }
}
