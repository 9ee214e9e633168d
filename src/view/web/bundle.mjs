// node bundle.mjs OUT: the scripts and styles of the pages, each one file in OUT, and the hash their policy names.
// Packages are found in OUT/node_modules; nothing is fetched.
import {createHash} from 'node:crypto';
import {readFileSync, writeFileSync, copyFileSync} from 'node:fs';
import {createRequire} from 'node:module';
import {dirname, join} from 'node:path';
import {fileURLToPath} from 'node:url';

const out = process.argv[2], here = dirname(fileURLToPath(import.meta.url));
const {buildSync} = createRequire(join(out, 'package.json'))('esbuild');
for (const page of ['replay', 'live']) {
  buildSync({
    entryPoints: [join(here, page + '.js')], outdir: out, bundle: true, minify: true, format: 'iife', target: 'es2022',
    charset: 'ascii', legalComments: 'none', nodePaths: [join(out, 'node_modules')],
    // the licences of what is bundled go with it
    banner: {js: '/* contains three.js (MIT, (c) three.js authors) and uPlot (MIT, (c) Leon Sorokin) */'},
  });
  const script = readFileSync(join(out, page + '.js'));
  writeFileSync(join(out, page + '.js.sha256'), createHash('sha256').update(script).digest('base64'));
  copyFileSync(join(here, page + '-body.html'), join(out, page + '-body.html'));
}
