// Charts of the report of a sweep, drawn on canvases: axes, points, parallel coordinates and curves. No state: sweep_page.js owns it.
const WORD_COLOURS = ['#0072B2', '#D55E00', '#009E73', '#CC79A7', '#E69F00', '#56B4E9'];   // Okabe and Ito
const GREY = '#c4c4c4', BLACK = '#1a1a1a', NO_VALUE = '#8a8a8a';
const MARGIN = { left: 68, right: 14, top: 12, bottom: 50 }, HEAD = 74, FOOT = 26;   // HEAD and FOOT: of parallel coordinates

const numberText = (value) => Number(value.toPrecision(4)).toString();
const isNumber = (value) => value !== null && value !== undefined;
const differ = (low, high) => high - low > 1e-6 * Math.max(Math.abs(low), Math.abs(high));   // by more than the rounding of a goal
const axisTitle = (axis) => (axis.unit ? `${axis.label} (${axis.unit})` : axis.label);

function sizeCanvas(canvas) {   // in CSS pixels, on screens of any resolution
  const scale = window.devicePixelRatio || 1, width = canvas.clientWidth, height = canvas.clientHeight;
  canvas.width = Math.round(width * scale);
  canvas.height = Math.round(height * scale);
  const context = canvas.getContext('2d');
  context.setTransform(scale, 0, 0, scale, 0, 0);
  context.clearRect(0, 0, width, height);
  context.font = '13px system-ui, sans-serif';
  return { context, width, height };
}

function ticks(low, high, count) {
  const raw = (high - low) / count, power = 10 ** Math.floor(Math.log10(raw));
  const step = power * [1, 2, 5, 10].find((factor) => factor * power >= 0.999 * raw), found = [];
  for (let i = Math.ceil(low / step - 1e-9); i * step <= high + 1e-9 * step; ++i) found.push(i * step);
  return found;
}

// The range of an axis: that of the values and, for words, half a place more on both sides.
function withRange(axis, lists) {
  let low = Infinity, high = -Infinity;
  for (const list of lists)
    for (const value of list ?? [])
      if (isNumber(value)) { low = Math.min(low, value); high = Math.max(high, value); }
  if (axis.words) { low = -0.5; high = axis.words.length - 0.5; }
  if (!(low <= high)) { low = 0; high = 1; }
  const space = axis.words ? 0 : differ(low, high) ? 0.03 * (high - low) : Math.abs(low) * 0.1 || 1;
  return { ...axis, low: low - space, high: high + space };
}

const axisTicks = (axis, count) => (axis.words
  ? axis.words.map((text, at) => ({ at, text })) : ticks(axis.low, axis.high, count).map((at) => ({ at, text: numberText(at) })));

function shortened(context, text, width) {
  if (context.measureText(text).width <= width) return text;
  let length = text.length;
  while (length > 1 && context.measureText(`${text.slice(0, length)}…`).width > width) --length;
  return `${text.slice(0, length)}…`;
}

function wrapped(context, text, width, maxLines) {
  const lines = [''];
  for (const word of text.split(/(?<=[ .=_])/)) {
    const longer = lines[lines.length - 1] + word;
    if (lines[lines.length - 1] === '' || context.measureText(longer).width <= width) lines[lines.length - 1] = longer;
    else lines.push(word);
  }
  if (lines.length > maxLines) lines.splice(maxLines - 1, Infinity, lines.slice(maxLines - 1).join(''));
  return lines.map((line) => shortened(context, line.trim(), width));
}

// Maps values of two axes to pixels and back, inside the margins.
function frameOf(canvas, xAxis, yAxis) {
  const left = MARGIN.left, right = canvas.clientWidth - MARGIN.right, top = MARGIN.top, bottom = canvas.clientHeight - MARGIN.bottom;
  return {
    left, right, top, bottom, xAxis, yAxis,
    x: (value) => left + (right - left) * (value - xAxis.low) / (xAxis.high - xAxis.low),
    y: (value) => bottom - (bottom - top) * (value - yAxis.low) / (yAxis.high - yAxis.low),
    xValue: (x) => xAxis.low + (xAxis.high - xAxis.low) * (x - left) / (right - left),
    yValue: (y) => yAxis.low + (yAxis.high - yAxis.low) * (bottom - y) / (bottom - top),
  };
}

