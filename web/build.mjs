// Builds the front end (no argument) or the tests (argument "test").
import { build } from "esbuild";
import { readdirSync, rmSync } from "node:fs";

if (process.argv[2] === "test") {
  rmSync("build/test", { recursive: true, force: true });
  const tests = readdirSync("test", { recursive: true }).filter((name) => name.endsWith(".test.ts"));
  await build({
    entryPoints: tests.map((name) => `test/${name}`),
    outdir: "build/test",
    outExtension: { ".js": ".mjs" },
    bundle: true,
    platform: "node",
    format: "esm",
    target: "es2022",
    logLevel: "warning",
  });
}
