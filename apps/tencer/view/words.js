// What rods, cables and places are called: a twin of tencer/core/names.hpp. Rods go by letters, so
// that they are not taken for the cables' numbers; the only one needs none.
import { lengthText } from './units.js';

export const rodName = (rod) =>
  (rod >= 26 ? rodName(Math.floor(rod / 26) - 1) : '') + String.fromCharCode(65 + rod % 26);
export const anchorName = (anchor) => `anchor ${anchor + 1}`;
export const cableInWords = (cable) => `cable ${cable + 1}`;
export const rodInWords = (design, rod) =>
  design.rods.length === 1 ? 'the rod' : `rod ${rodName(rod)}`;
export const placeInWords = (design, rod, s) =>
  design.rods.length === 1 ? `${lengthText(design, s)} along the rod`
    : `${rodName(rod)} at ${lengthText(design, s)}`;
export const endName = (design, end) =>
  end.anchor === undefined ? placeInWords(design, end.rod, end.s) : anchorName(end.anchor);

export const designName = (design) => design.name || 'tencer design';
// Designs of one name are told apart by their number of cables.
export const designInWords = (design) =>
  `${designName(design)}, ${design.cables.length} ${design.cables.length === 1 ? 'cable' : 'cables'}`;
