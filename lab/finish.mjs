// What comes after vite: the service worker, the licences, and the page as one file. Checks the sizes.
import { readdir, readFile, writeFile } from 'node:fs/promises';
import { join } from 'node:path';
import { gzipSync } from 'node:zlib';
import { createHash } from 'node:crypto';

const here = new URL('.', import.meta.url).pathname;
const site = join(here, '../build/lab/site');
// Bytes, gzipped: of what the page loads before it shows a search; of all files, which the service worker fetches after
// that; of the one file. A build that exceeds them fails.
// Raised by a tenth for ways out, closest places and the checks of every number, which each module has. Orders of
// neighbours and ties, for students, added 8 kB to what shows the first search.
// Controls of ways out and closest places, notes on maps and PNG images of 16 bits added 5 kB; that every loop over the
// cells asks for the time, 5 kB; one door for searches that are stepped, with checked fields, 4 kB;
// the words of all failures, which planners that come later had, and a metric more, 7 kB; the lists of fields, 4 kB;
// side rooms of maps with costs, 10 kB.
const mostOfFirst = 334_000;
// Limits on whole calls and drives to and fro of hybrid_astar added 5 kB to each; orders of neighbours and paths between
// any points 15 kB; ara_star on whole numbers, side rooms and sights of discs, 37 kB.
const mostOfSite = 1_030_000;
const mostOfFile = 1_012_000;
// Loaded when they are asked for: the module with all planners, the charts, the element for other pages; and the service
// worker, which the page starts after its first search.
const later = /^(assets\/(wend|uPlot)|embed\.js|worker\.js|licences\.html)/;

const parts = join(here, '../build/lab/file');

const filesIn = async (folder) => (await readdir(folder, { recursive: true, withFileTypes: true }))
  .filter((entry) => entry.isFile())
  .map((entry) => join(entry.parentPath ?? entry.path, entry.name).slice(folder.length + 1));
const files = () => filesIn(site);

await writeFile(join(site, 'licences.html'), await licences());
await writeFile(join(site, 'worker.js'), await serviceWorker());
const file = await oneFile();
await writeFile(join(site, '../wend-lab.html'), file);
await checkSizes();

async function licences() {
  const npm = ['lit', 'lit-html', 'lit-element', '@lit/reactive-element', 'fflate', 'uplot'];
  const parts = await Promise.all(npm.map(async (name) => {
    const { version, license } = JSON.parse(await readFile(join(here, 'node_modules', name, 'package.json'), 'utf8'));
    return [`${name} ${version}, ${license}`, await readFile(join(here, 'node_modules', name, 'LICENSE'), 'utf8')];
  }));
  for (const name of ['libc++-22-dev-wasm32', 'wasi-libc', 'libexpected-dev']) {
    parts.push([`${name}, in the WebAssembly module`, await readFile(`/usr/share/doc/${name}/copyright`, 'utf8').catch(() => 'See the package of this name in Debian.')]);
  }
  parts.unshift(['wend', await readFile(join(here, '../LICENSE'), 'utf8')]);
  const escape = (text) => text.replaceAll('&', '&amp;').replaceAll('<', '&lt;');
  const sections = parts.map(([title, text]) => `<h2>${escape(title)}</h2>\n<pre tabindex="0">${escape(text)}</pre>`);
  return `<!doctype html><html lang="en"><meta charset="utf-8"><meta name="viewport" content="width=device-width">
<title>Licences of wend lab</title><style>:root{color-scheme:light dark;font:16px/1.5 system-ui,sans-serif}
body{max-width:46rem;margin:2rem auto;padding:0 1rem}h1{font-size:1.2rem}h2{font-size:1rem}pre{white-space:pre-wrap;font-size:.8rem;max-height:20rem;overflow:auto}</style>
<main><h1>Licences</h1><p>The lab contains these works. <a href="./index.html">Back to the lab</a></p>
${sections.join('\n')}</main></html>\n`;
}

/** Answers from its copy, so that the lab works without a network after the first visit. */
async function serviceWorker() {
  const names = (await files()).filter((name) => name !== 'worker.js').sort();
  const hash = createHash('sha256');
  for (const name of names) hash.update(name).update(await readFile(join(site, name)));
  const version = hash.digest('hex').slice(0, 16);
  return `const version = 'wend-lab-${version}';
const files = ${JSON.stringify(['./', ...names])};
addEventListener('install', (event) => event.waitUntil(
  caches.open(version).then((cache) => cache.addAll(files)).then(() => skipWaiting())));
addEventListener('activate', (event) => event.waitUntil((async () => {
  for (const name of await caches.keys()) if (name.startsWith('wend-lab-') && name !== version) await caches.delete(name);
  await clients.claim();
})()));
addEventListener('fetch', (event) => {
  if (event.request.method !== 'GET') return;
  event.respondWith(caches.match(event.request, { ignoreSearch: true }).then((kept) => kept ?? fetch(event.request)));
});
`;
}

/** The page with all in it: its script and the module, both compressed, and the style. It opens from a folder too. */
async function oneFile() {
  const names = await filesIn(parts);
  const named = (ending) => join(parts, names.find((name) => ending.test(name)));
  const packed = async (id, ending) => `<script type="text/plain" id="${id}">${gzipSync(await readFile(named(ending)), { level: 9 }).toString('base64')}</script>`;
  const start = `
const packed = Uint8Array.from(atob(document.getElementById('wend-script').textContent), (letter) => letter.charCodeAt(0));
const script = document.createElement('script');
script.type = 'module';
script.textContent = await new Response(new Blob([packed]).stream().pipeThrough(new DecompressionStream('gzip'))).text();
document.body.append(script);`;
  const page = await readFile(join(parts, 'index.html'), 'utf8');
  const scripts = [await packed('wend-wasm', /^assets\/wend.*\.wasm$/), await packed('wend-script', /^assets\/.*\.js$/), `<script type="module">${start}\n</script>`];
  return page
    .replace(/<script type="module"[^>]*><\/script>/, '')
    .replace(/<link rel="stylesheet"[^>]*>/, `<style>${await readFile(named(/^assets\/.*\.css$/), 'utf8')}</style>`)
    .replace('</body>', () => `${scripts.join('\n')}\n</body>`);
}

async function checkSizes() {
  let [first, all] = [0, 0];
  for (const name of await files()) {
    const size = gzipSync(await readFile(join(site, name)), { level: 9 }).length;
    if (name !== 'licences.html') all += size;
    if (!later.test(name)) first += size;
  }
  const one = Buffer.byteLength(file);
  console.log(`first load: ${first} bytes gzipped; all files: ${all}; one file: ${one} bytes`);
  for (const [what, size, most] of [['the first load', first, mostOfFirst], ['the site', all, mostOfSite], ['the one file', one, mostOfFile]]) {
    if (size > most) throw new Error(`${what} has more than ${most} bytes`);
  }
}
