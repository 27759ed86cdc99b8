// Starts the page. Without WebGL it has the drawn picture in place of the view.
import { startCables } from './cables.js';
import { startCamera } from './camera.js';
import { startCheck } from './check.js';
import { startClosest } from './closest.js';
import { startHead } from './head.js';
import { startKeyboard } from './keyboard.js';
import { startLabels } from './labels.js';
import { startLegend } from './legend.js';
import { startModes } from './modes.js';
import { byId, change, page } from './page.js';
import { startPicking } from './pick.js';
import { startPlots } from './plots.js';
import { startPoses } from './poses.js';
import { startRods } from './rods.js';
import { chooseThickness, startStage } from './stage.js';
import { startStages } from './stages.js';
import { startSupports } from './supports.js';
import { scrollToCable, startTables } from './tables.js';
import { startTarget } from './target.js';
import { lengthUnits } from './units.js';
import { makeWorld } from './world.js';

function startUnits() {
  byId('unit').replaceChildren(...lengthUnits.map((unit) => new Option(unit, unit)));
  byId('unit').value = page.unit;
  byId('unit').onchange = (event) => change({ unit: event.target.value });
}

function startView() {
  chooseThickness();
  startRods();
  startCables();
  startTarget();
  startSupports();
  startClosest();
  startCamera();
  startLabels();
  startLegend();
  startModes();
  startPoses();
  startStages();
  startPicking(scrollToCable);
  startStage();
  startKeyboard();
}

startUnits();
startHead();
startCheck();
startTables();
startPlots();
if (makeWorld()) startView();
else document.body.classList.add('flat');
