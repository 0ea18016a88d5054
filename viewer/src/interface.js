// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

// What lies around the canvas: title, color bar, slider, options, keys, and the reading under the pointer.

import { colorAt, formatted, fractionOf, roundLevels } from './colors.js';

function element(tag, properties = {}, ...children) {
  const result = Object.assign(document.createElement(tag), properties);
  result.append(...children);
  return result;
}

// what the mouse and keys do, for the help
const mouseAndArrows = [
  ['drag', 'turn'],
  ['right drag, shift drag', 'move'],
  ['wheel, pinch', 'zoom'],
  ['← →', 'the field before, the next'],
];

export class Interface {
  constructor(scene, stage) {
    this.scene = scene;
    this.stage = stage;
    this.state = {
      field: scene.first ?? 0, map: 'auto', range: null, isolines: scene.isolines ?? 0,
      light: true, flat: false, wireframe: false, boundary: false, points: false,
      dark: matchMedia('(prefers-color-scheme: dark)').matches,
    };
    this.numberOfFields = Math.max(0, ...scene.surfaces.map((s) => s.fields.length));
    document.title = scene.title;
    this.#addHeader();
    this.#addTools();
    this.#addFooter();
    this.#addReading();
    document.addEventListener('keydown', (event) => this.#key(event));
    this.update();
  }

  set(changes) {
    Object.assign(this.state, changes);
    this.update();
  }

  setField(index) {
    this.set({ field: Math.min(Math.max(index, 0), this.numberOfFields - 1), range: null });
  }

  fieldOf(surface) {
    return surface.fields[Math.min(this.state.field, surface.fields.length - 1)] ?? null;
  }

  // One range for all surfaces: colors mean the same on all of them.
  #sharedRange() {
    if (this.state.range) return this.state.range;
    const ranges = this.scene.surfaces.map((s) => this.fieldOf(s)).filter((f) => f && !f.colors).map((f) => f.range);
    return ranges.length > 0
      ? [Math.min(...ranges.map((r) => r[0])), Math.max(...ranges.map((r) => r[1]))] : null;
  }

  update() {
    const { state, stage } = this;
    document.documentElement.classList.toggle('dark', state.dark);
    const range = this.#sharedRange();
    const ink = state.dark ? '#ffffff' : '#000000';
    for (const view of stage.views) {
      const field = this.fieldOf(view.surface);
      view.setField(field, { map: state.map, range });
      const step = state.isolines > 0 && view.range ? roundLevels(view.range, state.isolines).step : 0;
      view.setLevels(step);
      view.setLit(state.light);
      view.setFlat(state.flat);
      view.setPoints(state.points);
      view.setEdges('all', state.wireframe, ink);
      view.setEdges('boundary', state.boundary, '#e0218a');
      view.setEdges('nonManifold', state.boundary, '#ff8c00');
    }
    for (const [name, button] of Object.entries(this.toggles)) button.setAttribute('aria-pressed', state[name]);
    this.mapChoice.value = state.map;
    this.isolines.value = state.isolines;
    this.#updateBar();
    if (this.slider) {
      this.slider.value = state.field;
      const names = this.scene.surfaces.map((s) => this.fieldOf(s)?.name);
      this.sliderLabel.textContent = names.find(Boolean) ?? '';
      this.slider.setAttribute('aria-valuetext', this.sliderLabel.textContent);
    }
    stage.requestRender();
  }

