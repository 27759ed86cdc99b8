// What to cut and where to mark it; the rods, what holds and loads them, and what comes near what.
import { arcLengthAt, cableNotes, pointAt, rodLength } from './data.js';
import { byId, change, markedIndex, onChange, page, seenDesign } from './page.js';
import { pairInWords } from './closest.js';
import { fillTable, makeChoosable, tableSection } from './table.js';
import { saveCsv } from './save.js';
import { forceText, lengthText, massText, pointText, smallLength, unitOf } from './units.js';
import { anchorName, endName, placeInWords, rodInWords, rodName } from './words.js';

let cableRows = [];
let closestRows = [];
let crossingRows = [];

function cutList(design) {
  const titles = ['cable', `length ${unitOf(design)}`, 'from', 'to', `tension ${design.force_unit}`, ''];
  const rows = design.cables.map((cable, i) => [String(i + 1), lengthText(design, cable.length),
    endName(design, cable.a), endName(design, cable.b), forceText(cable.tension),
    cableNotes(design, i).join(', ')]);
  return { titles, rows };
}

function showCutList() {
  const design = seenDesign();
  const { titles, rows } = cutList(design);
  const total = design.cables.reduce((sum, cable) => sum + cable.length, 0);
  cableRows = fillTable(byId('cables'), titles, rows, [2, 3, 5],
    ['total', lengthText(design, total), '', '', '', '']);
  makeChoosable(cableRows, (i) =>
    change({ chosen: page.chosen && page.chosen.cable === i ? null : { cable: i }, hovered: null }));
  markRows();
}

// Where to mark each rod, along its length: per rod the rows.
function marksOf(design) {
  return design.rods.map((rod, r) => design.cables
    .flatMap((cable, i) => [[cable.a, cable.b, i], [cable.b, cable.a, i]])
    .filter(([end]) => end.rod === r).sort(([a], [b]) => a.s - b.s)
    .map(([end, other, i]) => [lengthText(design, end.s), String(i + 1), endName(design, other)]));
}

function showMarks() {
  const design = seenDesign();
  const sections = marksOf(design).map((rows, r) => rows.length &&
    tableSection(`Marks on ${rodInWords(design, r)}`, [`s ${unitOf(design)}`, 'cable', 'goes to'],
      rows, [2])).filter((section) => section);
  byId('marks').replaceChildren(...sections);
}

function rodSection(design) {
  const rows = design.rods.map((rod, r) => {
    const along = rod.pose[1].map((x, axis) => x - rod.pose[0][axis]);
    const length = Math.hypot(...along);
    return [rodName(r), lengthText(design, rodLength(rod)), rod.closed ? 'joined' : 'open',
      rod.section_words || 'not known', rod.material_words || 'not known',
      rod.grams === null ? 'not known' : massText(rod.grams), pointText(design, rod.pose[0]),
      `(${along.map((x) => (x / length).toFixed(2)).join(', ')})`];
  });
  return tableSection('Rods', ['rod', `length ${unitOf(design)}`, 'ends', 'section', 'material',
    'weight', `start, or joint ${unitOf(design)}`, 'direction there'], rows, [2, 3, 4, 6, 7]);
}

function supportRows(design) {
  const perLength = (v) => `(${v.map((x) => forceText(x)).join(', ')})`;
  return [
    ...design.anchors.map((p, i) => [anchorName(i), pointText(design, p), '']),
    ...design.pinned.map((pin) => {
      const rod = design.rods[pin.rod];
      return [`pin of ${rodInWords(design, pin.rod)} at ${lengthText(design, arcLengthAt(rod, pin.vertex))}`,
        pointText(design, rod.pose[pin.vertex]), `holds ${[...pin.axes].join(', ')}`];
    }),
    ...design.point_loads.map((load) =>
      [`load on ${rodInWords(design, load.rod)} at ${lengthText(design, load.s)}`,
        pointText(design, pointAt(design.rods[load.rod], load.s)),
        `${perLength(load.force)} ${design.force_unit}`]),
    ...design.line_loads.map((load) => [`weight, or load all along ${rodInWords(design, load.rod)}`, '',
      `${perLength(load.force_per_length)} ${design.force_unit} per ${design.length_unit}`]),
  ];
}

// Rows of places that a click shows; `kind` is what is chosen then.
function placesSection(kind, ...table) {
  const section = tableSection(...table);
  section.id = kind;
  const rows = [...section.querySelectorAll('tbody tr')];
  makeChoosable(rows, (i) => change({ hovered: null,
    chosen: page.chosen && page.chosen[kind] === i ? null : { [kind]: i } }));
  return { section, rows };
}

function closestSection(design) {
  return placesSection('closest', 'What comes nearest', ['', 'distance', 'where'],
    design.closest.map((pair) => [pair.kind, pair.distance === null ? 'not known'
      : smallLength(design, pair.distance) + (pair.distance < 0 ? ': overlap' : ''),
      pairInWords(design, pair)]), [0, 2], 'Between surfaces. A click shows where it is.');
}

function crossingSection(design) {
  const words = ({ rod, s }) => placeInWords(design, rod, s);
  return placesSection('crossing', 'Crossings', ['over', 'under', 'apart'],
    design.crossings.map(({ over, under, height }) =>
      [words(over), words(under), smallLength(design, height)]), [0, 1],
    'As seen from the front, between centre lines. A click shows where it is.');
}

function showMore() {
  const design = seenDesign();
  const more = [];
  closestRows = crossingRows = [];
  if (design.closest.length) {
    const { section, rows } = closestSection(design);
    closestRows = rows;
    more.push(section);
  }
  if (design.crossings.length) {
    const { section, rows } = crossingSection(design);
    crossingRows = rows;
    more.push(section);
  }
  more.push(rodSection(design));
  const supports = supportRows(design);
  if (supports.length) more.push(tableSection('Anchors, pins and loads',
    ['', `place ${unitOf(design)}`, ''], supports, [0, 1, 2]));
  byId('more').replaceChildren(...more);
  markRows();
}

function markRows() {
  const mark = (rows, kind) => rows.forEach((row, i) => {
    row.className = i === markedIndex(kind) ? 'chosen' : '';
    row.setAttribute('aria-selected', String(i === markedIndex(kind)));
  });
  mark(cableRows, 'cable');
  mark(closestRows, 'closest');
  mark(crossingRows, 'crossing');
}

export function scrollToCable(i) {
  cableRows[i].scrollIntoView({ block: 'nearest', behavior: 'smooth' });
}

function showTables() {
  const design = seenDesign();
  showCutList();
  showMarks();
  showMore();
  byId('save-marks').hidden = !design.cables.length;
}

export function startTables() {
  byId('save-list').onclick = () => {
    const { titles, rows } = cutList(seenDesign());
    saveCsv('cut-list', [...titles.slice(0, -1), 'note'], rows);
  };
  byId('save-marks').onclick = () => {
    const design = seenDesign();
    saveCsv('marks', ['rod', `s ${unitOf(design)}`, 'cable', 'goes to'],
      marksOf(design).flatMap((rows, r) => rows.map((cells) => [rodName(r), ...cells])));
  };
  onChange(['design', 'unit'], showTables);
  onChange(['chosen', 'hovered'], markRows);
  showTables();
}
