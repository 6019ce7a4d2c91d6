/** A module bundled for a worker, as text. */
declare module "worker:*" {
  const text: string;
  export default text;
}

/** A style sheet as text. */
declare module "*.css" {
  const text: string;
  export default text;
}
