// What comes after vite: the service worker, the licences, and the page as one file. Checks the sizes.
import { readdir, readFile, writeFile } from 'node:fs/promises';
import { join } from 'node:path';
import { gzipSync } from 'node:zlib';
import { createHash } from 'node:crypto';

const here = new URL('.', import.meta.url).pathname;
const site = join(here, '../build/lab/site');
// Bytes, gzipped, of all that a first visit loads; of the one file. A build that exceeds them fails. All planners are
// in the module: most of it is their code, and a new planner adds some 25,000.
const mostOfSite = 665_000;
const mostOfFile = 980_000;

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

/** The page with all in it: script, style and the module, compressed. It opens from a folder too. */
async function oneFile() {
  const names = await filesIn(parts);
  const text = (ending) => readFile(join(parts, names.find((name) => name.endsWith(ending) && name.startsWith('assets/'))), 'utf8');
  const wasm = gzipSync(await readFile(join(parts, names.find((name) => name.endsWith('.wasm')))), { level: 9 });
  const page = await readFile(join(parts, 'index.html'), 'utf8');
  const script = (await text('.js')).replaceAll('</script', '<\\/script');
  const module = `<script type="text/plain" id="wend-wasm">${wasm.toString('base64')}</script>`;
  return page
    .replace(/<script type="module"[^>]*><\/script>/, '')
    .replace(/<link rel="stylesheet"[^>]*>/, `<style>${await text('.css')}</style>`)
    .replace('</body>', () => `${module}\n<script type="module">${script}</script>\n</body>`);
}

async function checkSizes() {
  let total = 0;
  for (const name of await files()) {
    if (name !== 'licences.html') total += gzipSync(await readFile(join(site, name)), { level: 9 }).length;
  }
  console.log(`site: ${total} bytes gzipped; one file: ${Buffer.byteLength(file)} bytes`);
  if (total > mostOfSite) throw new Error(`the site is larger than ${mostOfSite} bytes gzipped`);
  if (Buffer.byteLength(file) > mostOfFile) throw new Error(`the one file is larger than ${mostOfFile} bytes`);
}
