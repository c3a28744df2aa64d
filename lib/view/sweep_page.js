// The report of a sweep: reads the data that view/sweep_report.cpp wrote into the page, keeps the selection, and responds to the lists,
// the pointer and the keyboard. It fetches nothing. A design is selected if it lies inside all intervals, or if it was clicked; without
// any interval or click all designs are selected.
const MAX_CURVES = 2000, MAX_ROWS = 200, NEAR = 14, DEFAULT_AXES = 9;   // NEAR: pixels

const byId = (id) => document.getElementById(id);
const data = JSON.parse(byId('data').textContent);
const columns = data.columns.map((column) => withRange(column, [column.values]));
const count = data.designs.length;
const isEarly = (d) => data.designs[d].code !== 0;
const state = { intervals: new Map(), picked: new Set(), hovered: -1, selected: [], front: [], axes: [], frames: {}, sort: null };

function element(name, text = '', attributes = {}) {
  const made = document.createElement(name);
  made.textContent = text;
  for (const [key, value] of Object.entries(attributes)) made.setAttribute(key, value);
  return made;
}
const chosen = (id) => Number(byId(id).value);
const valueText = (column, value) => (!isNumber(value) ? '' : column.words ? column.words[value] : numberText(value));

// Colours

function coloursOfAll() {
  const column = columns[chosen('colour')], known = column.values.filter(isNumber);
  const low = known.reduce((a, b) => Math.min(a, b), Infinity), high = known.reduce((a, b) => Math.max(a, b), -Infinity);
  return column.values.map((value) => {
    if (!isNumber(value)) return NO_VALUE;
    if (column.words) return WORD_COLOURS[value % WORD_COLOURS.length];
    return data.palette[high > low ? Math.round((value - low) / (high - low) * (data.palette.length - 1)) : 0];
  });
}

function showLegend() {
  const column = columns[chosen('colour')], legend = byId('legend');
  const known = column.values.filter(isNumber);
  legend.replaceChildren();
  if (column.words) {
    column.words.forEach((word, i) => {
      const swatch = element('span', '', { class: 'swatch' });
      swatch.style.background = WORD_COLOURS[i % WORD_COLOURS.length];
      legend.append(swatch, element('span', word));
    });
  } else if (known.length > 0) {
    const bar = element('span', '', { class: 'bar' });
    bar.style.background = `linear-gradient(to right, ${data.palette.join(', ')})`;
    const [low, high] = [Math.min, Math.max].map((end) => numberText(known.reduce((a, b) => end(a, b))));
    legend.append(element('span', low), bar, element('span', `${high} ${column.unit}`));
  }
}

// Selection

function isInside(d) {
  for (const [c, [low, high]] of state.intervals) {
    const value = columns[c].values[d];
    if (!isNumber(value) || value < low || value > high) return false;
  }
  return true;
}

function updateSelection() {
  const { intervals, picked } = state;
  state.selected = data.designs.map((_, d) => picked.has(d) || (intervals.size > 0 ? isInside(d) : picked.size === 0));
}

function setBounds(c, interval) {
  if (interval) state.intervals.set(c, interval);
  else state.intervals.delete(c);
  refresh();
}

function pick(d) {
  if (state.picked.has(d)) state.picked.delete(d);
  else state.picked.add(d);
  refresh();
}

function clearSelection() {
  state.intervals.clear();
  state.picked.clear();
  refresh();
}

// Charts

const overlayOf = (chart) => byId(`${chart}-over`);

function drawScatter() {
  const x = columns[chosen('x')], y = columns[chosen('y')], frame = frameOf(byId('scatter'), x, y);
  const designs = data.designs
    .map((_, d) => ({ index: d, x: x.values[d], y: y.values[d], colour: colours[d], isSelected: state.selected[d], isEarly: isEarly(d) }))
    .filter((design) => isNumber(design.x) && isNumber(design.y));
  state.front = byId('front').checked ? paretoFront(designs.filter((design) => design.isSelected), chosen('x-goal'), chosen('y-goal')) : [];
  state.frames.scatter = { ...frame, designs };
  drawPoints(byId('scatter'), frame, designs, state.front);
}

function drawParallelChart() {
  const frame = parallelFrame(byId('parallel'), state.axes.map((c) => columns[c]));
  const designs = data.designs.map((_, d) => (
    { index: d, values: state.axes.map((c) => columns[c].values[d]), colour: colours[d], isSelected: state.selected[d], isEarly: isEarly(d) }));
  state.frames.parallel = { ...frame, designs };
  drawParallel(byId('parallel'), frame, designs);
}

