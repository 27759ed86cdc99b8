// What the check says, a line a section, and all its figures. Good is only what it passed.
import { byId, element, onChange, seenDesign } from './page.js';
import { significant, smallLength } from './units.js';
import { cableInWords, placeInWords } from './words.js';
import { fillTable } from './table.js';

const toldOnly = ['repair', 'weight']; // for people to judge

function showLines(design) {
  const list = byId('check');
  list.replaceChildren();
  const add = (section, text, className) =>
    list.append(element('dt', section, className), element('dd', text));
  const check = design.check;
  for (const { section, text, fails } of check ? check.lines : [])
    add(section, text, fails ? 'bad' : toldOnly.includes(section) ? '' : 'good');
  // Whether it stands is among the facts anyway.
  const missing = (check ? check.not_looked_at : ['whether it can be built'])
    .filter((name) => name !== 'stands' || !design.certificate);
  if (missing.length) add('not checked', `${missing.join(', ')}: run tencer check`);
}

// Its figures as rows: section, what it is, how much.
function figuresOf(design) {
  const rows = [];
  const length = (value) => typeof value === 'number' ? smallLength(design, value) : 'not known';
  const cable = (i) => i === null || i === undefined ? 'none' : cableInWords(i);
  const certificate = design.certificate;
  if (certificate) {
    rows.push(['balance', 'residual', significant(certificate.residual, 3)]);
    rows.push(['balance', 'smallest eigenvalue',
      `${significant(certificate.smallest_eigenvalue, 3)} (${certificate.eigenvalue_unit})`]);
  }
  const { stands, forgives, comes_back: comesBack, holds, weight, clear, converged } =
    design.check || {};
  if (stands) {
    rows.push(['stands', 'moves from the pose of the file', length(stands.moved)]);
    stands.hertz.forEach((hertz, i) =>
      rows.push(['stands', `natural frequency ${i + 1}`, `${significant(hertz, 3)} Hz`]));
    stands.free_groups.forEach((text) => rows.push(['stands', 'moves at no cost', text]));
  }
  if (forgives)
    rows.push(
      ['forgives', 'error of a length, at most', length(forgives.length_error)],
      ['forgives', 'error of a mark, at most', length(forgives.attachment_error)],
      ['forgives', 'allowed to 95 %', length(forgives.max_deviation)],
      ['forgives', `expected, of ${forgives.draws} draws`, length(forgives.expected)],
      ['forgives', '95 % within', length(forgives.percentile_95)],
      ['forgives', 'worst', length(forgives.worst)],
      ['forgives', 'errors matter most of', `${cable(forgives.decisive_cable)}, ` +
        length(forgives.decisive)],
      ['forgives', 'goes slack first', `${cable(forgives.first_slack)}, at ` +
        `${significant(forgives.slack_at, 3)} times the errors`]);
  if (forgives && forgives.settled > 0)
    rows.push(
      ['forgives', `of ${forgives.settled} let settle, fall`, String(forgives.fallen)],
      ['forgives', 'worst of those that do not', length(forgives.settled_worst)],
      ['forgives', 'the first falls', forgives.falls_at !== undefined
        ? `at ${significant(forgives.falls_at, 3)} times the errors`
        : forgives.falls_up_to > 0
          ? `none up to ${significant(forgives.falls_up_to, 3)} times the errors` : 'not known']);
  for (const push of comesBack ? comesBack.pushes : [])
    rows.push(['comes back', `pushed by ${length(push.size)}`,
      `${push.back} of ${push.tried}${push.lost ? `, ${push.lost} were lost` : ''}`]);
  for (const other of comesBack ? comesBack.other_poses : [])
    rows.push(['comes back', 'another pose', `${length(other.distance)} away, ${other.times} times`]);
  if (holds && holds.rod !== undefined)
    rows.push(['holds', `strain of ${placeInWords(design, holds.rod, holds.s)}`,
      `${significant(100 * holds.strain, 3)} % of ${significant(100 * holds.strain_limit, 3)} %`]);
  if (holds)
    rows.push(['holds', `tension of ${cable(holds.cable)}`,
      `${significant(holds.tension, 3)} of ${significant(holds.breaking_load, 3)} ${design.force_unit}`]);
  for (const [key, words] of [['hung', 'hung, it sags by'], ['held', 'held, it sags by'],
    ['standing', 'standing, it sags by']])
    if (weight && weight[key])
      rows.push(['weight', words, length(weight[key].deviation) + (weight[key].falls ? ', and falls' : '')]);
  for (const [key, words] of [['rods', 'rod to rod'], ['cable_rod', 'cable to rod'],
    ['cables', 'cable to cable'], ['marks', 'between marks']])
    if (clear) rows.push(['clear', words, clear[key] ? length(clear[key].distance) : 'none near']);
  for (const one of converged ? converged.refinements : [])
    rows.push(['converged', `${one.times} edges for each`, `moves by ${length(one.moved)}`]);
  if (converged) rows.push(['converged', 'distance from converged, about', length(converged.distance)]);
  return rows;
}

function showCheck() {
  const design = seenDesign();
  showLines(design);
  const rows = figuresOf(design);
  byId('figures-box').hidden = rows.length === 0;
  fillTable(byId('figures'), ['section', 'figure', 'value'], rows, [0, 1, 2]);
}

export function startCheck() {
  // A phone shows the design first.
  byId('check-box').open = !matchMedia('(max-width: 560px)').matches;
  onChange(['design', 'unit'], showCheck);
  showCheck();
}
