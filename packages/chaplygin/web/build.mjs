// Builds the front end (no argument) or the tests (argument "test").
import { build } from "esbuild";
import { mkdirSync, readdirSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { dirname, resolve } from "node:path";

const common = { bundle: true, target: "es2022", logLevel: "warning", metafile: true };

/** Files of which something is in what was built, by their names in the reports of esbuild. */
const used = new Set();

/** Take note of what is in a bundle; a file of which nothing is left counts for nothing. */
function noted({ outputFiles, metafile }) {
  for (const { inputs } of Object.values(metafile.outputs)) {
    for (const [name, { bytesInOutput }] of Object.entries(inputs)) if (bytesInOutput > 0) used.add(name);
  }
  return { outputFiles, metafile };
}

/** `worker:FILE` is the text of a bundle of its own, `FILE.css` that of a small style sheet. */
const texts = {
  name: "texts",
  setup(builder) {
    builder.onResolve({ filter: /^worker:/ }, ({ path, resolveDir }) => ({
      path: resolve(resolveDir, path.slice("worker:".length)),
      namespace: "worker",
    }));
    builder.onLoad({ filter: /.*/, namespace: "worker" }, async ({ path }) => {
      const { outputFiles, metafile } = noted(await build({
        ...common, entryPoints: [path], format: "iife", minify: true, write: false,
      }));
      const watchFiles = Object.keys(metafile.inputs).map((name) => resolve(name));
      return { contents: outputFiles[0].text, loader: "text", watchFiles, resolveDir: dirname(path) };
    });
    builder.onLoad({ filter: /uPlot\.esm\.js$/ }, ({ path }) => ({ contents: withNotice(withOwnPen(readFileSync(path, "utf8"))), loader: "js" }));
    builder.onLoad({ filter: /\.css$/ }, async ({ path }) => ({ contents: await styleSheet(path), loader: "text" }));
  },
};

/** Plots with pens of the processor: those of the graphics card hold a page up where it is drawn by software. */
function withOwnPen(text) {
  const [asked, wanted] = ['getContext("2d")', 'getContext("2d", { willReadFrequently: true })'];
  if (text.split(asked).length !== 2) throw new Error("uPlot asks otherwise for its pen: adapt build.mjs");
  return text.replace(asked, wanted);
}

/** The notice of uPlot in the form that is kept. */
function withNotice(text) {
  if (!text.startsWith("/**")) throw new Error("uPlot begins otherwise: adapt build.mjs");
  return text.replace("/**", "/*!");
}

async function styleSheet(path) {
  const { outputFiles } = noted(await build({ ...common, entryPoints: [path], minify: true, write: false }));
  return outputFiles[0].text.trim();
}

/** The licences of the packages of which something is in what was built. */
function licences() {
  const folders = [...used].map((name) => /(?:.*\/)?node_modules\/(?:@[^/]+\/)?[^/]+/.exec(name.replace(/^[\w-]+:/, ""))?.[0]);
  const packages = [...new Set(folders.filter((folder) => folder !== undefined))].sort();
  const texts = packages.map((folder) => {
    const { name, version, license, homepage, repository } = JSON.parse(readFileSync(`${folder}/package.json`, "utf8"));
    const file = readdirSync(folder).find((entry) => /^licen[cs]e/i.test(entry));
    if (!license || file === undefined) throw new Error(`${name} has no licence: it may not be part of lab.js`);
    const source = (repository?.url ?? repository ?? homepage).replace(/^git\+/, "");
    return `${name} ${version}\nLicence: ${license}\nSource: ${source}\n\n${readFileSync(`${folder}/${file}`, "utf8").replaceAll("\r\n", "\n").trim()}\n`;
  });
  const line = "=".repeat(80);
  return `lab.js and engine.js contain parts of the following packages.\n\n${line}\n${texts.join(`\n${line}\n`)}`;
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
  const out = "../src/chaplygin/page/static";
  mkdirSync(out, { recursive: true });
  noted(await build({
    ...common,
    entryPoints: ["src/engine/index.ts"],
    format: "esm",
    outfile: `${out}/engine.js`,
  }));
  const { outputFiles } = noted(await build({
    ...common,
    entryPoints: ["src/index.ts"],
    format: "iife",
    globalName: "ChaplyginLab",
    minify: true,
    charset: "utf8",
    legalComments: "eof",
    plugins: [texts],
    write: false,
  }));
  // a page holds the program within its own text
  const program = outputFiles[0].text.replaceAll("</script", "<\\/script");
  writeFileSync(`${out}/lab.js`, program);
  writeFileSync(`${out}/lab.css`, (await styleSheet("src/style/lab.css")) + "\n");
  writeFileSync(`${out}/licences.txt`, licences());
  console.log(`lab.js ${(program.length / 1024).toFixed(0)} kB`, readFileSync(`${out}/lab.css`).length, "bytes of style");
}
