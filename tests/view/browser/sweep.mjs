// Tests the report of a sweep in a browser: intervals, clicks, Pareto front, curves, tables, keyboard; nothing is fetched.
//   node sweep.mjs REPORT.html RESULTS.csv [PICTURES]     PICTURES: folder for screenshots
// RESULTS.csv is the table of the same sweep, with the first factor as numbers and no commas in its cells before the error.
import { readFileSync, writeFileSync } from 'node:fs';
import { claim, testPage } from './page.mjs';

const [file, table, pictures] = process.argv.slice(2);
const [head, ...rows] = readFileSync(table, 'utf8').trim().split('\n').map((line) => line.split(','));
const designs = rows.map((row) => Object.fromEntries(head.map((name, i) => [name, row[i]])));
const value = (design, name) => (design[name] === '' ? NaN : Number(design[name]));

await testPage(file, { width: 1400, height: 1500 }, async (page) => {
  const settle = () => page.evaluate(() => new Promise((resolve) => requestAnimationFrame(() => requestAnimationFrame(() => requestAnimationFrame(resolve)))));
  const picture = async (name) => { if (pictures) writeFileSync(`${pictures}/${name}.png`, await page.screenshot({ fullPage: true })); };
  const text = (id) => page.$eval(`#${id}`, (element) => element.textContent);
  const ids = (where) => page.$$eval(`${where} tr td:first-child`, (cells) => cells.map((cell) => cell.textContent));
  const selected = () => ids('#selected-rows');
  const front = () => page.$$eval('#selected-rows tr', (list) => list.filter((row) => row.children[1].textContent === 'yes').map((row) => row.children[0].textContent));
  const same = (a, b) => [...a].sort().join() === [...b].sort().join();
  const columns = await page.evaluate(() => JSON.parse(document.getElementById('data').textContent).columns
    .map(({ name, label, parameter, values }) => ({ name, label, parameter, values })));
  const choose = async (id, name) => { await page.select(`#${id}`, String(columns.findIndex((column) => column.name === name))); await settle(); };
  const drawn = (id) => page.$eval(`#${id}`, (canvas) => {   // the fraction of its pixels that are drawn in a colour, neither white nor grey
    const copy = new OffscreenCanvas(canvas.width, canvas.height), context = copy.getContext('2d', { willReadFrequently: true });
    context.drawImage(canvas, 0, 0);
    const pixels = context.getImageData(0, 0, canvas.width, canvas.height).data;
    let count = 0;
    for (let i = 0; i < pixels.length; i += 4) count += pixels[i + 3] > 60 && Math.max(...pixels.slice(i, i + 3)) - Math.min(...pixels.slice(i, i + 3)) > 40 ? 1 : 0;
    return 4 * count / pixels.length;
  });
  const clear = async () => { await page.keyboard.press('Escape'); await settle(); };
  await settle();

  // all designs
  claim('each design is in the table', same(await selected(), designs.map((design) => design.id)), (await selected()).length);
  claim('the columns are those of the results', columns.every(({ name }) => head.includes(name)) && columns.length === head.length - 4, columns.map(({ name }) => name).join());
  const early = designs.filter((design) => design.exit_code !== '0');
  claim('there are designs that failed', early.length > 0);
  claim('designs that failed are listed', same(await ids('#early-rows'), early.map((design) => design.id)));
  const reasons = await page.$$eval('#early-rows tr', (list) => list.map((row) => row.textContent));
  claim('with their stop reason and their error', early.every((design, i) => reasons[i].includes(design.stop_reason) && reasons[i].includes(design.error.slice(1, 40))), reasons[0]);
  claim('the colours are drawn', await drawn('scatter') > 0.0005 && await drawn('parallel') > 0.005 && await drawn('curves') > 0.005);
  await picture('all');

  // the Pareto front of two outputs against a brute-force front, for all goals
  const outputs = columns.filter((column) => !column.parameter).map(({ name }) => name), [x, y] = outputs;
  await choose('x', x);
  await choose('y', y);
  const known = designs.filter((design) => !Number.isNaN(value(design, x)) && !Number.isNaN(value(design, y)));
  const bruteFront = (list, xGoal, yGoal) => list.filter((a) => !list.some((b) => {
    const dx = xGoal * (value(b, x) - value(a, x)), dy = yGoal * (value(b, y) - value(a, y));
    return dx >= 0 && dy >= 0 && (dx > 0 || dy > 0);
  })).map((design) => design.id);
  if (!(await page.$eval('#front', (box) => box.checked))) await page.click('#front');
  for (const xGoal of [-1, 1])
    for (const yGoal of [-1, 1]) {
      await page.select('#x-goal', String(xGoal));
      await page.select('#y-goal', String(yGoal));
      await settle();
      const expected = bruteFront(known, xGoal, yGoal);
      claim(`the front for ${xGoal}, ${yGoal} is that of all pairs`, expected.length > 0 && same(await front(), expected), `${(await front()).length}, not ${expected.length}`);
      claim('the front is counted', (await text('status')).includes(`Pareto front of the selected: ${expected.length}`), await text('status'));
    }

  // an interval by a drag on the first axis, a second one on another axis, and clearing the first by a click
  const box = async (id) => { const { x: left, y: top, width, height } = await (await page.$(`#${id}`)).boundingBox(); return { left, top, width, height }; };
  const drag = async ([x0, y0], [x1, y1]) => {
    await page.mouse.move(x0, y0);
    await page.mouse.down();
    await page.mouse.move((x0 + x1) / 2, (y0 + y1) / 2);
    await page.mouse.move(x1, y1);
    await page.mouse.up();
    await settle();
  };
  await page.$eval('#parallel', (canvas) => canvas.scrollIntoView({ block: 'center' }));
  const axes = await page.$$eval('#axes input:checked', (boxes) => boxes.map((each) => Number(each.dataset.column)));
  const parallel = await box('parallel'), onAxis = (i) => parallel.left + (i + 0.5) * parallel.width / axes.length;
  const limits = async (c) => page.$$eval(`#intervals input[data-column="${c}"]`, (inputs) => inputs.map((input) => (input.value === '' ? NaN : Number(input.value))));
  const inside = (list, c, [low, high]) => list.filter((design) => value(design, columns[c].name) >= low && value(design, columns[c].name) <= high);
  const top = parallel.top + 74, height = parallel.height - 100;
  await drag([onAxis(0), top + 0.35 * height], [onAxis(0), top + height + 10]);
  const first = await limits(axes[0]), expected = inside(designs, axes[0], first);
  claim('a drag on an axis selects the designs inside', expected.length > 0 && expected.length < designs.length && same(await selected(), expected.map((design) => design.id)),
    `${(await selected()).length} selected, ${expected.length} between ${first}`);
  claim('the selected designs are counted', (await text('status')).startsWith(`${expected.length} of ${designs.length} designs selected`), await text('status'));
  claim('the front is that of the selected designs', same(await front(), bruteFront(known.filter((design) => expected.includes(design)), 1, 1)));
  const last = axes.length - 1;
  await drag([onAxis(last), top], [onAxis(last), top + 0.6 * height]);
  const both = inside(expected, axes[last], await limits(axes[last]));
  claim('intervals on two axes are combined', both.length < expected.length && same(await selected(), both.map((design) => design.id)), `${(await selected()).length}, not ${both.length}`);
  await picture('intervals');
  await page.mouse.click(onAxis(last), top + 0.3 * height);
  await settle();
  claim('a click on an axis clears its interval', same(await selected(), expected.map((design) => design.id)), (await selected()).length);
  await clear();
  claim('Escape clears the selection', (await selected()).length === designs.length);

  // an interval as numbers, by the keyboard
  await page.$eval('#intervals', (element) => { element.parentElement.open = true; });
  const middle = [...columns[axes[0]].values].sort((a, b) => a - b)[Math.floor(designs.length / 2)];
  await page.focus(`#intervals input[data-column="${axes[0]}"][data-end="0"]`);
  await page.keyboard.type(String(middle));
  await page.keyboard.press('Tab');
  await settle();
  claim('a typed interval selects', same(await selected(), inside(designs, axes[0], [middle, Infinity]).map((design) => design.id)), await text('status'));
  await page.click('#clear');
  await settle();
  claim('the button clears the selection', (await selected()).length === designs.length);

  // a rectangle and a click in the scatter plot
  await page.$eval('#scatter', (canvas) => canvas.scrollIntoView({ block: 'center' }));
  const scatter = await box('scatter');
  await drag([scatter.left + 70, scatter.top + 14], [scatter.left + 0.5 * scatter.width, scatter.top + scatter.height - 52]);
  const limit = (await limits(columns.findIndex(({ name }) => name === x)))[1];
  const left = known.filter((design) => value(design, x) <= limit);
  claim('a rectangle selects the designs inside', left.length > 0 && left.length < known.length && same(await selected(), left.map((design) => design.id)), `${(await selected()).length}, not ${left.length}`);
  await clear();
  await page.focus('#scatter-over');
  await page.keyboard.press('ArrowRight');
  const tip = await text('focused');
  claim('the arrow keys describe a design', known.some((design) => tip.startsWith(design.id)), tip);
  await page.keyboard.press('Enter');
  await settle();
  claim('Enter selects it', (await selected()).length === 1 && tip.startsWith((await selected())[0]), (await selected()).join());
  claim('its curve is drawn alone', await drawn('curves') < 0.01 && await drawn('curves') > 0.0002, await drawn('curves'));
  await picture('one');
  await clear();
  await page.hover('#selected-rows tr:nth-child(2)');
  claim('the design of a row is marked', await page.$eval('#selected-rows tr:nth-child(2)', (row) => row.className === 'hovered'));
  await page.$eval('#curves', (canvas) => canvas.scrollIntoView({ block: 'center' }));
  const curves = await box('curves');
  let shown = '';
  for (let step = 1; step < 40 && shown === ''; ++step) {
    await page.mouse.move(curves.left + curves.width / 2, curves.top + step / 40 * curves.height);
    shown = await page.$eval('#tip', (element) => (element.hidden ? '' : element.textContent));
  }
  claim('the pointer on a curve shows its design', designs.some((design) => shown.startsWith(design.id)), shown);

  // other quantities, sorting, colours by words
  await page.select('#curve-x', await page.$eval('#curve-x', (list) => list.options[list.options.length - 1].value));
  await settle();
  claim('other curves can be chosen', await drawn('curves') > 0.0005);
  await page.click('#selected-head th:nth-child(3) button');
  const sorted = (await selected()).map((id) => value(designs.find((design) => design.id === id), head[1]));
  claim('a click on a heading sorts', sorted.every((number, i) => i === 0 || sorted[i - 1] <= number), sorted.join());
  const words = columns.filter(({ name }) => designs.some((design) => /[a-z]/.test(design[name] ?? '')));
  if (words.length > 0) {
    await choose('colour', words[0].name);
    claim('words have a legend', designs.every((design) => designs.length > 0) && (await text('legend')).includes(designs[0][words[0].name]), await text('legend'));
    await picture('words');
  }
});
