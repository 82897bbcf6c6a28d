// SPDX-License-Identifier: Apache-2.0
// The pictures of README.md: node pictures.mjs FOLDER, with RUNG and RUNG_BROWSER as for the tests
// (make pictures).
import {join} from 'node:path';
import {View, element, openBrowser, openPage, waitScan} from './bench.mjs';

const folder = process.argv[2];
const browser = await openBrowser();
const view = await View.start('--listen', '0');
const page = await openPage(browser, view, {viewport: {width: 1240, height: 620}});
const step = async (scans) => {
  const end = await page.evaluate(() => rung.frame.scan) + scans;
  await page.evaluate((n) => fetch('api/command', {method: 'POST', headers: {'Content-Type': 'application/json'}, body: JSON.stringify({do: 'step', scans: n})}), scans);
  await waitScan(page, end);
};
const start = async () => {
  await element(page, 'contact', 'X2').click();
  await element(page, 'contact', 'X0').click();
  await step(1);
  await element(page, 'contact', 'X0').click();
  await element(page, 'contact-up', 'X3').click();
};

await start();
await step(160);
await page.mouse.move(600, 600);
await page.evaluate(() => document.activeElement.blur());
await page.screenshot({path: join(folder, 'view-ladder.png')});

await element(page, 'contact', 'X0').click();
await page.click('#tab-inside');
await page.click('#record');
await page.waitForFunction(() => document.querySelectorAll('.processor').length === 3);
for (let i = 0; i < 9; i++) await page.keyboard.press('ArrowRight');
await page.setViewportSize({width: 1240, height: 900});
await page.waitForTimeout(500);
await page.screenshot({path: join(folder, 'view-inside.png')});
await browser.close();
await view.stop();