function drawFrame(context, frame) {
  const { left, right, top, bottom, xAxis, yAxis } = frame;
  context.lineWidth = 1;
  context.fillStyle = BLACK;
  context.textAlign = 'center';
  context.textBaseline = 'top';
  const xTicks = axisTicks(xAxis, Math.max(2, (right - left) / 90)), place = (right - left) / Math.max(1, xTicks.length);
  for (const { at, text } of xTicks) {
    context.strokeStyle = '#e6e6e6';
    context.strokeRect(frame.x(at), top, 0, bottom - top);
    context.fillText(shortened(context, text, place), frame.x(at), bottom + 6);
  }
  context.textAlign = 'right';
  context.textBaseline = 'middle';
  for (const { at, text } of axisTicks(yAxis, Math.max(2, (bottom - top) / 60))) {
    context.strokeRect(left, frame.y(at), right - left, 0);
    context.fillText(shortened(context, text, left - 24), left - 6, frame.y(at));
  }
  context.strokeStyle = BLACK;
  context.strokeRect(left, bottom, right - left, 0);
  context.strokeRect(left, top, 0, bottom - top);
  context.textAlign = 'center';
  context.fillText(shortened(context, axisTitle(xAxis), right - left), (left + right) / 2, bottom + 36);
  context.save();
  context.translate(12, (top + bottom) / 2);
  context.rotate(-Math.PI / 2);
  context.fillText(shortened(context, axisTitle(yAxis), bottom - top), 0, 0);
  context.restore();
}

function drawMessage(context, width, height, text) {
  context.fillStyle = NO_VALUE;
  context.textAlign = 'center';
  context.fillText(text, width / 2, height / 2);
}

// A point; a cross if the path of the design ended early.
function addMarker(path, x, y, isEarly, radius) {
  if (isEarly) {
    path.moveTo(x - radius, y - radius); path.lineTo(x + radius, y + radius);
    path.moveTo(x - radius, y + radius); path.lineTo(x + radius, y - radius);
  } else {
    path.moveTo(x + radius, y);
    path.arc(x, y, radius, 0, 2 * Math.PI);
  }
}

// Collects shapes of the same colour, which are then drawn at once.
class Strokes {
  constructor() { this.paths = new Map(); }
  at(colour) {
    if (!this.paths.has(colour)) this.paths.set(colour, new Path2D());
    return this.paths.get(colour);
  }
  draw(context, alpha, isFilled) {
    context.globalAlpha = alpha;
    for (const [colour, path] of this.paths) {
      context.strokeStyle = context.fillStyle = colour;
      if (isFilled) context.fill(path);
      context.stroke(path);
    }
    context.globalAlpha = 1;
  }
}

// Many lines become transparent, so that their density is visible.
const lineAlpha = (count) => Math.min(0.9, Math.max(0.12, 40 / count));

// `designs`: {index, x, y, colour, isSelected, isEarly}; `front`: indices in the order of x.
function drawPoints(canvas, frame, designs, front) {
  const { context, width, height } = sizeCanvas(canvas);
  drawFrame(context, frame);
  if (designs.length === 0) drawMessage(context, width, height, 'no design has a value for both axes');
  const radius = designs.length > 2000 ? 2 : 4;
  context.lineWidth = 1.5;
  for (const isSelected of [false, true]) {
    const strokes = new Strokes();
    for (const design of designs)
      if (design.isSelected === isSelected)
        addMarker(strokes.at(isSelected ? design.colour : GREY), frame.x(design.x), frame.y(design.y), design.isEarly, radius);
    strokes.draw(context, isSelected ? 1 : 0.7, true);
  }
  if (front.length === 0) return;
  const line = new Path2D(), rings = new Path2D();
  front.forEach((design, i) => {
    line[i === 0 ? 'moveTo' : 'lineTo'](frame.x(design.x), frame.y(design.y));
    addMarker(rings, frame.x(design.x), frame.y(design.y), false, radius + 3);
  });
  context.strokeStyle = BLACK;
  context.stroke(rings);
  context.setLineDash([5, 4]);
  context.stroke(line);
  context.setLineDash([]);
}

// Pixels of the axes of parallel coordinates.
function parallelFrame(canvas, axes) {
  const width = canvas.clientWidth, top = HEAD, bottom = canvas.clientHeight - FOOT, space = width / Math.max(1, axes.length);
  return {
    axes, top, bottom, space,
    x: (i) => (i + 0.5) * space,
    y: (i, value) => bottom - (bottom - top) * (value - axes[i].low) / (axes[i].high - axes[i].low),
    value: (i, y) => axes[i].low + (axes[i].high - axes[i].low) * (bottom - Math.min(bottom, Math.max(top, y))) / (bottom - top),
  };
}

