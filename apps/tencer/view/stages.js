// Networks that the search went through, from its first cables to the design.
import { sizeOf } from './data.js';
import { rodColour, tensionScale } from './colours.js';
import { cableBetween, cableRadius } from './cables.js';
import { change, onChange, page, seenDesign, seenStage } from './page.js';
import { startPlayer } from './player.js';
import { sweepOf } from './rods.js';
import { percentText, smallLength } from './units.js';
import { hideGroup, showGroup, vector } from './world.js';

// A rod that is shown by points; closed where they end as they start.
function rodAlong(design, points, r) {
  const last = points.length - 1;
  const closed = points[0].every((x, axis) => x === points[last][axis]);
  const like = design.rods[Math.min(r, design.rods.length - 1)];
  const { geometry } = sweepOf(design, { ...like, closed }, closed ? points.slice(0, last) : points);
  return new THREE.Mesh(geometry, new THREE.MeshLambertMaterial({ color: rodColour(r) }));
}

function showStage() {
  const design = seenDesign();
  const stage = seenStage();
  for (const name of ['rods', 'cables']) hideGroup(name, stage !== null);
  if (!stage) return showGroup('stage', []);
  const scale = tensionScale(stage);
  const radius = cableRadius(design);
  showGroup('stage', [
    ...stage.rods.map((points, r) => rodAlong(design, points, r)),
    ...stage.cables.map(({ a, b, tension }) =>
      cableBetween(vector(a), vector(b), radius, scale.at(tension))),
  ]);
}

function stageInWords() {
  const design = seenDesign();
  const stage = seenStage();
  const percent = stage ? stage.max_percent : design.error ? design.error.max_percent : null;
  const error = percent === null ? ''
    : `, off by ${smallLength(design, percent / 100 * sizeOf(design))} (${percentText(percent)})`;
  const { length } = (stage || design).cables;
  return `${stage ? stage.stage : 'the design'}: ${length} cable${length === 1 ? '' : 's'}${error}`;
}

export function startStages() {
  const count = () => seenDesign().stages.length + (seenDesign().stages.length ? 1 : 0);
  const showSlider = startPlayer({
    name: 'stages', title: 'search', perSecond: 2, count, label: stageInWords,
    at: () => page.stage < 0 ? count() - 1 : page.stage,
    go: (i) => change({ stage: i === count() - 1 ? -1 : i, mode: -1 }),
  });
  onChange(['design', 'stage', 'unit'], showSlider);
  onChange(['design', 'stage', 'thick'], showStage);
  onChange(['mode'], () => { if (page.mode >= 0) change({ stage: -1 }); });
  showSlider();
}
