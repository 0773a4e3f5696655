// SPDX-License-Identifier: BSD-3-Clause
// One page, one script, one style sheet, under names that stay: the plugin compiles them in.
import { defineConfig } from 'vitest/config';

const server = process.env['TOLMAN_VIEWER_URL'] ?? 'http://127.0.0.1:8080';

export default defineConfig({
  base: './',
  build: {
    target: 'es2021',
    modulePreload: false,
    chunkSizeWarningLimit: 1500,
    reportCompressedSize: false,
    rollupOptions: {
      output: {
        entryFileNames: 'assets/viewer.js',
        assetFileNames: 'assets/viewer[extname]',
        inlineDynamicImports: true,
      },
    },
  },
  server: {
    proxy: { '/api': server, '/live': { target: server, ws: true } },
  },
  test: { include: ['test/**/*.test.ts'] },
});
