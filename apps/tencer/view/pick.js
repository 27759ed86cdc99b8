// What is under the pointer, and what a click chooses.
import { drawnCables } from './cables.js';
import { arcLengthAt, cableNotes } from './data.js';
import { turnCamera } from './camera.js';
import { byId, change, element, page, seenDesign } from './page.js';
import { drawnRods } from './rods.js';
import { rodFields } from './colours.js';
import { lengthWithUnit, significant } from './units.js';
import { cableInWords, endName, placeInWords } from './words.js';
import { vector, world } from './world.js';

function cableDescription(design, i) {
  const cable = design.cables[i];
  return [cableInWords(i), `from ${endName(design, cable.a)}`, `to ${endName(design, cable.b)}`,
    `length ${lengthWithUnit(design, cable.length)}`,
    `tension ${significant(cable.tension, 3)} ${design.force_unit}`, ...cableNotes(design, i)];
}

// At the vertex of the rod nearest to a point of the pose.
function rodDescription(design, r, point) {
  const rod = design.rods[r];
  let vertex = 0;
  let least = Infinity;
  rod.pose.forEach((p, i) => {
    const distance = vector(p).distanceTo(point);
    if (distance < least) [least, vertex] = [distance, i];
  });
  const s = arcLengthAt(rod, vertex);
  return [placeInWords(design, r, s), ...Object.values(rodFields).map(({ title, values, say }) => {
    const known = values(design, rod);
    return `${title} ${known ? say(design, known[vertex]) : 'not known'}`;
  })];
}

const ray = new THREE.Raycaster();
function under(event) {
  if (page.stage >= 0) return null; // what is told is told of the design
  const frame = world.renderer.domElement.getBoundingClientRect();
  ray.setFromCamera({ x: (event.clientX - frame.left) / frame.width * 2 - 1,
    y: 1 - (event.clientY - frame.top) / frame.height * 2 }, world.camera);
  const cables = ray.intersectObjects(drawnCables.map(({ picked }) => picked));
  if (cables.length) return { cable: cables[0].object.userData.cable };
  const rods = ray.intersectObjects(drawnRods.map(({ mesh }) => mesh));
  if (!rods.length) return null;
  return { rod: rods[0].object.userData.rod, point: world.model.worldToLocal(rods[0].point.clone()) };
}

function showTip(event, found) {
  const tip = byId('tip');
  if (!found) return tip.style.display = 'none';
  const design = seenDesign();
  const lines = found.cable !== undefined ? cableDescription(design, found.cable)
    : rodDescription(design, found.rod, found.point);
  tip.replaceChildren(element('b', lines[0]), ...lines.slice(1).map((line) => element('div', line)));
  tip.style.display = 'block';
  const frame = byId('stage').getBoundingClientRect();
  const left = Math.min(event.clientX - frame.left + 16, frame.width - tip.offsetWidth - 8);
  const top = Math.min(event.clientY - frame.top + 16, frame.height - tip.offsetHeight - 8);
  tip.style.left = `${Math.max(left, 4)}px`;
  tip.style.top = `${Math.max(top, 4)}px`;
}

const cableOf = (found) => found && found.cable !== undefined ? { cable: found.cable } : null;

function hover(event) {
  const found = event.buttons ? null : under(event);
  world.renderer.domElement.style.cursor = found ? 'pointer' : 'grab';
  const cable = cableOf(found);
  if ((cable && cable.cable) !== (page.hovered && page.hovered.cable)) change({ hovered: cable });
  showTip(event, found);
}

// One finger turns from side to side, and scrolls the page up and down; two do what the mouse does.
function turnByOneFinger(canvas) {
  let last = null;
  canvas.addEventListener('touchstart', (event) => {
    if (event.touches.length === 1) event.stopImmediatePropagation();
  }, { capture: true, passive: true });
  canvas.addEventListener('touchmove', (event) => {
    if (event.touches.length === 1) event.stopImmediatePropagation();
  }, { capture: true, passive: true });
  canvas.addEventListener('pointerdown', (event) => {
    last = event.pointerType === 'touch' && event.isPrimary ? event.clientX : null;
  });
  canvas.addEventListener('pointermove', (event) => {
    if (last === null || event.pointerType !== 'touch' || !event.isPrimary) return;
    turnCamera((event.clientX - last) * 0.008, 0);
    last = event.clientX;
  });
  for (const end of ['pointerup', 'pointercancel'])
    canvas.addEventListener(end, () => { last = null; });
}

export function startPicking(scrollToRow) {
  const canvas = world.renderer.domElement;
  turnByOneFinger(canvas);
  canvas.addEventListener('pointermove', hover);
  canvas.addEventListener('pointerleave', (event) => {
    change({ hovered: null });
    showTip(event, null);
  });
  let pressed = null; // a drag is not a click
  canvas.addEventListener('pointerdown', (event) => { pressed = [event.clientX, event.clientY]; });
  canvas.addEventListener('pointerup', (event) => {
    if (!pressed || Math.hypot(event.clientX - pressed[0], event.clientY - pressed[1]) > 4) return;
    const found = under(event);
    change({ chosen: cableOf(found), hovered: null });
    showTip(event, found);
    if (page.chosen) scrollToRow(page.chosen.cable);
  });
}
