/** The engine by itself, for programs without the front end. */

export { directions, meshOfGrid, type Mesh } from "./body_mesh.js";
export type * from "./engine.js";
export { WasmEngine } from "./wasm_engine.js";
