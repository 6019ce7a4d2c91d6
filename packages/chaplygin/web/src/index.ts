/** What a page may call. */

export { mount } from "./mount";
export type { Source } from "./sources/source";
