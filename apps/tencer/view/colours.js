// Colours of things, and of what is told along them.
import { inUnit, significant, smallLength, smallUnit, unitOf } from './units.js';

const rodColours = [0x3f7cc4, 0x2fa37c, 0x8a68c8, 0x64859e, 0xb99338, 0xb7648c];
export const rodColour = (rod) => new THREE.Color(rodColours[rod % rodColours.length]);
export const overColour = 0xe0559b; // of a design laid over another

// Stops from least to most.
const ramps = {
  pull: [0xf2a93b, 0xe4572e, 0xa80f4a],
  size: [0x3b4fa8, 0x1f94a8, 0x45b36b, 0xe8d03a],
  sign: [0x2b6cc4, 0xb9c0c8, 0xc9352b],
};
const rampColours = (ramp) => ramps[ramp].map((hex) => new THREE.Color(hex));

// A ramp from `low` to `high`; logarithmic where asked for, of what is above zero.
export class ColourScale {
  constructor(ramp, low, high, isLogarithmic = false) {
    Object.assign(this, { low, high, isLogarithmic, stops: rampColours(ramp) });
  }
  at(value) {
    const last = this.stops.length - 1;
    const scaled = (x) => this.isLogarithmic ? Math.log(Math.max(x, this.low)) : x;
    const part = this.high > this.low
      ? (scaled(value) - scaled(this.low)) / (scaled(this.high) - scaled(this.low)) : 0.5;
    const place = Math.min(Math.max(part, 0), 1) * last;
    const first = Math.min(Math.floor(place), last - 1);
    return this.stops[first].clone().lerp(this.stops[first + 1], place - first);
  }
  gradient() {
    return `linear-gradient(to right, ${this.stops.map((colour) => colour.getStyle()).join(', ')})`;
  }
}

// What rods can be coloured by: a value a vertex, and how it is said.
export const rodFields = {
  deviation: {
    title: 'deviation from the target',
    values: (design, rod) => rod.deviation.map((v) => Math.hypot(...v)),
    say: (design, value) => smallLength(design, value),
  },
  strain: {
    title: 'bending strain',
    values: (design, rod) => rod.strain,
    say: (design, value) => `${significant(100 * value, 3)} %`,
  },
  curvature: {
    title: 'curvature',
    values: (design, rod) => rod.curvature,
    say: (design, value) => `${significant(1 / inUnit(design, 1 / value), 3)} / ${unitOf(design)}`,
  },
  tension: {
    title: 'tension along the rod',
    values: (design, rod) => rod.tension,
    say: (design, value) => `${significant(value, 3)} ${design.force_unit}`,
    signed: true,
  },
};

// The scale for all rods of a design; null: nothing is known.
export function fieldScale(design, name) {
  const field = rodFields[name];
  const all = design.rods.flatMap((rod) => field.values(design, rod) || []);
  if (!all.length) return null;
  const high = all.reduce((a, b) => Math.max(a, b), -Infinity);
  const low = all.reduce((a, b) => Math.min(a, b), Infinity);
  if (!field.signed) return new ColourScale('size', 0, high);
  const most = Math.max(Math.abs(low), Math.abs(high));
  return new ColourScale('sign', -most, most);
}

export function tensionScale(design) {
  const tensions = design.cables.map((cable) => cable.tension);
  const low = Math.min(...tensions);
  const high = Math.max(...tensions);
  return new ColourScale('pull', low, high, low > 0 && high > 50 * low);
}
