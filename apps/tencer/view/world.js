// The stage's three.js scene, which is drawn when something asks for it. What belongs to designs is
// in `world.model`, in a design's coordinates; turning it gives the views.
import { byId } from './page.js';

export const world = { renderer: null, scene: null, model: null, camera: null, size: 1 };
const beforeFrame = [];
const afterFrame = [];

export const onFrame = (act) => afterFrame.push(act);
// `act` gets the time in seconds; while it returns true, frames follow each other.
export const onEachFrame = (act) => beforeFrame.push(act);

export const vector = (p) => new THREE.Vector3(p[0], p[1], p[2]);

// False: there is no WebGL.
export function makeWorld() {
  try {
    world.renderer = new THREE.WebGLRenderer({ antialias: true, alpha: true });
  } catch (error) {
    return false;
  }
  const canvas = world.renderer.domElement;
  canvas.tabIndex = 0;
  canvas.setAttribute('role', 'img');
  canvas.setAttribute('aria-describedby', 'hint');
  byId('stage').prepend(canvas);
  world.scene = new THREE.Scene();
  world.model = new THREE.Group();
  world.scene.add(world.model);
  // Bright from everywhere, so that colours look as in their legend; a lamp at the reader's
  // shoulder (camera.js) gives the form.
  world.scene.add(new THREE.AmbientLight(0xffffff, 0.62));
  return true;
}

// Shows things of the world and takes the former ones of this name away.
const shownGroups = new Map();
const hiddenGroups = new Set();
export function showGroup(name, objects) {
  const before = shownGroups.get(name);
  if (before) {
    world.model.remove(before);
    before.traverse((object) => {
      if (object.geometry) object.geometry.dispose();
      if (object.material) object.material.dispose();
    });
  }
  const group = new THREE.Group();
  if (objects.length) group.add(...objects);
  group.visible = !hiddenGroups.has(name);
  shownGroups.set(name, group);
  world.model.add(group);
  draw();
}

// Whether the things of this name are seen, also those that are shown from now on.
export function hideGroup(name, isHidden) {
  if (isHidden) hiddenGroups.add(name);
  else hiddenGroups.delete(name);
  const group = shownGroups.get(name);
  if (group) group.visible = !isHidden;
  draw();
}

export function render() {
  world.renderer.render(world.scene, world.camera);
}

let pending = false;
export function draw() {
  if (pending || !world.camera) return;
  pending = true;
  requestAnimationFrame((milliseconds) => {
    pending = false;
    const goesOn = beforeFrame.filter((act) => act(milliseconds / 1000)).length > 0;
    render();
    afterFrame.forEach((act) => act());
    if (goesOn) draw();
  });
}
