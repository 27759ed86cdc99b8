// The page around the 3D view: facts, cut list, marks. Defines `page`, which the view uses.
'use strict';
const page = (() => {
  const design = JSON.parse(document.getElementById('design').textContent);
  const byId = (id) => document.getElementById(id);

  function element(tag, text, className) {
    const result = document.createElement(tag);
    if (text !== undefined) result.textContent = text;
    if (className) result.className = className;
    return result;
  }

  // A tenth of a millimetre is all that anyone cuts.
  const decimals = { mm: 1, cm: 2, m: 4 }[design.length_unit] ?? 3;
  const length = (value) => value.toFixed(decimals);
  const significant = (value, digits) =>
    value === 0 ? '0' : Math.abs(value) >= 1e5 || Math.abs(value) < 1e-3
      ? value.toExponential(digits - 1)
      : value.toLocaleString('en', { maximumSignificantDigits: digits, useGrouping: false });
  const tension = (value) => significant(value, 3);

  // Names as tencer/core/names.hpp has them: rods by letter, so that they are not taken for the
  // cables' numbers; the only one needs none.
  const only = design.rods.length === 1;
  const rodName = (rod) =>
    (rod >= 26 ? rodName(Math.floor(rod / 26) - 1) : '') + String.fromCharCode(65 + rod % 26);
  const anchorName = (anchor) => `anchor ${anchor + 1}`;
  const rodInWords = (rod) => only ? 'the rod' : `rod ${rodName(rod)}`;
  const cableInWords = (cable) => `cable ${cable + 1}`;
  const placeInWords = (rod, s) =>
    only ? `${length(s)} along the rod` : `${rodName(rod)} at ${length(s)}`;
  const endName = (end) =>
    end.anchor === undefined ? placeInWords(end.rod, end.s) : anchorName(end.anchor);

  function facts() {
    const title = design.name || 'tencer design';
    document.title = title;
    byId('name').textContent = title;
    const warnings = {
      'tolerance-not-reached': 'This design falls short of what was asked for.',
      interrupted: 'The search was interrupted; this is the best design until then.',
    };
    if (warnings[design.status]) {
      byId('status').textContent = warnings[design.status];
      byId('status').className = 'bad';
    }
    const list = byId('facts');
    const add = (name, value, className) => {
      const item = element('div');
      item.append(element('dt', name), element('dd', value, className));
      list.append(item);
    };
    add('cables', design.cables.length);
    add('rods', design.rods.map((rod) => rod.rest_lengths.reduce((a, b) => a + b, 0))
      .map((sum, i) => `${only ? '' : `${rodName(i)}: `}${length(sum)} ${design.length_unit}`)
      .join(', '));
    if (design.error) {
      add('largest error', `${significant(design.error.max_percent, 3)} %`);
      add('rms error', `${significant(design.error.rms_percent, 3)} %`);
    }
    const certificate = design.certificate;
    if (!certificate) return add('certificate', 'none');
    const passed = design.check && design.check.passed && design.check.stands;
    add('in this pose', certificate.stable ? 'it stands' : 'it does not stand',
      certificate.stable ? (passed ? 'good' : '') : 'bad');
    add('slack cables', certificate.slack_cables, certificate.slack_cables ? 'bad' : '');
    add('smallest eigenvalue',
      `${significant(certificate.smallest_eigenvalue, 3)} ${certificate.eigenvalue_unit || ''}`);
    add('residual', significant(certificate.residual, 2));
  }

  // What the check says, a line a section; good is only what it passed.
  function check() {
    const list = byId('check');
    const add = (section, text, className) =>
      list.append(element('dt', section, className), element('dd', text));
    const found = design.check ? design.check.lines : [];
    const told = ['repair', 'weight']; // for people to judge
    found.forEach((line) =>
      add(line.section, line.text, line.fails ? 'bad' : told.includes(line.section) ? '' : 'good'));
    // Whether it stands is among the facts anyway.
    const missing = (design.check ? design.check.not_looked_at : ['whether it can be built'])
      .filter((name) => name !== 'stands' || !design.certificate);
    if (missing.length) add('not checked', `${missing.join(', ')}: run tencer check`);
    (design.check ? design.check.fails : []).forEach((fail) => add('fails', fail, 'bad'));
  }

  function row(cells, tag, textColumns) {
    const result = element('tr');
    cells.forEach((cell, i) =>
      result.append(element(tag, cell, textColumns.includes(i) ? 'text' : '')));
    return result;
  }

  function table(target, titles, rows, textColumns) {
    const head = element('thead');
    head.append(row(titles, 'th', textColumns));
    const body = element('tbody');
    rows.forEach((cells) => body.append(row(cells, 'td', textColumns)));
    target.append(head, body);
    return body;
  }

  const listTitles = ['cable', `length ${design.length_unit}`, 'from', 'to',
    `tension ${design.force_unit}`];
  const listRows = design.cables.map((cable, i) =>
    [i + 1, length(cable.length), endName(cable.a), endName(cable.b), tension(cable.tension)]);

  function cutList() {
    const body = table(byId('cables'), listTitles, listRows, [2, 3]);
    const total = design.cables.reduce((sum, cable) => sum + cable.length, 0);
    const foot = element('tfoot');
    foot.append(row(['total', length(total), '', '', ''], 'td', []));
    byId('cables').append(foot);
    byId('save-list').onclick = () => {
      const text = [listTitles, ...listRows].map((cells) => cells.join(',')).join('\n') + '\n';
      const link = element('a');
      link.href = URL.createObjectURL(new Blob([text], { type: 'text/csv' }));
      link.download = 'cut-list.csv';
      link.click();
      setTimeout(() => URL.revokeObjectURL(link.href), 1000);
    };
    return [...body.rows];
  }

  // Where to mark each rod, along its length.
  function marks() {
    design.rods.forEach((rod, r) => {
      const ends = design.cables.flatMap((cable, i) => [[cable.a, cable.b, i], [cable.b, cable.a, i]])
        .filter(([end]) => end.rod === r).sort(([a], [b]) => a.s - b.s);
      if (!ends.length) return;
      const result = element('table');
      table(result, [`s ${design.length_unit}`, 'cable', 'goes to'],
        ends.map(([end, other, i]) => [length(end.s), i + 1, endName(other)]), [2]);
      const scroll = element('div', undefined, 'scroll');
      scroll.append(result);
      byId('marks').append(element('h2', `Marks on ${rodInWords(r)}`), scroll);
    });
  }

  function description(i) {
    const cable = design.cables[i];
    return [cableInWords(i), `from ${endName(cable.a)}`, `to ${endName(cable.b)}`,
      `length ${length(cable.length)} ${design.length_unit}`,
      `tension ${tension(cable.tension)} ${design.force_unit}`];
  }

  facts();
  check();
  const rows = cutList();
  marks();
  return { design, byId, element, rodInWords, anchorName, tension, description, rows };
})();
