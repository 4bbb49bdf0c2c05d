// Loads the core as the page does, from the bundle in DIST, and helps to draw with it.
import { readFileSync } from 'node:fs';
import { runInThisContext } from 'node:vm';

/** Returns createCore of the bundle, whose cores have the full module, unless the option `isFirst` is set. */
export function load_core(dist) {
  const load = (name, global) => runInThisContext(`${readFileSync(`${dist}/${name}`, 'utf8')}\nglobalThis.${global} = ${global};`,
    { filename: name });
  load('core.js', 'feltlineCore');
  const loadScript = async (name) => load(name, name === 'core_full.js' ? 'feltlineFull' : 'feltlineFelt');
  return async ({ isFirst = false, ...options } = {}) => {
    const core = await globalThis.feltlineCore.createCore({ loadScript, ...options });
    if (!isFirst) {
      const { ok, error } = await core.complete();
      if (!ok) throw new Error(error);
    }
    return core;
  };
}

/** Packs samples { time, x, y, touching, pressure, tilt } for core.samples(). */
export function packed(samples) {
  return Float64Array.from(samples.flatMap(({ time, x, y, touching = true, pressure = NaN, tilt = [NaN, NaN], keys = 0 }) =>
    [time, x, y, touching ? 1 : 0, pressure, ...tilt, keys]));
}

/** Draws a path of [x, y] points, one every 4 ms from `time` on, in frames of 16 ms. Returns the time after it. */
export function draw(core, path, time, more = {}) {
  const samples = [{ time, x: path[0][0], y: path[0][1], touching: false }];
  path.forEach(([x, y], i) => samples.push({ time: time + 4 + 4 * i, x, y, ...more }));
  const end = time + 4 * path.length + 4;
  samples.push({ time: end, x: path.at(-1)[0], y: path.at(-1)[1], touching: false });
  for (let from = 0; from < samples.length; from += 4) {
    const part = samples.slice(from, from + 4);
    core.samples(packed(part));
    core.advance(part.at(-1).time + 1);
    core.paint();
  }
  core.advance(end + 60);
  core.paint();
  return end + 60;
}

/** A line that swings from (x, y). */
export const wave = (x, y, count = 80) =>
  Array.from({ length: count }, (_, i) => [x + 3 * i, y + 30 * Math.sin(i / 9)]);

/** Returns whether there is ink at a pixel of white paper. */
export function has_ink(core, x, y) {
  const { data, width } = core.pixels();
  const at = 4 * (Math.round(y) * width + Math.round(x));
  return data[at] + data[at + 1] + data[at + 2] < 740;
}

export const text_of = (bytes) => new TextDecoder().decode(bytes);

/** A generator of random numbers 0..1 that gives the same numbers everywhere. */
export function random_of(seed) {
  let state = seed >>> 0;
  return () => {
    state = (Math.imul(state, 1664525) + 1013904223) >>> 0;
    return state / 2 ** 32;
  };
}
