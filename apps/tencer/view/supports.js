// What holds and loads the rods: anchors, pins, loads, weight; and how sections are turned.
import { pointAt, sizeOf } from './data.js';
import { onChange, page, seenDesign } from './page.js';
import { showGroup, vector } from './world.js';

const supportColour = 0x6b7682;
const loadColour = 0x7a4fb5;
const directorColour = 0x1f9e89;

const solid = (geometry, color, at) => {
  const mesh = new THREE.Mesh(geometry, new THREE.MeshLambertMaterial({ color }));
  mesh.position.copy(at);
  return mesh;
};

// From its tail at `from`.
function arrow(from, along, length, color) {
  return new THREE.ArrowHelper(along.clone().normalize(), from, length, color, length / 5, length / 12);
}

// Rods' middle, where the weight of a rod is drawn.
const middleOf = (rod) => rod.pose.reduce((sum, p) => sum.add(vector(p)), new THREE.Vector3())
  .divideScalar(rod.pose.length);

function showSupports() {
  const design = seenDesign();
  if (!page.supports) return showGroup('supports', []);
  const size = sizeOf(design);
  const side = size / 60;
  const things = design.anchors.map((p) =>
    solid(new THREE.BoxBufferGeometry(side, side, side), supportColour, vector(p)));
  for (const pin of design.pinned)
    things.push(solid(new THREE.OctahedronBufferGeometry(side * 0.8), supportColour,
      vector(design.rods[pin.rod].pose[pin.vertex])));
  const forces = design.point_loads.map((load) => Math.hypot(...load.force));
  design.point_loads.forEach((load, i) => {
    if (forces[i] > 0)
      things.push(arrow(vector(pointAt(design.rods[load.rod], load.s)), vector(load.force),
        size / 6 * forces[i] / Math.max(...forces), loadColour));
  });
  const weights = design.line_loads.map((load) => Math.hypot(...load.force_per_length));
  design.line_loads.forEach((load, i) => {
    if (weights[i] > 0)
      things.push(arrow(middleOf(design.rods[load.rod]), vector(load.force_per_length),
        size / 6 * weights[i] / Math.max(...weights), loadColour));
  });
  showGroup('supports', things);
}

function showDirectors() {
  const design = seenDesign();
  if (!page.directors) return showGroup('directors', []);
  const length = sizeOf(design) / 40;
  const points = design.rods.flatMap((rod) => (rod.pose_directors || []).flatMap((m1, e) => {
    const middle = vector(rod.pose[e]).lerp(vector(rod.pose[(e + 1) % rod.pose.length]), 0.5);
    return [middle, middle.clone().addScaledVector(vector(m1), length)];
  }));
  showGroup('directors', [new THREE.LineSegments(new THREE.BufferGeometry().setFromPoints(points),
    new THREE.LineBasicMaterial({ color: directorColour }))]);
}

export const hasDirectors = (design) =>
  design.rods.some((rod) => rod.pose_directors && rod.pose_directors.length);

export function startSupports() {
  onChange(['design', 'supports'], showSupports);
  onChange(['design', 'directors'], showDirectors);
  showSupports();
}
