// Plots: all designs of the page by number of cables, and the search's error against run time.
import { designs, sizeOf } from './data.js';
import { byId, change, onChange, page, see, seenDesign } from './page.js';
import { fillTable, makeChoosable } from './table.js';
import { inUnit, percentText, significant, smallLength } from './units.js';
import { designInWords } from './words.js';

const css = (name) => getComputedStyle(document.documentElement).getPropertyValue(name).trim();
let tradeOff = null;
let searchPlot = null;
let designRows = []; // by design
// Designs in the order in which lists have them.
const byCables = designs.map((design) => design.index)
  .sort((a, b) => designs[a].cables.length - designs[b].cables.length);

const toleranceOf = (design) => {
  const forgives = design.check && design.check.forgives;
  return forgives && typeof forgives.percentile_95 === 'number' ? forgives.percentile_95 : null;
};
const errorOf = (design) => design.error ? design.error.max_percent : null;

function axis(title, more) {
  return { title: { display: true, text: title, color: css('--soft') }, ticks: { color: css('--soft') },
    grid: { color: css('--line') }, ...more };
}

// Numbers of an axis with powers of ten: 1, 2 and 5 of each.
const plainTick = (value) => [1, 2, 5].includes(Number(value.toExponential()[0])) &&
  /^\de/.test(value.toExponential()) ? significant(value, 2) : '';

const common = { animation: false, maintainAspectRatio: false };

function tradeOffData() {
  const points = (valueOf) => designs.map((design, i) => ({ x: design.cables.length, y: valueOf(design), i }))
    .filter((point) => point.y !== null);
  const style = (colour, shape) => ({ borderColor: colour, pointStyle: shape,
    pointRadius: ({ raw }) => raw && raw.i === page.design ? 9 : 5, pointHitRadius: 12,
    backgroundColor: ({ raw }) => raw && raw.i === page.design ? colour : `${colour}66` });
  return { datasets: [
    { label: 'largest error, %', data: points(errorOf), yAxisID: 'y', ...style('#2b6cc4', 'circle') },
    { label: 'built with errors: 95 % within, mm', yAxisID: 'built', ...style('#c9622b', 'rectRot'),
      data: points((design) => toleranceOf(design) === null ? null
        : inUnit(design, toleranceOf(design), 'mm')) },
  ] };
}

function drawTradeOff() {
  if (tradeOff) tradeOff.destroy();
  tradeOff = new Chart(byId('trade-off'), {
    type: 'scatter',
    data: tradeOffData(),
    options: { ...common,
      onClick: (event, found) => {
        if (found.length) see(tradeOff.data.datasets[found[0].datasetIndex].data[found[0].index].i);
      },
      onHover: (event, found) => { event.native.target.style.cursor = found.length ? 'pointer' : ''; },
      scales: {
        x: axis('cables', { ticks: { color: css('--soft'), precision: 0 } }),
        y: axis('largest error, %', { type: 'logarithmic',
          ticks: { color: css('--soft'), callback: plainTick } }),
        built: axis('95 % within, mm', { type: 'logarithmic', position: 'right',
          grid: { drawOnChartArea: false }, ticks: { color: css('--soft'), callback: plainTick } }),
      },
      plugins: {
        legend: { labels: { color: css('--ink'), usePointStyle: true } },
        tooltip: { callbacks: { label: ({ raw, dataset }) =>
          `${designInWords(designs[raw.i])}: ${significant(raw.y, 3)} (${dataset.label})` } },
      } },
  });
}

// A row a design, for those who use the keyboard, and for print.
function showDesigns() {
  const rows = byCables.map((i) => designs[i]).map((design) => [String(design.cables.length),
    design.error ? `${percentText(design.error.max_percent)}, ` +
      smallLength(design, design.error.max_percent / 100 * sizeOf(design)) : 'not known',
    toleranceOf(design) === null ? 'not known' : smallLength(design, toleranceOf(design)),
    design.status === 'complete' ? 'yes' : 'no', design.name || '']);
  const made = fillTable(byId('designs-table'),
    ['cables', 'largest error', 'built with errors', 'as asked for', 'name'], rows, [4]);
  makeChoosable(made, (row) => see(byCables[row]));
  designRows = [];
  byCables.forEach((i, row) => { designRows[i] = made[row]; });
  markDesign();
}

function markDesign() {
  designRows.forEach((row, i) => { row.className = i === page.design ? 'chosen' : ''; });
  if (tradeOff) tradeOff.update();
}

const searchCurve = (label, yAxisID, colour, data) => ({ label, yAxisID, data, borderColor: colour,
  backgroundColor: colour, pointRadius: 4, borderWidth: 1.5 });

function drawSearch() {
  const design = seenDesign();
  if (searchPlot) searchPlot.destroy();
  searchPlot = null;
  let seconds = 0;
  const points = (design.trace || []).map((stage) => {
    seconds += stage.seconds;
    return { x: seconds, y: stage.max_percent, stage };
  }).filter((point) => point.y > 0);
  byId('search').hidden = !points.length;
  if (!points.length) return;
  searchPlot = new Chart(byId('search-plot'), {
    type: 'line',
    data: { datasets: [searchCurve('largest error, %', 'y', '#2b6cc4', points),
      searchCurve('cables', 'cables', '#c9622b', points.map((point) => ({ ...point,
        y: point.stage.cables })))] },
    options: { ...common,
      scales: {
        x: axis('seconds', { type: 'linear', beginAtZero: true }),
        y: axis('largest error, %', { type: 'logarithmic',
          ticks: { color: css('--soft'), callback: plainTick } }),
        cables: axis('cables', { position: 'right', beginAtZero: true,
          grid: { drawOnChartArea: false }, ticks: { color: css('--soft'), precision: 0 } }),
      },
      plugins: { legend: { labels: { color: css('--ink'), usePointStyle: true } },
        tooltip: { callbacks: { title: () => '', label: ({ raw }) => [
          `${raw.stage.stage}: ${significant(raw.stage.max_percent, 3)} % after ${significant(raw.x, 3)} s`,
          `${raw.stage.cables} cables${raw.stage.note ? `; ${raw.stage.note}` : ''}`] } } } },
  });
}

function showPickers() {
  const options = (none) => [...none, ...byCables.map((i) => new Option(designInWords(designs[i]), i))];
  byId('design').replaceChildren(...options([]));
  byId('over').replaceChildren(...options([new Option('nothing', '-1')]));
  byId('design').value = String(page.design);
  const number = byId('number');
  number.max = String(byCables.length - 1);
  number.value = String(byCables.indexOf(page.design));
  number.setAttribute('aria-valuetext', designInWords(seenDesign()));
  byId('over').value = String(page.over);
}

export function startPlots() {
  const several = designs.length > 1;
  byId('designs-box').hidden = byId('pickers').hidden = !several;
  if (several) {
    byId('number').oninput = (event) => see(byCables[Number(event.target.value)]);
    byId('design').onchange = (event) => see(Number(event.target.value));
    byId('over').onchange = (event) => change({ over: Number(event.target.value) });
    onChange(['design', 'over'], showPickers);
    onChange(['design'], markDesign);
    onChange(['unit'], showDesigns);
    showPickers();
    showDesigns();
    drawTradeOff();
  }
  onChange(['design'], drawSearch);
  drawSearch();
  matchMedia('(prefers-color-scheme: dark)').addEventListener('change', () => {
    if (several) drawTradeOff();
    drawSearch();
  });
}
