// Key of the segment that `path` traces in this dispatch; constant where nothing has alpha.
AlphaKey alphaKeyOf(uint path, uint kind) {
    if (kHasAlpha == 0u) return AlphaKey(0u);
    return makeAlphaKey(sampleIdOf(path), batch.bounce, kind);
}
