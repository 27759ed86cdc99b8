// The target as a ghost of the rods, and how far the pose is from it, as vectors.
import { sizeOf } from './data.js';
import { onChange, page, seenDesign } from './page.js';
import { sweepOf } from './rods.js';
import { showGroup, vector } from './world.js';

const ghostColour = 0x8b95a1;
const vectorColour = 0xd6336c;

function showTarget() {
  const design = seenDesign();
  if (!page.targets) return showGroup('target', []);
  const ghost = (rod) => {
    const material = new THREE.MeshLambertMaterial({ color: ghostColour, transparent: true,
      opacity: 0.38, depthWrite: false });
    const mesh = new THREE.Mesh(sweepOf(design, rod, rod.target, rod.target_directors).geometry,
      material);
    mesh.renderOrder = 1;
    return mesh;
  };
  showGroup('target', design.rods.map(ghost));
}

// So many times as long that the longest is a twelfth of the size, and never shorter than it is.
export function vectorFactor(design) {
  const longest = design.rods.reduce((most, rod) =>
    rod.deviation.reduce((a, v) => Math.max(a, Math.hypot(...v)), most), 0);
  const size = sizeOf(design);
  return longest > 1e-9 * size ? Math.max(1, size / 12 / longest) : 1;
}

function showVectors() {
  const design = seenDesign();
  if (!page.vectors) return showGroup('vectors', []);
  const times = vectorFactor(design);
  const tails = [];
  const tips = [];
  for (const rod of design.rods) {
    const step = Math.ceil(rod.target.length / 90);
    for (let i = 0; i < rod.target.length; i += step) {
      tails.push(vector(rod.target[i]));
      tips.push(vector(rod.target[i]).addScaledVector(vector(rod.deviation[i]), times));
    }
  }
  const shafts = new THREE.LineSegments(
    new THREE.BufferGeometry().setFromPoints(tails.flatMap((tail, i) => [tail, tips[i]])),
    new THREE.LineBasicMaterial({ color: vectorColour }));
  const size = sizeOf(design);
  const heads = new THREE.InstancedMesh(new THREE.ConeBufferGeometry(1, 3, 8),
    new THREE.MeshBasicMaterial({ color: vectorColour }), tips.length);
  tips.forEach((tip, i) => {
    const along = tip.clone().sub(tails[i]);
    const length = along.length();
    const head = Math.min(size / 400, length / 6);
    const turn = new THREE.Quaternion();
    if (length > 0) turn.setFromUnitVectors(new THREE.Vector3(0, 1, 0), along.normalize());
    heads.setMatrixAt(i, new THREE.Matrix4().compose(tip.addScaledVector(along, -1.5 * head), turn,
      new THREE.Vector3(head, head, head)));
  });
  heads.frustumCulled = false;
  showGroup('vectors', [shafts, heads]);
}

export function startTarget() {
  onChange(['design', 'targets', 'thick'], showTarget);
  onChange(['design', 'vectors'], showVectors);
  showTarget();
  showVectors();
}
