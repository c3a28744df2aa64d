// Tests a report in a browser: it loads, the slider moves the body, the pointer rotates it, nothing is fetched, no error is logged.
//   node report.mjs REPORT.html LENGTH_MM ELONGATION_MM PICTURES [moving]     PICTURES: folder for screenshots
// LENGTH_MM is the undeformed length along x, ELONGATION_MM the elongation of the last step or ''; moving: an obstacle moves.
import { writeFileSync } from 'node:fs';
import { claim, testPage } from './page.mjs';

const [file, length, elongation, pictures, obstacle] = process.argv.slice(2);
await testPage(file, { width: 1000, height: 1200 }, async (page, browser) => {
  const text = (id) => page.$eval(`#${id}`, (element) => element.textContent);
  const body = await page.$('#body');
  // The fraction of pixels that are not white, and the number and mean position of those of an obstacle's lines, decoded by the browser in a
  // page without the report's policy.
  const eye = await browser.newPage();
  const look = async (name) => {
    await page.bringToFront();
    const png = await body.screenshot();
    writeFileSync(`${pictures}/${name}.png`, png);
    const seen = await eye.evaluate(async (base64) => {
      const bitmap = await createImageBitmap(await (await fetch(`data:image/png;base64,${base64}`)).blob());
      const canvas = new OffscreenCanvas(bitmap.width, bitmap.height), context = canvas.getContext('2d');
      context.drawImage(bitmap, 0, 0);
      const pixels = context.getImageData(0, 0, bitmap.width, bitmap.height).data;
      let count = 0, blue = 0, x = 0, y = 0;
      for (let i = 0; i < pixels.length; i += 4) {
        const [r, g, b] = pixels.slice(i, i + 3);
        if (r + g + b < 600) count += 1;
        if (r < 100 || b - r < 50 || b - g < 30) continue;
        blue += 1;
        x += i / 4 % bitmap.width;
        y += Math.floor(i / 4 / bitmap.width);
      }
      return { inked: 4 * count / pixels.length, blue, middle: [x / blue, y / blue] };
    }, Buffer.from(png).toString('base64'));
    return { png: Buffer.from(png).toString('base64'), ...seen };
  };
  const size_x = async () => Number(/drawn: ([0-9.]+) /.exec(await text('size'))[1]);
  const slide = (value) => page.$eval('#frame', (slider, to) => {
    slider.value = to;
    slider.dispatchEvent(new Event('input'));
  }, value);

  claim('the body can be drawn', await page.$eval('#viewer-error', (element) => element.hidden), await text('viewer-error'));
  const last = await look('last');
  claim('the body fills part of its window', last.inked > 0.01 && last.inked < 0.9, last.inked);
  const end = await size_x();
  if (elongation) claim('the length in the last step matches the result', Math.abs(end - length - elongation) < 0.01 * end, end);

  await slide(0);
  const first = await look('first');
  claim('the slider moves the body', first.png !== last.png && first.inked > 0.005, first.inked);
  claim('the first step has the undeformed length', Math.abs(await size_x() - length) < 0.005 * length, await size_x());
  claim('an obstacle is drawn where there is one', obstacle ? first.blue > 200 && last.blue > 200 : last.blue < 50, last.blue);
  const way = Math.hypot(last.middle[0] - first.middle[0], last.middle[1] - first.middle[1]);
  if (obstacle) claim('the slider moves the obstacle', way > 5, way);
  claim('the label shows the step', (await text('step')).startsWith('step 0:'), await text('step'));
  claim('the row of the step is marked in the table', await page.$eval('#results tr.shown', (row) => row.dataset.step === '0'));

  await slide(1e9);
  claim('the slider ends at the last step', Math.abs(await size_x() - end) < 1e-6, await size_x());
  const high = await text('high');
  await page.select('#field', '1');
  claim('another field has other colours', (await look('field')).png !== last.png && await text('high') !== high, await text('high'));
  await page.select('#field', '0');
  await page.click('#outline');
  claim('the outline can be hidden', (await look('outline')).png !== last.png);
  await page.click('#outline');
  claim('the outline can be shown again', (await look('again')).png === last.png);

  if (await page.$eval('#cut', (element) => !element.parentElement.hidden)) {
    const size = await text('size');
    await page.click('#cut');
    const closed = await look('closed');
    claim('a symmetric body can be closed', closed.png !== last.png && await text('size') === size, await text('size'));
    await page.click('#cut');
  }

  const box = await body.boundingBox();
  await page.mouse.move(box.x + box.width / 2, box.y + box.height / 2);
  await page.mouse.down();
  await page.mouse.move(box.x + box.width / 2 + 120, box.y + box.height / 2 + 40, { steps: 5 });
  await page.mouse.up();
  claim('the pointer rotates the body', (await look('turned')).png !== last.png);
  await page.click('#reset');
  claim('the reset button restores the view', (await look('reset')).png === last.png);

  const playing = await page.$eval('#frame', (slider) => slider.value);
  await page.click('#play');
  const moved = await page.waitForFunction((value) => document.getElementById('frame').value !== value, { timeout: 20000 }, playing)
    .then(() => true, () => false);
  await page.click('#play');
  claim('the animation plays and stops', moved && await text('play') === 'Play');

  claim('the curve is visible', await page.$eval('#curve', (image) => image.complete && image.naturalWidth > 100));
});
