// The pictures of README and docs, made anew from what the program writes now; to be run on a quiet machine:
//   tests/view/browser build/release ../../docs/pictures/remake
import {execFileSync, spawn, spawnSync} from 'node:child_process';
import {once} from 'node:events';
import {cpSync, readdirSync} from 'node:fs';
import {dirname, join} from 'node:path';
import {createInterface} from 'node:readline';
import {test} from 'node:test';
import {fileURLToPath, pathToFileURL} from 'node:url';
import {open as open_page, program, work} from '../../tests/view/pages.mjs';

const here = dirname(fileURLToPath(import.meta.url)), samples = join(here, '../../tests/submissions');
const rigor = (...words) => execFileSync(program, words, {stdio: ['ignore', 'ignore', 'inherit']});
const open = (path, width, height) => open_page(path.startsWith('http') ? path : pathToFileURL(path).href, {viewport: {width, height}});
const keep = (shown, name, options = {}) => shown.screenshot({path: join(here, name + '.png'), ...options});
const seconds = s => new Promise(done => setTimeout(done, 1000 * s));

test('demo', async () => {
  rigor('demo', '--out', join(work, 'demo'));
  await keep(await open(join(work, 'demo/index.html'), 1000, 1700), 'demo');
});

test('class and counterexample', async () => {
  for (const room of ['right', 'wrong'])
    for (const name of readdirSync(join(samples, room))) cpSync(join(samples, room, name), join(work, 'hand-ins', name), {recursive: true});
  spawnSync(program, ['class', join(work, 'hand-ins'), '--out', join(work, 'graded'), '--quiet'], {stdio: 'inherit'});
  await keep(await open(join(work, 'graded/class.html'), 1000, 1900), 'class');
  const report = await open(join(work, 'graded/plane-inertia-missing/report.html'), 1000, 1060);
  const card = report.locator('details[id="plane.impulse-turned"]');
  await card.evaluate(details => { details.open = true, details.scrollIntoView(); });
  await keep(report, 'counterexample');
});

test('study', async () => {
  rigor('study', 'work-precision', '--problem', 'case-A', '--method', 'sheet,euler-momentum,rk4,implicit-midpoint,split2,split2-kahan-li8,moser-veselov8,taylor16,exact', '--out', join(work, 'study'), '--quiet');
  const page = await open(join(work, 'study/study.html'), 1000, 760);
  await keep(page.locator('figure').first(), 'study');
});

test('replay', async () => {
  rigor('run', 'assignment', '--seed', '3', '--out', join(work, 'run'));
  const page = await open(join(work, 'run/replay.html'), 1100, 680);
  await page.locator('#play').click();
  await seconds(0.9);
  await page.locator('#play').click();
  await keep(page, 'replay');
});

test('live', async () => {
  const server = spawn(program, ['view', 'assignment', '--seed', '3'], {stdio: ['ignore', 'pipe', 'inherit']});
  const [line] = await once(createInterface(server.stdout), 'line');
  const page = await open(line.match(/^http:\/\/127\.0\.0\.1:\d+\//)[0], 1100, 680);
  await page.locator('#canvas').waitFor();
  await page.keyboard.press(' ');
  await seconds(1);
  await page.keyboard.press(' ');
  await keep(page, 'live');
  server.kill('SIGINT');
});
