// Copyright (c) 2026 The Restricted_laplacian_3 developers
// SPDX-License-Identifier: GPL-3.0-or-later

// Which colors show which values: as color_map.h of the programs has it. Lightness is about linear in
// all maps, so equal differences look equally large, also to who cannot tell red from green.

export const colorMaps = {
  diverging: [[3, 70, 163], [45, 116, 195], [85, 162, 225], [166, 202, 235], [242, 242, 242],
    [243, 180, 167], [234, 115, 93], [190, 68, 58], [146, 8, 23]],
  sequential: [[51, 16, 92], [53, 51, 118], [44, 82, 145], [44, 116, 147], [44, 148, 146],
    [76, 179, 127], [108, 209, 97], [190, 225, 83], [255, 239, 56]],
  gray: [[20, 20, 20], [46, 46, 46], [74, 74, 74], [102, 102, 102], [130, 130, 130],
    [160, 160, 160], [190, 190, 190], [220, 220, 220], [250, 250, 250]],
};

export const colorOfNothing = [187, 187, 187];

// the color of t from 0 to 1, in bytes
export function colorAt(name, t) {
  const map = colorMaps[name];
  const x = Math.min(Math.max(t, 0), 1) * (map.length - 1);
  const i = Math.min(Math.floor(x), map.length - 2);
  return map[i].map((low, k) => low + (x - i) * (map[i + 1][k] - low));
}

// the texture of a map: `size` colors, four bytes each
export function colorTable(name, size) {
  const table = new Uint8Array(4 * size);
  for (let i = 0; i < size; ++i)
    table.set([...colorAt(name, i / (size - 1)).map(Math.round), 255], 4 * i);
  return table;
}

// The range that colors and the color bar show: symmetric around 0 for diverging colors.
export function shownRange(range, mapName) {
  let [low, high] = range;
  if (mapName === 'diverging') {
    high = Math.max(Math.abs(low), Math.abs(high));
    low = -high;
  }
  // a difference this small, relative to the values, is rounding: a constant is painted evenly
  const largest = Math.max(Math.abs(low), Math.abs(high));
  const smallest = 1e-290; // differences below lose digits
  if (high / 2 - low / 2 > Math.max(0.5e-9 * largest, smallest)) return [low, high];
  return [low, low + (largest > 1e9 * smallest ? 1e-9 * largest : 1)];
}

// where a value lies in a range, from 0 to 1; the halves do not overflow
export function fractionOf(value, [low, high]) {
  return (value / 2 - low / 2) / (high / 2 - low / 2);
}

export function defaultMap(range) {
  const [low, high] = range;
  return (low < 0 && high > 0) || (low === 0 && high === 0) ? 'diverging' : 'sequential';
}

// about `number` levels at round numbers in a range, and the distance between them
export function roundLevels([low, high], number) {
  const raw = high / number - low / number;
  const power = 10 ** Math.floor(Math.log10(raw));
  const step = power * [1, 2, 5, 10].find((factor) => factor * power >= 0.999 * raw);
  const levels = [];
  for (let k = Math.ceil(low / step - 1e-9); (k - 1e-9) * step <= high; ++k) levels.push(k * step);
  return { step, levels };
}

export function formatted(x, digits = 4) {
  if (Number.isNaN(x)) return 'no value';
  if (!Number.isFinite(x)) return x > 0 ? '∞' : '−∞';
  const isSmall = x !== 0 && Math.abs(x) < 1e-3;
  const rounded = Number(x.toPrecision(digits)); // has no trailing zeros
  return (isSmall ? rounded.toExponential() : String(rounded)).replaceAll('-', '−');
}
