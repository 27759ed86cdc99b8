// What the colours and lengths of the drawing mean.
import { designs, leastTaut } from './data.js';
import { fieldScale, rodFields, tensionScale } from './colours.js';
import { byId, element, onChange, page, seenDesign, seenStage } from './page.js';
import { vectorFactor } from './target.js';
import { thicknessInWords } from './rods.js';
import { forceText, significant } from './units.js';
import { cableInWords, designInWords } from './words.js';

function legendBar(title, scale, low, high) {
  const result = element('div', undefined, 'legend');
  const bar = element('div', undefined, 'bar');
  bar.style.background = scale.gradient();
  const ends = element('div', undefined, 'ends');
  ends.append(element('span', low), element('span', high));
  result.append(element('div', title, 'soft'), bar, ends);
  return result;
}

function showLegends() {
  const design = seenDesign();
  const shown = [];
  const { cables } = seenStage() || design;
  if (cables.length) {
    const scale = tensionScale({ cables });
    const bar = legendBar(`cables: tension, ${design.force_unit}` +
      (scale.isLogarithmic ? ', logarithmic' : ''), scale, forceText(scale.low),
      forceText(scale.high));
    if (cables.length > 1 && page.stage < 0)
      bar.append(element('div', `least taut: ${cableInWords(leastTaut(design))}`));
    shown.push(bar);
  }
  if (page.colour !== 'plain') {
    const field = rodFields[page.colour];
    const scale = fieldScale(design, page.colour);
    shown.push(scale
      ? legendBar(`rods: ${field.title}`, scale, field.say(design, scale.low),
        field.say(design, scale.high))
      : element('div', `rods: ${field.title} is not known`, 'legend'));
  }
  if (page.vectors)
    shown.push(element('div', `vectors from the target: ${significant(vectorFactor(design), 2)} ` +
      'times as long', 'legend'));
  if (page.over >= 0)
    shown.push(element('div', `laid over: ${designInWords(designs[page.over])}`, 'legend over'));
  byId('legends').replaceChildren(...shown);
  byId('thickness-note').textContent = thicknessInWords(design);
}

export function startLegend() {
  onChange(['design', 'stage', 'unit', 'colour', 'vectors', 'over', 'thick'], showLegends);
  showLegends();
}
