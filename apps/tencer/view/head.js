// The head of the page: what the design is, and what is known of it.
import { sizeOf, rodLength } from './data.js';
import { byId, element, onChange, seenDesign } from './page.js';
import { forceText, lengthWithUnit, massText, percentText, significant, smallLength } from './units.js';
import { designName, rodName } from './words.js';

// Whether it is what was asked for, and everything that it falls short of.
function statusOf(design) {
  const short = [...(design.shortfalls || [])];
  for (const fail of (design.check && design.check.fails) || [])
    if (!short.includes(fail)) short.push(fail);
  const certificate = design.certificate;
  if (certificate && !certificate.stable && !short.some((text) => text.includes('does not stand')))
    short.push('it does not stand');
  if (certificate && certificate.settles_from_target === false &&
      !short.some((text) => text.includes('let go at the target')))
    short.push('let go at the target it comes to rest elsewhere');
  const interrupted = design.status === 'interrupted';
  const said = interrupted ? ['The search was interrupted: this is the best design until then.'] : [];
  if (short.length) said.push(`Not what was asked for: ${short.join('; ')}.`);
  else if (design.status === 'tolerance-not-reached')
    said.push('Not what was asked for; the file does not say why.');
  if (said.length) return { text: said.join(' '), className: 'bad' };
  if (!certificate) return { text: 'Nobody has found out yet whether it stands.', className: '' };
  const check = design.check;
  if (check && check.passed) return { text: 'It passes the whole check.', className: 'good' };
  if (check)
    return { text: 'Nothing fails of what was looked at; not looked at: ' +
      `${check.not_looked_at.join(', ')} (tencer check does).`, className: '' };
  return { text: 'Nobody has checked yet whether it can be built (tencer check does).', className: '' };
}

// The same word for all rods once, else rod by rod.
function rodByRod(design, say) {
  const words = design.rods.map(say);
  if (words.every((word) => word === words[0])) return words[0];
  return words.map((word, r) => `${rodName(r)}: ${word}`).join(', ');
}

function rodFacts(design, add) {
  const lengths = design.rods.map((rod) => lengthWithUnit(design, rodLength(rod)));
  add(design.rods.length === 1 ? 'rod' : 'rods', design.rods.length <= 4
    ? rodByRod(design, (rod, r) => lengths[r])
    : `${design.rods.length}, together ` +
      lengthWithUnit(design, design.rods.reduce((sum, rod) => sum + rodLength(rod), 0)));
  add('section', rodByRod(design, (rod) => rod.section_words || 'not known'));
  add('material', rodByRod(design, (rod) => rod.material_words || 'not known'));
  const grams = design.rods.map((rod) => rod.grams);
  add('weight', grams.every((one) => one !== null)
    ? massText(grams.reduce((a, b) => a + b, 0)) : 'not known');
}

function strainFact(design, add) {
  let worst = null;
  design.rods.forEach((rod, r) => (rod.strain || []).forEach((strain) => {
    if (!worst || strain > worst.strain) worst = { strain, r, material: rod.material };
  }));
  if (!worst) return add('largest strain', 'not known');
  const limit = worst.material && worst.material.strain_limit;
  add('largest strain', percentText(100 * worst.strain) +
    (limit ? ` of ${percentText(100 * limit)} held for long` : ''),
    limit && worst.strain > 1.001 * limit ? 'bad' : '');
}

function toleranceFact(design, add) {
  const forgives = design.check && design.check.forgives;
  if (forgives && typeof forgives.percentile_95 === 'number')
    return add('built with errors', `cut to ${smallLength(design, forgives.length_error)}, tied to ` +
      `${smallLength(design, forgives.attachment_error)}: within ` +
      `${smallLength(design, forgives.percentile_95)} (95 %)`,
      forgives.percentile_95 > forgives.max_deviation ? 'bad' : '');
  const off = design.certificate && design.certificate.off_by_errors;
  if (typeof off === 'number')
    add('built with errors', `cut to 1 mm, tied to 2 mm: off by about ${smallLength(design, off)}`);
  else add('built with errors', 'not known');
}

function balanceFacts(design, add) {
  const certificate = design.certificate;
  if (!certificate) return add('in this pose', 'not known');
  const passed = design.check && design.check.passed;
  add('in this pose', certificate.stable ? 'it stands' : 'it does not stand',
    certificate.stable ? (passed ? 'good' : '') : 'bad');
  const settles = certificate.settles_from_target;
  add('let go at the target', settles === undefined ? 'not tried'
    : settles ? 'it settles here' : 'it settles elsewhere', settles === false ? 'bad' : '');
  add('slack cables', certificate.slack_cables, certificate.slack_cables ? 'bad' : '');
}

function showHead() {
  const design = seenDesign();
  document.title = designName(design);
  byId('name').textContent = designName(design);
  const { text, className } = statusOf(design);
  byId('status').textContent = text;
  byId('status').className = className;
  const list = byId('facts');
  list.replaceChildren();
  const add = (name, value, valueClass) => {
    const item = element('div');
    item.append(element('dt', name), element('dd', value, valueClass));
    list.append(item);
  };
  const needed = design.at_least && design.at_least.cables;
  add('cables', design.cables.length + (needed ? `; at least ${needed} needed within ` +
    percentText(design.at_least.error_percent) : ''));
  const size = sizeOf(design);
  const error = design.error;
  const away = (percent) => `${smallLength(design, percent / 100 * size)} (${percentText(percent)})`;
  add('largest error', error ? away(error.max_percent) : 'not known');
  add('rms error', error ? away(error.rms_percent) : 'not known');
  if (design.views)
    add('errors as seen along', design.views.map((view) =>
      `(${view.direction.map((c) => significant(c, 3)).join(', ')})`).join(' and '));
  toleranceFact(design, add);
  balanceFacts(design, add);
  strainFact(design, add);
  rodFacts(design, add);
  const tensions = design.cables.map((cable) => cable.tension);
  if (tensions.length) add('tension', `${forceText(Math.min(...tensions))} to ` +
    `${forceText(Math.max(...tensions))} ${design.force_unit}`);
}

export function startHead() {
  onChange(['design', 'unit'], showHead);
  showHead();
}
