// Vibrations, and a shove that dies out, played: slowly, and so far that they are seen.
import { sizeOf } from './data.js';
import { bendCables } from './cables.js';
import { byId, change, onChange, page, seenDesign } from './page.js';
import { bendRods } from './rods.js';
import { significant } from './units.js';
import { draw, onEachFrame } from './world.js';

const seconds = 2.4; // of one swing to and fro, of the slowest
const dying = 3; // seconds in which a shove loses two thirds
const again = 4 * dying; // then it is given again

function showChoice() {
  const { modes } = seenDesign();
  const select = byId('mode');
  const options = [new Option('at rest', '-1')];
  ((modes && modes.hertz) || []).forEach((hertz, i) =>
    options.push(new Option(`vibration ${i + 1}: ${significant(hertz, 3)} Hz`, i)));
  if (options.length > 1) options.push(new Option('a shove, let go', modes.hertz.length));
  select.replaceChildren(...options);
  select.value = String(page.mode);
  select.parentElement.hidden = options.length === 1;
}

// All vibrations let go together, each at its own pace and with as much energy as the others.
function shoved({ hertz, shapes }, time) {
  const given = time % again;
  const parts = hertz.map((own) => hertz[0] / own / hertz.length * Math.exp(-given / dying) *
    Math.cos(2 * Math.PI * own / hertz[0] * given / seconds));
  return shapes[0].map((rod, r) => rod.map((point, i) => point.map((x, axis) =>
    parts.reduce((sum, part, k) => sum + part * shapes[k][r][i][axis], 0))));
}

let isBent = false;
function swing(time) {
  const design = seenDesign();
  const { modes } = design;
  const isShove = modes && page.mode === modes.hertz.length && page.mode > 0;
  const shape = isShove ? shoved(modes, time)
    : page.mode >= 0 && modes ? modes.shapes[page.mode] : null;
  if (!shape) {
    if (isBent && page.pose === 0) {
      const still = design.rods.map((rod) => rod.pose.map(() => [0, 0, 0]));
      bendRods(still, 0);
      bendCables(still, 0);
    }
    isBent = false;
    return false;
  }
  isBent = true;
  const far = sizeOf(design) / 12 * (isShove ? 2 : Math.sin(2 * Math.PI * time / seconds));
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