  #addHeader() {
    const header = element('header', {}, element('h1', { textContent: this.scene.title }));
    const counts = this.scene.surfaces.map((s) => {
      const number = (n, what) => `${n.toLocaleString('en-US')} ${what}${n === 1 ? '' : 's'}`;
      const text = s.numberOfFaces > 0 ? number(s.numberOfFaces, 'triangle') : number(s.numberOfVertices, 'point');
      return s.leftOut > 0 ? `${text}, ${s.leftOut.toLocaleString('en-US')} left out: no finite place` : text;
    });
    header.append(element('p', { textContent: counts.join(' · ') }));
    document.body.append(header);
    if (this.scene.surfaces.length < 2) return;
    const names = this.scene.surfaces.map((s) => element('div', { className: 'name', textContent: s.name }));
    document.body.append(...names);
    this.stage.listeners.push(() => names.forEach((name, i) => {
      const [left, top, width] = this.stage.pane(i);
      name.style.left = `${left + width / 2}px`;
      name.style.top = `${Math.max(top + 4, 66)}px`; // below the title
    }));
  }

  #toggle(name, label, key) {
    const button = element('button', {
      type: 'button', textContent: label, title: `${label} (key ${key})`,
      onclick: () => this.set({ [name]: !this.state[name] }),
    });
    this.toggles[name] = button;
    this.keys[key] = button.onclick;
    this.explained.push([key, label.toLowerCase()]);
    return button;
  }

  #action(label, key, act) {
    this.keys[key] = act;
    this.explained.push([key, label.toLowerCase()]);
    return element('button', { type: 'button', textContent: label, title: `${label} (key ${key})`, onclick: act });
  }

  #addTools() {
    this.toggles = {};
    this.explained = [...mouseAndArrows];
    this.keys = { ArrowRight: () => this.setField(this.state.field + 1), ArrowLeft: () => this.setField(this.state.field - 1) };
    this.mapChoice = element('select', { id: 'map', onchange: () => this.set({ map: this.mapChoice.value }) },
      ...[['auto', 'automatic'], ['sequential', 'sequential'], ['diverging', 'symmetric'], ['gray', 'gray']]
        .map(([value, textContent]) => element('option', { value, textContent })));
    this.isolines = element('input', {
      type: 'range', id: 'isolines', min: 0, max: 50, step: 1,
      oninput: () => this.set({ isolines: Number(this.isolines.value) }),
    });
    this.range = element('input', {
      type: 'text', id: 'range', placeholder: 'all values', title: 'two numbers, or nothing',
      onchange: () => {
        const numbers = this.range.value.trim().split(/[\s,;]+/).map(Number);
        const isRange = numbers.length === 2 && numbers.every(Number.isFinite) && numbers[0] < numbers[1];
        this.set({ range: isRange ? numbers : null });
        if (!isRange) this.range.value = '';
      },
    });
    const toggles = [
      this.#toggle('wireframe', 'Edges', 'w'), this.#toggle('boundary', 'Boundary', 'b'),
      this.#toggle('points', 'Vertices', 'v'), this.#toggle('flat', 'Flat faces', 'f'),
      this.#toggle('light', 'Light', 'l'), this.#toggle('dark', 'Dark', 'd'),
      this.#action('Reset view', 'r', () => this.stage.resetCamera()),
      this.#action('Other axis up', 'u', () => this.stage.resetCamera(this.stage.up === 'y' ? 'z' : 'y')),
      this.#action('Save picture', 's', () => this.savePicture()),
    ];
    this.options = element('div', { id: 'options', className: 'panel', hidden: true },
      element('label', { htmlFor: 'map', textContent: 'Colors' }), this.mapChoice,
      element('label', { htmlFor: 'range', textContent: 'Range' }), this.range,
      element('label', { htmlFor: 'isolines', textContent: 'Isolines' }), this.isolines,
      element('div', { className: 'wide' }, ...toggles));
    this.help = element('div', { id: 'help', className: 'panel', hidden: true });
    const opener = (label, key, panel, other) => {
      const button = this.#action(label, key, () => {
        panel.hidden = !panel.hidden;
        other().hidden = true;
        for (const [b, p] of [[this.optionsButton, this.options], [this.helpButton, this.help]])
          b.setAttribute('aria-expanded', !p.hidden);
      });
      button.setAttribute('aria-expanded', false);
      return button;
    };
    this.optionsButton = opener('Options', 'o', this.options, () => this.help);
    this.helpButton = opener('?', 'h', this.help, () => this.options);
    this.helpButton.title = 'Mouse and keys (key h)';
    this.helpButton.setAttribute('aria-label', 'Mouse and keys');
    this.keys['?'] = this.helpButton.onclick;
    this.keys.i = () => this.set({ isolines: this.state.isolines > 0 ? 0 : 15 });
    this.explained.push(['i', 'isolines']);
    const list = element('dl');
    for (const [key, what] of this.explained)
      if (what !== '?') list.append(element('dt', {}, element('kbd', { textContent: key })), element('dd', { textContent: what }));
    this.help.append(list);
    document.body.append(element('div', { id: 'tools' },
      element('div', {}, this.optionsButton, ' ', this.helpButton), this.options, this.help));
  }

  #addFooter() {
    this.barCanvas = element('canvas', { width: 256, height: 1 });
    this.caption = element('div', { className: 'caption' });
    this.ticks = element('div', { className: 'ticks' });
    this.bar = element('div', { id: 'bar' }, this.caption, this.barCanvas, this.ticks);
    const footer = element('footer', {}, this.bar);
    if (this.numberOfFields > 1) {
      this.slider = element('input', {
        type: 'range', id: 'field', min: 0, max: this.numberOfFields - 1, step: 1,
        oninput: () => this.setField(Number(this.slider.value)),
      });
      this.sliderLabel = element('label', { htmlFor: 'field' });
      const step = (label, name, by) => element('button', {
        type: 'button', textContent: label, ariaLabel: name, onclick: () => this.setField(this.state.field + by),
      });
      footer.append(element('div', { id: 'fields' }, this.sliderLabel,
        element('div', { className: 'row' }, step('‹', 'the field before', -1), this.slider, step('›', 'the next field', 1))));
    }
    document.body.append(footer);
    new ResizeObserver(() => this.#updateBar()).observe(this.bar);
  }

  #updateBar() {
    const view = this.stage.views.find((v) => v.field && !v.field.colors);
    this.bar.hidden = !view;
    if (!view) return;
    const context = this.barCanvas.getContext('2d');
    for (let i = 0; i < 256; ++i) {
      context.fillStyle = `rgb(${colorAt(view.mapName, i / 255).join(' ')})`;
      context.fillRect(i, 0, 1, 1);
    }
    const [low, high] = view.range;
    this.caption.textContent = view.field.name;
    this.caption.hidden = Boolean(this.slider);
    // both ends, and round numbers with room between them
    const room = Math.max(1, Math.floor(this.bar.clientWidth / 90));
    const { step, levels } = roundLevels(view.range, room);
    // digits that tell one number from the next
    const digits = Math.min(12, Math.max(1, 1 + Math.ceil(Math.log10(Math.max(Math.abs(low), Math.abs(high)) / step))));
    const label = (level, t) => [t, formatted(level, t === 0 || t === 1 ? Math.max(digits, 3) : digits)];
    const ends = [label(low, 0), label(high, 1)];
    const longest = Math.max(...ends.map(([, words]) => words.length));
    const inner = levels.map((level) => label(level, fractionOf(level, view.range)))
      .filter(([t, words]) => Math.min(t, 1 - t) * this.bar.clientWidth > 7.5 * (longest + words.length / 2 + 1));
    this.ticks.replaceChildren(...[ends[0], ...inner, ends[1]].map(([t, textContent]) => {
      const isEnd = t === 0 || t === 1;
      const tick = element('span', { textContent });
      tick.style.left = `${100 * t}%`;
      tick.style.transform = isEnd ? `translateX(${-100 * t}%)` : '';
      return tick;
    }));
  }

  #addReading() {
    this.reading = element('div', { id: 'reading', className: 'panel', hidden: true });
    this.reading.setAttribute('role', 'status');
    document.body.append(this.reading);
    const { canvas } = this.stage;
    let pending = null;
    const read = (event) => {
      if (event.pointerType === 'mouse' && event.buttons !== 0) {
        this.reading.hidden = true;
        return;
      }
      const isFirst = pending === null;
      pending = [event.clientX, event.clientY];
      if (isFirst) requestAnimationFrame(() => {
        this.read(...pending);
        pending = null;
      });
    };
    canvas.addEventListener('pointermove', read);
    canvas.addEventListener('pointerup', read);
    canvas.addEventListener('pointerleave', () => { this.reading.hidden = true; });
  }

  // Shows what is at a place of the window.
  read(x, y) {
    const hit = this.stage.pick(x, y);
    this.reading.hidden = !hit;
    if (!hit) return;
    const lines = [];
    if (hit.value !== undefined) lines.push(element('b', { textContent: formatted(hit.value, 6) }), element('br'));
    if (hit.color) lines.push(element('b', { textContent: `red, green, blue ${hit.color.join(', ')}` }), element('br'));
    lines.push(`at ${hit.position.map((c) => formatted(c, 5)).join(', ')}`, element('br'), `vertex ${hit.vertex}`);
    if (hit.vertexValue !== undefined) lines.push(`: ${formatted(hit.vertexValue, 7)}`);
    this.reading.replaceChildren(...lines);
    const { offsetWidth, offsetHeight } = this.reading;
    this.reading.style.left = `${Math.max(4, Math.min(x + 14, innerWidth - offsetWidth - 4))}px`;
    this.reading.style.top = `${Math.max(4, y - offsetHeight - 14)}px`;
  }

  savePicture() {
    this.stage.render();
    const link = element('a', { href: this.stage.canvas.toDataURL('image/png'), download: `${this.scene.title}.png` });
    link.click();
  }

  #key(event) {
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    if (event.target instanceof HTMLInputElement && (event.target.type === 'text' || event.key.startsWith('Arrow'))) return;
    const act = this.keys[event.key.length === 1 ? event.key.toLowerCase() : event.key];
    if (!act) return;
    if (event.target instanceof HTMLSelectElement) return;
    act();
    event.preventDefault();
  }
}
