"""Many motions at once, in blocks that are kept on disk and may run on Dask."""