// A line through the axes that have a value; a single value between two missing ones is a short bar.
function addParallelLine(path, frame, values) {
  let isOpen = false;
  values.forEach((value, i) => {
    if (!isNumber(value)) { isOpen = false; return; }
    const x = frame.x(i), y = frame.y(i, value);
    if (isOpen) path.lineTo(x, y);
    else if (isNumber(values[i + 1])) path.moveTo(x, y);
    else { path.moveTo(x - 5, y); path.lineTo(x + 5, y); }
    isOpen = true;
  });
}

// `designs`: {values, colour, isSelected, isEarly}
function drawParallel(canvas, frame, designs) {
  const { context } = sizeCanvas(canvas);
  const selected = designs.filter((design) => design.isSelected).length;
  for (const isSelected of [false, true])
    for (const isEarly of [false, true]) {
      const strokes = new Strokes();
      for (const design of designs)
        if (design.isSelected === isSelected && design.isEarly === isEarly)
          addParallelLine(strokes.at(isSelected ? design.colour : GREY), frame, design.values);
      context.setLineDash(isEarly ? [4, 3] : []);
      context.lineWidth = isSelected ? 1.3 : 1;
      strokes.draw(context, isSelected ? lineAlpha(selected) : 0.6 * lineAlpha(designs.length) + 0.1, false);
    }
  context.setLineDash([]);
  context.lineWidth = 1;
  frame.axes.forEach((axis, i) => {
    const x = frame.x(i);
    context.strokeStyle = context.fillStyle = BLACK;
    context.strokeRect(x, frame.top, 0, frame.bottom - frame.top);
    context.textAlign = 'center';
    context.textBaseline = 'top';
    const lines = wrapped(context, axisTitle(axis), frame.space - 8, 4);
    lines.forEach((line, k) => context.fillText(line, x, frame.top - 8 - 16 * (lines.length - k)));
    context.textAlign = 'left';
    context.textBaseline = 'middle';
    for (const { at, text } of axisTicks(axis, 5)) {
      const shown = shortened(context, text, frame.space - 14), wide = context.measureText(shown).width;
      context.fillStyle = 'rgb(255 255 255 / 75%)';   // over the lines
      context.fillRect(x + 6, frame.y(i, at) - 8, wide + 2, 16);
      context.fillStyle = BLACK;
      context.strokeRect(x - 3, frame.y(i, at), 6, 0);
      context.fillText(shown, x + 7, frame.y(i, at));
    }
  });
}

// `curves`: {xs, ys, colour, isSelected, isEarly}. A cross at the end of a path that ended early.
function drawCurves(canvas, frame, curves) {
  const { context, width, height } = sizeCanvas(canvas);
  drawFrame(context, frame);
  if (curves.length === 0) drawMessage(context, width, height, 'no selected design has this curve');
  const selected = curves.filter((curve) => curve.isSelected).length;
  for (const isSelected of [false, true]) {
    const strokes = new Strokes();
    for (const curve of curves) {
      if (curve.isSelected !== isSelected) continue;
      const path = strokes.at(isSelected ? curve.colour : GREY), last = curve.xs.length - 1;
      curve.xs.forEach((x, i) => path[i === 0 ? 'moveTo' : 'lineTo'](frame.x(x), frame.y(curve.ys[i])));
      if (curve.isEarly) addMarker(path, frame.x(curve.xs[last]), frame.y(curve.ys[last]), true, 4);
    }
    context.lineWidth = isSelected ? 1.5 : 1;
    strokes.draw(context, isSelected ? lineAlpha(selected) : 0.75, false);
  }
}

// The front of `designs` by x and y, where goals of 1 maximise and -1 minimise: no other design is at least as good in both and better
// in one. In the order of x.
function paretoFront(designs, xGoal, yGoal) {
  const sorted = [...designs].sort((a, b) => xGoal * (b.x - a.x) || yGoal * (b.y - a.y)), front = [];
  let best = -Infinity, bestX = 0;
  for (const design of sorted) {
    const y = yGoal * design.y;
    if (y > best) { best = y; bestX = design.x; front.push(design); } else if (y === best && design.x === bestX) front.push(design);
  }
  return front.sort((a, b) => a.x - b.x || a.y - b.y);
}
