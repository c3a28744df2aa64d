// The lists, intervals and tables of the report of a sweep, and its start.

// The intervals as fields, for the keyboard and for exact values.
function showIntervalFields() {
  const fields = state.axes.map((c) => {
    const column = columns[c], set = element('fieldset'), interval = state.intervals.get(c);
    set.append(element('legend', axisTitle(column)));
    if (column.words) {
      const list = element('select', '', { 'aria-label': column.label, 'data-column': c });
      list.add(new Option('all', ''));
      column.words.forEach((word, i) => list.add(new Option(word, i)));
      list.value = interval ? Math.round((interval[0] + interval[1]) / 2) : '';
      list.addEventListener('change', () => setBounds(c, list.value === '' ? null : [Number(list.value) - 0.5, Number(list.value) + 0.5]));
      set.append(list);
      return set;
    }
    const inputs = ['from', 'to'].map((word, end) => {
      const input = element('input', '', { type: 'number', step: 'any', 'aria-label': `${column.label} ${word}`, 'data-column': c, 'data-end': end });
      const value = interval?.[end];
      input.value = isNumber(value) && Number.isFinite(value) ? Number(value.toPrecision(6)) : '';
      return input;
    });
    for (const input of inputs)
      input.addEventListener('change', () => {
        const [low, high] = inputs.map((each) => (each.value === '' ? null : Number(each.value)));
        setBounds(c, low === null && high === null ? null : [low ?? -Infinity, high ?? Infinity]);
      });
    set.append(inputs[0], element('span', ' to '), inputs[1]);
    return set;
  });
  byId('intervals').replaceChildren(...fields);
}

function headCell(text, key) {
  const cell = element('th', '', { scope: 'col' }), button = element('button', text, { type: 'button' });
  const { sort } = state;
  cell.setAttribute('aria-sort', sort?.key !== key ? 'none' : sort.goal > 0 ? 'ascending' : 'descending');
  button.addEventListener('click', () => { state.sort = { key, goal: sort?.key === key ? -sort.goal : 1 }; showTables(); });
  cell.append(button);
  return cell;
}

function rowOf(d, cells) {
  const row = element('tr', '', { 'data-design': d, tabindex: 0 });
  if (state.picked.has(d)) row.classList.add('picked');
  row.append(...cells.map((text) => element('td', text)));
  row.addEventListener('pointerenter', () => hover(d));
  row.addEventListener('pointerleave', () => hover(-1));
  row.addEventListener('focus', () => hover(d));
  row.addEventListener('click', () => pick(d));
  row.addEventListener('keydown', (event) => { if (event.key === 'Enter') pick(d); });
  return row;
}

function sortedSelection() {
  const { sort } = state, selected = [...data.designs.keys()].filter((d) => state.selected[d]);
  if (sort) {
    const value = (d) => columns[sort.key].values[d];
    selected.sort((a, b) => (isNumber(value(b)) - isNumber(value(a))) || sort.goal * (value(a) - value(b)));
  }
  return selected;
}

function showTables() {
  const front = new Set(state.front.map((design) => design.index)), selected = sortedSelection();
  const cells = (d, shown) => shown.map((c) => valueText(columns[c], columns[c].values[d]));
  const all = [...columns.keys()], parameters = all.filter((c) => columns[c].parameter);
  byId('selected-head').replaceChildren(element('th', 'ID', { scope: 'col' }), element('th', 'front', { scope: 'col' }),
    ...all.map((c) => headCell(axisTitle(columns[c]), c)), element('th', 'stop reason', { scope: 'col' }));
  byId('selected-rows').replaceChildren(...selected.slice(0, MAX_ROWS).map((d) => (
    rowOf(d, [data.designs[d].id, front.has(d) ? 'yes' : '', ...cells(d, all), data.designs[d].stop]))));
  byId('rows-note').textContent = selected.length > MAX_ROWS ? `The first ${MAX_ROWS} of ${selected.length} designs are listed.` : '';
  const early = [...data.designs.keys()].filter(isEarly);
  byId('early-section').hidden = early.length === 0;
  byId('early-head').replaceChildren(...['ID', ...parameters.map((c) => axisTitle(columns[c])), 'stop reason', 'exit code', 'reason']
    .map((text) => element('th', text, { scope: 'col' })));
  byId('early-rows').replaceChildren(...early.slice(0, MAX_ROWS).map((d) => {
    const { id, stop, code, error } = data.designs[d];
    return rowOf(d, [id, ...cells(d, parameters), stop, code === null ? '' : String(code), error]);
  }));
  byId('early-note').textContent = early.length > MAX_ROWS ? `The first ${MAX_ROWS} of ${early.length} designs are listed.` : '';
}

