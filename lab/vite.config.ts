import { defineConfig } from 'vite';

// Twice: the site, whose embed.js is for other pages too; and, as mode `file`, what becomes the page as one file.
export default defineConfig(({ mode }) => ({
  base: './',
  clearScreen: false,
  build: {
    outDir: mode === 'file' ? '../build/lab/file' : '../build/lab/site',
    emptyOutDir: true,
    target: 'es2022',
    modulePreload: { polyfill: false },
    assetsInlineLimit: 0,
    rollupOptions: mode === 'file' ? { output: { inlineDynamicImports: true } } : {
      input: { index: 'index.html', embed: 'embed.ts' },
      output: { entryFileNames: ({ name }) => (name === 'embed' ? 'embed.js' : 'assets/[name]-[hash].js') },
    },
  },
  // Classic scripts: browsers refuse workers that are modules on pages from a folder.
  worker: { format: 'iife' },
}));
