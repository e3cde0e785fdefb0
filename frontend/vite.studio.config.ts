// The studio: index.html and hashed files beside it, with relative addresses.
import { type Plugin, defineConfig, loadEnv } from "vite";

/** What the page imports first of all is loaded along with what imports it. */
const preloadApp: Plugin = {
  name: "preload-app",
  transformIndexHtml: {
    order: "post",
    handler: (_, { bundle }) =>
      Object.values(bundle ?? {})
        .filter((each) => each.type === "chunk" && each.isDynamicEntry)
        .map(({ fileName }) => ({
          tag: "link",
          injectTo: "head" as const,
          attrs: { rel: "modulepreload", crossorigin: "", href: `./${fileName}` },
        })),
  },
};

/** The address that a running studio printed, with its key. */
const { ORISHELL_STUDIO = "http://127.0.0.1:8765/" } = loadEnv("", ".", "ORISHELL_");
const studio = new URL(ORISHELL_STUDIO);
const cookie = `orishell-${studio.port}=${studio.searchParams.get("key")}`;

export default defineConfig({
  base: "./",
  publicDir: false,
  plugins: [preloadApp],
  build: {
    outDir: "../src/orishell/studio/static",
    emptyOutDir: false,
    target: "es2022",
    assetsInlineLimit: 0,
    modulePreload: { polyfill: false },
    chunkSizeWarningLimit: 1200,
  },
  server: { proxy: { "/api": { target: studio.origin, changeOrigin: true, headers: { origin: studio.origin, cookie } } } },
});