function showStatus() {
  const selected = state.selected.filter(Boolean).length, drawn = state.frames.scatter.designs.length;
  const parts = [`${selected} of ${count} designs selected`];
  if (state.front.length > 0) parts.push(`Pareto front of the selected: ${state.front.length}`);
  if (drawn < count) parts.push(`without a point in the scatter plot: ${count - drawn}`);
  byId('status').textContent = parts.join('; ');
}

// Everything that depends on the selection or the lists, once per frame.
let colours = [], isWaiting = false;
function refresh() {
  if (isWaiting) return;
  isWaiting = true;
  requestAnimationFrame(() => {
    isWaiting = false;
    updateSelection();
    colours = coloursOfAll();
    drawScatter();
    drawParallelChart();
    drawCurveChart();
    drawOverlays();
    showLegend();
    showStatus();
    showTables();
    if (!byId('intervals').contains(document.activeElement)) showIntervalFields();
  });
}

function fillList(id, list, selected) {
  list.forEach((axis, i) => byId(id).add(new Option(axisTitle(axis), i)));
  byId(id).value = selected;
  byId(id).addEventListener('change', refresh);
}

function start() {
  const all = [...columns.keys()], varies = (c) => {
    const known = columns[c].values.filter(isNumber);
    return known.length > 0 && differ(...[Math.min, Math.max].map((end) => known.reduce((a, b) => end(a, b))));
  };
  const parameters = all.filter((c) => columns[c].parameter), outputs = all.filter((c) => !columns[c].parameter && varies(c));
  const x = outputs.length > 1 ? outputs[0] : parameters[0], y = outputs.length > 1 ? outputs[1] : outputs[0] ?? parameters[parameters.length - 1];
  fillList('x', columns, x);
  fillList('y', columns, y);
  fillList('colour', columns, parameters.find(varies) ?? 0);
  fillList('curve-x', data.trace_columns, data.curve_axes[0]);
  fillList('curve-y', data.trace_columns, data.curve_axes[1]);
  for (const id of ['x-goal', 'y-goal', 'front']) byId(id).addEventListener('change', refresh);
  byId('front').checked = outputs.length > 1;
  state.axes = [...parameters, ...outputs].slice(0, Math.max(DEFAULT_AXES, parameters.length));
  for (const c of all) {
    const label = element('label'), box = element('input', '', { type: 'checkbox', 'data-column': c });
    box.checked = state.axes.includes(c);
    box.addEventListener('change', () => {
      state.axes = all.filter((each) => document.querySelector(`#axes input[data-column="${each}"]`).checked);
      refresh();
    });
    label.append(box, ` ${axisTitle(columns[c])}`);
    byId('axes').append(label);
  }
  byId('clear').addEventListener('click', clearSelection);
  byId('intervals').addEventListener('focusout', () => setTimeout(refresh));
  document.addEventListener('keydown', (event) => { if (event.key === 'Escape') clearSelection(); });
  for (const chart of ['scatter', 'parallel', 'curves']) watchPointer(chart);
  new ResizeObserver(refresh).observe(byId('parallel'));
  refresh();
}

start();
