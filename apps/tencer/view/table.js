// Tables of the page.
import { element } from './page.js';

function tableRow(cells, tag, textColumns) {
  const result = element('tr');
  cells.forEach((cell, i) => {
    const made = element(tag, cell, textColumns.includes(i) ? 'text' : '');
    if (tag === 'th') made.scope = 'col';
    result.append(made);
  });
  return result;
}

// Fills `target`; returns its rows. textColumns: those to be set flush left.
export function fillTable(target, titles, rows, textColumns, foot) {
  const head = element('thead');
  head.append(tableRow(titles, 'th', textColumns));
  const body = element('tbody');
  rows.forEach((cells) => body.append(tableRow(cells, 'td', textColumns)));
  target.replaceChildren(head, body);
  if (foot) {
    const last = element('tfoot');
    last.append(tableRow(foot, 'td', textColumns));
    target.append(last);
  }
  return [...body.rows];
}

// A heading and a table in a box that scrolls, as one block; with what it says under the heading.
export function tableSection(heading, titles, rows, textColumns, note) {
  const result = element('section');
  result.append(element('h2', heading));
  if (note) result.append(element('p', note, 'soft'));
  const table = element('table');
  fillTable(table, titles, rows, textColumns);
  const scroll = element('div', undefined, 'scroll');
  scroll.append(table);
  result.append(scroll);
  return result;
}

// Rows that are chosen by a click, Enter or the space bar; the arrows go from one to the next.
export function makeChoosable(rows, choose) {
  rows.forEach((row, i) => {
    row.tabIndex = 0;
    row.addEventListener('click', () => choose(i));
    row.addEventListener('keydown', (event) => {
      const step = { ArrowDown: 1, ArrowUp: -1 }[event.key];
      if (event.key === 'Enter' || event.key === ' ') choose(i);
      else if (step && rows[i + step]) rows[i + step].focus();
      else return;
      event.preventDefault();
    });
  });
}
