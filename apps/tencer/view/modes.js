// Vibrations, played slowly and so far that they are seen; and shoves of the check, as far as they go
// and by the way on which the simulation finds where the structure comes to rest.
import { sizeOf } from './data.js';
import { bendCables } from './cables.js';
import { byId, change, onChange, page, seenDesign } from './page.js';
import { bendRods, still } from './rods.js';
import { significant, smallLength } from './units.js';
import { draw, onEachFrame } from './world.js';

const seconds = 2.4; // of one swing to and fro
const shove = { out: 0.5, held: 0.5, step: 0.35, rest: 1.5 }; // seconds

function shoveInWords(design, { size, smooth, rests, away, back }) {
  const end = back ? 'it comes back'
    : rests ? `it comes to rest ${smallLength(design, away)} away` : 'where it comes to rest was not found';
  return `${smooth ? 'smooth' : 'rough'} shove of ${smallLength(design, size)}: ${end}`;
}

function showChoice() {
  const design = seenDesign();
  const options = ['at rest',
    ...design.modes.hertz.map((hertz, i) => `vibration ${i + 1}: ${significant(hertz, 3)} Hz`),
    ...design.shoves.map((one) => shoveInWords(design, one))];
  const select = byId('mode');
  select.replaceChildren(...options.map((text, i) => new Option(text, i - 1)));
  select.value = String(page.mode);
  select.parentElement.hidden = options.length === 1;
}

// Out into the first shape, then through all of them.
function shoved(design, { shapes }, time) {
  const last = shapes.length - 1;
  const { out, held, step, rest } = shove;
  const t = time % (out + held + step * last + rest);
  const at = t < out ? t / out - 1 : Math.min(Math.max(t - out - held, 0) / step, last);
  const before = Math.floor(at);
  const [from, to] = [shapes[before] || still(design), shapes[Math.min(before + 1, last)]];
  return from.map((rod, r) => rod.map((point, i) =>
    point.map((x, axis) => x + (at - before) * (to[r][i][axis] - x))));
}

let isBent = false;
function swing(time) {
  const design = seenDesign();
  const { modes, shoves } = design;
  const vibrations = modes.hertz.length;
  const show = (shape, times) => {
    bendRods(shape, times);
    bendCables(shape, times);
  };
  const moves = page.mode >= 0;
  if (page.mode >= vibrations) show(shoved(design, shoves[page.mode - vibrations], time), 1);
  else if (moves)
    show(modes.shapes[page.mode], sizeOf(design) / 12 * Math.sin(2 * Math.PI * time / seconds));
  else if (isBent && page.pose === 0) show(still(design), 0);
  isBent = moves;
  return moves;
}

export function startModes() {
  byId('mode').onchange = (event) => change({ mode: Number(event.target.value) });
  onChange(['design', 'mode', 'unit'], showChoice);
  onChange(['mode'], draw);
  onEachFrame(swing);
  showChoice();
}