function drawCurveChart() {
  const over = chosen('curve-x'), of = chosen('curve-y');
  if (data.trace_columns.length === 0) {   // no design was solved
    const { context, width, height } = sizeCanvas(byId('curves'));
    state.frames.curves = { curves: [] };
    return drawMessage(context, width, height, 'no design has a curve');
  }
  const all = data.traces.map((trace, d) => (
    { index: d, xs: trace?.[over], ys: trace?.[of], colour: colours[d], isSelected: state.selected[d], isEarly: isEarly(d) }))
    .filter((curve) => curve.xs && curve.ys).sort((a, b) => b.isSelected - a.isSelected);
  const curves = all.slice(0, MAX_CURVES);
  const axis = (c, key) => withRange(data.trace_columns[c], curves.map((curve) => curve[key]));
  const frame = frameOf(byId('curves'), axis(over, 'xs'), axis(of, 'ys'));
  state.frames.curves = { ...frame, curves };
  byId('curve-note').textContent = all.length > curves.length ? `${curves.length} of ${all.length} curves are drawn, selected ones first.` : '';
  return drawCurves(byId('curves'), frame, curves);
}

function drawIntervals(context, frame) {
  context.fillStyle = 'rgb(0 114 178 / 20%)';
  context.strokeStyle = '#0072B2';
  state.axes.forEach((c, i) => {
    const interval = state.intervals.get(c);
    if (!interval) return;
    const [low, high] = interval.map((value) => Math.min(frame.axes[i].high, Math.max(frame.axes[i].low, value)));
    context.fillRect(frame.x(i) - 9, frame.y(i, high), 18, frame.y(i, low) - frame.y(i, high));
    context.strokeRect(frame.x(i) - 9, frame.y(i, high), 18, frame.y(i, low) - frame.y(i, high));
  });
}

// The hovered design and the intervals, above the charts.
function drawOverlays() {
  const { scatter, parallel, curves } = state.frames, d = state.hovered;
  for (const chart of ['scatter', 'parallel', 'curves']) {
    const { context } = sizeCanvas(overlayOf(chart)), path = new Path2D();
    if (chart === 'parallel') drawIntervals(context, parallel);
    if (chart === 'scatter') {
      const point = scatter.designs.find((design) => design.index === d);
      if (point) addMarker(path, scatter.x(point.x), scatter.y(point.y), false, 8);
    } else if (chart === 'parallel' && d >= 0) {
      addParallelLine(path, parallel, parallel.designs[d].values);
    } else if (chart === 'curves') {
      const curve = curves.curves.find((each) => each.index === d);
      curve?.xs.forEach((x, i) => path[i === 0 ? 'moveTo' : 'lineTo'](curves.x(x), curves.y(curve.ys[i])));
    }
    context.strokeStyle = BLACK;
    context.lineWidth = 3;
    context.stroke(path);
  }
  for (const row of document.querySelectorAll('tr.hovered')) row.classList.remove('hovered');
  if (d >= 0) for (const row of document.querySelectorAll(`tr[data-design="${d}"]`)) row.classList.add('hovered');
}

function describe(d) {
  const design = data.designs[d];
  const shown = [...new Set([...columns.keys()].filter((c) => columns[c].parameter)), chosen('x'), chosen('y'), chosen('colour')];
  const lines = [...new Set(shown)].map((c) => `${columns[c].label}: ${valueText(columns[c], columns[c].values[d]) || 'no value'} ${columns[c].unit}`);
  return [`${design.id} (${design.stop})`, ...lines, ...(design.error ? [design.error] : [])].join('\n');
}

function hover(d, event = null) {
  const tip = byId('tip');
  if (d !== state.hovered) {
    state.hovered = d;
    drawOverlays();
    if (d >= 0) tip.textContent = describe(d);
  }
  tip.hidden = d < 0 || !event;
  if (tip.hidden) return;
  tip.style.left = `${Math.min(event.clientX + 16, window.innerWidth - tip.offsetWidth - 8)}px`;
  tip.style.top = `${Math.min(event.clientY + 16, window.innerHeight - tip.offsetHeight - 8)}px`;
}

// Pointer

