// Builds the front end (no argument) or the tests (argument "test").
import { build } from "esbuild";
import { mkdirSync, readdirSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { dirname, resolve } from "node:path";

const common = { bundle: true, target: "es2022", logLevel: "warning" };

/** `worker:FILE` is the text of a bundle of its own, `FILE.css` that of a small style sheet. */
const texts = {
  name: "texts",
  setup(builder) {
    builder.onResolve({ filter: /^worker:/ }, ({ path, resolveDir }) => ({
      path: resolve(resolveDir, path.slice("worker:".length)),
      namespace: "worker",
    }));
    builder.onLoad({ filter: /.*/, namespace: "worker" }, async ({ path }) => {
      const { outputFiles, metafile } = await build({
        ...common, entryPoints: [path], format: "iife", minify: true, write: false, metafile: true,
      });
      const watchFiles = Object.keys(metafile.inputs).map((name) => resolve(name));
      return { contents: outputFiles[0].text, loader: "text", watchFiles, resolveDir: dirname(path) };
    });
    builder.onLoad({ filter: /uPlot\.esm\.js$/ }, ({ path }) => ({ contents: withOwnPen(readFileSync(path, "utf8")), loader: "js" }));
    builder.onLoad({ filter: /\.css$/ }, async ({ path }) => ({ contents: await styleSheet(path), loader: "text" }));
  },
};

/** Plots with pens of the processor: those of the graphics card hold a page up where it is drawn by software. */
function withOwnPen(text) {
  const [asked, wanted] = ['getContext("2d")', 'getContext("2d", { willReadFrequently: true })'];
  if (text.split(asked).length !== 2) throw new Error("uPlot asks otherwise for its pen: adapt build.mjs");
  return text.replace(asked, wanted);
}

async function styleSheet(path) {
  const { outputFiles } = await build({ ...common, entryPoints: [path], minify: true, write: false });
  return outputFiles[0].text.trim();
}

if (process.argv[2] === "test") {
  rmSync("build/test", { recursive: true, force: true });
  const tests = readdirSync("test", { recursive: true }).filter((name) => name.endsWith(".test.ts"));
  await build({
    ...common,
    entryPoints: tests.map((name) => `test/${name}`),
    outdir: "build/test",
    outExtension: { ".js": ".mjs" },
    platform: "node",
    format: "esm",
    plugins: [texts],
  });
} else {
  const out = "../src/chaplygin/lab/static";
  mkdirSync(out, { recursive: true });
  await build({
    ...common,
    entryPoints: ["src/engine/index.ts"],
    format: "esm",
    outfile: `${out}/engine.js`,
  });
  const { outputFiles } = await build({
    ...common,
    entryPoints: ["src/index.ts"],
    format: "iife",
    globalName: "ChaplyginLab",
    minify: true,
    charset: "utf8",
    legalComments: "eof",
    plugins: [texts],
    write: false,
  });
  // a page holds the program within its own text
  const program = outputFiles[0].text.replaceAll("</script", "<\\/script");
  writeFileSync(`${out}/lab.js`, program);
  writeFileSync(`${out}/lab.css`, (await styleSheet("src/style/lab.css")) + "\n");
  console.log(`lab.js ${(program.length / 1024).toFixed(0)} kB`, readFileSync(`${out}/lab.css`).length, "bytes of style");
}
