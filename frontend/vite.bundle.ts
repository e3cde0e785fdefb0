// A page's program: one module without imports, styles inside.
import { defineConfig, type UserConfig } from "vite";

export function bundle(name: string): UserConfig {
  return defineConfig({
    publicDir: false,
    build: {
      outDir: "../src/orishell/io/pages",
      emptyOutDir: false,
      target: "es2022",
      chunkSizeWarningLimit: 1200,
      modulePreload: false,
      // Not library mode: that keeps the white space of modules.
      rollupOptions: {
        input: `${name}.ts`,
        preserveEntrySignatures: "strict",
        output: { format: "es", entryFileNames: `${name}.js`, inlineDynamicImports: true },
      },
    },
  });
}
