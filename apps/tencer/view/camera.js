// From where the design is seen. A view turns the model so that one direction is to the right, one
// up and one towards the reader; the camera then goes around what is up.
import { sizeOf, usedAnchors } from './data.js';
import { byId, onChange, seenDesign } from './page.js';
import { inUnit, unitOf } from './units.js';
import { draw, onFrame, vector, world } from './world.js';

const fieldOfView = 28; // degrees, up and down
const slope = Math.tan(fieldOfView * Math.PI / 360);
const filled = 0.9; // of the stage, by the shape

const lens = {}; // perspective, orthographic
let controls = null;
let lamp = null; // goes where the camera goes
let isFitted = true; // nothing was turned, moved or zoomed since
let turned = 'home';
let backwards = false;

// The design lies in a plane, or nearly.
function isFlat(design) {
  const extent = design.axes.map((axis) => {
    const along = design.rods.flatMap((rod) => rod.pose.map((p) =>
      p[0] * axis[0] + p[1] * axis[1] + p[2] * axis[2]));
    return along.reduce((a, b) => Math.max(a, b)) - along.reduce((a, b) => Math.min(a, b));
  });
  return extent[2] < 0.02 * extent[0];
}

// Rows: right, up, towards the reader. `from`: where the camera is then, in these.
function viewOf(name) {
  const design = seenDesign();
  if (name === 'home')
    return { rows: design.axes, from: design.views || isFlat(design) ? [0, 0, 1] : [-0.35, 0.5, 0.88] };
  if (name === 'front') return { rows: design.axes, from: [0, 0, 1] };
  const x = [1, 0, 0];
  const y = [0, 1, 0];
  const z = [0, 0, 1];
  const minus = (v) => v.map((c) => -c);
  const sides = backwards
    ? { x: [minus(y), z, minus(x)], y: [x, z, minus(y)], z: [minus(x), y, minus(z)] }
    : { x: [y, z, x], y: [minus(x), z, y], z: [x, y, z] };
  return { rows: sides[name], from: [0, 0, 1] };
}

function worldPoints() {
  const design = seenDesign();
  world.model.updateMatrixWorld();
  return [...design.rods.flatMap((rod) => rod.pose), ...usedAnchors(design)]
    .map((p) => world.model.localToWorld(vector(p)));
}

// So near that all points fill the stage, from the direction in which the camera is.
export function fit() {
  const canvas = world.renderer.domElement;
  const aspect = canvas.clientWidth / canvas.clientHeight || 1;
  const towards = world.camera.position.clone().sub(controls.target).normalize();
  const basis = new THREE.Matrix4().lookAt(towards, new THREE.Vector3(), world.camera.up);
  const right = new THREE.Vector3().setFromMatrixColumn(basis, 0);
  const up = new THREE.Vector3().setFromMatrixColumn(basis, 1);
  const points = worldPoints().map((p) => [p.dot(right), p.dot(up), p.dot(towards)]);
  const isFar = world.camera.isOrthographicCamera;
  const middle = [0, 1, 2].map((axis) => {
    const along = points.map((p) => p[axis]);
    return (along.reduce((a, b) => Math.max(a, b)) + along.reduce((a, b) => Math.min(a, b))) / 2;
  });
  let distance = 0;
  for (let round = 0; round < (isFar ? 1 : 8); ++round) {
    distance = 0;
    for (const p of points)
      distance = Math.max(distance, (isFar ? 0 : p[2] - middle[2]) +
        Math.max(Math.abs(p[0] - middle[0]) / aspect, Math.abs(p[1] - middle[1])) / slope / filled);
    if (isFar) break;
    for (const axis of [0, 1]) { // what is nearer looks larger: the middle as seen
      const seen = points.map((p) => (p[axis] - middle[axis]) / (distance - p[2] + middle[2]));
      middle[axis] += distance * (seen.reduce((a, b) => Math.max(a, b)) +
        seen.reduce((a, b) => Math.min(a, b))) / 2;
    }
  }
  distance = Math.max(distance, world.size / 50);
  controls.target.set(0, 0, 0).addScaledVector(right, middle[0]).addScaledVector(up, middle[1])
    .addScaledVector(towards, middle[2]);
  world.camera.position.copy(controls.target).addScaledVector(towards, distance);
  controls.minDistance = distance / 40;
  controls.maxDistance = distance * 4;
  lens.orthographic.zoom = 1;
  lens.orthographic.userData.half = distance * slope;
  shapeLenses();
  controls.update();
  isFitted = true;
  draw();
}

function shapeLenses() {
  const canvas = world.renderer.domElement;
  const aspect = canvas.clientWidth / canvas.clientHeight || 1;
  lens.perspective.aspect = aspect;
  const half = lens.orthographic.userData.half || 1;
  Object.assign(lens.orthographic, { left: -half * aspect, right: half * aspect, top: half,
    bottom: -half });
  Object.values(lens).forEach((one) => one.updateProjectionMatrix());
}

// home, front, or along x, y or z of the file; asked for again, and not turned since, all but home are
// from the other side.
export function view(name) {
  backwards = name === turned && name !== 'home' && isFitted && !backwards;
  turned = name;
  const { rows, from } = viewOf(name);
  const matrix = new THREE.Matrix4().set(...rows[0], 0, ...rows[1], 0, ...rows[2], 0, 0, 0, 0, 1);
  world.model.quaternion.setFromRotationMatrix(matrix);
  const sign = backwards && (name === 'home' || name === 'front') ? -1 : 1;
  controls.target.set(0, 0, 0);
  world.camera.position.set(sign * from[0], from[1], sign * from[2]).multiplyScalar(world.size);
  fit();
}

