// The stage: the drawing with its switches, and pictures of it.
import { isSeenInTrueThickness } from './rods.js';
import { byId, change, onChange, page, seenDesign } from './page.js';
import { changeLens, fit, isOrthographic, resizeCamera, view } from './camera.js';
import { rodFields } from './colours.js';
import { hasDirectors } from './supports.js';
import { labelsForPicture } from './labels.js';
import { savePng } from './save.js';
import { designInWords } from './words.js';
import { render, world } from './world.js';

const switches = { 'show-target': 'targets', 'show-vectors': 'vectors', 'show-thick': 'thick',
  'show-labels': 'labels', 'show-supports': 'supports', 'show-directors': 'directors' };

function showSwitches() {
  for (const [id, key] of Object.entries(switches)) byId(id).checked = page[key];
  byId('colour').value = page.colour;
  const design = seenDesign();
  const supports = design.anchors.length + design.pinned.length + design.point_loads.length +
    design.line_loads.length;
  byId('show-supports').parentElement.hidden = !supports;
  byId('show-directors').parentElement.hidden = !hasDirectors(design);
  world.renderer.domElement.setAttribute('aria-label', `The design in 3D: ${designInWords(design)}`);
}

export function toggle(key) { change({ [key]: !page[key] }); }

export function toggleLens() {
  changeLens();
  byId('lens').textContent = isOrthographic() ? 'perspective' : 'orthographic';
}

// The view with its labels on the paper's colour, as a canvas.
export function pictureOfView(paper, ink) {
  render();
  const drawn = world.renderer.domElement;
  const picture = document.createElement('canvas');
  picture.width = drawn.width;
  picture.height = drawn.height;
  const context = picture.getContext('2d');
  context.fillStyle = paper;
  context.fillRect(0, 0, picture.width, picture.height);
  context.drawImage(drawn, 0, 0);
  const ratio = drawn.width / drawn.clientWidth;
  context.scale(ratio, ratio);
  context.font = '600 11.5px system-ui, sans-serif';
  context.textAlign = 'center';
  context.textBaseline = 'middle';
  for (const { text, x, y, width, height } of labelsForPicture()) {
    context.fillStyle = paper;
    context.fillRect(x - width / 2, y - height / 2, width, height);
    context.strokeStyle = ink;
    context.lineWidth = 0.5;
    context.strokeRect(x - width / 2, y - height / 2, width, height);
    context.fillStyle = ink;
    context.fillText(text, x, y);
  }
  return picture;
}

export function saveView() {
  const style = getComputedStyle(document.body);
  savePng(pictureOfView(style.backgroundColor, style.color));
}

export function startStage() {
  for (const [id, key] of Object.entries(switches))
    byId(id).onchange = (event) => change({ [key]: event.target.checked });
  for (const [name, { title }] of Object.entries(rodFields)) byId('colour').append(new Option(title, name));
  byId('colour').onchange = (event) => change({ colour: event.target.value });
  for (const button of document.querySelectorAll('[data-view]'))
    button.onclick = () => view(button.dataset.view);
  byId('fit').onclick = fit;
  byId('lens').onclick = toggleLens;
  byId('save-png').onclick = saveView;
  onChange([...Object.values(switches), 'colour', 'design'], showSwitches);
  showSwitches();
  // What is printed is the view as it was turned.
  window.addEventListener('beforeprint', () => {
    byId('printed').src = pictureOfView('#ffffff', '#1c232b').toDataURL();
  });
  const resize = () => {
    const { clientWidth: width, clientHeight: height } = byId('stage');
    if (width && height) resizeCamera(width, height);
  };
  new ResizeObserver(resize).observe(byId('stage'));
  resize();
}

// Before anything is drawn.
export function chooseThickness() { page.thick = isSeenInTrueThickness(seenDesign()); }
