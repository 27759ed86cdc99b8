// Vibrations, played: slowly, and so far that they are seen.
import { sizeOf } from './data.js';
import { bendCables } from './cables.js';
import { byId, change, onChange, page, seenDesign } from './page.js';
import { bendRods } from './rods.js';
import { significant } from './units.js';
import { draw, onEachFrame } from './world.js';

const seconds = 2.4; // of one swing to and fro

function showChoice() {
  const { modes } = seenDesign();
  const select = byId('mode');
  const options = [new Option('at rest', '-1')];
  ((modes && modes.hertz) || []).forEach((hertz, i) =>
    options.push(new Option(`vibration ${i + 1}: ${significant(hertz, 3)} Hz`, i)));
  select.replaceChildren(...options);
  select.value = String(page.mode);
  select.parentElement.hidden = options.length === 1;
}

let isBent = false;
function swing(time) {
  const design = seenDesign();
  const shape = page.mode >= 0 && design.modes ? design.modes.shapes[page.mode] : null;
  if (!shape) {
    if (isBent) {
      const still = design.rods.map((rod) => rod.pose.map(() => [0, 0, 0]));
      bendRods(still, 0);
      bendCables(still, 0);
    }
    isBent = false;
    return false;
  }
  isBent = true;
  const far = sizeOf(design) / 12 * Math.sin(2 * Math.PI * time / seconds);
  bendRods(shape, far);
  bendCables(shape, far);
  return true;
}

export function startModes() {
  byId('mode').onchange = (event) => change({ mode: Number(event.target.value) });
  onChange(['design', 'mode'], showChoice);
  onChange(['mode'], draw);
  onEachFrame(swing);
  showChoice();
}
