// The viewer: one module without imports, styles inside, for viewer.html and notebooks.
import { defineConfig } from "vite";

export default defineConfig({
  publicDir: false,
  build: {
    outDir: "../src/orishell/io/pages",
    emptyOutDir: false,
    target: "es2022",
    chunkSizeWarningLimit: 1200,
    modulePreload: false,
    // Not library mode: that keeps the white space of modules.
    rollupOptions: {
      input: "viewer.ts",
      preserveEntrySignatures: "strict",
      output: { format: "es", entryFileNames: "viewer.js", inlineDynamicImports: true },
    },
  },
});