function holdLamp() { world.camera.add(lamp, lamp.target); }

export const isOrthographic = () => world.camera === lens.orthographic;

// The other lens from the same place, the middle as large as before.
export function changeLens() {
  const before = world.camera;
  const distance = before.position.distanceTo(controls.target);
  world.camera = isOrthographic() ? lens.perspective : lens.orthographic;
  world.camera.position.copy(before.position);
  if (isOrthographic()) {
    lens.orthographic.zoom = lens.orthographic.userData.half / (distance * slope);
  } else {
    const half = lens.orthographic.userData.half / lens.orthographic.zoom;
    world.camera.position.sub(controls.target).setLength(half / slope).add(controls.target);
  }
  controls.object = world.camera;
  holdLamp();
  shapeLenses();
  if (isFitted) fit();
  controls.update();
  draw();
}

// By angles, radians, as when dragged.
export function turnCamera(aside, up) {
  const offset = world.camera.position.clone().sub(controls.target);
  const place = new THREE.Spherical().setFromVector3(offset);
  place.theta -= aside;
  place.phi = Math.min(Math.max(place.phi - up, 0.01), Math.PI - 0.01);
  world.camera.position.copy(controls.target).add(offset.setFromSpherical(place));
  isFitted = false;
  controls.update();
  draw();
}

export function zoomCamera(factor) {
  if (isOrthographic()) {
    world.camera.zoom = Math.min(Math.max(world.camera.zoom * factor, controls.minZoom), controls.maxZoom);
    world.camera.updateProjectionMatrix();
  } else {
    const offset = world.camera.position.clone().sub(controls.target).divideScalar(factor);
    offset.clampLength(controls.minDistance, controls.maxDistance);
    world.camera.position.copy(controls.target).add(offset);
  }
  isFitted = false;
  controls.update();
  draw();
}

// A round length that fits into the corner, at the depth of the middle.
function showScaleBar() {
  const canvas = world.renderer.domElement;
  const half = isOrthographic() ? lens.orthographic.userData.half / world.camera.zoom
    : world.camera.position.distanceTo(controls.target) * slope;
  const design = seenDesign();
  const perPixel = inUnit(design, 2 * half / canvas.clientHeight);
  const most = 120 * perPixel;
  const power = 10 ** Math.floor(Math.log10(most));
  const length = [5, 2, 1].map((n) => n * power).find((n) => n <= most);
  byId('scale-bar').style.width = `${length / perPixel}px`;
  byId('scale-text').textContent = `${Number(length.toPrecision(1))} ${unitOf(design)}`;
}

// The file's x, y and z as they are seen.
function showAxes() {
  const turn = world.camera.quaternion.clone().inverse().multiply(world.model.quaternion);
  const arms = [[1, 0, 0], [0, 1, 0], [0, 0, 1]].map((axis) => vector(axis).applyQuaternion(turn));
  arms.forEach((arm, i) => {
    const [x, y] = [30 + 22 * arm.x, 30 - 22 * arm.y];
    const line = byId(`axis-${'xyz'[i]}`);
    line.setAttribute('x2', x);
    line.setAttribute('y2', y);
    const text = byId(`axis-name-${'xyz'[i]}`);
    text.setAttribute('x', 30 + 28 * arm.x);
    text.setAttribute('y', 33 - 28 * arm.y);
  });
}

export function resizeCamera(width, height) {
  world.renderer.setPixelRatio(window.devicePixelRatio);
  world.renderer.setSize(width, height);
  if (isFitted) fit();
  else shapeLenses();
  draw();
}

function startDesign() {
  world.size = sizeOf(seenDesign());
  for (const one of Object.values(lens)) Object.assign(one, { near: world.size / 500, far: world.size * 60 });
  lens.orthographic.near = -world.size * 10;
  backwards = false;
  turned = '';
  view('home');
}

export function startCamera() {
  lens.perspective = new THREE.PerspectiveCamera(fieldOfView, 1, 0.1, 100);
  lens.orthographic = new THREE.OrthographicCamera(-1, 1, 1, -1, 0.1, 100);
  world.camera = lens.perspective;
  lamp = new THREE.DirectionalLight(0xffffff, 0.42);
  lamp.position.set(-0.5, 0.7, 1);
  world.scene.add(...Object.values(lens));
  holdLamp();
  const canvas = world.renderer.domElement;
  controls = new THREE.OrbitControls(world.camera, canvas);
  controls.enableKeys = false;
  controls.screenSpacePanning = true;
  controls.minZoom = 0.25;
  controls.maxZoom = 40;
  controls.touches.TWO = THREE.TOUCH.DOLLY_ROTATE;
  controls.addEventListener('change', draw);
  controls.addEventListener('start', () => { isFitted = false; });
  canvas.addEventListener('wheel', () => { isFitted = false; });
  onChange(['design'], startDesign);
  onChange(['unit'], draw);
  onFrame(showScaleBar);
  onFrame(showAxes);
  startDesign();
}
