// What the tests of the pages share: a browser, and pages that keep an account of what must not happen. Screenshots stay in
// BUILD/screenshots for a person to look at. Run by `browser`: node TEST.mjs BUILD CHROMIUM.
import assert from 'node:assert/strict';
import {mkdirSync, mkdtempSync, readFileSync, rmSync} from 'node:fs';
import {createRequire} from 'node:module';
import {tmpdir} from 'node:os';
import {join} from 'node:path';
import {after, before} from 'node:test';

const [build, chromium_path] = process.argv.slice(2);
const packages = createRequire(join(build, 'web/package.json'));
const {chromium} = packages('playwright-core'), axe = readFileSync(packages.resolve('axe-core/axe.min.js'), 'utf8');
export const program = join(build, 'rigor'), pictures = join(build, 'screenshots'), work = mkdtempSync(join(tmpdir(), 'rigor-pages-'));
mkdirSync(pictures, {recursive: true});

let browser;
before(async () => {
  browser = await chromium.launch({executablePath: chromium_path, args: ['--no-sandbox', '--use-angle=swiftshader', '--enable-unsafe-swiftshader']});
});
after(async () => {
  await browser?.close();
  rmSync(work, {recursive: true, force: true});
});

/// Opens a page; page.wrong: errors and warnings of its console; page.asked and page.sockets: all that it asked for.
export async function open(url, options = {}) {
  const context = await browser.newContext({viewport: {width: 1280, height: 800}, ...options});
  const page = await context.newPage();
  page.wrong = [], page.asked = [], page.sockets = [];
  page.on('console', message => { if (['error', 'warning'].includes(message.type()) && !/GPU stall|GL Driver|swiftshader/i.test(message.text())) page.wrong.push(message.text()); });
  page.on('pageerror', error => page.wrong.push(error.message));
  page.on('request', request => { if (!/^(data|blob):/.test(request.url())) page.asked.push(request.url()); });
  page.on('websocket', socket => page.sockets.push(socket.url()));
  await page.goto(url);
  return page;
}
export async function no_serious_finding(page) {
  const session = await page.context().newCDPSession(page);  // the page's own policy lets no script in; a debugger may
  await session.send('Runtime.evaluate', {expression: axe});
  const found = await page.evaluate(() => axe.run(document, {resultTypes: ['violations']}));
  const serious = found.violations.filter(v => ['serious', 'critical'].includes(v.impact));
  assert.deepEqual(serious.map(v => `${v.id}: ${v.nodes.map(n => n.target).join(' ')}`), []);
}
