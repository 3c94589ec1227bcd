import { defineConfig } from 'vite';

export default defineConfig({
  base: './',
  clearScreen: false,
  build: {
    outDir: '../build/lab/site',
    emptyOutDir: true,
    target: 'es2022',
    modulePreload: { polyfill: false },
    assetsInlineLimit: 0,
  },
  // Classic scripts: browsers refuse workers that are modules on pages from a folder.
  worker: { format: 'iife' },
});