const positionIn = (chart, event) => {
  const box = overlayOf(chart).getBoundingClientRect();
  return [event.clientX - box.left, event.clientY - box.top];
};

// Squared distance to the polyline; only vertices and the segments between them.
function distanceToLine(x, y, points) {
  let nearest = Infinity;
  points.forEach(([bx, by], i) => {
    const [ax, ay] = points[Math.max(0, i - 1)], length = (bx - ax) ** 2 + (by - ay) ** 2;
    const t = length > 0 ? Math.min(1, Math.max(0, ((x - ax) * (bx - ax) + (y - ay) * (by - ay)) / length)) : 0;
    nearest = Math.min(nearest, (ax + t * (bx - ax) - x) ** 2 + (ay + t * (by - ay) - y) ** 2);
  });
  return nearest;
}

// The nearest design at a position of a chart, selected ones first; -1 if none is near.
function designAt(chart, x, y) {
  const frame = state.frames[chart], items = frame.designs ?? frame.curves;
  const points = (item) => (chart === 'scatter' ? [[frame.x(item.x), frame.y(item.y)]]
    : chart === 'parallel' ? item.values.flatMap((value, i) => (isNumber(value) ? [[frame.x(i), frame.y(i, value)]] : []))
      : item.xs.map((over, i) => [frame.x(over), frame.y(item.ys[i])]));
  let found = -1, nearest = NEAR ** 2;
  for (const isSelected of [true, false]) {
    for (const item of items) {
      if (item.isSelected !== isSelected) continue;
      const distance = distanceToLine(x, y, points(item));
      if (distance < nearest) { nearest = distance; found = item.index; }
    }
    if (found >= 0) break;
  }
  return found;
}

// A drag sets intervals: on an axis of the parallel coordinates, or of both quantities by a rectangle in the scatter plot.
function dragged(chart, [x0, y0], [x1, y1]) {
  const frame = state.frames[chart], sorted = (a, b) => [Math.min(a, b), Math.max(a, b)];
  if (chart === 'parallel') {
    const i = Math.min(state.axes.length - 1, Math.max(0, Math.floor(x0 / frame.space)));
    return setBounds(state.axes[i], sorted(frame.value(i, y0), frame.value(i, y1)));
  }
  state.intervals.set(chosen('x'), sorted(frame.xValue(x0), frame.xValue(x1)));
  return setBounds(chosen('y'), sorted(frame.yValue(y0), frame.yValue(y1)));
}

function watchPointer(chart) {
  const canvas = overlayOf(chart);
  let from = null, isDrag = false;
  canvas.addEventListener('pointerdown', (event) => { from = positionIn(chart, event); isDrag = false; canvas.setPointerCapture(event.pointerId); });
  canvas.addEventListener('pointermove', (event) => {
    const at = positionIn(chart, event);
    if (from && chart !== 'curves' && (isDrag || Math.hypot(at[0] - from[0], at[1] - from[1]) > 4)) {
      isDrag = true;
      hover(-1);
      dragged(chart, from, at);
    } else hover(designAt(chart, ...at), event);
  });
  canvas.addEventListener('pointerup', (event) => {
    const at = positionIn(chart, event), d = designAt(chart, ...at), i = Math.floor(at[0] / (state.frames.parallel.space || 1));
    if (from && !isDrag) {
      const isOnAxis = chart === 'parallel' && Math.abs(at[0] - state.frames.parallel.x(i)) < NEAR && state.intervals.has(state.axes[i]);
      if (isOnAxis) setBounds(state.axes[i], null);
      else if (d >= 0) pick(d);
    }
    from = null;
  });
  canvas.addEventListener('pointerleave', () => hover(-1));
  canvas.addEventListener('keydown', (event) => {   // the arrows go from design to design, Enter picks
    const order = chart === 'scatter' ? [...state.frames.scatter.designs].sort((a, b) => a.x - b.x).map((design) => design.index) : [...data.designs.keys()];
    const step = { ArrowRight: 1, ArrowDown: 1, ArrowLeft: -1, ArrowUp: -1 }[event.key];
    if (step && order.length > 0) {
      const at = order.indexOf(state.hovered);
      hover(order[at < 0 ? (step > 0 ? 0 : order.length - 1) : (at + step + order.length) % order.length]);
      byId('focused').textContent = describe(state.hovered);
    } else if (event.key === 'Enter' && state.hovered >= 0) pick(state.hovered);
    else return;
    event.preventDefault();
  });
}
