// Cables, coloured by tension; the chosen one is set off.
import { endPoint, leastTaut, pointAt, sizeOf } from './data.js';
import { tensionScale } from './colours.js';
import { markedIndex, onChange, page, seenDesign } from './page.js';
import { drawnRadius } from './rods.js';
import { draw, showGroup, vector } from './world.js';

function cylinder(radius, material) {
  return new THREE.Mesh(new THREE.CylinderBufferGeometry(radius, radius, 1, 10, 1), material);
}

function stretch(mesh, a, b) {
  const span = b.clone().sub(a);
  mesh.scale.y = span.length() || 1e-9;
  mesh.position.copy(a).addScaledVector(span, 0.5);
  mesh.quaternion.setFromUnitVectors(new THREE.Vector3(0, 1, 0), span.normalize());
}

// A cable between two points.
export function cableBetween(a, b, radius, color) {
  const mesh = cylinder(radius, new THREE.MeshBasicMaterial({ color }));
  stretch(mesh, a, b);
  return mesh;
}

// All cables of a design as plain lines.
export function cableLines(design, color) {
  const points = design.cables.flatMap((cable) =>
    [vector(endPoint(design, cable.a)), vector(endPoint(design, cable.b))]);
  return new THREE.LineSegments(new THREE.BufferGeometry().setFromPoints(points),
    new THREE.LineBasicMaterial({ color }));
}

export const drawnCables = []; // {shown, picked, a, b}, one a cable

// Thinner than rods, and still seen.
export function cableRadius(design) {
  const size = sizeOf(design);
  const thinnest = Math.min(...design.rods.map((rod) => drawnRadius(design, rod)));
  return Math.min(Math.max(0.5 * thinnest, size / 1100), size / 500);
}

function showCables() {
  const design = seenDesign();
  const size = sizeOf(design);
  const scale = tensionScale(design);
  const radius = cableRadius(design);
  drawnCables.length = 0;
  design.cables.forEach((cable, i) => {
    const a = vector(endPoint(design, cable.a));
    const b = vector(endPoint(design, cable.b));
    const shown = cableBetween(a, b, radius, scale.at(cable.tension));
    // Wide enough to hit with a pointer.
    const picked = cylinder(size / 90, new THREE.MeshBasicMaterial({ visible: false }));
    picked.userData.cable = i;
    stretch(picked, a, b);
    drawnCables.push({ shown, picked, a, b });
  });
  showGroup('cables', drawnCables.flatMap(({ shown, picked }) => [shown, picked]));
  markCables();
}

// The cables that the chosen thing is about: itself, or those of a near pair.
export function markedCables() {
  const cable = markedIndex('cable');
  if (cable >= 0) return [cable];
  const pair = seenDesign().closest[markedIndex('closest')];
  return pair ? pair.cables : [];
}

function markCables() {
  const marked = markedCables();
  const anything = (page.hovered || page.chosen) !== null;
  drawnCables.forEach(({ shown }, i) => {
    const isMarked = marked.includes(i);
    const faded = anything && !isMarked;
    shown.scale.x = shown.scale.z = isMarked ? 2.4 : 1;
    shown.material.transparent = faded;
    shown.material.opacity = faded ? 0.35 : 1;
    shown.material.needsUpdate = true;
  });
  draw();
}

// The cables between the displaced points of bendRods.
export function bendCables(displacement, times) {
  const design = seenDesign();
  const moved = (end) => {
    if (end.anchor !== undefined) return vector(design.anchors[end.anchor]);
    const rod = design.rods[end.rod];
    return vector(pointAt(rod, end.s))
      .addScaledVector(vector(pointAt(rod, end.s, displacement[end.rod])), times);
  };
  design.cables.forEach((cable, i) => {
    const { shown, picked } = drawnCables[i];
    for (const mesh of [shown, picked]) stretch(mesh, moved(cable.a), moved(cable.b));
  });
}

export const cableLabel = (design, i) =>
  design.cables.length > 1 && i === leastTaut(design) ? `${i + 1} least` : String(i + 1);

export function startCables() {
  onChange(['design', 'thick'], showCables);
  onChange(['chosen', 'hovered'], markCables);
  showCables();
}
