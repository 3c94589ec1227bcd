// Serves a folder on the loopback address: node serve.mjs FOLDER [PORT]. Prints the address; port 0: any free one.
import { createReadStream } from 'node:fs';
import { stat } from 'node:fs/promises';
import { createServer } from 'node:http';
import { extname, join, normalize, resolve, sep } from 'node:path';
import { pathToFileURL } from 'node:url';

const types = {
  '.html': 'text/html; charset=utf-8', '.js': 'text/javascript', '.css': 'text/css', '.wasm': 'application/wasm',
  '.json': 'application/json', '.txt': 'text/plain; charset=utf-8', '.webmanifest': 'application/manifest+json',
};

/** null for an address that is not well-formed. */
function pathOf(address) {
  try {
    return decodeURIComponent(new URL(address, 'http://localhost').pathname);
  } catch {
    return null;
  }
}

/** Returns the server and its address. */
export function serve(folder, port = 0) {
  const root = resolve(folder);
  const server = createServer(async (request, response) => {
    const path = pathOf(request.url);
    if (path === null) return void response.writeHead(400).end('not a path');
    const file = join(root, normalize(path.endsWith('/') ? `${path}index.html` : path));
    const found = !file.includes('\0') && file.startsWith(root + sep) && await stat(file).catch(() => null);
    if (!found || !found.isFile()) return void response.writeHead(404).end('not here');
    response.writeHead(200, { 'Content-Type': types[extname(file)] ?? 'application/octet-stream', 'Cache-Control': 'no-cache' });
    createReadStream(file).pipe(response);
  });
  return new Promise((done) => server.listen(port, '127.0.0.1', () =>
    done({ server, address: `http://127.0.0.1:${server.address().port}/` })));
}

if (process.argv[1] && import.meta.url === pathToFileURL(process.argv[1]).href) {
  const { address } = await serve(process.argv[2], Number(process.argv[3] ?? 8080));
  console.log(`The lab: ${address} (Ctrl-C ends it)`);
}
