// Lengths in the unit that the reader chose, whatever the design's own.
import { page } from './page.js';

const metres = { mm: 1e-3, cm: 1e-2, m: 1, in: 0.0254 };
// A tenth of a millimetre is all that anyone cuts.
const unitDecimals = { mm: 1, cm: 2, m: 4, in: 3 };

export const lengthUnits = Object.keys(metres);

export function significant(value, digits) {
  if (value === null || value === undefined || Number.isNaN(value)) return 'not known';
  if (value === 0) return '0';
  return Math.abs(value) >= 1e5 || Math.abs(value) < 1e-3
    ? value.toExponential(digits - 1)
    : value.toLocaleString('en', { maximumSignificantDigits: digits, useGrouping: false });
}

// The unit that lengths of the design are shown in: its own where nobody knows how long that is.
export const unitOf = (design) => metres[design.length_unit] ? page.unit : design.length_unit;
export const inUnit = (design, value, unit = unitOf(design)) =>
  metres[design.length_unit] ? value * metres[design.length_unit] / metres[unit] : value;

// Without the unit, as in tables.
export const lengthText = (design, value) =>
  inUnit(design, value).toFixed(unitDecimals[unitOf(design)] ?? 3);
export const lengthWithUnit = (design, value) => `${lengthText(design, value)} ${unitOf(design)}`;

// Distances that are small beside the design, three digits: in mm, or in inches.
export const smallUnit = (design) =>
  !metres[design.length_unit] ? design.length_unit : page.unit === 'in' ? 'in' : 'mm';
export const smallLength = (design, value) =>
  `${significant(inUnit(design, value, smallUnit(design)), 3)} ${smallUnit(design)}`;

export const pointText = (design, point) => `(${point.map((x) => lengthText(design, x)).join(', ')})`;
export const massText = (grams) =>
  grams >= 1000 ? `${significant(grams / 1000, 3)} kg` : `${significant(grams, 3)} g`;
export const forceText = (value) => significant(value, 3);
export const percentText = (value) => `${significant(value, 3)} %`;
