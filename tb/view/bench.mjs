// SPDX-License-Identifier: Apache-2.0
// `rung view` and a browser, as the tests start and stop them. RUNG is the program, RUNG_BROWSER the
// folder with playwright-core; CHROMIUM may name another browser.
import {spawn} from 'node:child_process';
import {mkdtempSync, rmSync, writeFileSync} from 'node:fs';
import {createRequire} from 'node:module';
import {tmpdir} from 'node:os';
import {dirname, join} from 'node:path';
import {fileURLToPath} from 'node:url';

const HERE = dirname(fileURLToPath(import.meta.url));
export const program = (name) => join(HERE, 'programs', name);
const {chromium} = createRequire(join(process.env.RUNG_BROWSER, 'package.json'))('playwright-core');

export const scratch = mkdtempSync(join(tmpdir(), 'rung-view-'));
process.on('exit', () => rmSync(scratch, {recursive: true, force: true}));

// A running `rung view`.
export class View {
  static async start(...options) {
    const view = new View();
    view.child = spawn(process.env.RUNG, ['view', '--no-browser', ...options], {stdio: ['ignore', 'pipe', 'pipe']});
    view.errors = '';
    view.child.stderr.on('data', (data) => { view.errors += data; });
    view.ended = new Promise((end) => view.child.on('exit', end));
    view.url = await new Promise((ready, fail) => {
      let text = '';
      view.child.stdout.on('data', (data) => {
        text += data;
        if (text.includes('\n')) ready(text.split('\n')[0]);
      });
      view.ended.then((code) => fail(new Error(`rung view ended with ${code}: ${view.errors}`)));
    });
    return view;
  }

  // The code it ends with; a sanitizer's report would make it another one.
  async stop() {
    this.child.kill('SIGTERM');
    return this.ended;
  }
}

// A simulated controller, `rung device`, that runs a program of tb/clients; `port` is its Modbus TCP port.
export async function startController(name, ...options) {
  const folder = join(HERE, '../clients/programs');
  const child = spawn(process.env.RUNG, ['device', join(folder, `${name}.il`), '--io', join(folder, `${name}.toml`), '--fast', '--tcp', '0', ...options],
    {stdio: ['pipe', 'pipe', 'inherit']});
  const ended = new Promise((end) => child.on('exit', end));
  const port = await new Promise((ready, fail) => {
    let text = '';
    child.stdout.on('data', (data) => {
      text += data;
      const found = /127\.0\.0\.1:(\d+)/.exec(text);
      if (found && text.includes('ready')) ready(found[1]);
    });
    ended.then((code) => fail(new Error(`rung device ended with ${code}`)));
  });
  return {
    port,
    program: join(folder, `${name}.il`),
    tell: (line) => child.stdin.write(`${line}\n`),
    stop: () => {
      child.kill('SIGTERM');
      return ended;
    },
  };
}

// Sends no page: requests as a program makes them.
export const request = (view, path, options) => fetch(new URL(path, view.url), options);

export async function openBrowser() {
  return chromium.launch({
    executablePath: process.env.CHROMIUM ?? '/usr/bin/chromium',
    args: ['--headless', '--no-sandbox', '--disable-gpu'],
  });
}

// A page that shows the program; a fault of its scripts fails the test that looks at `faults`.
export async function openPage(browser, view, options = {}) {
  // What waits for the page is evaluated in it, which its own policy would forbid.
  const context = await browser.newContext({viewport: {width: 1500, height: 900}, bypassCSP: true, ...options});
  const page = await context.newPage();
  page.faults = [];
  page.on('pageerror', (error) => page.faults.push(String(error)));
  page.on('console', (message) => {
    if (message.type() === 'error' && !/Failed to load|ERR_/.test(message.text())) page.faults.push(message.text());
  });
  page.setDefaultTimeout(60000);
  await page.goto(view.url);
  await page.waitForFunction(() => globalThis.rung?.frame);
  return page;
}

// The value of a device, as the page has it.
export const value = (page, name) => page.evaluate((n) => rung.values[rung.model.devices.findIndex((each) => each.name === n)], name);
export const becomes = (page, name, wanted) => page.waitForFunction(
  ([n, w]) => rung.values[rung.model.devices.findIndex((each) => each.name === n)] === w, [name, wanted], {timeout: 60000});
export const scans = (page) => page.evaluate(() => rung.frame.scan);
export const waitScan = (page, scan) => page.waitForFunction((n) => rung.frame.scan >= n, scan, {timeout: 60000});

// An element of the ladder by its sign and text.
export const element = (page, sign, text) => page.locator(`.element.${sign}`).filter({has: page.locator(`text="${text}"`)}).first();

// A program of so many instructions that is busy everywhere: chains of relays and timers that never rest.
export function busyProgram(instructions) {
  const lines = ['LD   M8013', 'OUT  Y0'];
  for (let i = 0; lines.length + 10 <= instructions; i++) {
    const m = i % 400;
    lines.push(`LD   X${(i % 16).toString(8)}`, `OR   M${m}`, `ANI  M${m + 1}`, `OUT  M${m + 2}`, `LDI  M${m + 500}`, `OUT  M${m + 500}`,
      `LD   M${m + 500}`, `OUT  T${i % 199} K${10 + i % 30}`, `LD   T${i % 199}`, `RST  T${i % 199}`);
  }
  while (lines.length < instructions) lines.push('LD   M0', 'OUT  Y1');
  const file = join(scratch, 'busy.il');
  writeFileSync(file, `${lines.join('\n')}\nEND\n`);
  return file;
}
