// A browser and the built page, for the tests of the page.

import { chromium, type Browser } from 'playwright-core';
import { serve } from '../serve.mjs';

const site = new URL('../../build/lab/site', import.meta.url).pathname;

export interface Opened {
  browser: Browser;
  address: string;
  close(): Promise<void>;
}

export async function openBrowser(): Promise<Opened> {
  const { server, address } = await serve(site);
  const browser = await chromium.launch({
    executablePath: process.env['CHROMIUM'] ?? '/usr/bin/chromium',
    args: ['--no-sandbox', '--disable-gpu', '--disable-background-networking'],
  });
  return { browser, address, close: async () => { await browser.close(); server.close(); } };
}
