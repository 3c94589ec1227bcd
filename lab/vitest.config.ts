import { defineConfig } from 'vitest/config';

export default defineConfig({
  server: { fs: { allow: ['..'] } },  // build/lab
  test: { include: ['test/*.test.ts'], testTimeout: 30_000, hookTimeout: 30_000, fileParallelism: true },
});
