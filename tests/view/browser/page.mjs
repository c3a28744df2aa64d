// Shared by the browser tests: opens a page offline in a headless Chromium and counts what holds.
import puppeteer from 'puppeteer-core';
import { pathToFileURL } from 'node:url';

let failures = 0, claims = 0;
export function claim(text, holds, seen = '') {
  claims += 1;
  if (holds) return;
  failures += 1;
  console.log(`FAILED: ${text}${seen === '' ? '' : `; found: ${seen}`}`);
}

// Calls test(page, browser); then nothing may have been fetched and no error logged. Ends the process.
export async function testPage(file, viewport, test) {
  const browser = await puppeteer.launch({
    executablePath: process.env.CHROMIUM || '/usr/bin/chromium',
    headless: true,
    args: ['--no-sandbox', '--use-gl=angle', '--use-angle=swiftshader', '--enable-unsafe-swiftshader', '--ignore-gpu-blocklist'],
  });
  try {
    const page_url = pathToFileURL(file).href, page = await browser.newPage();
    await page.setViewport(viewport);
    const requests = [], complaints = [];
    await page.setRequestInterception(true);
    page.on('request', (request) => {
      const url = request.url();
      if (url === page_url || url.startsWith('data:')) return void request.continue();
      requests.push(url);
      void request.abort();
    });
    page.on('console', (message) => { if (['error', 'warn'].includes(message.type())) complaints.push(message.text()); });
    page.on('pageerror', (error) => complaints.push(error.message));
    page.on('dialog', (dialog) => { complaints.push(dialog.message()); void dialog.dismiss(); });
    await page.goto(page_url, { waitUntil: 'load', timeout: 120000 });
    await test(page, browser);
    claim('nothing is fetched', requests.length === 0, requests.join(' '));
    claim('no error is logged', complaints.length === 0, complaints.join(' | '));
  } finally {
    await browser.close();
  }
  console.log(failures === 0 ? `all ${claims} checks passed` : `${failures} of ${claims} checks failed`);
  process.exit(failures === 0 && claims > 0 ? 0 : 1);
}
