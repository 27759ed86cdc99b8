// Labels over the drawing. One that would cover another tries the next of its places, and is left
// out when none is free; what is chosen comes first.
import { cableLabel, drawnCables, markedCables } from './cables.js';
import { byId, element, onChange, page, seenDesign } from './page.js';
import { anchorName, rodName } from './words.js';
import { draw, onFrame, vector, world } from './world.js';

let labels = []; // {span, places, cable, width, height}

function addLabel(text, places, className, cable = -1) {
  const span = element('span', text, className);
  byId('labels').append(span);
  labels.push({ span, places, cable, className, width: span.offsetWidth, height: span.offsetHeight });
}

function makeLabels() {
  const design = seenDesign();
  byId('labels').replaceChildren();
  labels = [];
  drawnCables.forEach(({ a, b }, i) =>
    addLabel(cableLabel(design, i), [0.5, 0.38, 0.62, 0.27, 0.73].map((t) => a.clone().lerp(b, t)),
      cableLabel(design, i) === String(i + 1) ? '' : 'least', i));
  design.rods.forEach((rod, r) => addLabel(design.rods.length > 1 ? rodName(r) : 'start',
    [vector(rod.pose[0])], 'rod'));
  if (page.supports) design.anchors.forEach((p, i) => addLabel(anchorName(i), [vector(p)], 'anchor'));
  draw();
}

const isMoving = ({ cable }) => page.mode >= 0 && cable >= 0;

function placeLabels() {
  const { clientWidth: width, clientHeight: height } = world.renderer.domElement;
  const marked = markedCables();
  const taken = [];
  const isFree = (box) => !taken.some((other) => box.left < other.right && other.left < box.right &&
    box.top < other.bottom && other.top < box.bottom);
  const order = [...labels].sort((a, b) => marked.includes(b.cable) - marked.includes(a.cable));
  for (const label of order) {
    const { span } = label;
    const places = page.stage >= 0 && label.cable >= 0 ? [] : label.places; // a stage has others
    const isMarked = label.cable >= 0 && marked.includes(label.cable);
    span.className = `${label.className}${isMarked ? ' chosen' : ''}`;
    let found = null;
    // What swings takes its label along.
    for (const place of isMoving(label) ? [drawnCables[label.cable].shown.position] : places) {
      const p = world.model.localToWorld(place.clone()).project(world.camera);
      if (Math.abs(p.z) >= 1) continue;
      if (Math.abs(p.x) > 1 || Math.abs(p.y) > 1) continue;
      const within = (at, size, most) => Math.min(Math.max(at - size / 2, 2), most - size - 2);
      const x = within((p.x + 1) / 2 * width, label.width, width);
      const y = within((1 - p.y) / 2 * height, label.height, height);
      const box = { left: x, top: y, right: x + label.width, bottom: y + label.height };
      if (!found && isFree(box)) found = box;
    }
    span.style.visibility = found && page.labels ? 'visible' : 'hidden';
    if (!found) continue;
    taken.push(found);
    span.style.transform = `translate(${found.left}px, ${found.top}px)`;
  }
}

// For a picture of the view: what is written where.
export function labelsForPicture() {
  const stage = byId('stage').getBoundingClientRect();
  return labels.filter(({ span }) => span.style.visibility === 'visible').map(({ span }) => {
    const box = span.getBoundingClientRect();
    return { text: span.textContent, x: box.left - stage.left + box.width / 2,
      y: box.top - stage.top + box.height / 2, width: box.width, height: box.height };
  });
}

export function startLabels() {
  onChange(['design', 'supports'], makeLabels);
  onChange(['labels'], draw);
  onFrame(placeLabels);
  makeLabels();
}
