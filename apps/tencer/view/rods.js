// Rods: as thick as they are, or so thick that they are seen; coloured by what is told along them.
import { designs, sizeOf } from './data.js';
import { fieldScale, overColour, rodColour, rodFields } from './colours.js';
import { onChange, page, seenDesign } from './page.js';
import { Sweep, flatProfile, roundProfile } from './sweep.js';
import { alongCurve, directorsAlong, smoothCurve, smoothness } from './sweep.js';
import { inUnit, significant } from './units.js';
import { cableLines } from './cables.js';
import { showGroup, vector } from './world.js';

const visibleRadius = (design) => sizeOf(design) / 170;

// Of the section; where only stiffnesses are known, that of a round one with these.
const trueHalfSizes = (rod) => rod.half_sizes || Array(2).fill(2 * Math.sqrt(Math.min(...rod.EI) / rod.EA));

// In words; of the thinnest rod, how many times as thick as it is.
export function thicknessInWords(design) {
  const known = design.rods.every((rod) => rod.half_sizes);
  if (page.thick)
    return `Rods are drawn as thick as ${known ? 'they are' : 'round ones of their stiffness'}, cables ` +
      'so that they are seen.';
  const thinnest = Math.min(...design.rods.map((rod) => Math.min(...trueHalfSizes(rod))));
  return 'Rods and cables are drawn so thick that they are seen: rods up to ' +
    `${significant(visibleRadius(design) / thinnest, 2)} times as thick as they are.`;
}

// Rods that would be thinner than a line are drawn thicker until the reader wants otherwise.
export const isSeenInTrueThickness = (design) =>
  design.rods.every((rod) => Math.min(...trueHalfSizes(rod)) > sizeOf(design) / 400);

export function drawnRadius(design, rod) {
  return page.thick ? Math.max(...trueHalfSizes(rod)) : visibleRadius(design);
}

// The rod laid along these points, one a vertex.
export function sweepOf(design, rod, points, directors) {
  const pieces = smoothness(design.rods);
  const curve = smoothCurve(points, rod.closed, pieces);
  const [u, v] = trueHalfSizes(rod);
  const known = directors && directors.length;
  const isFlat = page.thick && rod.section && rod.section.shape === 'rectangle' && known;
  return isFlat
    ? new Sweep(curve, rod.closed, flatProfile(u, v), directorsAlong(directors, rod.closed, pieces))
    : new Sweep(curve, rod.closed, roundProfile(drawnRadius(design, rod)));
}

function coloursAlong(design, rod, r) {
  const pieces = smoothness(design.rods);
  const values = page.colour === 'plain' ? null : rodFields[page.colour].values(design, rod);
  const plain = rodColour(r);
  if (!values) return alongCurve(rod.curvature, rod.closed, pieces).map(() => plain);
  const scale = fieldScale(design, page.colour);
  return alongCurve(values, rod.closed, pieces).map((value) => scale.at(value));
}

// A cone at the start of the rod, in its direction, and a collar where a closed one is joined.
function startMarks(design, rod, material) {
  const radius = drawnRadius(design, rod);
  const length = Math.max(4 * radius, sizeOf(design) / 60);
  const along = vector(rod.pose[1]).sub(vector(rod.pose[0])).normalize();
  const turn = new THREE.Quaternion().setFromUnitVectors(new THREE.Vector3(0, 1, 0), along);
  const cone = new THREE.Mesh(
    new THREE.ConeBufferGeometry(Math.max(2 * radius, length / 3), length, 20), material);
  cone.position.copy(vector(rod.pose[0])).addScaledVector(along, length / 2);
  cone.quaternion.copy(turn);
  if (!rod.closed) return [cone];
  const collar = new THREE.Mesh(
    new THREE.CylinderBufferGeometry(1.6 * radius, 1.6 * radius, length / 4, 20), material);
  collar.position.copy(vector(rod.pose[0]));
  collar.quaternion.copy(turn);
  return [cone, collar];
}

export const drawnRods = []; // of the design that is seen: {mesh, sweep}, one a rod

function showRods() {
  const design = seenDesign();
  drawnRods.length = 0;
  const marks = [];
  design.rods.forEach((rod, r) => {
    const sweep = sweepOf(design, rod, rod.pose, rod.pose_directors);
    sweep.paint(coloursAlong(design, rod, r));
    const mesh = new THREE.Mesh(sweep.geometry,
      new THREE.MeshLambertMaterial({ vertexColors: THREE.VertexColors }));
    mesh.userData.rod = r;
    drawnRods.push({ mesh, sweep });
    marks.push(...startMarks(design, rod, new THREE.MeshLambertMaterial({ color: rodColour(r) })));
  });
  showGroup('rods', [...drawnRods.map(({ mesh }) => mesh), ...marks]);
}

function showOver() {
  if (page.over < 0) return showGroup('over', []);
  const other = designs[page.over];
  const material = () => new THREE.MeshLambertMaterial({ color: overColour, transparent: true,
    opacity: 0.6 });
  const group = new THREE.Group();
  group.scale.setScalar(inUnit(other, 1, seenDesign().length_unit));
  group.add(cableLines(other, overColour), ...other.rods.map((rod) =>
    new THREE.Mesh(sweepOf(other, rod, rod.pose, rod.pose_directors).geometry, material())));
  showGroup('over', [group]);
}

// No displacement.
export const still = (design) => design.rods.map((rod) => rod.pose.map(() => [0, 0, 0]));

// Rods displaced by `displacement`, per rod and vertex, `times` as far.
export function bendRods(displacement, times) {
  const design = seenDesign();
  const pieces = smoothness(design.rods);
  design.rods.forEach((rod, r) => {
    const points = rod.pose.map((p, i) => p.map((x, axis) => x + times * displacement[r][i][axis]));
    drawnRods[r].sweep.lay(smoothCurve(points, rod.closed, pieces));
  });
}

export function startRods() {
  onChange(['design', 'colour', 'thick'], showRods);
  onChange(['over', 'thick', 'design'], showOver);
  showRods();
}
