// Files that the reader takes along.
import { seenDesign } from './page.js';
import { designInWords } from './words.js';

function save(blob, name) {
  const link = document.createElement('a');
  link.href = URL.createObjectURL(blob);
  link.download = name;
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 1000);
}

// "trefoil-6-cables-marks.csv"
export const fileName = (what) =>
  `${designInWords(seenDesign()).replace(/[^\p{L}\p{N}]+/gu, '-')}-${what}`;

const csvCell = (value) => /[",\n]/.test(value) ? `"${String(value).replace(/"/g, '""')}"` : value;

// The rows get the design's name in front: sheets of several designs are laid together.
export function saveCsv(what, titles, rows) {
  const { name } = seenDesign();
  const lines = [['design', ...titles], ...rows.map((cells) => [name, ...cells])];
  const text = lines.map((cells) => cells.map(csvCell).join(',') + '\n').join('');
  save(new Blob([text], { type: 'text/csv' }), fileName(`${what}.csv`));
}

export function savePng(canvas) {
  canvas.toBlob((blob) => save(blob, fileName('view.png')), 'image/png');
}
