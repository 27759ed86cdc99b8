// Keys. On the stage: arrows turn, + and - zoom, letters are what the buttons are. Anywhere: Esc
// lets go of what is chosen.
import { fit, turnCamera, view, zoomCamera } from './camera.js';
import { byId, change } from './page.js';
import { toggle, toggleLens } from './stage.js';
import { world } from './world.js';

const stageKeys = {
  ArrowLeft: () => turnCamera(-0.15, 0),
  ArrowRight: () => turnCamera(0.15, 0),
  ArrowUp: () => turnCamera(0, -0.15),
  ArrowDown: () => turnCamera(0, 0.15),
  '+': () => zoomCamera(1.2),
  '=': () => zoomCamera(1.2),
  '-': () => zoomCamera(1 / 1.2),
  h: () => view('home'),
  1: () => view('front'),
  x: () => view('x'),
  y: () => view('y'),
  z: () => view('z'),
  f: fit,
  o: toggleLens,
  t: () => toggle('targets'),
  v: () => toggle('vectors'),
  l: () => toggle('labels'),
};

export function startKeyboard() {
  document.addEventListener('keydown', (event) => {
    if (event.key !== 'Escape') return;
    change({ chosen: null, hovered: null, mode: -1, stage: -1 });
    byId('tip').style.display = 'none';
  });
  world.renderer.domElement.addEventListener('keydown', (event) => {
    const act = stageKeys[event.key];
    if (!act || event.ctrlKey || event.metaKey || event.altKey) return;
    act();
    event.preventDefault();
  });
  const touch = matchMedia('(pointer: coarse)').matches;
  byId('hint').textContent = touch
    ? 'One finger turns, two turn and zoom. Tap a cable to choose it.'
    : 'Drag to turn, wheel to zoom, right button to move. Click a cable to choose it, Esc lets go. ' +
      'Keys: arrows, + and -, h home, x y z, f fit, o orthographic.';
}
