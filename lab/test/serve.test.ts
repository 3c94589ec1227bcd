// The server gives the files of its folder, and nothing else, whatever is asked.

import { request } from 'node:http';
import { expect, test } from 'vitest';
import { serve } from '../serve.mjs';

test('only files of the folder are served, and odd addresses do not end it', async () => {
  const { server, address } = await serve(new URL('..', import.meta.url).pathname);
  const status = (path: string) => new Promise<number>((done, fail) => {
    const { hostname, port } = new URL(address);
    request({ hostname, port, path }, (answer) => { answer.resume(); done(answer.statusCode!); }).on('error', fail).end();
  });
  expect(await status('/index.html')).toBe(200);
  expect(await status('/')).toBe(200);
  for (const path of ['/../run', '/%2e%2e/run', '/..%2frun', '/no', '/engine', '/%00']) expect(await status(path), path).toBe(404);
  for (const path of ['/%zz', '//%']) expect([400, 404], path).toContain(await status(path));
  expect(await status('/index.html')).toBe(200);
  server.close();
});
