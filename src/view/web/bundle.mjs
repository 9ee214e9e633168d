// node bundle.mjs OUT: the scripts and styles of the pages, each one file in OUT, and the hash their policy names.
// Packages are found in OUT/node_modules; nothing is fetched.
import {createHash} from 'node:crypto';
import {existsSync, readFileSync, writeFileSync, copyFileSync} from 'node:fs';
import {createRequire} from 'node:module';
import {dirname, join} from 'node:path';
import {fileURLToPath} from 'node:url';

const out = process.argv[2], here = dirname(fileURLToPath(import.meta.url));
const packages = createRequire(join(out, 'package.json')), {buildSync} = packages('esbuild'), katex = packages('katex');

// the formulas as MathML, which a browser shows without a script or a font: id, tab, markup
const lines = file => readFileSync(join(here, '../..', file), 'utf8').trim().split('\n').slice(1);
const formulas = ['formulas/typeset.tsv', 'studies/problems.tsv'].flatMap(lines).map(line => line.split('\t'));
const markup = tex => katex.renderToString(tex, {output: 'mathml', displayMode: true, throwOnError: true}).replace(/^<span class="katex">|<\/span>$/g, '');
writeFileSync(join(out, 'formulas.mathml'), formulas.map(([id, , tex]) => `${id}\t${markup(tex)}\n`).join(''));

for (const page of ['replay', 'live', 'hover']) {
  buildSync({
    entryPoints: [join(here, page + '.js')], outdir: out, bundle: true, minify: true, format: 'iife', target: 'es2022',
    charset: 'ascii', legalComments: 'none', nodePaths: [join(out, 'node_modules')],
    // the licences of what is bundled go with it
    banner: {js: '/* contains ' + (page !== 'hover' ? 'three.js (MIT, (c) three.js authors) and ' : '') + 'uPlot (MIT, (c) Leon Sorokin) */'},
  });
  const script = readFileSync(join(out, page + '.js'));
  writeFileSync(join(out, page + '.js.sha256'), createHash('sha256').update(script).digest('base64'));
  const body = join(here, page + '-body.html');
  if (existsSync(body)) copyFileSync(body, join(out, page + '-body.html'));
}
