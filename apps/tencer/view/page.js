// What the page shows just now, and who is told when that changes.
import { designs, firstDesign } from './data.js';

export const page = {
  design: firstDesign, // which one is seen
  over: -1, // another one laid over it; -1: none
  unit: ['mm', 'cm', 'm'].includes(designs[firstDesign].length_unit)
    ? designs[firstDesign].length_unit : 'mm',
  chosen: null, // {cable}, {closest} or {crossing}, an index, kept until something else is chosen
  hovered: null, // the same, under the pointer
  colour: 'plain', // of rods: plain, or a vertex field
  targets: true,
  vectors: false,
  thick: true, // rods as thick as they are
  labels: true,
  supports: true,
  directors: false,
  mode: -1, // the vibration that is played, or further on the shove; -1: none
  pose: 0, // of those that the structure goes through
  stage: -1, // of the search; -1: the design
};

const listeners = [];

// Calls `act` once for each change of some of these keys.
export function onChange(keys, act) { listeners.push({ keys, act }); }

export function change(values) {
  const changed = Object.keys(values).filter((key) => page[key] !== values[key]);
  Object.assign(page, values);
  if (!changed.length) return;
  for (const { keys, act } of listeners) if (keys.some((key) => changed.includes(key))) act();
}

export const seenDesign = () => designs[page.design];
export const seenStage = () => page.stage < 0 ? null : seenDesign().stages[page.stage];
export const see = (index) => change({ design: index, over: page.over === index ? -1 : page.over,
  chosen: null, hovered: null, mode: -1, pose: 0, stage: -1 });

// What is to be set off: under the pointer, else what was chosen. `kind`: cable, closest or crossing.
export const markedIndex = (kind) => (page.hovered || page.chosen || {})[kind] ?? -1;

export const byId = (id) => document.getElementById(id);

export function element(tag, text, className) {
  const result = document.createElement(tag);
  if (text !== undefined) result.textContent = text;
  if (className) result.className = className;
  return result;
}
